// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentLists.h
 * @brief Lists in the text of Fluent's files, which are those of Scheme: (a "b" (c 1)).
 */
#ifndef camaron_FluentLists_h
#define camaron_FluentLists_h

namespace camaron
{
/**
 * Moves @a place behind the parenthesis that closes as many as are open and those that open meanwhile;
 * false at the end of the text, the place being as it was.
 * @param depth number of open parentheses; 0 if the first is still to come
 * @param quotes whether parentheses between quotation marks do not count; a backslash takes the meaning
 *        from the character behind it there
 */
bool SkipFluentLists(const char*& place, const char* end, int depth, bool quotes);
}

#endif
