// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellLists
 * @brief Reads cells that tables of a file list by their points (or faces), one list per row.
 */
#ifndef camaron_CellLists_h
#define camaron_CellLists_h

#include "Intake/CellMesh/CellMeshPiece.h"
#include "Intake/Rows/TableRows.h"

#include <memory> // for rows
#include <vector> // for parts

namespace camaron
{
class CellLists
{
public:
  /// A table, its lists, and the cells that they become.
  struct Part
  {
    std::unique_ptr<TableRows> Rows;
    int List = -1; ///< property of the rows
    ListIds Expected{ "" };
    bool AreLines = false; ///< lists of more than two points become lines, not polygons
    /// Optional, for lists that the rows do not have: sets Ids, and their common size in Sizes.
    bool (*Load)(Part& part, const Progress& progress) = nullptr;

    ///@{
    /// Set by Read.
    ListSizes Sizes;
    std::vector<std::int32_t> Ids; ///< of loaded lists
    Tally Few[3];                  ///< lists of the rows without, with one and with two ids
    vtkIdType NumberOfLists = 0;
    vtkIdType NumberOfCells = 0;
    vtkIdType FirstCell = 0;
    Buffer<std::int32_t> Items; ///< cells of lists, -1 for none, unless all are consecutive
    vtkIdType GetCell(vtkIdType list) const
    {
      return this->Items.size() > 0 ? this->Items[list] : this->FirstCell + list;
    }
    ///@}
  };

  /**
   * Determines a piece of the cells of some tables and reads it. Other cells are not stored, except
   * loaded ones.
   * @param limit of the ids, which are points or faces
   * @param keepsEmpty whether empty lists become cells of type VTK_EMPTY_CELL, or are left out
   * @return false with an error set, or if aborted
   */
  bool Read(const std::vector<Part*>& parts, vtkIdType limit, bool keepsEmpty,
    const PieceRequest& request, CellMeshPiece& piece, const Progress& progress);

  CellMesh Mesh;
  vtkIdType NumberOfCells = 0; ///< of the file

private:
  bool Measure(Part& part, bool keepsEmpty, const Progress& progress);
  void Allocate(const std::vector<Part*>& parts, const CellMeshPiece& piece);
  bool Fill(const Part& part, bool isAlone, const CellMeshPiece& piece, vtkIdType& firstId,
    const Progress& progress);
};
}

#endif
