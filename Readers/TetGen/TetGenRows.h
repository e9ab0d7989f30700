// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetGenRows.h
 * @brief What the tables of TetGen's files have in common: headers, ids, attributes and markers.
 */
#ifndef camaron_TetGenRows_h
#define camaron_TetGenRows_h

#include "Base/IdSet.h"
#include "CellMesh/CellMeshPiece.h"
#include "Scan/TextRows.h"

#include <atomic> // for what threads find
#include <vector> // for columns

class vtkDataSetAttributes;

namespace camaron
{
/**
 * Reads the numbers of the first line of a table; those that it lacks at its end stay as they are.
 * @param kind of the error if there is no number at all
 */
bool ReadTetGenHeader(
  TextScanner& scanner, std::int64_t* numbers, int size, ErrorKind kind, const char* expected);

/// More attributes than any file has; each becomes an array.
constexpr int MaxTetGenAttributes = 1000;

/// Reads an id, or a marker, of 32 bits.
bool ReadTetGenInteger(TextRow& row, std::int32_t& value, const char* what);
/// Reads an id that is not negative.
bool ReadTetGenId(TextRow& row, std::int32_t& id, const char* what);

/**
 * @class camaron::TetGenUnmarked
 * @brief Rows without the marker that the header of their table promises, however often they are
 * read.
 */
class TetGenUnmarked
{
public:
  /// Starts anew, for a table of so many rows.
  void Start(vtkIdType rows) { this->Rows = IdSet(rows); }
  /// Any thread may.
  void Add(vtkIdType row) { this->Rows.Add(row); }
  /// Warns of them, named as in "node", "nodes".
  void Warn(Warnings& warnings, const char* one, const char* many) const;

private:
  IdSet Rows;
};

/**
 * @class camaron::TetGenColumns
 * @brief The columns after the ids and coordinates of a row: attributes, a marker, adjacent
 * tetrahedra.
 *
 * The type of an array must be the same in all pieces, so all rows are looked at, and the values of
 * some are kept.
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

  /// Starts anew, for a table of so many rows, without room for values.
  void Start(const Layout& layout, vtkIdType rows);
  /// Provides room for so many rows.
  void Allocate(vtkIdType size);

  /// Reads a row of the file; @a index is where its values go, -1 to drop them. Any thread may.
  bool Read(TextRow& row, vtkIdType number, vtkIdType index);

  /**
   * Makes arrays: "attr_0", "attr_1", ... (double), "BoundaryMarker" (int), "Tetrahedra" (int).
   * @param first name of the first attribute instead, which is int then if all values are integers
   */
  void AddTo(vtkDataSetAttributes* attributes, const char* first = nullptr);

  /// Warns of rows without marker, named as in "node", "nodes", and of values behind the last
  /// column.
  void Warn(Warnings& warnings, const char* one, const char* many) const;

private:
  Layout Columns;
  std::vector<Buffer<double>> Attributes;
  Buffer<std::int32_t> Markers;
  Buffer<std::int32_t> Tetrahedra;
  std::atomic<bool> FirstIsInteger{ true };
  TetGenUnmarked Unmarked;
  std::atomic<vtkIdType> Surplus{ VTK_ID_MAX }; ///< the first row with more values
};

/**
 * Adds ids of the file as an array, unless they count from 0 in the order of the file.
 * @param find where in the piece a row of the file is, or -1; @a size of them are kept
 */
template <typename Find>
void AddTetGenIds(vtkDataSetAttributes* attributes, const char* name, Buffer<std::int32_t>& ids,
  vtkIdType size, Find&& find);

/// Implementation of AddTetGenIds.
void AddIntegers(vtkDataSetAttributes* attributes, const char* name, Buffer<std::int32_t>&& values,
  int components = 1);

//------------------------------------------------------------------------------
template <typename Find>
void AddTetGenIds(vtkDataSetAttributes* attributes, const char* name, Buffer<std::int32_t>& ids,
  vtkIdType size, Find&& find)
{
  vtkIdType same = 0;
  while (same < ids.size() && ids[same] == same)
  {
    ++same;
  }
  if (same == ids.size())
  {
    return;
  }
  if (size == ids.size())
  {
    AddIntegers(attributes, name, std::move(ids));
    return;
  }
  Buffer<std::int32_t> kept(size);
  for (vtkIdType i = 0; i < ids.size(); ++i)
  {
    if (const vtkIdType index = find(i); index >= 0)
    {
      kept[index] = ids[i];
    }
  }
  AddIntegers(attributes, name, std::move(kept));
}
}

#endif
