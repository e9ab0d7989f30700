// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentMesh.h
 * @brief The piece of the mesh of a Fluent file, and what is created from it: cells, zones,
 * surfaces.
 */
#ifndef camaron_FluentMesh_h
#define camaron_FluentMesh_h

#include "Intake/CellMesh/CellMeshPiece.h"
#include "Intake/Fluent/FluentCells.h"
#include "Intake/Fluent/FluentFaces.h"
#include "Intake/Fluent/FluentInteriorZones.h"
#include "Intake/Ids/IdSet.h"
#include "Intake/Pieces/PieceOfSpace.h"

#include "vtkSmartPointer.h" // for coordinates

#include <map>    // for split faces
#include <vector> // for members

class vtkDataArray;
class vtkFieldData;
class vtkMultiBlockDataSet;
class vtkPoints;
class vtkUnstructuredGrid;

namespace camaron
{
struct FluentMesh
{
  FluentFile& File;
  FluentFaces Faces = {};
  FluentCells Cells = {};
  FluentInteriorZones InteriorZones = {};
  CellMeshPiece Piece = {};              ///< its cells are the leaves
  std::vector<std::int32_t> Leaves = {}; ///< of the piece, unless it is whole
  /// Positions of faces that were split where neighbors have been refined, by those of their parts.
  std::map<vtkIdType, vtkIdType> SplitFaces = {};

  /// Index in the piece of the cell with an id of the file; -1 if it is not in the piece.
  vtkIdType FindCell(std::int64_t id) const
  {
    const vtkIdType leaf = this->Cells.FindLeaf(id);
    return leaf >= 0 ? this->Piece.FindCell(leaf) : -1;
  }
  /// The leaf of a cell of the piece.
  vtkIdType GetLeaf(vtkIdType cell) const
  {
    return this->Piece.IsWhole() ? cell : this->Leaves[static_cast<std::size_t>(cell)];
  }
  FluentShape GetShape(vtkIdType cell) const
  {
    return GetFluentShape(this->Cells.GetElement(this->GetLeaf(cell)), this->File.GetDimension());
  }
};

/**
 * Sets the cells of @a grid to those of a piece.
 *
 * Faces declare the cell on each side, which determines the orientation of cells: an inverted cell
 * remains inverted. Cells of a declared type become that of VTK, with split faces instead of their
 * parts where neighbors were refined; if they have other faces, they become polyhedra (polygons).
 * Cells declared as polyhedra remain so, whatever their shape; cells of unknown type are
 * recognized. Cells without faces, and 2D cells whose edges do not form a closed ring, become
 * VTK_EMPTY_CELL.
 *
 * The faces of meshes with polyhedra are passed on to MeshTopology. The grid does not depend on the
 * number of threads.
 *
 * @param mesh whose interior zones get the faces if these are several
 * @param isFirstPiece whether this one warns about faces of the whole mesh
 * @return false with the error in the file, or without one if aborted
 */
bool BuildFluentCells(FluentMesh& mesh, bool isFirstPiece, vtkUnstructuredGrid* grid,
  Warnings& warnings, const Progress& progress);

/**
 * Creates the same cells without storing faces, if all are of declared types other than polyhedra.
 * @return false, with @a grid unchanged, for other cells, if faces do not match the declared type
 * of their cell or are oriented inconsistently, if the file is invalid, or if aborted
 */
bool StreamFluentStandardCells(
  FluentMesh& mesh, vtkUnstructuredGrid* grid, const Progress& progress);

/// Adds the zones of the file as "ZoneIds", "ZoneNames", "ZoneTypes" and "ZoneBoundaryTypes"
/// (Fluent's numbers of boundary types).
void AddFluentZones(const FluentFile& file, vtkFieldData* fieldData);

/**
 * Creates a block, a vtkPolyData, for every face zone, except interior ones and parents of split
 * faces, unless there are too many. Faces are oriented outward of their (first) cell. They have the
 * cell arrays "Zone" and "BoundaryType", Fluent's number of the boundary type.
 * @param points of the piece
 * @param warnings also receives the numbers of faces that belong to no cell, by zone
 * @return false with the error in the file, or if aborted
 */
bool MakeFluentBoundaries(
  const FluentMesh& mesh, vtkPoints* points, vtkMultiBlockDataSet* blocks, Warnings& warnings);

/**
 * Reads faces that belong to no cell as cells, in the order of the file: polygons, in 2D lines,
 * with the arrays "Zone" and "BoundaryType". False with the error in @a file, or if aborted.
 */
bool ReadFluentSurface(FluentFile& file, FluentFaces& faces, const PieceRequest& request,
  vtkUnstructuredGrid* grid, Warnings& warnings, const Progress& progress);

/// Number of nodes, after checking that the sections define all of them; -1 with the error in the
/// file.
vtkIdType CountFluentNodes(FluentFile& file);

/// Passes all nodes, from any thread; false with the error in the file, or if aborted.
bool ForEachFluentNode(
  FluentFile& file, const PieceOfSpace::Visit& visit, const Progress& progress);

/**
 * Coordinates: float if all sections are binary in single precision, else double. nullptr with the
 * error in the file, or if aborted.
 * @param nodes their number
 * @param some the nodes to read, numbered; nullptr for all
 */
vtkSmartPointer<vtkDataArray> ReadFluentNodes(
  FluentFile& file, vtkIdType nodes, const IdSet* some, const Progress& progress);
}

#endif
