// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MAPDLRows.h
 * @brief Rows of the blocks of Mechanical APDL: nodes, elements, components.
 *
 * Rows are split by the columns of the block's format or, without a valid format, at blanks and
 * commas.
 */
#ifndef camaron_MAPDLRows_h
#define camaron_MAPDLRows_h

#include "Intake/Rows/FixedColumns.h"
#include "Intake/Rows/LineChunks.h"
#include "MAPDLElements.h"
#include "Scan/ScanError.h"

#include <map>    // for types
#include <memory> // for shared formats
#include <string> // for messages

namespace camaron
{
/// Type of a line of a block.
enum class MAPDLLine
{
  Row,
  Blank,  ///< blank, or a comment
  End,    ///< -1
  Command ///< anything else; it follows the block
};
MAPDLLine ClassifyMAPDLLine(const Line& line);
/// The first line that is not blank, or the end.
const char* SkipBlankMAPDLLines(const char* text, const char* end);

/// An error in the text; the first one in the file is reported.
struct MAPDLFault
{
  const char* Place = nullptr;
  ErrorKind Kind = ErrorKind::None;
  std::string Expected;
  std::string Found; ///< empty for the text at the position

  explicit operator bool() const { return this->Place != nullptr; }
  /// Always returns false, for convenience.
  bool Set(const char* place, ErrorKind kind, const char* expected, std::string found = {})
  {
    this->Place = place;
    this->Kind = kind;
    this->Expected = expected;
    this->Found = std::move(found);
    return false;
  }
};

/// How rows are split into fields.
class MAPDLRowFormat
{
public:
  /// Split by columns if given, else at blanks and commas.
  explicit MAPDLRowFormat(std::shared_ptr<const ColumnFormat> columns = nullptr)
    : Columns(std::move(columns))
  {
  }
  const ColumnFormat* GetColumns() const { return this->Columns.get(); }

  ///@{
  /// Reads field @a i; an absent one is 0. False if it is not a number, which is then at @a place.
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
  /// Sets the fault for field @a i, which cannot be read. Returns false.
  bool SetFault(
    const Line& line, int i, const char* place, const char* expected, MAPDLFault& fault) const;
  /// Number of fields up to the last that is not blank, at most @a limit.
  int CountFields(const Line& line, int limit) const;

private:
  template <typename Number>
  bool ReadToken(const Line& line, int i, Number& value, const char*& place) const;
  std::shared_ptr<const ColumnFormat> Columns;
};

/// Rows of NBLOCK: id, entity of the solid model, position on it, x, y, z, angles; or without the
/// second and third.
struct MAPDLNodeFormat
{
  MAPDLRowFormat Fields;
  int FirstCoordinate = 3;

  bool ReadId(const Line& line, std::int32_t& id, MAPDLFault& fault) const;
  bool ReadCoordinates(const Line& line, double x[3], MAPDLFault& fault) const;
};

/// An element as given by rows and commands.
struct MAPDLElement
{
  std::int32_t Id = 0;
  std::int32_t Type = 1;
  std::int32_t Material = 1;
  std::int32_t Real = 1;
  std::int32_t Section = 1;
  std::int32_t NumberOfNodes = 0; ///< at most MaxMAPDLNodes; further ones are ignored
  std::int32_t Nodes[MaxMAPDLNodes];
};

/// Fields before the nodes in rows of EBLOCK, determined by its key.
enum class MAPDLElementKey
{
  None,   ///< 5 numbers
  Solid,  ///< 11 numbers; the ninth is the number of nodes
  Compact ///< the number of the element; attributes are those of commands before the block
};

/// Rows of EBLOCK, each of which may continue over several lines.
struct MAPDLElementFormat
{
  MAPDLRowFormat Fields;
  MAPDLElementKey Key = MAPDLElementKey::Solid;
  int FieldsPerLine = 19;
  /// Largest number of nodes of the types that the deck has defined before the block.
  std::map<std::int64_t, int> MostNodes;
  MAPDLElement Attributes; ///< of compact rows
  int FurtherLines = 0;    ///< lines that follow the first if a compact row fills it

  bool IsSolid() const { return this->Key == MAPDLElementKey::Solid; }
  bool IsCompact() const { return this->Key == MAPDLElementKey::Compact; }
  int GetNumberOfHeaderFields() const { return this->IsSolid() ? 11 : this->IsCompact() ? 1 : 5; }
  int GetNodesOnFirstLine() const { return this->FieldsPerLine - this->GetNumberOfHeaderFields(); }
  /// Type of the element that begins on a line; arbitrary if there is none.
  std::int64_t PeekType(const Line& line) const;
  /// Number of nodes of the element that begins on a line: for Solid as declared, else those
  /// present.
  int PeekNumberOfNodes(const Line& line) const;
  /// Number of further lines of an element with this type and number of nodes.
  int GetNumberOfFurtherLines(int nodes, std::int64_t type) const;
  /**
   * False with a fault if it is unknown whether the element that begins on a line continues on the
   * next one, or if the next line is missing.
   * @param end of the block
   */
  bool CheckEnd(const Line& line, const char* end, std::int64_t type, MAPDLFault& fault) const;

  /// Reads everything but the nodes.
  bool ReadHeader(const Line& line, MAPDLElement& element, MAPDLFault& fault) const;
  /**
   * Reads the nodes from the first line and @a furtherLines lines after it.
   * @param end of the block
   * @return the end of the last line, or nullptr after a fault
   */
  const char* ReadNodes(const Line& line, const char* end, int furtherLines, MAPDLElement& element,
    MAPDLFault& fault) const;

  /// Largest number of nodes of elements of a type, 0 if unknown.
  int GetMostNodes(std::int64_t type) const;

private:
  bool ReadInteger(
    const Line& line, int field, const char* what, std::int32_t& value, MAPDLFault& fault) const;
};
}

#endif
