// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NotFinitePoints.h
 * @brief Points with a coordinate that is NaN or infinite.
 */
#ifndef camaron_NotFinitePoints_h
#define camaron_NotFinitePoints_h

#include "Scan/ScanError.h"

class vtkPointSet;

namespace camaron
{
/// Number of points of a mesh with a nonfinite coordinate, and the first of them; for a piece, by
/// its "GlobalPointIds".
Tally FindNotFinitePoints(vtkPointSet* mesh);
}

#endif
