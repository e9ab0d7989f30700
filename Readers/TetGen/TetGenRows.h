// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetGenRows.h
 * @brief Common parts of the tables of TetGen files: headers, ids, attributes and markers.
 */
#ifndef camaron_TetGenRows_h
#define camaron_TetGenRows_h

#include "Intake/CellMesh/CellMeshPiece.h"
#include "Intake/Ids/IdSet.h"
#include "Intake/Rows/TextRows.h"

#include <atomic> // for what threads find
#include <vector> // for columns

class vtkDataSetAttributes;

namespace camaron
{
/// Least size of a number: a digit and a blank or line end.
constexpr int BytesPerNumber = 2;

/**
 * Reads the numbers of the first line of a table; missing ones at the end keep their values.
 * @param kind of the error if there is no number at all
 */
bool ReadTetGenHeader(
  TextScanner& scanner, std::int64_t* numbers, int size, ErrorKind kind, const char* expected);

/// Limit beyond that of real files; each attribute becomes an array.
constexpr int MaxTetGenAttributes = 1000;
/// Checks the number of attributes of items, e.g. "nodes"; false with the error in the scanner.
bool CheckTetGenAttributes(TextScanner& scanner, std::int64_t attributes, const char* items);

/// Whether the scanner is at a row that begins with so many ids and real numbers. Reports no
/// errors.
bool IsTetGenRow(TextScanner scanner, int ids, int reals);

/// Reads a 32-bit id or marker.
bool ReadTetGenInteger(TextRow& row, std::int32_t& value, const char* what);

/// Warns about rows, named as in "node", "nodes", without the marker that the header of their table
/// declares.
void WarnOfUnmarked(const IdSet& rows, Warnings& warnings, const char* one, const char* many);

/**
 * @class camaron::TetGenColumns
 * @brief The columns after the ids and coordinates of a row: attributes, a marker, adjacent
 * tetrahedra.
 *
 * The type of an array must be the same in all pieces, so all rows are read, and the values of some
 * are kept.
 */
class TetGenColumns
{
public:
  struct Layout
  {
    int Attributes = 0;
    bool Markers = false;
    int Tetrahedra = 0;
    bool IsEmpty() const
    {
      return this->Attributes == 0 && !this->Markers && this->Tetrahedra == 0;
    }
  };

  /// Starts anew, for a table with so many rows, without memory for values.
  void Start(const Layout& layout, vtkIdType rows);
  /// Allocates so many rows.
  void Allocate(vtkIdType size);

  /// Reads a row of the file; @a index is where to store its values, -1 to drop them. Thread-safe.
  bool Read(TextRow& row, vtkIdType number, vtkIdType index);

  /**
   * Adds arrays: "attr_0", "attr_1", ... (double), "BoundaryMarker" (int), "Tetrahedra" (int).
   * @param first other name for the first attribute, which is then int if all values are integers
   */
  void AddTo(vtkDataSetAttributes* attributes, const char* first = nullptr);

  /// Warns about rows without marker, named as in "node", "nodes", and about values after the last
  /// column.
  void Warn(Warnings& warnings, const char* one, const char* many) const;

private:
  Layout Columns;
  std::vector<Buffer<double>> Attributes;
  Buffer<std::int32_t> Markers;
  Buffer<std::int32_t> Tetrahedra;
  std::atomic<bool> FirstIsInteger{ true };
  IdSet Unmarked;                               ///< rows without marker
  std::atomic<vtkIdType> Surplus{ VTK_ID_MAX }; ///< the first row with more values
};

/// Adds an array of integers.
void AddIntegers(vtkDataSetAttributes* attributes, const char* name, Buffer<std::int32_t>&& values,
  int components = 1);
}

#endif
