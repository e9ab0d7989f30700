// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ElementIds.h
 * @brief Numbers the faces, edges and vertices of a mesh in pieces as those of the undivided mesh.
 */
#ifndef camaron_ElementIds_h
#define camaron_ElementIds_h

#include "Ranks/Reducer.h"

#include "vtkType.h" // for ids

#include <array>   // for keys
#include <cstdint> // for keys
#include <vector>  // for the pieces

class vtkPolyData;

namespace camaron
{
/**
 * What the elements of the undivided mesh are sorted by: for a face, the global id of its first
 * cell, and its number in that cell; for an edge or vertex, the global ids of its points.
 */
using ElementKey = std::array<std::int64_t, 2>;

/// Elements of one piece.
struct KeyedElements
{
  int Block = 0; ///< elements of different blocks differ; they are numbered block by block
  std::vector<ElementKey> Keys; ///< one per element
  const unsigned char* Ghosts =
    nullptr; ///< DUPLICATECELL if it belongs to another piece; or nullptr
};

/// Keys of edges and vertices; empty if their points have no global ids.
std::vector<ElementKey> MakeKeys(vtkPolyData* elements);

/**
 * Collective. The number of every element in the undivided mesh, by piece. Ghosts have the number
 * of the element that they duplicate. Empty if keys do not tell the elements apart: two elements
 * have the same, or some are negative or too large.
 */
std::vector<std::vector<vtkIdType>> NumberElements(
  const std::vector<KeyedElements>& pieces, Reducer& reducer);
}

#endif
