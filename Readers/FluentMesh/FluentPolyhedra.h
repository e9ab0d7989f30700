// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentPolyhedra
 * @brief Makes polyhedra in two passes over the faces, none of which has to be kept.
 *
 * The first pass counts the faces and corners of every cell, so that the second puts each face
 * where its cells have it in the grid. Faces, points and their order are those that FluentCellFaces
 * finds. What is not a mesh of polyhedra only, each with faces, has to be made by BuildFluentCells.
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
  /// Makes the cells, hands their faces over to MeshTopology, and adds the faces to @a zones; false
  /// if some have no faces, the batches cannot be visited, or if stopped. The grid gets the cells
  /// only if all is well.
  bool Build(FluentFaceBatches& batches, FluentInteriorZones& zones, vtkUnstructuredGrid* grid,
    const Progress& progress);

private:
  using Id = vtkTypeInt32;
  /// Where the next face of a cell and its corners go.
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
  Buffer<Id> LocationOffsets;       ///< where the faces of every cell begin
  Buffer<Id> FaceOffsets; ///< where the corners of every face begin, complemented if it was turned
  Buffer<Id> Corners;     ///< points
  Buffer<Id> Offsets;     ///< where the points of every cell begin
  Buffer<Id> Points;
  LargeVector<Index> Faces; ///< positions in the file of the faces of cells
};
}

#endif
