// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetGenWriting.h
 * @brief Writes TetGen and Triangle files.
 *
 * See Readers/TetGen/README.md for the files that a mesh becomes.
 */
#ifndef camaron_TetGenWriting_h
#define camaron_TetGenWriting_h

#include "Intake/CellMesh/CellConversion.h"

#include <string> // for paths

class vtkDataSet;

namespace camaron
{
/// Options of the writer.
struct TetGenOptions
{
  int FirstId = 0; ///< 0 or 1
  UnsupportedCells Others = UnsupportedCells::Refuse;
  bool Arrays = true;         ///< attributes, regions and markers
  bool BoundaryFaces = false; ///< of tetrahedra, if the mesh has no triangles
};

/**
 * Writes a vtkUnstructuredGrid or vtkPolyData to a .node and an .ele file; if there are triangles
 * and tetrahedra, triangles go to a .face file. Coordinates have the fewest digits that read back
 * as the same number of their type. All files appear together when they are complete.
 * @param path of any of the files
 * @return false with the error in @a error, or without one if aborted; files are then unchanged
 */
bool WriteTetGen(const std::string& path, vtkDataSet* mesh, const TetGenOptions& options,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress());
}

#endif
