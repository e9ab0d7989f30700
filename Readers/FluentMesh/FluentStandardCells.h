// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentStandardCells
 * @brief Creates cells of declared types other than polyhedra in one pass over the faces.
 *
 * Faces are read in the order of their ids, and each adds its data to the nodes of the cells on its
 * sides, so only faces of incomplete pyramids and wedges are stored. Nodes are in the same order as
 * from FluentCellFaces. A mesh with a cell whose faces do not match its type, or are oriented
 * inconsistently, requires BuildFluentCells.
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

  /// Determines the position of every cell; false if some are of other types.
  bool Place();
  /// Creates the cells, and adds the faces to @a zones if there are several; false if some do not
  /// match their declared type, the batches cannot be visited, or if aborted. The grid only changes
  /// on success.
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
  vtkIdType CommonSize = 0;     ///< number of nodes of each cell then
  Buffer<unsigned char> Types;
  Buffer<Id> Offsets;
  Buffer<Id> Nodes; ///< ids of the file, or data from which they follow; finally points
  FluentCellState* States = nullptr;
};
}

#endif
