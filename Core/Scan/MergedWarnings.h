// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MergedWarnings.h
 * @brief What several processes warn of that have read pieces of one file.
 */
#ifndef camaron_MergedWarnings_h
#define camaron_MergedWarnings_h

#include <string> // for sentences
#include <vector> // for processes

namespace camaron
{
/**
 * The sentences of Warnings that one process would give that had read all of the file. What all
 * processes found in all of it they say in the same words, and that is said once. What each counted
 * in its own piece has other numbers everywhere, as the first of its kind is in one piece only: the
 * counts are added.
 * @param ofProcesses each in the order in which it gave them, which is the same for all but for
 * those that it lacks
 */
std::vector<std::string> MergeWarnings(const std::vector<std::vector<std::string>>& ofProcesses);
}

#endif
