// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceTables.h
 * @brief Makes a grid from tables of a file: points, faces, and cells that list their faces.
 */
#ifndef camaron_FaceTables_h
#define camaron_FaceTables_h

#include "Intake/FaceMesh/FaceMesh.h"
#include "Intake/Rows/TableRows.h"

#include <array> // for properties

class vtkDataSetAttributes;
class vtkUnstructuredGrid;

namespace camaron
{
/// The tables of a file, as TableScanner::Locate makes them.
struct FaceTables
{
  std::unique_ptr<TableRows> Points; ///< x, y and z, all of type Float or all Double, and values
  std::unique_ptr<TableRows> Faces;  ///< a list of points
  std::unique_ptr<TableRows> Cells;  ///< a list of faces, and values
  ///@{
  /// Which ids these lists have; all that the tables have, from 0, by default.
  ListIds PointsOfFaces{ "a point of a face" };
  ListIds FacesOfCells{ "a face of a cell" };
  ///@}
};

/**
 * Fills a grid as BuildGrid does. If faces of cells have signs, so are negative where the normal of
 * a face points into the cell, they give the faces their sides. The values of points and cells
 * become arrays with their names; those of faces without a cell are 0. Rows must have the declared
 * length.
 * @return false with the error set, also of a face with two cells on one side, or if stopped
 */
bool ReadFaceTables(FaceTables& tables, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress);

/// Reads all coordinates into memory of the mesh.
/// @param type of the coordinates: Float or Double
/// @param properties x, y and z; negative for one that the rows do not have, which is 0
bool ReadPoints(TableRows& points, ValueType type, const std::array<int, 3>& properties,
  FaceMesh& mesh, const Progress& progress);

/// Position in a piece of each of the first items of the mesh, by global id; -1 for none.
Buffer<std::int32_t> FindPlaces(vtkDataSetAttributes* attributes, vtkIdType numberOfItems);
}

#endif
