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

  /**
   * Reads the neighbors of the elements of a piece.
   * @param all read those of all elements instead, to check them
   * @param ids finds an element by its id
   */
  bool Read(TextScanner& scanner, const TextLines* lines, const TetGenCells& cells,
    const CellMeshPiece& piece, bool all, const IdMap& ids, const Progress& progress);

  /**
   * Warns about elements that are missing among the neighbors of a neighbor, or that do not share
   * with a neighbor the facet opposite the vertex for which it is given.
   */
  void Check(const CellMesh& mesh, Warnings& warnings, const Progress& progress) const;

  /// Adds "Neighbors": indices of elements in the whole mesh, -1 if there is none.
  void AddArrays(vtkUnstructuredGrid* grid, const CellMeshPiece& piece);

private:
  int Corners = 4;
  bool HasAll = true;
  Buffer<std::int32_t> Neighbors; ///< in the order of elements
};
}

#endif
