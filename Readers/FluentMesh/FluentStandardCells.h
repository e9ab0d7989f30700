// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentStandardCells
 * @brief Makes cells of declared types, none of them polyhedra, in one pass over the faces.
 *
 * Faces come in the order of their ids, and each adds what it says to the nodes of the cells on its
 * sides, so that no faces have to be kept but those of incomplete pyramids and wedges. Nodes are in
 * the order in which FluentCellFaces finds them. A mesh that has a cell whose faces are not those
 * of its type, or do not run as neighbors do, has to be made by BuildFluentCells.
 */
#ifndef camaron_FluentStandardCells_h
#define camaron_FluentStandardCells_h

#include "FluentCellFaces.h"
#include "FluentCellNodes.h"
#include "FluentFaceBatches.h"
#include "FluentInteriorZones.h"

class vtkUnstructuredGrid;

namespace camaron
{
class FluentStandardCells
{
public:
  explicit FluentStandardCells(const FluentMesh& mesh)
    : Mesh(mesh)
    , Count(mesh.Piece.GetNumberOfCells())
  {
  }

  /// Finds the place of every cell; false if some are of no such type.
  bool Place();
  /// Makes the cells, and adds the faces to @a zones if they are several; false if some are not as
  /// they are declared, the batches cannot be visited, or if stopped. The grid gets them only if
  /// all is well.
  bool Build(FluentFaceBatches& batches, FluentInteriorZones& zones, vtkUnstructuredGrid* grid,
    const Progress& progress);

private:
  using Id = vtkTypeInt32;
  struct Triangle;
  struct Side;
  class Share;

  bool PlaceUniform(const FluentShape& shape);
  bool PlaceMixed();
  unsigned char GetType(vtkIdType cell) const
  {
    return this->CommonType != 0 ? this->CommonType : this->Types[cell];
  }
  vtkIdType GetOffset(vtkIdType cell) const
  {
    return this->CommonType != 0 ? this->CommonSize * cell : this->Offsets[cell];
  }
  template <typename SideOfFace>
  bool AddFaces(FluentFaceBatches& batches, FluentInteriorZones& zones, const Progress& progress);
  bool Finish(const Progress& progress);

  const FluentMesh& Mesh;
  vtkIdType Count;
  unsigned char CommonType = 0; ///< of all cells, or 0
  vtkIdType CommonSize = 0;     ///< nodes of each cell then
  Buffer<unsigned char> Types;
  Buffer<Id> Offsets;
  Buffer<Id> Nodes; ///< ids of the file or what leads to them, then points
  FluentCellState* States = nullptr;
};
}

#endif
