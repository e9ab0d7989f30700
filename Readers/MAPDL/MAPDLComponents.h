// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MAPDLComponents.h
 * @brief Components of Mechanical APDL, which are named sets of nodes or elements.
 */
#ifndef camaron_MAPDLComponents_h
#define camaron_MAPDLComponents_h

#include "MAPDLMesh.h"

namespace camaron
{
/**
 * Adds an array of 0 and 1 per component to the points or cells of a piece, and lists the names in
 * the string arrays NodeComponents and ElementComponents of the field data. Of components with the
 * same name the last is used.
 * @param textSize bytes of the file; bounds the memory that damaged components can request
 */
bool AddMAPDLComponents(const MAPDLDeck& deck, const MAPDLMesh& mesh, const CellMeshPiece& piece,
  std::size_t textSize, vtkUnstructuredGrid* grid, Warnings& warnings, MAPDLFault& fault,
  const Progress& progress);
}

#endif
