// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TetGenNodes
 * @brief The table of nodes of a .node file, or of the first part of a .poly or .smesh file.
 *
 * Ids may be arbitrary and in any order. For the whole mesh everything is read at once; for a
 * piece, ids are read first, and values when it is known which nodes the piece needs.
 */
#ifndef camaron_TetGenNodes_h
#define camaron_TetGenNodes_h

#include "Intake/Ids/IdMap.h"
#include "TetGenRows.h"

class vtkUnstructuredGrid;

namespace camaron
{
class TetGenNodes
{
public:
  /// The first line: count, dimension, attributes, whether there are markers.
  struct Header
  {
    std::int64_t Count = 0;
    int Dimension = 3;
    TetGenColumns::Layout Columns;
  };
  static bool ReadHeader(TextScanner& scanner, Header& header);

  /// Reads the table from its header to its end: all values if @a whole, else ids only.
  bool Read(TextScanner& scanner, const TextLines* lines, bool whole, const Progress& progress);
  /// Passes all coordinates; the scanner is at the header.
  bool ForEach(TextScanner& scanner, const TextLines* lines, const PieceOfSpace::Visit& visit,
    const Progress& progress) const;
  /// Reads the values of the points of a piece; the scanner is at the header.
  bool ReadValues(TextScanner& scanner, const TextLines* lines, const CellMeshPiece& piece,
    const Progress& progress);

  vtkIdType GetCount() const { return this->Ids.size(); }
  int GetDimension() const { return this->Table.Dimension; }

  /// Reads the id of a node of this table, and returns its row in @a point.
  bool ReadPoint(TextRow& row, std::int32_t& point, const char* what) const
  {
    std::int64_t id;
    if (!row.ReadInteger(id, what))
    {
      return false;
    }
    point = this->Map.Find(id);
    return point >= 0 || this->FailAtId(row, what);
  }
  /// Row of a node, -1 if the id does not exist.
  std::int32_t Find(std::int64_t id) const { return this->Map.Find(id); }

  ///@{
  /**
   * Coordinates of some nodes, even if they are not in the piece: requested before the values are
   * read, and available in the same order afterwards.
   */
  void Ask(const std::vector<std::int32_t>& rows) { this->Asked = rows; }
  void GetAnswer(double (*x)[3]) const;
  ///@}

  /// Moves the coordinates into a point array; call once.
  vtkSmartPointer<vtkDataArray> TakePoints();
  /// Adds "attr_i", "BoundaryMarker", and "OriginalPointId" unless ids count from 0.
  void AddArrays(vtkUnstructuredGrid* grid, const CellMeshPiece& piece);
  void Warn(Warnings& warnings) const { this->Columns.Warn(warnings, "node", "nodes"); }

private:
  void Allocate(vtkIdType size);
  bool ReadValuesOf(TextRow& row, vtkIdType number, vtkIdType index);
  bool FailAtId(TextRow& row, const char* what) const;
  bool FailAtRepeated(TextScanner& scanner, const char* rows) const;

  Header Table;
  bool IsWhole = true;
  Buffer<std::int32_t> Ids;
  IdMap Map;
  Buffer<double> Coordinates;
  TetGenColumns Columns;
  std::vector<std::int32_t> Asked;
  std::vector<double> Answer; ///< if they may be missing among the coordinates
};
}

#endif
