// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointPairs.h
 * @brief The closest and the farthest pair of a set of points.
 */
#ifndef camaron_PointPairs_h
#define camaron_PointPairs_h

#include "Base/Vector.h"

#include <cstddef> // for std::size_t

namespace camaron
{
/// Maximum squared distance; 0 for fewer than two points. O(n log n) in practice.
double FindLargestSquaredDistance(const Vector* points, std::size_t size);
/// Minimum squared distance; infinite for fewer than two points. O(n log n) in practice.
double FindSmallestSquaredDistance(const Vector* points, std::size_t size);
}

#endif
