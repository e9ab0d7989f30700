// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ConvertedMesh.h
 * @brief Converts the cells of a mesh for writers that need the faces between cells.
 */
#ifndef camaron_ConvertedMesh_h
#define camaron_ConvertedMesh_h

#include "Intake/CellMesh/CellConversion.h"

#include "vtkSmartPointer.h" // for the mesh

#include <vector> // for names

namespace camaron
{
/**
 * The mesh itself if a format stores all its cells, else a grid of the cells that ConvertCells
 * finds, with the field data and the given cell arrays.
 *
 * @return nullptr with the error in @a error, or without one if stopped
 */
vtkSmartPointer<vtkDataSet> ConvertMesh(vtkDataSet* mesh, const CellConversion& how,
  const std::string& path, const std::vector<std::string>& arrays, Warnings& warnings,
  ScanError& error, const Progress& progress);
}

#endif
