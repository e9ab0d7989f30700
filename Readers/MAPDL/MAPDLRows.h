// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MAPDLRows.h
 * @brief Rows of the blocks of Mechanical APDL: nodes, elements, components.
 *
 * Rows are split by the columns of the block's format.
 */
#ifndef camaron_MAPDLRows_h
#define camaron_MAPDLRows_h

#include "Intake/Rows/FixedColumns.h"
#include "Intake/Rows/LineChunks.h"
#include "MAPDLElements.h"
#include "Scan/ScanError.h"

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

/// An error in the text; the first one in the file is reported.
struct MAPDLFault
{
  const char* Place = nullptr;
  ErrorKind Kind = ErrorKind::None;
  std::string Expected;
  std::string Found; ///< empty for the text at the position

  explicit operator bool() const { return this->Place != nullptr; }
  /// Always returns false, for convenience.
  bool Set(const char* place, ErrorKind kind, std::string expected, std::string found = {})
  {
    this->Place = place;
    this->Kind = kind;
    this->Expected = std::move(expected);
    this->Found = std::move(found);
    return false;
  }
};

/// The columns of the rows of a block.
class MAPDLRowFormat
{
public:
  /// Parses a line such as (3i9,6e21.13e3); false if it is no format.
  bool Parse(const Line& line)
  {
    const bool good = this->Columns.Parse(line.Begin, line.End);
    this->Integers = good ? this->Columns.GetNumberOfLeadingIntegers() : 0;
    return good;
  }
  int GetNumberOfColumns() const { return this->Columns.GetNumberOfColumns(); }
  /// Number of integer columns at the beginning.
  int GetNumberOfIntegers() const { return this->Integers; }

  /// Reads the number in column @a i; an absent one is 0. False with a fault if it is not a number.
  template <typename Number>
  bool Read(const Line& line, int i, const char* what, Number& value, MAPDLFault& fault) const
  {
    if (i >= this->GetNumberOfColumns())
    {
      value = 0;
      return true;
    }
    const ColumnText text(line.Begin, line.End, this->Columns[i]);
    return ParseFixed(text, value) || this->Fail(text, i, what, fault);
  }
  /// Reads an integer of 32 bits, at least @a least.
  bool ReadInteger(const Line& line, int i, const char* what, std::int32_t& value,
    MAPDLFault& fault, std::int32_t least = -MaxMAPDLId) const;
  /// Number of integer columns up to the last that is not blank.
  int CountIntegers(const Line& line) const;

private:
  bool Fail(const ColumnText& text, int i, const char* what, MAPDLFault& fault) const;

  ColumnFormat Columns;
  int Integers = 0;
};

struct MAPDLNode
{
  std::int32_t Id;
  double X[3];
};

/// Rows of NBLOCK: id, entity of the solid model, position on it, x, y, z, angles; or without the
/// second and third.
struct MAPDLNodeFormat
{
  MAPDLRowFormat Fields;

  bool ReadId(const Line& line, std::int32_t& id, MAPDLFault& fault) const;
  bool ReadPoint(const Line& line, double x[3], MAPDLFault& fault) const;
  /// Reads the node of a line; as MAPDLElementFormat::Read.
  const char* Read(const Line& line, const char*, MAPDLNode& node, MAPDLFault& fault) const
  {
    const bool good = this->ReadId(line, node.Id, fault) && this->ReadPoint(line, node.X, fault);
    return good ? line.Next : nullptr;
  }
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

/// Rows of EBLOCK, some of which continue over several lines.
struct MAPDLElementFormat
{
  MAPDLRowFormat Fields;
  MAPDLElementKey Key = MAPDLElementKey::Solid;
  MAPDLElement Attributes; ///< of compact rows
  int FurtherLines = 0;    ///< after the first of each compact row

  int GetNumberOfHeaderFields() const
  {
    return this->Key == MAPDLElementKey::Solid ? 11 : this->Key == MAPDLElementKey::Compact ? 1 : 5;
  }
  int GetNodesOnFirstLine() const
  {
    return this->Fields.GetNumberOfIntegers() - this->GetNumberOfHeaderFields();
  }
  /// Number of lines that continue the row that begins on a line.
  int GetNumberOfFurtherLines(const Line& line) const;
  /**
   * Reads the element that begins on a line.
   * @param end of the block
   * @return the end of its last line, or nullptr after a fault
   */
  const char* Read(
    const Line& line, const char* end, MAPDLElement& element, MAPDLFault& fault) const;

private:
  std::int64_t GetDeclaredNodes(const Line& line) const;
  bool ReadHeader(const Line& line, MAPDLElement& element, MAPDLFault& fault) const;
};

/// Whether a line that follows the first one of a row continues it: not if it is a comment.
inline bool ContinuesMAPDLRow(const Line& line)
{
  const char* const text = SkipBlanks(line.Begin, line.End);
  return text == line.End || *text != '!';
}
}

#endif
