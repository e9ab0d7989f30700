// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SmallFile.h
 * @brief A text file of the user, such as one of ranges, that one process reads for all.
 */
#ifndef camaron_SmallFile_h
#define camaron_SmallFile_h

#include "Ranks/Reducer.h"

#include <string> // for the text

namespace camaron
{
/**
 * Collective. Its bytes. Throws std::runtime_error on all processes alike where it cannot be read,
 * or where it is too large for @a what, such as "a file of ranges".
 */
std::string ReadSmallFile(const std::string& path, const std::string& what, Reducer& reducer);
}

#endif
