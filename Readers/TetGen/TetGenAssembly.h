// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TetGenAssembly
 * @brief Assembles a mesh, or a piece of it, from its files.
 *
 * A file may be read in several passes, each of them within ReadText.
 */
#ifndef camaron_TetGenAssembly_h
#define camaron_TetGenAssembly_h

#include "Intake/Pieces/PieceRequest.h"
#include "TetGenNeighbors.h"

#include <string> // for messages

namespace camaron
{
class TetGenAssembly
{
public:
  TetGenAssembly(const PieceRequest& request, vtkUnstructuredGrid* grid, vtkIdType chunk,
    Warnings& warnings, ScanError& error)
    : Request(request)
    , Grid(grid)
    , Chunk(chunk)
    , Messages(warnings)
    , Error(error)
  {
  }

  /// Reads points, each of which becomes a cell.
  bool ReadCloud(const MappedFile& nodes, const Progress& progress);
  /// Reads cells of one type, and their neighbors if that file is given.
  bool ReadTable(const MappedFile& cells, TetGenKind kind, const MappedFile& nodes,
    const MappedFile* neighbors, const Progress& progress);
  /// Reads facets, or segments in 2D; @a nodes may be the same file.
  bool ReadComplex(
    const MappedFile& file, bool isSmesh, const MappedFile& nodes, const Progress& progress);

private:
  template <typename Read>
  bool ReadFile(const MappedFile& file, const Progress& progress, Read&& read)
  {
    return ReadText(file, '#', this->Chunk, this->Error, progress, read);
  }
  bool IsWhole() const { return this->Request.NumberOfPieces <= 1; }
  bool ReadNodes(const MappedFile& file, bool isLast, const Progress& progress);
  bool ReadNeighbors(const MappedFile& file, const TetGenCells& cells, const Progress& progress);
  void OrderMidpoints(CellMesh& mesh, int corners);
  bool Fill(const MappedFile& nodes, CellMesh& mesh, int corners, const Progress& progress);
  bool FillCloud(const MappedFile& nodes, const Progress& progress);
  bool FinishTable(
    TetGenCells& cells, const MappedFile& nodes, bool hasNeighbors, const Progress& progress);
  void WarnOfMore(TextScanner& scanner, const MappedFile& file);

  PieceRequest Request;
  vtkUnstructuredGrid* Grid;
  vtkIdType Chunk;
  Warnings& Messages;
  ScanError& Error;
  TetGenNodes Nodes;
  TetGenNeighbors Neighbors;
  CellMeshPiece Piece;
  std::ptrdiff_t EndOfNodes = 0; ///< in their file
  std::string More;              ///< warning about data after the end
};
}

#endif
