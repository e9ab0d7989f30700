// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PLYColumns.h
 * @brief Puts values of arrays into the rows of a PLY file.
 */
#ifndef camaron_PLYColumns_h
#define camaron_PLYColumns_h

#include "Base/Bytes.h"
#include "Base/Number.h"
#include "PLYTypes.h"
#include "Scan/ScanError.h"

#include "vtkSmartPointer.h" // for arrays that are put in order first

#include <set>    // for names
#include <string> // for bytes
#include <vector> // for columns

class vtkDataArray;
class vtkDataSetAttributes;

namespace camaron
{
/// Appends numbers in the encoding of a file.
class PLYEncoder
{
public:
  enum class Encoding
  {
    Text = 0,
    LittleEndian = 1,
    BigEndian = 2
  };
  explicit PLYEncoder(Encoding encoding)
    : Text(encoding == Encoding::Text)
    , Swap((encoding == Encoding::BigEndian) != (GetByteOrder() == ByteOrder::Big))
  {
  }

  template <typename Number>
  void Append(std::string& bytes, Number number) const
  {
    if (this->Text)
    {
      AppendNumber(bytes, number);
      bytes += ' ';
    }
    else
    {
      AppendBytes(bytes, number, this->Swap);
    }
  }
  /// Ends a row of at least one number.
  void EndRow(std::string& bytes) const
  {
    if (this->Text)
    {
      bytes.back() = '\n';
    }
  }

private:
  bool Text;
  bool Swap;
};

/**
 * @class camaron::PLYColumns
 * @brief The arrays of points or of cells as properties.
 *
 * Normals, colors and texture coordinates have their usual names. Other arrays have theirs, with
 * what cannot be in a name replaced by `_`, and more of these where another array has that name,
 * with a warning; those of several components become `name_0`, `name_1`
 * and so on, of which a comment "components name number" tells. Integers of 64 bits become `int` or
 * `uint` if all values fit, else `double`.
 */
class PLYColumns
{
public:
  PLYColumns() = default;
  /**
   * @param reserved names of properties that mean something else
   * @param written gets the names of all arrays that have become properties
   */
  PLYColumns(vtkDataSetAttributes* attributes, std::set<std::string> reserved,
    std::vector<std::string>& written, Warnings& warnings);

  bool IsEmpty() const { return this->Columns.empty(); }
  /// Lines of the header: comments, and properties.
  const std::string& GetComments() const { return this->Comments; }
  std::string GetProperties() const;

  /// Appends the values of a tuple; those of -1 are nan, or 0 in integers.
  void Append(const PLYEncoder& encoder, std::string& bytes, vtkIdType tuple) const
  {
    for (const Column& column : this->Columns)
    {
      column.Append(
        encoder, bytes, column.Values, tuple < 0 ? -1 : tuple * column.Stride + column.Component);
    }
  }

private:
  using AppendFunction = void (*)(
    const PLYEncoder& encoder, std::string& bytes, const void* values, vtkIdType index);
  struct Column
  {
    std::string Name;
    PLYType Type;
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
  PLYType ChooseType(vtkDataArray* array, PLYType type);

  Warnings* Messages = nullptr;
  std::set<std::string> Names;
  std::set<std::string> Reserved; ///< by arrays whose names need no change
  std::string Renamed;            ///< which arrays have got which names
  std::string Comments;
  std::vector<Column> Columns;
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays; ///< that the columns point into
};
}

#endif
