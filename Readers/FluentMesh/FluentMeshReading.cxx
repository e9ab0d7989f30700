// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentMeshReading.h"

#include "Intake/Pieces/ReadMappedFile.h"
#include "Intake/Rows/Bytes.h"
#include "Scan/TextScanner.h"

#include <algorithm>
#include <string_view>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool BeginsWith(const char* begin, const char* end, std::string_view text)
{
  return std::string_view(begin, static_cast<std::size_t>(end - begin)).substr(0, text.size()) ==
    text;
}

//------------------------------------------------------------------------------
// Moves @a place past the parenthesis that closes @a depth open ones (0 if the first one follows)
// and those opened after it; false at the end of the text, with @a place unchanged. With @a quotes,
// parentheses between quotation marks, where a backslash escapes the next character, do not count.
bool SkipLists(const char*& place, const char* end, int depth, bool quotes)
{
  std::int64_t open = depth;
  bool quoted = false;
  for (const char* text = place; text < end; ++text)
  {
    const char c = *text;
    if (quoted)
    {
      text += c == '\\' && end - text > 1;
      quoted = c != '"';
    }
    else if (c == '(')
    {
      ++open;
    }
    else if (c == ')')
    {
      if (--open == 0)
      {
        place = text + 1;
        return true;
      }
    }
    else
    {
      quoted = quotes && c == '"';
    }
  }
  return false;
}

//------------------------------------------------------------------------------
/**
 * Finds the sections of a file in text or binary.
 *
 * A file is a sequence of sections `(index ...)`. Those that describe the mesh are collected, all
 * others are skipped: text by matching parentheses outside of quotes, including lists of settings
 * without an index; binary sections (index 2000 to 3999) up to their end mark, as bytes in them may
 * look like parentheses.
 */
class FluentMeshFile : public FluentFile
{
public:
  FluentMeshFile(std::string name, const char* begin, const char* end)
    : FluentFile(std::move(name), begin, FindTextEnd(begin, end))
  {
  }

  /// Finds all sections; false with the error, or if aborted.
  bool Scan(const Progress& progress)
  {
    this->Swap = GetByteOrder() != ByteOrder::Little;
    this->Position = SkipByteOrderMark(this->Begin, this->End);
    while (this->IsAtList() || this->Position < this->End)
    {
      if (!this->ReadSection() ||
        !progress.Report(static_cast<double>(this->Position - this->Begin) /
          static_cast<double>(this->End - this->Begin)))
      {
        return false;
      }
    }
    if (!this->HasMeshSection && this->Dimension == 0)
    {
      this->Fail(ErrorKind::NotThisFormat, "a Fluent mesh",
        this->Begin == this->End ? "an empty file" : "no nodes or faces");
      return false;
    }
    if (this->Dimension == 0)
    {
      // If all faces have two nodes, the mesh is two-dimensional.
      const bool isFlat = std::any_of(this->Faces.begin(), this->Faces.end(),
        [](const FluentSection& face) { return face.GetElement() == 2; });
      this->Dimension = isFlat ? 2 : 3;
    }
    return true;
  }

private:
  bool ReadSection()
  {
    FluentSection section;
    section.Place = this->Position;
    // If a number comes first, it is a section, possibly a damaged one; else a list such as
    // (cad/options 1), ("a" 1), ((a . 1)) or ().
    const char* text = this->IsAtList() ? SkipSpaceFrom(this->Position + 1, this->End) : nullptr;
    const char first = text && text < this->End ? *text : ' ';
    if (text && !IsDigit(first) && first != '-' && first != '+' && first != '.')
    {
      constexpr int NoIndex = -1;
      section.Index = NoIndex;
      return this->SkipRest(0, section);
    }
    constexpr std::int64_t MaxIndex = 999999;
    std::int64_t number = 0;
    text = IsDigit(first) ? ParseInteger(text, this->End, number) : nullptr;
    if (!text || number > MaxIndex || text == this->End ||
      !(IsSpace(*text) || *text == '(' || *text == ')' || *text == '"'))
    {
      this->FailAt(section.Place,
        this->HasMeshSection || this->Dimension > 0 ? ErrorKind::Syntax : ErrorKind::NotThisFormat,
        "a section of a Fluent mesh, which begins with '(' and an index, or another list");
      return false;
    }
    this->Position = text;
    constexpr int FirstSingle = 2000, FirstDouble = 3000, EndBinary = 4000;
    const int index = static_cast<int>(number);
    const bool isBinary = index >= FirstSingle && index < EndBinary;
    section.Index = isBinary ? index % 1000 : index;
    if (isBinary)
    {
      section.RealSize = index < FirstDouble ? 4 : 8;
      this->FirstBinary = this->FirstBinary ? this->FirstBinary : section.Place;
    }
    switch (section.Index)
    {
      case FluentSection::NodesIndex:
      case FluentSection::CellsIndex:
      case FluentSection::FacesIndex:
      case FluentSection::FaceTreeIndex:
      case FluentSection::InterfaceIndex:
        return this->ReadMeshSection(section, index);
      default:
        break;
    }
    if (isBinary)
    {
      return this->SkipBinary(section, index);
    }
    constexpr int Dimension = 2, Configuration = 4, OldZone = 45, Zone = 39;
    if (index == Configuration)
    {
      this->ReadConfiguration();
    }
    else if (index == Zone || index == OldZone)
    {
      this->ReadZone();
    }
    return (index != Dimension || this->ReadDimension()) && this->SkipRest(1, section);
  }

  bool ReadDimension()
  {
    const char* const place = this->Position;
    std::int64_t value = 0;
    const char* next = ParseInteger(SkipSpaceFrom(place, this->End), this->End, value);
    if (!next || (value != 2 && value != 3))
    {
      this->FailAt(place, ErrorKind::Syntax, "the dimension of the mesh, 2 or 3");
      return false;
    }
    this->Dimension = static_cast<int>(value);
    this->Position = next;
    return true;
  }

  /// "(60 ...": little endian; any other number, big endian.
  void ReadConfiguration()
  {
    constexpr int LittleEndian = 60;
    std::int64_t value = 0;
    if (this->ParseFirst(value))
    {
      const ByteOrder order = value == LittleEndian ? ByteOrder::Little : ByteOrder::Big;
      this->Swap = order != GetByteOrder();
    }
  }

  /// "(id type name ...". An invalid zone gets no name.
  void ReadZone()
  {
    std::int64_t id = 0;
    const char* text = this->ParseFirst(id);
    if (!text || id < 0 || id > INT32_MAX)
    {
      return;
    }
    const auto readWord = [&]
    {
      constexpr std::size_t MaxWord = 1000;
      text = SkipSpaceFrom(text, this->End);
      std::string word;
      const bool quoted = text < this->End && *text == '"';
      text += quoted;
      while (text < this->End && word.size() < MaxWord &&
        (quoted ? *text != '"' : !IsSpace(*text) && *text != '(' && *text != ')'))
      {
        word += *text++;
      }
      text += quoted && text < this->End;
      return word;
    };
    const std::string type = readWord(), name = readWord();
    if (!type.empty())
    {
      this->Zones.push_back({ static_cast<int>(id), type, name });
    }
  }

  /// Reads a section with data of the mesh, from its header on.
  bool ReadMeshSection(FluentSection& section, int index)
  {
    const bool isRange = section.Index <= FluentSection::FacesIndex; // of elements of a zone
    if (!this->ReadHeader(section) || (isRange && !this->CheckRange(section)))
    {
      return false;
    }
    const bool hasBody = this->IsAtList();
    bool good;
    if (section.IsText())
    {
      good = (!hasBody || section.Header[0] == 0 || this->ReadTextBody(section)) &&
        this->SkipRest(1, section);
    }
    else
    {
      // Cells of one type need no data; as in text, data that some writers add is ignored. For
      // interface faces, the range in the header is sufficient.
      const bool areCells = section.Index == FluentSection::CellsIndex;
      const bool reads = isRange
        ? (section.Header[0] != 0 || areCells) &&
          !(areCells && section.GetElement() != 0 && hasBody)
        : section.Index == FluentSection::FaceTreeIndex && section.HeaderSize > 1;
      good = reads ? this->ReadBinaryBody(section, index) : this->SkipBinary(section, index);
    }
    if (good)
    {
      this->Keep(std::move(section));
    }
    return good;
  }

  /// Reads "(hexadecimal numbers)".
  bool ReadHeader(FluentSection& section)
  {
    if (!this->IsAtList())
    {
      this->FailAt(this->Position,
        this->Position == this->End ? ErrorKind::Truncated : ErrorKind::Syntax,
        "the header of section " + std::to_string(section.Index) + " in parentheses");
      return false;
    }
    const char* text = this->Position + 1;
    const char* const end = std::find(text, this->End, ')');
    if (end == this->End)
    {
      this->FailAt(
        this->Position, ErrorKind::Truncated, "the end of the header", "the end of the file");
      return false;
    }
    for (text = SkipSpaceFrom(text, end); text < end; text = SkipSpaceFrom(text, end))
    {
      std::int64_t value = 0;
      const char* const next =
        section.HeaderSize < FluentSection::MaxHeader ? ParseHex(text, end, value) : nullptr;
      if (!next || value > INT32_MAX)
      {
        this->FailAt(text, next ? ErrorKind::Count : ErrorKind::Syntax,
          next ? "a number below 80000000" : "a hexadecimal number or the end of the header");
        return false;
      }
      section.Header[section.HeaderSize++] = value;
      text = next;
    }
    this->Position = end + 1;
    return true;
  }

  bool CheckRange(const FluentSection& section)
  {
    constexpr int LeastHeader = 3;
    const std::string what = section.Index == FluentSection::NodesIndex ? "nodes"
      : section.Index == FluentSection::CellsIndex                      ? "cells"
                                                                        : "faces";
    if (section.HeaderSize < LeastHeader)
    {
      this->FailAt(section.Place, ErrorKind::Syntax,
        "a header of " + what + " with a zone, the first and the last index",
        std::to_string(section.HeaderSize) + " numbers");
    }
    else if (section.Header[0] != 0 && (section.Header[1] < 1 || section.GetCount() < 0))
    {
      this->FailAt(section.Place, ErrorKind::Count, "the first and the last index of " + what,
        std::to_string(section.Header[1]) + " and " + std::to_string(section.Header[2]));
    }
    return !this->HasFailed();
  }

  /// Keeps a section with data; of zone 0 only the declared total.
  void Keep(FluentSection&& section)
  {
    if (section.Index > FluentSection::FacesIndex)
    {
      const bool isTree = section.Index == FluentSection::FaceTreeIndex;
      if (section.HeaderSize > 1 && (section.Begin || !isTree))
      {
        (isTree ? this->FaceTrees : this->InterfaceFaces).push_back(std::move(section));
      }
      return;
    }
    const bool areNodes = section.Index == FluentSection::NodesIndex;
    const bool areCells = section.Index == FluentSection::CellsIndex;
    this->HasMeshSection = this->HasMeshSection || !areCells;
    if (section.Header[0] == 0)
    {
      (areNodes      ? this->DeclaredNodes
          : areCells ? this->DeclaredCells
                     : this->DeclaredFaces) = { section.Header[2], section.Place };
      const std::int64_t dimension = areNodes ? section.GetElement() : 0;
      if (this->Dimension == 0 && (dimension == 2 || dimension == 3))
      {
        this->Dimension = static_cast<int>(dimension);
      }
    }
    else if (section.GetCount() > 0)
    {
      (areNodes ? this->Nodes : areCells ? this->Cells : this->Faces).push_back(std::move(section));
    }
  }

  bool ReadTextBody(FluentSection& section)
  {
    const char* const body = this->Position + 1;
    const std::string_view rest(body, static_cast<std::size_t>(this->End - body));
    const std::size_t size = rest.find(')');
    const bool isClosed = size != rest.npos;
    const bool opens = isClosed && rest.substr(0, size).find('(') != rest.npos;
    if (!isClosed || opens)
    {
      this->FailAt(section.Place, ErrorKind::Truncated,
        "a closing parenthesis for the section that begins here",
        opens ? "another opening one" : "the end of the file");
      return false;
    }
    section.Begin = body;
    section.End = body + size;
    this->Position = section.End + 1;
    return true;
  }

  /// Reads the body of a binary section after its header.
  bool ReadBinaryBody(FluentSection& section, int index)
  {
    const bool hasBody = this->IsAtList();
    const char* const open = this->Position;
    if (!hasBody)
    {
      const char* const next = this->FindEndMark(open, index, false);
      if (!next)
      {
        this->FailAt(open, open == this->End ? ErrorKind::Truncated : ErrorKind::Syntax,
          "the data of section " + std::to_string(index) + " or its end");
        return false;
      }
      this->Position = next;
      return true;
    }
    // Some writers put a line end between the parenthesis and the data. If the data began later,
    // its end would be after the closing parenthesis; if it began earlier, it may end in bytes that
    // look like blanks.
    constexpr std::ptrdiff_t LongestGap = 2;
    std::ptrdiff_t gap = 0;
    while (gap < LongestGap && open + 1 + gap < this->End &&
      (open[1 + gap] == '\n' || open[1 + gap] == '\r'))
    {
      ++gap;
    }
    for (; gap >= 0; --gap)
    {
      this->Error = ScanError(); // of a longer gap
      section.Begin = open + 1 + gap;
      section.End = this->FindEndOfData(section);
      const char* const next = section.End ? this->FindEndMark(section.End, index, true) : nullptr;
      if (next)
      {
        this->Position = next;
        return true;
      }
      if (section.End)
      {
        const bool isShort = this->End - section.End < static_cast<std::ptrdiff_t>(EndMark.size());
        this->FailAt(section.End, isShort ? ErrorKind::Truncated : ErrorKind::Syntax,
          "')' and 'End of Binary Section " + std::to_string(index) + "'");
      }
    }
    return false;
  }

  /// Finds the end of the binary data of a section; nullptr with an error.
  const char* FindEndOfData(const FluentSection& section)
  {
    const std::int64_t element = section.GetElement();
    if (section.Index == FluentSection::FaceTreeIndex ||
      (section.Index == FluentSection::FacesIndex &&
        (element == 0 || element == FluentSection::Polygons)))
    {
      return this->FindLists(section);
    }
    std::int64_t bytes = 4 * (element + 2); // of a face
    if (section.Index == FluentSection::NodesIndex)
    {
      const bool hasDimension = element == 2 || element == 3;
      bytes = (hasDimension ? element : this->Dimension == 2 ? 2 : 3) * section.RealSize;
    }
    else if (section.Index == FluentSection::CellsIndex)
    {
      bytes = element == 0 ? 4 : 0;
    }
    bytes *= section.GetCount();
    if (bytes > this->End - section.Begin)
    {
      this->FailAt(section.Begin, ErrorKind::Truncated,
        std::to_string(bytes) + " bytes of the section that begins at byte " +
          std::to_string(section.Place - this->Begin),
        std::to_string(this->End - section.Begin) + " up to the end of the file");
      return nullptr;
    }
    return section.Begin + bytes;
  }

  /// Finds the end of lists that contain their length: faces "n v1 ... vn c0 c1", or the parts of
  /// split faces "n child1 ... childn".
  const char* FindLists(const FluentSection& section)
  {
    const bool areFaces = section.Index == FluentSection::FacesIndex;
    const std::int64_t others = areFaces ? 3 : 1; // numbers besides those counted
    const std::int64_t first = section.Header[areFaces ? 1 : 0];
    const std::int64_t count = section.Header[areFaces ? 2 : 1] - first + 1;
    const char* place = section.Begin;
    if (areFaces && count > (this->End - place) / (4 * others))
    {
      this->FailAt(section.Place, ErrorKind::Truncated, std::to_string(count) + " faces",
        std::to_string(this->End - place) + " bytes up to the end of the file");
      return nullptr;
    }
    for (std::int64_t i = 0; i < count; ++i)
    {
      const std::int64_t left = (this->End - place) / 4;
      const std::int32_t size = left > 0 ? Load<std::int32_t>(place, this->Swap) : 0;
      if (left < others || size < 0 || size > left - others)
      {
        const std::string id = std::to_string(first + i);
        this->FailAt(place, size < 0 ? ErrorKind::Count : ErrorKind::Truncated,
          areFaces ? "the number of nodes of face " + id + " of at most " +
              std::to_string(std::max<std::int64_t>(left - others, 0))
                   : "the number of parts of face " + id,
          left > 0 ? std::to_string(size) : "the end of the file");
        return nullptr;
      }
      place += 4 * (size + others);
    }
    return place;
  }

  /// Returns the text after the end mark of a binary section, or nullptr; the mark follows a
  /// parenthesis if the section has data.
  const char* FindEndMark(const char* place, int index, bool hasData) const
  {
    const char* text = SkipSpaceFrom(place, this->End);
    if (text < this->End && *text == ')')
    {
      text = SkipSpaceFrom(text + 1, this->End);
    }
    else if (hasData)
    {
      return nullptr;
    }
    if (!BeginsWith(text, this->End, EndMark))
    {
      return nullptr;
    }
    text = SkipSpaceFrom(text + EndMark.size(), this->End);
    std::int64_t number = 0;
    text = ParseInteger(text, this->End, number);
    text = text ? SkipSpaceFrom(text, this->End) : nullptr;
    return text && number == index && text < this->End && *text == ')' ? text + 1 : nullptr;
  }

  bool SkipBinary(const FluentSection& section, int index)
  {
    const std::string_view rest(
      this->Position, static_cast<std::size_t>(this->End - this->Position));
    for (std::size_t at = rest.find(EndMark); at != std::string_view::npos;
      at = rest.find(EndMark, at + EndMark.size()))
    {
      if (const char* next = this->FindEndMark(rest.data() + at, index, false))
      {
        this->Position = next;
        return true;
      }
    }
    this->FailAt(section.Place, ErrorKind::Truncated,
      "'End of Binary Section " + std::to_string(index) + "'", "the end of the file");
    return false;
  }

  bool SkipRest(int depth, const FluentSection& section)
  {
    // In the text of a comment, a quotation mark may mean inch.
    constexpr int Comments = 1;
    const char* const text = SkipSpaceFrom(this->Position, this->End);
    const bool isProse = section.Index >= 0 && section.Index <= Comments &&
      !(text < this->End && (*text == '"' || *text == '('));
    if (this->TrustsQuotes && !isProse && SkipLists(this->Position, this->End, depth, true))
    {
      return true;
    }
    // Elsewhere, a single quotation mark hides everything after it.
    this->TrustsQuotes = this->TrustsQuotes && isProse;
    if (SkipLists(this->Position, this->End, depth, false))
    {
      return true;
    }
    this->FailAt(section.Place, ErrorKind::Truncated,
      "a closing parenthesis for the section that begins here", "the end of the file");
    return false;
  }

  /// Reads "(number" in decimal; returns its end, or nullptr.
  const char* ParseFirst(std::int64_t& value)
  {
    return this->IsAtList()
      ? ParseInteger(SkipSpaceFrom(this->Position + 1, this->End), this->End, value)
      : nullptr;
  }

  /// Skips white space; whether '(' follows.
  bool IsAtList()
  {
    this->Position = SkipSpaceFrom(this->Position, this->End);
    return this->Position < this->End && *this->Position == '(';
  }

  /// "name:line", or with the byte instead of the line after binary sections.
  std::string Locate(const char* place) const override
  {
    // Line numbers are meaningless after binary data.
    const bool isText = !this->FirstBinary || place <= this->FirstBinary;
    return isText ? this->Name + ":" +
        std::to_string(TextScanner(this->Name, this->Begin, this->End).GetLine(place))
                  : this->Name + ": byte " + std::to_string(place - this->Begin);
  }

  static constexpr std::string_view EndMark = "End of Binary Section";
  const char* Position = nullptr;
  const char* FirstBinary = nullptr;
  bool TrustsQuotes = true;
  bool HasMeshSection = false;
};

constexpr std::string_view HDF5("\x89HDF\r\n\x1a\n", 8);

//------------------------------------------------------------------------------
// Recognizes files of other formats with the same extensions; empty if unknown.
std::string RecognizeOther(const char* begin, const char* end)
{
  if (BeginsWith(begin, end, HDF5))
  {
    return "a file of Fluent in HDF5 (Common Fluids Format), which the ANSYS Fluent HDF5 "
           "Reader and ParaView's FLUENT CFF reader open if it is named .cas.h5";
  }
  const char* const text = SkipSpaceFrom(begin, end);
  if (BeginsWith(text, end, "$MeshFormat") || BeginsWith(text, end, "$NOD") ||
    BeginsWith(text, end, "$Comments"))
  {
    return "a Gmsh file, which the reader of ParaView's GmshIO plugin opens";
  }
  if (text < end && IsDigit(*text))
  {
    return "a file that begins with a number, as those of Netgen and ADVENTURE do";
  }
  return std::string();
}
}

//------------------------------------------------------------------------------
bool IsFluentMesh(const std::string& path)
{
  // Among files with its extensions, only these begin with '('.
  const MappedFile file(path);
  const char* const text = SkipSpaceFrom(SkipByteOrderMark(file.begin(), file.end()), file.end());
  return text < file.end() && *text == '(';
}

//------------------------------------------------------------------------------
bool ReadFluentMesh(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  vtkMultiBlockDataSet* boundaries, Warnings& warnings, ScanError& error, const Progress& progress)
{
  return ReadMappedFile(path, request, grid, warnings, error, progress,
    [&](const MappedFile& mapped, const Progress& rest)
    {
      const std::string other = RecognizeOther(mapped.begin(), mapped.end());
      if (!other.empty())
      {
        const bool isFluent = BeginsWith(mapped.begin(), mapped.end(), HDF5); // in another format
        error = { isFluent ? ErrorKind::Unsupported : ErrorKind::NotThisFormat,
          mapped.GetName() + ": expected a Fluent mesh, found " + other };
        return false;
      }
      constexpr double ScanShare = 0.1; // of the progress
      FluentMeshFile file(mapped.GetName(), mapped.begin(), mapped.end());
      const bool isRead = file.Scan(rest.Part(0, ScanShare)) &&
        ReadFluent(file, request, grid, boundaries, warnings, error, rest.Part(ScanShare, 1));
      error = file.GetError();
      return isRead;
    });
}
}
