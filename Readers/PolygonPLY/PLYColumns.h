// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PLYColumns.h
 * @brief Writes values of arrays into the rows of a PLY file.
 */
#ifndef camaron_PLYColumns_h
#define camaron_PLYColumns_h

#include "Intake/Rows/ValueTypes.h"
#include "Intake/Write/NumberEncoder.h"
#include "Scan/ScanError.h"

#include "vtkSmartPointer.h" // for arrays that are put in order first

#include <set>    // for names
#include <string> // for bytes
#include <vector> // for columns

class vtkDataArray;
class vtkDataSetAttributes;

namespace camaron
{
/**
 * @class camaron::PLYColumns
 * @brief The arrays of points or of cells as properties.
 *
 * Normals, colors and texture coordinates get their usual names. In the names of other arrays,
 * invalid characters are replaced by `_`, and more of these are appended to names that are already
 * used, with a warning. Arrays with several components become `name_0`, `name_1` and so on,
 * recorded in a comment "components name number". 64-bit integers become `int` or `uint` if all
 * values fit, else `double`.
 */
class PLYColumns
{
public:
  PLYColumns() = default;
  /**
   * @param reserved names of properties with a different meaning
   * @param written gets the names of all arrays that become properties
   */
  PLYColumns(vtkDataSetAttributes* attributes, std::set<std::string> reserved,
    std::vector<std::string>& written, Warnings& warnings);

  bool IsEmpty() const { return this->Columns.empty(); }
  /// Lines of the header: comments and properties.
  const std::string& GetComments() const { return this->Comments; }
  std::string GetProperties() const;

  /// Appends the values of a tuple; for -1, NaN, or 0 for integers.
  void Append(const NumberEncoder& encoder, std::string& bytes, vtkIdType tuple) const
  {
    for (const Column& column : this->Columns)
    {
      column.Append(
        encoder, bytes, column.Values, tuple < 0 ? -1 : tuple * column.Stride + column.Component);
    }
  }

private:
  using AppendFunction = void (*)(
    const NumberEncoder& encoder, std::string& bytes, const void* values, vtkIdType index);
  struct Column
  {
    std::string Name;
    ValueType Type;
    AppendFunction Append;
    const void* Values;
    vtkIdType Stride;
    int Component;
  };
  void Add(vtkDataArray* array, const std::vector<std::string>& names);
  void AddUsual(vtkDataArray* array, const char* name, const std::vector<std::string>& names);
  void AddRenamed(vtkDataArray* array, const std::string& name);
  void Reserve(vtkDataArray* array);
  void AddOther(vtkDataArray* array);
  ValueType ChooseType(vtkDataArray* array, ValueType type);

  Warnings* Messages = nullptr;
  std::set<std::string> Names;
  std::set<std::string> Reserved; ///< for arrays whose names need no change
  std::string Renamed;            ///< renamed arrays, for the warning
  std::string Comments;
  std::vector<Column> Columns;
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays; ///< to which the columns point
};
}

#endif
