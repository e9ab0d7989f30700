// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PLYParts.h
 * @brief The meaning of the elements of a PLY file.
 */
#ifndef camaron_PLYParts_h
#define camaron_PLYParts_h

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

/// An element with its role.
struct PLYPart
{
  PLYRole Role = PLYRole::None;
  PLYElement Element;
  std::unique_ptr<TableRows> Rows;
  std::vector<bool> Used;          ///< properties that are not arrays
  std::vector<PLYListShape> Lists; ///< of properties
  int List = -1;                   ///< of vertices or faces
  int Ends[2] = { -1, -1 };        ///< of edges
  bool HasSignedIds() const { return IsSigned(this->Element.Properties[this->List].Type); }

  ///@{
  /// Of cells: the list of points or faces of each, in the order of the rows or, of strips, of
  /// their triangles.
  vtkIdType NumberOfLists = 0;
  ListSizes Sizes;
  bool IsInMemory = false;
  std::vector<std::int32_t> Ids; ///< if so
  ///@}

  ///@{
  /// The first cell, their number, and the cell of every list, if these are not consecutive; -1 for
  /// none.
  vtkIdType FirstCell = 0;
  vtkIdType NumberOfCells = 0;
  Buffer<std::int32_t> Items;
  vtkIdType GetCell(vtkIdType list) const
  {
    return this->Items.size() > 0 ? this->Items[list] : this->FirstCell + list;
  }
  ///@}
};

/// Adds properties missing in the header: those of edges as Camarón writes them.
void CompleteElement(PLYElement& element);

/// Determines the role of an element; @a hasPoints if there is one for points already.
PLYPart MakePart(const PLYElement& element, bool hasPoints);
}

#endif
