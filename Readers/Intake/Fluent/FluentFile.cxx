// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentFile.h"

#include "Intake/Fluent/FluentText.h"
#include "Scan/TextScanner.h"

#include <algorithm>

namespace camaron
{
//------------------------------------------------------------------------------
FluentFile::FluentFile(std::string name, const char* begin, const char* end)
  : Name(std::move(name))
  , Begin(begin)
  , End(end)
{
}

//------------------------------------------------------------------------------
void FluentFile::FailAt(
  const char* place, ErrorKind kind, const std::string& expected, const std::string& found)
{
  if (this->HasFailed())
  {
    return;
  }
  this->Error = { kind, this->Locate(place) + ": expected " + expected + ", found " + found };
}

//------------------------------------------------------------------------------
void FluentFile::FailAt(const char* place, ErrorKind kind, const std::string& expected)
{
  constexpr int MaxLength = 30;
  place = SkipSpaceFrom(place, this->End);
  std::string word;
  for (const char* c = place; c < this->End && !IsSpace(*c); ++c)
  {
    if (word.size() == MaxLength)
    {
      word += "...";
      break;
    }
    word += ToPrintable(*c);
    if (*c == ')')
    {
      break;
    }
  }
  this->FailAt(place, kind, expected, word.empty() ? "the end of the file" : "'" + word + "'");
}

//------------------------------------------------------------------------------
void FluentFile::Fail(ErrorKind kind, const std::string& expected, const std::string& found)
{
  if (!this->HasFailed())
  {
    this->Error = { kind, this->Name + ": expected " + expected + ", found " + found };
  }
}

//------------------------------------------------------------------------------
bool FluentFile::LoadStored(const FluentSection&, std::int64_t, std::int64_t, Buffer<std::int32_t>&)
{
  return false;
}

//------------------------------------------------------------------------------
bool FluentFile::LoadStored(const FluentSection&, std::int64_t, std::int64_t, Buffer<double>&)
{
  return false;
}

//------------------------------------------------------------------------------
std::vector<const FluentSection*> FluentFile::SortById(const std::vector<FluentSection>& sections)
{
  std::vector<const FluentSection*> sorted;
  for (const FluentSection& section : sections)
  {
    sorted.push_back(&section);
  }
  std::stable_sort(sorted.begin(), sorted.end(),
    [](const FluentSection* a, const FluentSection* b) { return a->Header[1] < b->Header[1]; });
  return sorted;
}

//------------------------------------------------------------------------------
bool FluentFile::CheckIds(const FluentSection& section, std::int64_t lastId,
  const FluentTotal& declared, const std::string& what)
{
  if (section.Header[1] <= lastId)
  {
    this->FailAt(section.Place, ErrorKind::Index,
      what + " after " + std::to_string(lastId) + ", the last one of another section",
      std::to_string(section.Header[1]));
  }
  else if (declared.Count >= 0 && section.Header[2] > declared.Count)
  {
    this->FailAt(section.Place, ErrorKind::Index,
      what + " from 1 to " + std::to_string(declared.Count), std::to_string(section.Header[2]));
  }
  return !this->HasFailed();
}

//------------------------------------------------------------------------------
TextLines FluentFile::GetLines(
  const FluentSection& section, const Progress& progress, vtkIdType chunk) const
{
  TextScanner scanner("", this->Begin, section.End);
  scanner.SetPosition(section.Begin);
  return TextLines(scanner, progress, chunk);
}

//------------------------------------------------------------------------------
FluentRows FluentFile::FindRows(
  const FluentSection& section, const Progress& progress, vtkIdType chunk) const
{
  FluentRows rows{ this->GetLines(section, progress, chunk), {} };
  const TextLines::Section records = rows.Lines.Find(section.Begin, section.GetCount());
  if (records && SkipSpaceFrom(records.End, section.End) == section.End)
  {
    rows.Records = records;
  }
  return rows;
}
}
