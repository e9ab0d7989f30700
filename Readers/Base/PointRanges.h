// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointRanges.h
 * @brief Coordinates of a mesh after reading it: their ranges, and which are not finite.
 *
 * ParaView requests the bounds of every mesh that it opens, and the ranges of its coordinates and
 * of their norms, with and without infinite values. VTK makes a pass over all points for each of
 * the five, which in some packages takes as long as reading the file. This function makes one pass.
 */
#ifndef camaron_PointRanges_h
#define camaron_PointRanges_h

#include "Scan/ScanError.h"

class vtkPointSet;

namespace camaron
{
/**
 * Computes these ranges and stores them where VTK caches them, until the coordinates are modified.
 * With nonfinite coordinates, nothing is stored and VTK computes them itself.
 * @return whether the ranges are stored
 */
bool FindPointRanges(vtkPointSet* mesh);

/// Number of points of a mesh with a nonfinite coordinate, and the first of them; for a piece, by
/// its "GlobalPointIds".
Tally FindNotFinitePoints(vtkPointSet* mesh);
}

#endif
