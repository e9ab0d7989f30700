// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellShells.h
 * @brief Which of the closed shells of one cell lie inside of which: those around voids.
 */
#ifndef camaron_CellShells_h
#define camaron_CellShells_h

#include "Mesh/Vector.h"

#include <vector> // for shells

namespace camaron
{
class CellGeometry;

/// A closed surface made of faces of a cell.
struct CellShell
{
  std::vector<int> Faces;
  Vector Low, High;  ///< its box
  double Volume = 0; ///< negative if the faces point inward
};

/// The shells of a cell with NeedsFaces, as its topology tells them apart.
std::vector<CellShell> GetCellShells(const CellGeometry& cell);

/// Of every shell whether it bounds a void: an odd number of others contains it.
std::vector<unsigned char> FindVoids(
  const CellGeometry& cell, const std::vector<CellShell>& shells);
}

#endif
