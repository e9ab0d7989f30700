// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PLYCells
 * @brief The lists of ids that elements of a PLY file become: faces, triangle strips and edges, as
 * cells with points, or polyhedra, with faces.
 */
#ifndef camaron_PLYCells_h
#define camaron_PLYCells_h

#include "Intake/CellMesh/CellMeshPiece.h"
#include "PLYParts.h"

namespace camaron
{
class PLYCells
{
public:
  /**
   * Determines a piece of the cells of some elements and reads it; sets the positions of the
   * elements in the mesh. Other cells are not stored, except edges and strips.
   * @param limit of the ids, which are points or faces
   * @param keepsEmpty whether empty lists become cells of type VTK_EMPTY_CELL, or are left out
   * @return false with an error set, or if aborted
   */
  bool Read(const std::vector<PLYPart*>& parts, vtkIdType limit, bool keepsEmpty,
    const PieceRequest& request, CellMeshPiece& piece, const Progress& progress);

  CellMesh Mesh;
  vtkIdType NumberOfCells = 0; ///< of the file
  Tally Empty;                 ///< lists without vertices
  Tally Short;                 ///< lists with one or two

private:
  bool Measure(PLYPart& part, bool keepsEmpty, const Progress& progress);
  bool ReadStrips(PLYPart& part, const Progress& progress);
  bool ReadEdges(PLYPart& part, const Progress& progress);
  ListIds GetExpected(const PLYPart& part) const;
  void Allocate(const std::vector<PLYPart*>& parts, const CellMeshPiece& piece);
  bool Pass(const PLYPart& part, TableRows::TakeIds take, const TableRows::Needs* needs,
    std::int32_t* all, const Progress& progress) const;
  bool Fill(const PLYPart& part, bool isAlone, const CellMeshPiece& piece, vtkIdType& firstId,
    const Progress& progress);

  vtkIdType Limit = 0;
};
}

#endif
