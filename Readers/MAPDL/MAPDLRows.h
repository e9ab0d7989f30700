// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MAPDLRows.h
 * @brief Rows of the blocks of Mechanical APDL: nodes, elements, components.
 *
 * Rows are cut by the columns of the block's format, or, where it has none that makes sense, at
 * blanks and commas.
 */
#ifndef camaron_MAPDLRows_h
#define camaron_MAPDLRows_h

#include "MAPDLElements.h"
#include "Scan/FixedColumns.h"
#include "Scan/LineChunks.h"
#include "Scan/ScanError.h"

#include <map>    // for types
#include <memory> // for shared formats
#include <string> // for messages

namespace camaron
{
/// What a line of a block is.
enum class MAPDLLine
{
  Row,
  Blank,  ///< nothing, or a comment
  End,    ///< -1
  Command ///< something else follows the block
};
MAPDLLine ClassifyMAPDLLine(const Line& line);

/// Something wrong in the text; the first in the file counts.
struct MAPDLFault
{
  const char* Place = nullptr;
  ErrorKind Kind = ErrorKind::None;
  std::string Expected;
  std::string Found; ///< empty if it is what stands at the place

  explicit operator bool() const { return this->Place != nullptr; }
  /// Returns false for the convenience of callers.
  bool Set(const char* place, ErrorKind kind, const char* expected, std::string found = {})
  {
    this->Place = place;
    this->Kind = kind;
    this->Expected = expected;
    this->Found = std::move(found);
    return false;
  }
};

/// How rows are divided.
class MAPDLRowFormat
{
public:
  /// Columns if given, else blanks and commas divide.
  explicit MAPDLRowFormat(std::shared_ptr<const ColumnFormat> columns = nullptr)
    : Columns(std::move(columns))
  {
  }
  const ColumnFormat* GetColumns() const { return this->Columns.get(); }

  ///@{
  /// Reads field @a i; an absent one is 0. False if it is no number; @a place is where it is then.
  template <typename Number>
  bool Read(const Line& line, int i, Number& value, const char*& place) const
  {
    if (!this->Columns)
    {
      return this->ReadToken(line, i, value, place);
    }
    if (i >= this->Columns->GetNumberOfColumns())
    {
      value = 0;
      return true;
    }
    const ColumnText text(line.Begin, line.End, (*this->Columns)[i]);
    if (ParseFixed(text, value))
    {
      return true;
    }
    place = SkipBlanks(text.Begin, text.End);
    return false;
  }
  ///@}
  /// Says what field @a i, which cannot be read, has instead of what is expected. Returns false.
  bool SetFault(
    const Line& line, int i, const char* place, const char* expected, MAPDLFault& fault) const;
  /// Number of fields up to the last that is not blank, at most @a limit.
  int CountFields(const Line& line, int limit) const;

private:
  template <typename Number>
  bool ReadToken(const Line& line, int i, Number& value, const char*& place) const;
  std::shared_ptr<const ColumnFormat> Columns;
};

/// Rows of NBLOCK: id, entity of the solid model, place on it, x, y, z, angles; or without the
/// second.
struct MAPDLNodeFormat
{
  MAPDLRowFormat Fields;
  int FirstCoordinate = 3;

  bool ReadId(const Line& line, std::int32_t& id, MAPDLFault& fault) const;
  bool ReadCoordinates(const Line& line, double x[3], MAPDLFault& fault) const;
};

/// An element as rows and commands give it.
struct MAPDLElement
{
  std::int32_t Id = 0;
  std::int32_t Type = 1;
  std::int32_t Material = 1;
  std::int32_t Real = 1;
  std::int32_t Section = 1;
  std::int32_t NumberOfNodes = 0; ///< at most MaxMAPDLNodes; further ones do not matter
  std::int32_t Nodes[MaxMAPDLNodes];
};

/// What rows of EBLOCK have before the nodes, as its key tells.
enum class MAPDLElementKey
{
  None,   ///< 5 numbers
  Solid,  ///< 11 numbers, of which the ninth tells how many nodes there are
  Compact ///< the number of the element; attributes are those of commands before the block
};

/// Rows of EBLOCK, of which each may go on over several lines.
struct MAPDLElementFormat
{
  MAPDLRowFormat Fields;
  MAPDLElementKey Key = MAPDLElementKey::Solid;
  int FieldsPerLine = 19;
  /// Most nodes of elements of the types that the deck has defined before the block.
  std::map<std::int64_t, int> MostNodes;
  MAPDLElement Attributes; ///< of compact rows
  int FurtherLines = 0;    ///< on which compact rows go on that fill the first

  bool IsSolid() const { return this->Key == MAPDLElementKey::Solid; }
  bool IsCompact() const { return this->Key == MAPDLElementKey::Compact; }
  int GetNumberOfHeaderFields() const { return this->IsSolid() ? 11 : this->IsCompact() ? 1 : 5; }
  int GetNodesOnFirstLine() const { return this->FieldsPerLine - this->GetNumberOfHeaderFields(); }
  /// Type of the element that begins on a line; any number if there is none.
  std::int64_t PeekType(const Line& line) const;
  /// Number of nodes of the element that begins on a line: for Solid as it says, else those there
  /// are.
  int PeekNumberOfNodes(const Line& line) const;
  /// Number of lines on which it goes on, if it is of this type and has as many nodes as that.
  int GetNumberOfFurtherLines(int nodes, std::int64_t type) const;
  /**
   * False with a fault if it cannot be told whether the element of this type that begins on a line
   * goes on in the next one, or if it does not though it has to.
   * @param end of the block
   */
  bool CheckEnd(const Line& line, const char* end, std::int64_t type, MAPDLFault& fault) const;

  /// Reads all but the nodes.
  bool ReadHeader(const Line& line, MAPDLElement& element, MAPDLFault& fault) const;
  /**
   * Reads the nodes from the first line and @a furtherLines ones that follow it.
   * @param end of the block
   * @return the end of the last line, or nullptr after a fault
   */
  const char* ReadNodes(const Line& line, const char* end, int furtherLines, MAPDLElement& element,
    MAPDLFault& fault) const;

  /// Most nodes that an element of a type has, 0 if that is not known.
  int GetMostNodes(std::int64_t type) const;

private:
  bool ReadInteger(
    const Line& line, int field, const char* what, std::int32_t& value, MAPDLFault& fault) const;
};
}

#endif
