// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PLYParts.h
 * @brief What the elements of a PLY file are.
 */
#ifndef camaron_PLYParts_h
#define camaron_PLYParts_h

#include "PLYRows.h"

namespace camaron
{
/// What an element becomes, if any.
enum class PLYRole
{
  None,
  Points,
  Faces,    ///< lists of vertices
  Strips,   ///< lists of vertices, of which every three in a row are a triangle
  Edges,    ///< two vertices
  Polyhedra ///< lists of faces
};

/// An element with its role.
struct PLYPart
{
  PLYRole Role = PLYRole::None;
  std::unique_ptr<PLYRows> Rows;
  std::vector<bool> Used;          ///< properties that tell what the element is
  std::vector<PLYListShape> Lists; ///< of properties
  int List = -1;                   ///< of vertices or faces
  int Ends[2] = { -1, -1 };        ///< of edges

  ///@{
  /// Of cells: the first one, how many, and which cell a row is where these are not one after the
  /// other.
  vtkIdType FirstCell = 0;
  vtkIdType NumberOfCells = 0;
  Buffer<std::int32_t> Items;
  vtkIdType GetCell(vtkIdType row) const
  {
    return this->Items.size() > 0 ? this->Items[row] : this->FirstCell + row;
  }
  ///@}
  Buffer<std::int32_t> RowOfCell; ///< of strips
};

/// Adds the properties that the header does not tell of: those of edges as Camarón writes them.
void CompleteElement(PLYElement& element);

/// Finds out what an element is; @a hasPoints if there is one of points already.
PLYPart MakePart(const PLYElement& element, bool hasPoints);
}

#endif
