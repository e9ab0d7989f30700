// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ElementArrays
 * @brief Makes the arrays of faces, edges or vertices that are taken out of a mesh.
 *
 * The elements have the points of the mesh with their data. Arrays are owned by the elements' data set.
 */
#ifndef camaron_ElementArrays_h
#define camaron_ElementArrays_h

#include "Criteria/Criterion.h"
#include "Mesh/FacetTable.h"

class vtkDataArray;
class vtkDataSet;
class vtkPolyData;

namespace camaron
{
class ElementArrays
{
public:
  ElementArrays(vtkDataSet* mesh, vtkPolyData* elements, AngleUnit angles);

  /// Number of elements; before arrays are added.
  void SetSize(vtkIdType size) { this->Size = size; }

  ///@{
  /// Adds an array of the elements and returns its values, which are to be filled in.
  vtkIdType* AddIds(const char* name);
  unsigned char* AddFlags(const char* name);
  unsigned char* AddGhosts();
  double* AddReals(const char* name, enum Unit unit);
  ///@}

  /// Global id of a cell of the mesh; its own if there are none.
  vtkIdType GetGlobalCell(vtkIdType cell) const;
  /// Of every cell of the mesh whether it is a ghost; nullptr if there are no ghosts.
  const unsigned char* GetInputGhosts() const { return this->Ghosts; }
  /// DUPLICATECELL if the cell of the smallest global id is a ghost, else 0.
  unsigned char BelongsToGhost(const Index* cells, std::size_t size) const;

private:
  vtkPolyData* Elements;
  AngleUnit Angles;
  vtkIdType Size = 0;
  vtkDataArray* GlobalIds;
  const unsigned char* Ghosts = nullptr;
};
}

#endif
