// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ContentHash.h
 * @brief Tells whether the values of an array are those that were there before.
 *
 * Values that are changed in place leave no trace in the time of an array.
 */
#ifndef camaron_ContentHash_h
#define camaron_ContentHash_h

#include <cstdint> // for the hash

class vtkDataArray;

namespace camaron
{
/**
 * Does not depend on the number of threads. Arrays that are computed have no content but their parameters, which change
 * with their time: only their size counts.
 */
std::uint64_t HashContent(vtkDataArray* array, std::uint64_t seed);
}

#endif
