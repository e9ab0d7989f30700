// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TableRows
 * @brief The rows of a table in text or in a binary file. All have the same properties: numbers,
 * and lists "n value1 ... valuen".
 *
 * Rows are located first and then read as often as needed, in parallel, each time only the
 * requested properties: what a row becomes (a point, a cell, nothing) depends on others. Both
 * encodings provide blocks of rows as bytes, which are read here: binary files in place, text
 * converted.
 */
#ifndef camaron_TableRows_h
#define camaron_TableRows_h

#include "Base/Buffer.h"
#include "Base/FunctionRef.h" // for parameters
#include "Base/Progress.h"
#include "Intake/Ids/IdSet.h"
#include "Intake/Rows/BinaryScanner.h"
#include "Intake/Rows/Bytes.h"
#include "Intake/Rows/ListRows.h"
#include "Intake/Rows/TextRows.h" // for the layout of rows
#include "Intake/Rows/ValueTypes.h"

#include <algorithm>   // for ranges
#include <atomic>      // for counts
#include <cmath>       // for real ids
#include <cstdlib>     // for ids with signs
#include <memory>      // for rows
#include <optional>    // for the byte order
#include <string>      // for names
#include <type_traits> // for the kinds of types
#include <vector>      // for columns

namespace camaron
{
/// What each row of a table has, one after the other.
struct TableProperty
{
  std::string Name;
  ValueType Type;
  bool IsList = false;
  ValueType CountType = ValueType::UInt8; ///< of the length of a list
  int Length = 1;                         ///< values of a binary row, unless it is a list

  /// Bytes before the values.
  int GetHeaderSize() const { return this->IsList ? GetSize(this->CountType) : 0; }
};

struct Table
{
  std::string Name; ///< of a row, e.g. "face"; errors about ids do not name rows without a name
  vtkIdType Count = 0;
  std::vector<TableProperty> Properties; ///< the name of a list is a plural, e.g. "points"
  bool HasNamesOfFile = false; ///< whether messages quote these names, as the file has them, too
};

/// Conversion of a value for an array.
enum class ValueConversion : unsigned char
{
  Value, ///< the same value, perhaps in another type
  Color  ///< a value from 0 to 255: integers unchanged, real numbers scaled from 0 to 1
};

/// The target of the values of a property; of several values, of one of them; of a list, of one of
/// its items or of its length.
struct TableColumn
{
  int Property;
  int Item; ///< of several values or a list; -1 for a single value or the length of a list
  ValueConversion Conversion;
  ValueType Type; ///< of the array: that of the property, a real type, or UInt8 for colors
  void* Values;   ///< of the component of the first tuple
  int Stride;     ///< values from tuple to tuple
};

/// The tuple for each row: its position in the mesh, and from that in a piece of the mesh.
struct TableTargets
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
struct ListSizes
{
  std::int32_t Common = -1;     ///< length of all lists, or -1
  Buffer<std::int32_t> Offsets; ///< of consecutive lists, and one more, unless there is a common
                                ///< length
  vtkIdType Total = 0;

  vtkIdType GetOffset(vtkIdType row) const
  {
    return this->Common >= 0 ? row * this->Common : this->Offsets[row];
  }
  vtkIdType GetSize(vtkIdType row) const
  {
    return this->Common >= 0 ? this->Common : this->Offsets[row + 1] - this->Offsets[row];
  }
  /// Converts sizes to offsets; the size of row i is in Offsets at i + 1. If they are too large,
  /// only sets their total.
  void Finish();
};

/// Valid ids in a list.
struct ListIds
{
  static constexpr vtkIdType Any = -1; ///< limit for words that are not ids
  const char* What;                    ///< e.g. "a vertex of a face"
  vtkIdType Limit = 0;                 ///< how many ids there are: 0, 1, ...
  bool HasBreaks = false;              ///< or -1
  /// Ids count from 1 and are passed from 0.
  bool AreFromOne = false;
  /// Ids count from 1 and may have a sign: they are passed as they are.
  bool HaveSigns = false;

  static ListIds FromOne(const char* what, vtkIdType limit) { return { what, limit, false, true }; }
  static ListIds WithSigns(const char* what, vtkIdType limit)
  {
    return { what, limit, false, false, true };
  }
  bool Contain(std::int32_t id) const
  {
    const std::int64_t number = this->HaveSigns ? std::abs(std::int64_t(id)) : id;
    const bool isFromOne = this->AreFromOne || this->HaveSigns;
    return (number >= (isFromOne ? 1 : 0) && number < this->Limit + (isFromOne ? 1 : 0)) ||
      (this->HasBreaks && id == -1);
  }
};

class TableRows
{
public:
  virtual ~TableRows() = default;
  const Table& GetTable() const { return this->Description; }
  vtkIdType GetCount() const { return this->Description.Count; }

  ///@{
  /// False with the error in the scanner, or if stopped; for text read in parallel, errors are left
  /// to reading without lines.

  /// Moves the scanner to the end of the rows; checks that the file is long enough.
  virtual bool Locate(const Progress& progress) = 0;
  /// Checks rows from which nothing has been read so far.
  virtual bool Check(const Progress& progress) = 0;
  /// Reads the lengths of the lists of a property.
  virtual bool ReadSizes(int property, ListSizes& sizes, const Progress& progress) = 0;

  /// Whether any of these rows is needed.
  using Needs = FunctionRef<bool(vtkIdType first, vtkIdType count)>;
  /// Receives the concatenated lists of some rows.
  using TakeIds = FunctionRef<void(vtkIdType first, vtkIdType count, const std::int32_t* ids)>;
  /**
   * Reads the lists of a property, or the values of one that is not a list, and passes them in
   * parallel.
   * @param sizes of the lists; 1 for values
   * @param all optional: where to store all lists
   * @param needs optional: other rows may be skipped
   */
  bool ReadIds(int property, const ListIds& expected, const ListSizes& sizes, std::int32_t* all,
    TakeIds take, const Needs* needs, const Progress& progress);
  /// Reads the lists of a property and stores them all.
  bool ReadLists(int property, const ListIds& expected, ListSizes& sizes, Buffer<std::int32_t>& all,
    const Progress& progress);
  bool ReadColumns(
    const std::vector<TableColumn>& columns, const TableTargets& targets, const Progress& progress);
  /// Passes three properties of every row in parallel, in single precision; 0 for -1. If they are
  /// one property, these are its first three values.
  bool ForEachPoint(
    const std::vector<int>& properties, FunctionRef<void(vtkIdType row, const double* x)> visit);
  ///@}

  ///@{
  /// Sets the error for all rows, or for one, which has a line of its own in text; returns false.
  virtual bool Fail(ErrorKind kind, const std::string& expected, const std::string& found) = 0;
  virtual bool FailInRow(
    vtkIdType, ErrorKind kind, const std::string& expected, const std::string& found)
  {
    return this->Fail(kind, expected, found);
  }
  ///@}
  ///@{
  /// Rows with more values than the header declares; known when the rows have been read.
  const Tally& GetLongRows() const { return this->LongRows; }
  bool RefuseLongRows()
  {
    return this->LongRows.Count == 0 ||
      this->FailInRow(this->LongRows.First, ErrorKind::Syntax, "rows of their declared length",
        "more in " + this->Description.Name + " " + std::to_string(this->LongRows.First) +
          FromZero);
  }
  ///@}
  /// Number of color values read that are out of range.
  vtkIdType CountOddColors() const { return this->OddColors; }

protected:
  explicit TableRows(const Table& table, bool swap)
    : Description(table)
    , Stored(table.Properties)
    , Swap(swap)
  {
  }

  /// What to read of which rows.
  struct Request
  {
    std::vector<bool> Properties;
    int End = 0;                 ///< after the last one
    const Needs* Rows = nullptr; ///< others may be skipped

    explicit Request(const TableRows& rows)
      : Properties(rows.Stored.size(), false)
    {
    }
    void Add(int property)
    {
      this->Properties[property] = true;
      this->End = property < this->End ? this->End : property + 1;
    }
  };

  /// Places of a property in consecutive rows.
  struct Places
  {
    const char* Begin = nullptr; ///< of rows of one length
    std::ptrdiff_t Stride = 0;
    const char* const* Others = nullptr; ///< of other rows

    template <typename Visit>
    void ForEach(int count, Visit&& visit) const
    {
      const Places own = *this; // in registers
      if (own.Others)
      {
        for (int i = 0; i < count; ++i)
        {
          visit(i, own.Others[i]);
        }
        return;
      }
      for (int i = 0; i < count; ++i)
      {
        visit(i, own.Begin + i * own.Stride);
      }
    }
  };
  /// Consecutive rows.
  struct Block
  {
    vtkIdType First = 0;
    int Count = 0;
    std::vector<Places> Properties; ///< set for the requested ones
  };
  static constexpr vtkIdType BlockSize = 1024; ///< the most rows

  using VisitBlock = FunctionRef<bool(const Block&)>;
  /// Calls @a visit in parallel until it returns false; then no block before this one is left out.
  virtual bool ForEachBlock(const Request& request, const Progress& progress, VisitBlock visit) = 0;
  /// Finds the lists of a property, if they are 32-bit integers and their positions follow from
  /// their sizes.
  virtual bool FindLists(int, const ListSizes&, ListRows&) const { return false; }
  /// Prepares for reading a property as ids.
  virtual void ExpectIds(int, const ListIds&) {}
  /// Sets the error at an item of a list, or at a value; returns false.
  virtual bool FailAtId(vtkIdType, int, vtkIdType, const ListIds&) { return false; }

  std::int64_t LoadLength(ValueType type, const char* place) const
  {
    return type == ValueType::UInt8 ? static_cast<unsigned char>(*place) // nearly always
      : type == ValueType::Int32    ? Load<std::int32_t>(place, this->Swap)
                                    : this->LoadLongLength(type, place);
  }
  /// Whether there are not too many values in all lists.
  bool CheckTotal(int property, const ListSizes& sizes);
  static bool AreValid(const std::int32_t* ids, vtkIdType size, const ListIds& expected)
  {
    return expected.Limit == ListIds::Any ||
      (expected.AreFromOne || expected.HaveSigns
          ? std::all_of(ids, ids + size, [&](std::int32_t id) { return expected.Contain(id); })
          : AreIds(ids, size, expected.Limit, expected.HasBreaks));
  }
  static std::string DescribeIds(const ListIds& expected);
  /// The name of the table or of a property, as messages show it.
  std::string Quote(const std::string& name) const
  {
    return this->Description.HasNamesOfFile ? QuoteWord(name) : name;
  }
  /// "8 elements 'face'", or of other files "8 rows, one per face".
  std::string CountRows() const
  {
    return std::to_string(this->GetCount()) +
      (this->Description.HasNamesOfFile ? " elements " : " rows, one per ") +
      this->Quote(this->Description.Name);
  }
  /// An integer that fits, or else the least one.
  template <typename In>
  static std::int32_t ToId(In value)
  {
    constexpr std::int32_t none = INT32_MIN;
    if constexpr (std::is_floating_point<In>::value)
    {
      const bool isId = value > none && value < -double(none) && std::trunc(value) == value;
      return isId ? static_cast<std::int32_t>(value) : none;
    }
    else
    {
      const auto id = static_cast<std::int64_t>(value);
      return id >= none && id <= INT32_MAX ? static_cast<std::int32_t>(id) : none;
    }
  }

  Table Description;
  std::vector<TableProperty> Stored; ///< their types in blocks
  bool Swap;                         ///< of numbers in blocks
  Tally LongRows;

private:
  std::int64_t LoadLongLength(ValueType type, const char* place) const;
  bool CopyIds(const Block& rows, int property, const ListSizes& sizes, std::int32_t* ids) const;
  void ReadColumn(
    const Block& rows, const TableColumn& column, const std::int32_t* tuples, vtkIdType first);

  std::atomic<vtkIdType> OddColors{ 0 };
};

/// The rows from the scanner's position on, in either byte order.
std::unique_ptr<TableRows> MakeBinaryRows(const Table& table, BinaryScanner& scanner);
/// @param lines of the text if it is read in parallel, else nullptr
std::unique_ptr<TableRows> MakeTextRows(
  const Table& table, TextScanner& scanner, const TextLines* lines, RowLayout layout);

/**
 * A file that has tables as text or, between lines of text, as binary rows: reads them one after
 * the other.
 */
struct TableScanner
{
  TextScanner& Text;
  BinaryScanner* Binary = nullptr;  ///< of the same file if its rows are binary
  const TextLines* Lines = nullptr; ///< if text is read in parallel
  ScanError Error;                  ///< of the mesh, not of a place in the file, nor with its name

  /// Makes the rows from the position of the text on, which moves to their end. Here and below,
  /// false with the error in one of the scanners, or if stopped; see TableRows::Locate.
  bool Locate(std::unique_ptr<TableRows>& rows, const Table& table, const Progress& progress,
    RowLayout layout = RowLayout::OneLine);
  /// Expects nothing but blanks, and comments in text.
  bool ReadEnd();
};

/**
 * The frame of a reader of tables in text or, with a byte order, binary rows: calls @a read, again
 * from scratch if text does not have one row per line; see ReadText.
 * @return false with the reason in @a error, or without one if stopped
 */
bool ReadTextOrBinary(const MappedFile& file, std::optional<ByteOrder> order, char comment,
  vtkIdType chunk, ScanError& error, const Progress& progress,
  FunctionRef<bool(TableScanner&, const Progress&)> read);
}

#endif
