// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SimilarName.h
 * @brief Finds the name that a misspelled word may mean.
 */
#ifndef camaron_SimilarName_h
#define camaron_SimilarName_h

#include <string>      // for names
#include <string_view> // for words
#include <vector>      // for names

namespace camaron
{
/**
 * The most similar of the known names, whatever the case of ASCII letters; empty if none is
 * similar.
 *
 * Similarity is that of Ratcliff and Obershelp, Pattern Matching: The Gestalt Approach, Dr. Dobb's
 * Journal, 1988: twice the number of common characters over the number of all characters, where the
 * longest common substring is common, and so are the common characters left and right of it. At
 * least 0.6 is similar. Python's difflib.get_close_matches has the same results for words of fewer
 * than 200 characters.
 */
std::string FindSimilarName(std::string_view word, const std::vector<std::string>& known);
}

#endif
