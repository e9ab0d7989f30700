// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SmallFile.h
 * @brief Reads small text files of the user, such as acceptable ranges, on one process for all.
 */
#ifndef camaron_SmallFile_h
#define camaron_SmallFile_h

#include "Ranks/Reducer.h"

#include <string> // for the text

namespace camaron
{
/**
 * Collective. The bytes of a file, which process 0 reads. Throws std::runtime_error on all
 * processes if the file cannot be read, is a pipe or a device, or is larger than 1 MiB.
 *
 * @param what the expected content for messages, such as "a file of ranges"
 */
std::string ReadSmallFile(const std::string& path, const std::string& what, Reducer& reducer);
}

#endif
