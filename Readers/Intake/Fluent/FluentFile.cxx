// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentFile.h"

#include "Scan/ScanError.h"

#include <algorithm>
#include <string_view>

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
  place = SkipSpaceFrom(place, this->End);
  const char* const bracket = std::find(place, this->End, ')');
  const char* const end = bracket < this->End ? bracket + 1 : bracket;
  this->FailAt(place, kind, expected,
    place == end ? "the end of the file"
                 : QuoteWord(std::string_view(place, static_cast<std::size_t>(end - place))));
}

//------------------------------------------------------------------------------
void FluentFile::Fail(ErrorKind kind, const std::string& expected, const std::string& found)
{
  this->Fail({ kind, "expected " + expected + ", found " + found });
}

//------------------------------------------------------------------------------
void FluentFile::Fail(const ScanError& error)
{
  if (error && !this->HasFailed())
  {
    this->Error = { error.Kind, this->Name + ": " + error.Message };
  }
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
}
