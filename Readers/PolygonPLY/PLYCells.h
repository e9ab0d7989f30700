// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PLYCells
 * @brief The cells that elements of a PLY file become: faces, triangle strips and edges.
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
   * Reads the cells of some elements; sets their positions in the mesh.
   * @param keepsEmpty whether lists without vertices become cells of type VTK_EMPTY_CELL
   * @return false with an error set, or if aborted
   */
  bool Read(const std::vector<PLYPart*>& parts, vtkIdType numberOfPoints, bool keepsEmpty,
    const Progress& progress);

  /**
   * Determines a piece of the cells of some elements and reads it; lists without vertices are left
   * out. Other cells are not stored, except edges and strips. The piece is not set if there are no
   * cells.
   */
  bool ReadPiece(const std::vector<PLYPart*>& parts, vtkIdType numberOfPoints,
    const PieceRequest& request, CellMeshPiece& piece, const Progress& progress);

  CellMesh Mesh;
  vtkIdType NumberOfCells = 0; ///< of the file
  Tally Empty;                 ///< lists without vertices
  Tally Short;                 ///< lists with one or two

private:
  struct Extent; // of a part, before the mesh is allocated
  bool Measure(const std::vector<PLYPart*>& parts, std::vector<Extent>& extents,
    vtkIdType numberOfPoints, const Progress& progress);
  bool MeasurePart(PLYPart& part, Extent& extent, const Progress& progress);
  bool MeasureStrips(PLYPart& part, Extent& extent, const Progress& progress);
  PLYIds GetExpected(const PLYPart& part) const;
  bool ReadEdges(PLYPart& part, std::int32_t* ids, const Progress& progress);
  void FillStrips(PLYPart& part, const Extent& extent, std::int32_t* ids);
  bool FillPart(PLYPart& part, Extent& extent, vtkIdType firstId, const Progress& progress);
  bool PassPart(PLYPart& part, const Extent& extent, CellMeshPiece& piece, CellMesh* mesh,
    const Progress& progress);
  bool HasOneKind(const std::vector<PLYPart*>& parts, const std::vector<Extent>& extents) const;
  bool Fill(
    const std::vector<PLYPart*>& parts, std::vector<Extent>& extents, const Progress& progress);
  void AllocatePiece(const std::vector<PLYPart*>& parts, const std::vector<Extent>& extents,
    const CellMeshPiece& piece);
  void CountFaces(PLYPart& part, Extent& extent);

  vtkIdType NumberOfPoints = 0; ///< of the file
  bool KeepsEmpty = false;
};

/// The lists of all cells in the form n id1 ... idn.
Buffer<std::int32_t> MakeWords(const CellMesh& mesh);
}

#endif
