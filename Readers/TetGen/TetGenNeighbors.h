// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TetGenNeighbors
 * @brief The neighbors of elements, from a .neigh file.
 */
#ifndef camaron_TetGenNeighbors_h
#define camaron_TetGenNeighbors_h

#include "TetGenCells.h"

namespace camaron
{
class TetGenNeighbors
{
public:
  struct Header
  {
    std::int64_t Count = 0;
    int Corners = 4;
  };
  static bool ReadHeader(TextScanner& scanner, Header& header);

  /// Reads the neighbors of the elements of a piece; @a ids finds an element by its id.
  bool Read(TextScanner& scanner, const TextLines* lines, const TetGenCells& cells,
    const CellMeshPiece& piece, const IdMap& ids, const Progress& progress);

  /// Adds "Neighbors": indices of elements in the whole mesh, -1 if there is none.
  void AddArrays(vtkUnstructuredGrid* grid);

private:
  int Corners = 4;
  Buffer<std::int32_t> Neighbors; ///< in the order of elements
};
}

#endif
