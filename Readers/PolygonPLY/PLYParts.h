// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PLYParts.h
 * @brief The meaning of the elements of a PLY file.
 */
#ifndef camaron_PLYParts_h
#define camaron_PLYParts_h

#include "Intake/CellMesh/CellLists.h"
#include "PLYArrays.h"

namespace camaron
{
/// What an element becomes.
enum class PLYRole
{
  None,
  Points,
  Faces,    ///< lists of vertices
  Strips,   ///< lists of vertices in which every three consecutive ones are a triangle
  Edges,    ///< two vertices
  Polyhedra ///< lists of faces
};

/// An element with its role, and the lists of vertices or faces that it has, if any.
struct PLYPart : CellLists::Part
{
  PLYRole Role = PLYRole::None;
  PLYElement Element;
  std::vector<bool> Used;          ///< properties that are not arrays
  std::vector<PLYListShape> Lists; ///< of properties
  int Ends[2] = { -1, -1 };        ///< of edges
};

/// Determines the role of an element; @a hasPoints if there is one for points already. Adds
/// properties missing in the header: those of edges as Camarón writes them.
PLYPart MakePart(const PLYElement& element, bool hasPoints);
}

#endif
