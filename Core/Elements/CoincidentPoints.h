// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CoincidentPoints.h
 * @brief Points of a mesh that lie in one place.
 */
#ifndef camaron_CoincidentPoints_h
#define camaron_CoincidentPoints_h

#include "Mesh/MeshView.h"

#include <vector> // for the result

class vtkDataArray;

namespace camaron
{
/**
 * Of every point the lowest id of all points within a tolerance of it, itself included; -1 if there is no other.
 * Exact, whatever the number of threads. Points with coordinates that are not finite coincide with none.
 *
 * @param tolerance a length; 0 for 8 rounding units of the larger one of the coordinates that are compared
 * @param ids by which points are known; nullptr for their places in the mesh
 */
std::vector<vtkIdType> FindCoincidentPoints(
  const MeshView& mesh, double tolerance, vtkDataArray* ids);
}

#endif
