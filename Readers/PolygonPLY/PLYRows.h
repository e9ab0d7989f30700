// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PLYRows.h
 * @brief The rows of an element of a PLY file, whatever the encoding.
 *
 * Rows are located first and then read as often as needed, each time only what is wanted and in
 * parallel: what a row becomes (a point, a cell, nothing) is known when others have been read.
 */
#ifndef camaron_PLYRows_h
#define camaron_PLYRows_h

#include "Base/Buffer.h"
#include "Base/IdSet.h"
#include "Base/Progress.h"
#include "PLYHeader.h"

#include <atomic> // for counts
#include <memory> // for rows
#include <vector> // for columns

namespace camaron
{
class PLYLists;

/// What becomes of a value on its way into an array.
enum class PLYConversion : unsigned char
{
  Value, ///< it stays, perhaps in another type
  Color  ///< it becomes one of 0 ... 255: integers as they are, real numbers from 0 ... 1
};

/// Where the values of a property go; of a list, those of one of its items, or its length.
struct PLYColumn
{
  int Property;
  int Item; ///< of a list; -1 for its length
  PLYConversion Conversion;
  PLYType Type; ///< of the array: that of the property, a real type, or UInt8 for colors
  void* Values; ///< of the component of the first tuple
  int Stride;   ///< values from tuple to tuple
};

/// What lists that are no points or faces become: an array with as many components as the longest
/// one has items.
struct PLYListShape
{
  std::int32_t Components = 0; ///< 0 for no array
  bool Varies = false;         ///< some are shorter
};

/// Which tuple a row becomes: position in a mesh, and of that in a piece of the mesh.
struct PLYTargets
{
  vtkIdType First = 0;                  ///< position of the first row; the others follow
  const std::int32_t* Items = nullptr;  ///< positions of rows where they do not, -1 for none
  const IdSet* Kept = nullptr;          ///< positions that a piece has, in its order
  const std::int32_t* Places = nullptr; ///< of positions in the piece, -1 for none

  /// Whether all rows become tuples one after the other.
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

/// How long the lists of a property are.
struct PLYSizes
{
  std::int32_t Common = -1;     ///< length of all lists, or -1
  Buffer<std::int32_t> Offsets; ///< of the lists one after the other, and one more; perhaps none if
                                ///< there is a common size
  vtkIdType Total = 0;
  std::int32_t Least = 0; ///< no list is shorter

  vtkIdType GetOffset(vtkIdType row) const
  {
    return this->Offsets.size() > 0 ? this->Offsets[row] : row * this->Common;
  }
  vtkIdType GetSize(vtkIdType row) const
  {
    return this->Common >= 0 ? this->Common : this->Offsets[row + 1] - this->Offsets[row];
  }
  /// Makes offsets of sizes, of which Offsets has that of row i at i + 1; false if they are too
  /// large.
  bool Finish();
};

/// Which ids a list may hold.
struct PLYIds
{
  const char* What;       ///< e.g. "a vertex of a face"
  vtkIdType Limit = 0;    ///< ids must be in [0, Limit)
  bool HasBreaks = false; ///< or -1, in an unsigned type its largest value
};

class PLYRows
{
public:
  virtual ~PLYRows() = default;
  const PLYElement& GetElement() const { return this->Element; }
  vtkIdType GetCount() const { return this->Element.Count; }

  /// Finds the end of the rows, to which the scanner is moved; checks that the file has so much.
  virtual bool Locate(const Progress& progress) = 0;
  /// Makes sure that rows are as the header says that nothing was read of so far.
  virtual bool Check(const Progress& progress) = 0;
  /// Reads how long the lists of a property are.
  virtual bool ReadSizes(int property, PLYSizes& sizes, const Progress& progress) = 0;
  /// Reads the lists of a property.
  virtual bool ReadIds(
    int property, const PLYIds& expected, const PLYLists& lists, const Progress& progress) = 0;
  virtual bool ReadColumns(
    const std::vector<PLYColumn>& columns, const PLYTargets& targets, const Progress& progress) = 0;
  /// Says what is wrong with a property of a row; returns false.
  virtual bool FailAt(vtkIdType row, int property, ErrorKind kind, const std::string& expected,
    const std::string& found) = 0;
  /// Rows that hold more than the header says.
  const Tally& GetLongRows() const { return this->LongRows; }
  /// Values of colors that have been read for which there is no color.
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
