// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Binary sections: finds the end of their data, which depends on their headers and the data itself.
#include "FluentMeshFile.h"

#include "Intake/Fluent/FluentText.h"
#include "Intake/Rows/Bytes.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace camaron
{
namespace
{
constexpr std::string_view EndMark = "End of Binary Section";
}

//------------------------------------------------------------------------------
// Returns the text after the end mark of a binary section, or nullptr; the mark follows a
// parenthesis if the section has data.
const char* FluentMeshFile::FindEndMark(const char* place, int index, bool hasData) const
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
  if (this->End - text < static_cast<std::ptrdiff_t>(EndMark.size()) ||
    std::memcmp(text, EndMark.data(), EndMark.size()) != 0)
  {
    return nullptr;
  }
  text = SkipSpaceFrom(text + EndMark.size(), this->End);
  std::int64_t number = 0;
  text = ParseInteger(text, this->End, number);
  text = text ? SkipSpaceFrom(text, this->End) : nullptr;
  return text && number == index && text < this->End && *text == ')' ? text + 1 : nullptr;
}

//------------------------------------------------------------------------------
bool FluentMeshFile::SkipBinary(const FluentSection& section, int index)
{
  const std::string_view rest(this->Position, static_cast<std::size_t>(this->End - this->Position));
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

//------------------------------------------------------------------------------
// Finds the end of lists that contain their length: faces "n v1 ... vn c0 c1", or the parts of
// split faces "n child1 ... childn".
const char* FluentMeshFile::FindLists(FluentSection& section)
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

//------------------------------------------------------------------------------
// Reads the body of a binary section after its header.
bool FluentMeshFile::ReadBinaryBody(FluentSection& section, int index)
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
  // Some writers put a line end between the parenthesis and the data. If the data began later, its
  // end would be after the closing parenthesis; if it began earlier, it may end in bytes that look
  // like blanks.
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

//------------------------------------------------------------------------------
// Finds the end of the binary data of a section; nullptr with an error.
const char* FluentMeshFile::FindEndOfData(FluentSection& section)
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
}
