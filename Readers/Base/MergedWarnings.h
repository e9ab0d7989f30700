// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MergedWarnings.h
 * @brief Merges the warnings of several ranks that have read pieces of one file.
 */
#ifndef camaron_MergedWarnings_h
#define camaron_MergedWarnings_h

#include "Scan/ScanError.h"

#include <vector> // for processes

namespace camaron
{
/**
 * Returns the warnings that one rank would give for the whole file. Warnings about the whole file
 * are the same on all ranks and are kept once. Warnings about single pieces differ in their
 * counts, and the first item is in one piece only: the counts are added.
 * @param ofProcesses the warnings of every rank in the order in which they were added; this order
 * is the same on all ranks, except for missing ones
 */
Warnings MergeWarnings(const std::vector<Warnings>& ofProcesses);
}

#endif
