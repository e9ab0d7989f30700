// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointRanges.h
 * @brief The ranges of the coordinates of a mesh that was just read.
 *
 * ParaView asks for the bounds of every mesh that it opens, and for the ranges of its coordinates
 * and of their norms, with and without infinite ones. VTK goes over all points for each of the
 * five, and in some packages takes as long for that as we for all of the reading. All come out of
 * one pass.
 */
#ifndef camaron_PointRanges_h
#define camaron_PointRanges_h

class vtkPointSet;

namespace camaron
{
/**
 * Finds these ranges and leaves them where VTK keeps those that it has computed itself, until the
 * coordinates are modified. Where any coordinate is not finite nothing is left, and VTK finds out
 * by itself.
 * @return whether they are left
 */
bool FindPointRanges(vtkPointSet* mesh);
}

#endif
