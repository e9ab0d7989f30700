// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PLYRows.h
 * @brief The rows of an element of a PLY file in any encoding.
 *
 * Rows are located first and then read as often as needed, in parallel, each time only the
 * requested properties: what a row becomes (a point, a cell, nothing) depends on others.
 */
#ifndef camaron_PLYRows_h
#define camaron_PLYRows_h

#include "Base/Buffer.h"
#include "Base/Progress.h"
#include "Intake/Ids/IdSet.h"
#include "PLYHeader.h"

#include <atomic> // for counts
#include <memory> // for rows
#include <vector> // for columns

namespace camaron
{
class PLYLists;

/// Conversion of a value for an array.
enum class PLYConversion : unsigned char
{
  Value, ///< the same value, perhaps in another type
  Color  ///< a value from 0 to 255: integers unchanged, real numbers scaled from 0 to 1
};

/// The target of the values of a property; of a list, of one of its items or of its length.
struct PLYColumn
{
  int Property;
  int Item; ///< of a list; -1 for its length
  PLYConversion Conversion;
  PLYType Type; ///< of the array: that of the property, a real type, or UInt8 for colors
  void* Values; ///< of the component of the first tuple
  int Stride;   ///< values from tuple to tuple
};

/// The array of lists that are not points or faces: it has the number of components of the longest
/// list.
struct PLYListShape
{
  std::int32_t Components = 0; ///< 0 for no array
  bool Varies = false;         ///< some are shorter
};

/// The tuple for each row: its position in the mesh, and from that in a piece of the mesh.
struct PLYTargets
{
  vtkIdType First = 0;                  ///< position of the first row; the others follow
  const std::int32_t* Items = nullptr;  ///< positions of rows if they do not, -1 for none
  const IdSet* Kept = nullptr;          ///< positions that a piece has, in its order
  const std::int32_t* Places = nullptr; ///< index in the piece for each position, -1 for none

  /// Whether all rows become consecutive tuples.
  bool AreRows() const { return !this->Items && !this->Kept && !this->Places; }
  vtkIdType Find(vtkIdType row) const
  {
    const vtkIdType item = this->Items ? this->Items[row] : this->First + row;
    if (item < 0)
    {
      return -1;
    }
    return this->Places            ? this->Places[item]
      : !this->Kept                ? item
      : this->Kept->Contains(item) ? this->Kept->GetNumber(item)
                                   : -1;
  }
};

/// Lengths of the lists of a property.
struct PLYSizes
{
  std::int32_t Common = -1;     ///< length of all lists, or -1
  Buffer<std::int32_t> Offsets; ///< of consecutive lists, and one more; may be empty if there is a
                                ///< common size
  vtkIdType Total = 0;
  std::int32_t Least = 0; ///< length of the shortest list

  vtkIdType GetOffset(vtkIdType row) const
  {
    return this->Offsets.size() > 0 ? this->Offsets[row] : row * this->Common;
  }
  vtkIdType GetSize(vtkIdType row) const
  {
    return this->Common >= 0 ? this->Common : this->Offsets[row + 1] - this->Offsets[row];
  }
  /// Converts sizes to offsets; the size of row i is in Offsets at i + 1. False if they are too
  /// large.
  bool Finish();
};

/// Valid ids in a list.
struct PLYIds
{
  const char* What;       ///< e.g. "a vertex of a face"
  vtkIdType Limit = 0;    ///< ids must be in [0, Limit)
  bool HasBreaks = false; ///< or -1; for unsigned types the largest value
};

class PLYRows
{
public:
  virtual ~PLYRows() = default;
  const PLYElement& GetElement() const { return this->Element; }
  vtkIdType GetCount() const { return this->Element.Count; }

  /// Moves the scanner to the end of the rows; checks that the file is long enough.
  virtual bool Locate(const Progress& progress) = 0;
  /// Checks rows from which nothing has been read so far.
  virtual bool Check(const Progress& progress) = 0;
  /// Reads the lengths of the lists of a property.
  virtual bool ReadSizes(int property, PLYSizes& sizes, const Progress& progress) = 0;
  /// Reads the lists of a property.
  virtual bool ReadIds(
    int property, const PLYIds& expected, const PLYLists& lists, const Progress& progress) = 0;
  virtual bool ReadColumns(
    const std::vector<PLYColumn>& columns, const PLYTargets& targets, const Progress& progress) = 0;
  /// Sets the error for a property of a row; returns false.
  virtual bool FailAt(vtkIdType row, int property, ErrorKind kind, const std::string& expected,
    const std::string& found) = 0;
  /// Rows with more values than the header declares.
  const Tally& GetLongRows() const { return this->LongRows; }
  /// Number of color values read that are out of range.
  vtkIdType CountOddColors() const { return this->OddColors; }

protected:
  explicit PLYRows(const PLYElement& element)
    : Element(element)
  {
  }
  static std::string DescribeIds(const PLYIds& expected);

  PLYElement Element;
  Tally LongRows;
  mutable std::atomic<vtkIdType> OddColors{ 0 };
};
}

#endif
