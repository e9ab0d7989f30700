// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MAPDLWriting.h
 * @brief Writes decks of Ansys Mechanical APDL in the blocked form of CDWRITE.
 */
#ifndef camaron_MAPDLWriting_h
#define camaron_MAPDLWriting_h

#include "Intake/CellMesh/CellConversion.h"

#include <string> // for paths

class vtkDataSet;

namespace camaron
{
struct MAPDLWriteOptions
{
  /// Use ids from the arrays NodeId and ElementId if they exist and are positive and unique.
  bool OriginalIds = true;
  int Digits = 14; ///< of coordinates; 17 preserve every double
  UnsupportedCells Others = UnsupportedCells::Refuse;
};

/**
 * Writes a vtkUnstructuredGrid or vtkPolyData: nodes, elements, their types, and a component for
 * each byte array with values 0 or 1. Types and attributes of elements are taken from the arrays
 * that the reader creates (TypeId, ElementType, Material, Real, Section) if they match the cells.
 * @return false with the error in @a error, or without one if aborted; the file is then unchanged
 */
bool WriteMAPDL(const std::string& path, vtkDataSet* mesh, const MAPDLWriteOptions& options,
  Warnings& warnings, ScanError& error, const Progress& progress = Progress());
}

#endif
