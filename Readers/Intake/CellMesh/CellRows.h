// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellRows.h
 * @brief Reads cells of several types or sizes from rows of text in parallel.
 *
 * For cells of one type, fill CellMesh::Connectivity by RowSequence::ForEach.
 */
#ifndef camaron_CellRows_h
#define camaron_CellRows_h

#include "Intake/CellMesh/CellMesh.h"
#include "Intake/Rows/TextRows.h"

#include <vector> // for cells whose number of points is not known before

namespace camaron
{
/// Receives the cells of consecutive rows.
class CellSink
{
public:
  /// Begins a cell of a type, without points.
  void BeginCell(unsigned char type)
  {
    this->Types.push_back(type);
    this->Sizes.push_back(0);
  }
  /// Adds a point to the last cell.
  void AddPoint(std::int32_t point)
  {
    this->Points.push_back(point);
    ++this->Sizes.back();
  }
  /// Adds a cell.
  void AddCell(unsigned char type, const std::vector<std::int32_t>& points)
  {
    this->Types.push_back(type);
    this->Sizes.push_back(static_cast<std::int32_t>(points.size()));
    this->Points.insert(this->Points.end(), points.begin(), points.end());
  }

  vtkIdType GetNumberOfCells() const { return static_cast<vtkIdType>(this->Types.size()); }

private:
  friend bool FillCells(std::vector<CellSink>& sinks, CellMesh& mesh, ScanError& error);
  std::vector<unsigned char> Types;
  std::vector<std::int32_t> Sizes; ///< numbers of points of the cells
  std::vector<std::int32_t> Points;
};

/**
 * Moves the cells of all sinks to @a mesh. False if they have too many points for 32-bit offsets.
 */
bool FillCells(std::vector<CellSink>& sinks, CellMesh& mesh, ScanError& error);

/// The same with the error in the scanner.
template <typename Scanner>
bool FillCells(std::vector<CellSink>& sinks, CellMesh& mesh, Scanner& scanner)
{
  ScanError error;
  const bool good = FillCells(sinks, mesh, error);
  if (!good)
  {
    scanner.FailAt(scanner.GetPosition(), error.Kind, error.Message, "more");
  }
  return good;
}

/**
 * Reads rows by @a visit(row, TextRow&, CellSink&), which adds one cell per row, returns false on
 * errors, and must be thread-safe. Sets the cells of @a mesh, but not its number of points. False
 * with the error in the scanner, or if stopped.
 */
template <typename Visit>
bool ReadCells(const RowSequence& rows, CellMesh& mesh, const Progress& progress, Visit&& visit)
{
  std::vector<CellSink> sinks(rows.GetNumberOfParts());
  return rows.ForEach(progress, [&](vtkIdType row, vtkIdType part, TextRow& text)
           { return visit(row, text, sinks[static_cast<std::size_t>(part)]); }) &&
    FillCells(sinks, mesh, rows.GetScanner());
}
}

#endif
