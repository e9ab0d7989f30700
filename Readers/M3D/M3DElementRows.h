// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::M3DElementRows
 * @brief Reads the rows of elements of M3D, M2D and MVM files.
 */
#ifndef camaron_M3DElementRows_h
#define camaron_M3DElementRows_h

#include "Intake/CellMesh/CellMeshPiece.h"
#include "Intake/Rows/TextRows.h"
#include "M3DElements.h"

namespace camaron
{
class M3DElementRows
{
public:
  M3DElementRows(M3DDialect dialect, vtkIdType numberOfNodes, RowLayout layout)
    : Dialect(dialect)
    , NumberOfNodes(numberOfNodes)
    , Layout(layout)
  {
  }

  /// Reads a row up to its material, with nodes in the order of the file; nullptr if it is invalid.
  const ElementKind* ReadElement(TextRow& row, std::int32_t* nodes) const;

  /**
   * Sets the points and cells of @a mesh to those of a piece, which is determined, and passes the
   * rest of each row, after the nodes, to @a materials. False with the error in the scanner, or if
   * aborted.
   */
  bool Read(TextScanner& scanner, const TextLines* lines, vtkIdType count,
    const PieceRequest& request, CellMeshPiece& piece, CellMesh& mesh, MaterialTally& materials,
    const Progress& progress) const;

private:
  /// Reads the letters first, so that nodes are stored only once.
  bool ReadWhole(TextScanner& scanner, const TextLines* lines, vtkIdType count, CellMesh& mesh,
    MaterialTally& materials, const Progress& progress) const;
  bool ReadPiece(TextScanner& scanner, const TextLines* lines, const Buffer<unsigned char>& types,
    const CellMeshPiece& piece, CellMesh& mesh, MaterialTally& materials,
    const Progress& progress) const;
  const ElementKind* ReadKind(TextRow& row, bool& hasNumber) const;
  const ElementKind* ReadSize(TextRow& row) const;
  const ElementKind* ReadCell(TextRow& row, std::int32_t* points, MaterialTally& materials) const;
  bool ReadInParallel(const TextLines& lines, const TextLines::Section& section, char comment,
    CellMesh& mesh, MaterialTally& materials, const Progress& progress) const;
  bool ReadOneByOne(
    TextScanner& scanner, CellMesh& mesh, MaterialTally& materials, const Progress& progress) const;

  std::int32_t GetSize(unsigned char type) const
  {
    return FindElementKind(type, this->Dialect)->NumberOfNodes;
  }

  M3DDialect Dialect;
  vtkIdType NumberOfNodes;
  RowLayout Layout;
};
}

#endif
