// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentPolyhedra
 * @brief Creates polyhedra in two passes over the faces, without storing these.
 *
 * The first pass counts the faces and face points of every cell, so the second can store each face
 * at the positions of its cells in the grid. Faces, points and their order are the same as from
 * FluentCellFaces. Meshes with other cells, or with polyhedra without faces, require
 * BuildFluentCells.
 */
#ifndef camaron_FluentPolyhedra_h
#define camaron_FluentPolyhedra_h

#include "FluentCellFaces.h"
#include "FluentFaceBatches.h"
#include "FluentInteriorZones.h"

class vtkUnstructuredGrid;

namespace camaron
{
class FluentPolyhedra
{
public:
  explicit FluentPolyhedra(const FluentMesh& mesh)
    : Mesh(mesh)
    , Count(mesh.Piece.GetNumberOfCells())
  {
  }

  /// Whether all cells are declared as polyhedra.
  bool AreAll() const;
  /// Creates the cells, passes their faces on to MeshTopology, and adds the faces to @a zones;
  /// false if some cells have no faces, the batches cannot be visited, or if aborted. The grid only
  /// changes on success.
  bool Build(FluentFaceBatches& batches, FluentInteriorZones& zones, vtkUnstructuredGrid* grid,
    const Progress& progress);

private:
  using Id = vtkTypeInt32;
  /// Positions of the next face of a cell and of its points.
  struct Cursor
  {
    std::uint32_t Face, Corner;
  };

  struct Side;

  bool CountFaces(FluentFaceBatches& batches, const Progress& progress);
  bool FindPlaces();
  bool Fill(FluentFaceBatches& batches, FluentInteriorZones& zones, const Progress& progress);
  bool AddTo(const Side& face);
  bool FindPoints(const Progress& progress);
  class Numbering;
  bool NumberPoints(Buffer<std::uint32_t>& counts, const Progress& progress);
  void HandOver(vtkUnstructuredGrid* grid);

  const FluentMesh& Mesh;
  vtkIdType Count;
  Buffer<Cursor> Cursors;           ///< per cell
  Buffer<std::uint32_t> CornerEnds; ///< per cell
  Buffer<Id> LocationOffsets;       ///< begins of the faces of every cell
  Buffer<Id> FaceOffsets; ///< begins of the points of every face, complemented if it was reversed
  Buffer<Id> Corners;     ///< points of faces
  Buffer<Id> Offsets;     ///< begins of the points of every cell
  Buffer<Id> Points;
  LargeVector<Index> Faces; ///< positions in the file of the faces of cells
};
}

#endif
