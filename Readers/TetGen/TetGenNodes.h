// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TetGenNodes
 * @brief The table of nodes of a .node file, or of the first part of a .poly or .smesh file.
 *
 * Ids may be any and in any order. If the whole mesh is wanted all is read at once; for a piece ids
 * are read first, and when it is known which nodes it needs, their values.
 */
#ifndef camaron_TetGenNodes_h
#define camaron_TetGenNodes_h

#include "Base/IdMap.h"
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
  /// Whether the scanner is at a row that fits the header. Reports nothing.
  static bool IsRow(TextScanner scanner, const Header& header);

  /// Reads the table from its header to its end; with all values if @a whole, else ids only.
  bool Read(TextScanner& scanner, const TextLines* lines, bool whole, const Progress& progress);
  /// Reads the values of the points of a piece, the scanner being at the header.
  bool ReadValues(TextScanner& scanner, const TextLines* lines, const CellMeshPiece& piece,
    const Progress& progress);

  vtkIdType GetCount() const { return this->Ids.size(); }
  int GetDimension() const { return this->Table.Dimension; }

  /// Reads the id of a node of this table, as its row.
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
  /// Row of a node, -1 if there is no such id.
  std::int32_t Find(std::int64_t id) const { return this->Map.Find(id); }

  ///@{
  /**
   * Coordinates of some nodes, also of those that are not in a piece: asked for before the values
   * are read, and found in the same order afterwards.
   */
  void Ask(const std::vector<std::int32_t>& rows) { this->Asked = rows; }
  void GetAnswer(double (*x)[3]) const;
  ///@}

  /// Makes points of the coordinates, which are gone then.
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
  std::vector<double> Answer; ///< if they may not be among the coordinates
};
}

#endif
