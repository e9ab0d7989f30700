// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceTables.h
 * @brief Fills a FaceMesh from tables of a file: points, faces, and cells that list
 * their faces.
 */
#ifndef camaron_FaceTables_h
#define camaron_FaceTables_h

#include "Intake/FaceMesh/FaceMesh.h"
#include "Intake/Rows/TableRows.h"

#include <array> // for properties

class vtkUnstructuredGrid;

namespace camaron
{
/// Reads all coordinates into memory of the mesh.
/// @param type of the coordinates: Float or Double
/// @param properties x, y and z; negative for one that the rows do not have, which is 0
bool ReadPoints(TableRows& points, ValueType type, const std::array<int, 3>& properties,
  FaceMesh& mesh, const Progress& progress);

/// Reads the lists of points of the faces.
bool ReadFaces(TableRows& faces, int list, const ListIds& points, const PieceRequest& request,
  FaceMesh& mesh, Warnings& warnings, const Progress& progress);

/**
 * Reads the lists of faces of polyhedra. If the faces have signs, so negative where the normal of a
 * face points into the cell, they give the faces their sides.
 * @return false with an error set, as for a face with two cells on one side, or if stopped
 */
bool ReadFacesOfCells(TableRows& cells, int list, const ListIds& faces, const PieceRequest& request,
  FaceMesh& mesh, Warnings& warnings, const Progress& progress);

/// Adds an array with the value of each row of the cells to a grid that BuildGrid has filled; 0 for
/// faces without a cell.
void AddCellValues(const char* name, const Buffer<std::int32_t>& values, vtkUnstructuredGrid* grid);
}

#endif
