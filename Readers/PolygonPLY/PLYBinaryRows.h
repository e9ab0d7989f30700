// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PLYBinaryRows
 * @brief Rows of a binary PLY file of either byte order, read from the mapped file.
 *
 * The positions of rows without lists, or with lists as long as those of the first row, are
 * computed. For others, one pass over the lengths finds the start of every 1024th row.
 */
#ifndef camaron_PLYBinaryRows_h
#define camaron_PLYBinaryRows_h

#include "Intake/Rows/BinaryScanner.h"
#include "Intake/Rows/ListRows.h"
#include "PLYRows.h"

namespace camaron
{
class PLYBinaryRows : public PLYRows
{
public:
  PLYBinaryRows(const PLYElement& element, BinaryScanner& scanner);

  bool Locate(const Progress& progress) override;
  bool Check(const Progress&) override { return true; } // done by Locate
  bool ReadSizes(int property, PLYSizes& sizes, const Progress& progress) override;
  bool ReadIds(
    int property, const PLYIds& expected, const PLYLists& lists, const Progress& progress) override;
  bool ReadColumns(const std::vector<PLYColumn>& columns, const PLYTargets& targets,
    const Progress& progress) override;
  bool FailAt(vtkIdType row, int property, ErrorKind kind, const std::string& expected,
    const std::string& found) override;

  /// Positions of a property in consecutive rows.
  struct Places
  {
    const char* Begin = nullptr; ///< of rows of one length
    std::ptrdiff_t Stride = 0;
    const char* const* Parts = nullptr; ///< of other rows
    std::ptrdiff_t Offset = 0;

    template <typename Visit>
    void ForEach(int count, Visit&& visit) const
    {
      if (this->Parts)
      {
        for (int i = 0; i < count; ++i)
        {
          visit(i, this->Parts[i] + this->Offset);
        }
      }
      else
      {
        for (int i = 0; i < count; ++i)
        {
          visit(i, this->Begin + i * this->Stride);
        }
      }
    }
  };

private:
  static constexpr vtkIdType BlockSize = 1024;

  /// Consecutive properties up to and including the length of a list; their size is fixed.
  struct Part
  {
    std::ptrdiff_t Size = 0;
    int List = -1; ///< the property, -1 for the last part
    std::ptrdiff_t CountOffset = 0;
    PLYType CountType = PLYType::UInt8;
    int ItemSize = 0;
    std::int32_t CommonLength = 0; ///< of rows of one length
    std::ptrdiff_t Begin = 0;      ///< in rows of one length
  };
  /// Position of a property: the part, and the offset in it.
  struct Location
  {
    std::size_t Part;
    std::ptrdiff_t Offset;
  };
  /// The rows of a block.
  struct Block
  {
    vtkIdType First = 0;
    int Count = 0;
    const char* Begin = nullptr;
    std::vector<const char*> Parts; ///< of rows of different lengths, part by part
  };

  bool HasOneLength() const { return this->Stride > 0; }
  std::int64_t LoadLength(const Part& part, const char* place) const
  {
    place += part.CountOffset;
    return part.CountType == PLYType::UInt8 ? static_cast<unsigned char>(*place) // nearly always
                                            : this->LoadLengthOf(part.CountType, place);
  }
  std::int64_t LoadLengthOf(PLYType type, const char* place) const;
  bool GuessLength();
  bool HaveGuessedLength(const Progress& progress) const;
  bool PassRow(vtkIdType row, const char*& place, const char* end, std::int64_t& sum);
  bool FindBlocks(const Progress& progress);
  bool Load(vtkIdType block, Block& rows) const;
  bool HaveSizes(const Block& rows, int property, const PLYSizes& sizes) const;
  /// Finds the lists of a property, if their positions follow from their sizes.
  bool FindLists(int property, const PLYSizes& sizes, ListRows& rows) const;
  template <typename Visit>
  bool ForEachBlock(const Progress& progress, Visit&& visit, bool loads = true) const;
  Places GetPlaces(const Block& rows, int property) const;
  /// @param tuples of the rows, -1 for none; or nullptr if they follow @a first, that of row 0
  void ReadColumn(
    const Block& rows, const PLYColumn& column, const std::int32_t* tuples, vtkIdType first) const;
  /// The position of a value, or of the length of a list.
  const char* GetPlace(vtkIdType row, int property) const;
  template <typename In>
  bool ReadIdsAs(
    int property, const PLYIds& expected, const PLYLists& lists, const Progress& progress);

  BinaryScanner& Scanner;
  std::vector<Part> Parts;
  std::vector<Location> Locations;
  const char* Data = nullptr;
  const char* End = nullptr;       ///< of all rows
  std::ptrdiff_t Stride = 0;       ///< bytes from row to row if they have one length
  std::vector<const char*> Starts; ///< of blocks of other rows
  Buffer<std::int32_t>
    Offsets; ///< of the lists of other rows, if there is one list; moved out by the first request
  std::int32_t Least = INT32_MAX; ///< length of the shortest of these lists
};
}

#endif
