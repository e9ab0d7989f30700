// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Characters.h
 * @brief Unicode characters of a text in UTF-8.
 */
#ifndef camaron_Characters_h
#define camaron_Characters_h

#include <string>      // for text
#include <string_view> // for text

namespace camaron
{
/// Whether every byte is part of a valid character.
bool IsUtf8(std::string_view text);

/// The characters of a text; U+FFFD for each invalid byte.
std::u32string ToCharacters(std::string_view text);
/// The inverse; @a character must be a valid code.
void AppendCharacter(std::string& text, char32_t character);
std::string ToUtf8(std::u32string_view characters);

/// Whether the character is white space, in any script.
bool IsBlank(char32_t character);
/// Whether the character can be shown in a message: neither a control or format character, nor
/// white space other than a blank, nor for private use.
bool IsPrintable(char32_t character);
}

#endif
