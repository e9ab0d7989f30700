// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HDF5Column.h"

#include "Base/Text.h"

#include <algorithm>
#include <utility>

namespace camaron
{
//------------------------------------------------------------------------------
void HDF5Column::Section::SetData(const HDF5Object& data)
{
  // Unsigned, as damaged ids may be so far apart that the difference is out of range.
  const std::uint64_t wanted = this->IsEmpty()
    ? 0
    : static_cast<std::uint64_t>(this->Last) - static_cast<std::uint64_t>(this->First) + 1;
  data.Check(data.IsData() && static_cast<std::uint64_t>(data.GetCount()) == wanted,
    ErrorKind::Count, std::to_string(wanted) + " entries, as minId and maxId say",
    std::to_string(data.GetCount()));
  this->Path = data.GetPath();
}

//------------------------------------------------------------------------------
void HDF5Column::Open(const HDF5Object& group, const char* what, std::int64_t last, bool isComplete,
  const FindData& find)
{
  const std::vector<std::string> names = group.GetNames();
  group.CheckDeclared("nSections", names.size(), "sections");
  for (const std::string& name : names)
  {
    const HDF5Object part = group.Open(name);
    Section section{ part.GetNumber("minId"), part.GetNumber("maxId"), "" };
    find(part, section);
    this->Add(std::move(section));
  }
  this->Finish(group, what, last, isComplete);
}

//------------------------------------------------------------------------------
void HDF5Column::Finish(
  const HDF5Object& group, const char* what, std::int64_t last, bool isComplete)
{
  this->Sections.erase(std::remove_if(this->Sections.begin(), this->Sections.end(),
                         [](const Section& section) { return section.IsEmpty(); }),
    this->Sections.end());
  std::stable_sort(this->Sections.begin(), this->Sections.end(),
    [](const Section& a, const Section& b) { return a.First < b.First; });
  std::int64_t next = 1;
  for (const Section& section : this->Sections)
  {
    group.Check(isComplete ? section.First == next : section.First >= next, ErrorKind::Index,
      std::string(what) + (isComplete ? " from " : " not before ") + std::to_string(next) +
        " in the next section",
      std::to_string(section.First) + " to " + std::to_string(section.Last));
    group.Check(section.Last <= last, ErrorKind::Index,
      std::string(what) + " up to " + std::to_string(last), std::to_string(section.Last));
    next = section.Last + 1;
  }
  group.Check(!isComplete || next == last + 1, ErrorKind::Truncated,
    std::string(what) + " up to " + std::to_string(last) + " in its sections",
    std::to_string(next - 1));
}

//------------------------------------------------------------------------------
// The first section that does not end before an id.
std::size_t HDF5Column::Find(std::int64_t id) const
{
  const auto found = std::lower_bound(this->Sections.begin(), this->Sections.end(), id,
    [](const Section& section, std::int64_t value) { return section.Last < value; });
  return static_cast<std::size_t>(found - this->Sections.begin());
}

//------------------------------------------------------------------------------
bool HDF5Column::Contains(std::int64_t first, std::int64_t last) const
{
  std::int64_t count = 0;
  for (const Section& section : this->Sections)
  {
    const std::int64_t end = std::min(last, section.Last) + 1;
    count += std::max<std::int64_t>(end - std::max(first, section.First), 0);
  }
  return count > last - first;
}

//------------------------------------------------------------------------------
std::string HDF5Column::Locate(std::int64_t id) const
{
  const std::size_t i = this->Find(id);
  const bool isInside = i < this->Sections.size() && this->Sections[i].First <= id;
  return isInside
    ? this->Sections[i].Path + "[" + std::to_string(id - this->Sections[i].First) + "]"
    : "";
}

//------------------------------------------------------------------------------
const HDF5Object& HDF5Column::Reopen(HDF5File& file, const Section& section)
{
  if (this->Opened.GetPath() != section.Path)
  {
    this->Opened = HDF5Object(); // its cache is released before the next one is needed
    this->Opened = file.GetRoot().Open(section.Path);
  }
  return this->Opened;
}

//------------------------------------------------------------------------------
template <typename Value>
void HDF5Column::Read(
  HDF5File& file, std::int64_t first, std::int64_t count, Value* values, std::int64_t columns)
{
  const std::int64_t end = first + count;
  for (std::size_t i = this->Find(first); first < end;)
  {
    const Section* const next = i < this->Sections.size() ? &this->Sections[i] : nullptr;
    const bool isInside = next && next->First <= first;
    const std::int64_t size = std::min(end,
                                !next        ? end
                                  : isInside ? next->Last + 1
                                             : next->First) -
      first;
    if (isInside && !next->Path.empty())
    {
      const HDF5Object& data = this->Reopen(file, *next);
      data.Check(data.GetColumns() == columns, ErrorKind::Count,
        "rows of " + CountOf(columns, "value", "values"), std::to_string(data.GetColumns()));
      data.Read(first - next->First, size, values);
    }
    else
    {
      std::fill_n(values, size * columns, static_cast<Value>(isInside ? next->Value : 0));
    }
    first += size;
    values += size * columns;
    i += isInside;
  }
}
template void HDF5Column::Read(HDF5File&, std::int64_t, std::int64_t, std::int32_t*, std::int64_t);
template void HDF5Column::Read(HDF5File&, std::int64_t, std::int64_t, double*, std::int64_t);

//------------------------------------------------------------------------------
void HDF5Column::FailAt(HDF5File& file, std::int64_t id, ErrorKind kind,
  const std::string& expected, const std::string& found)
{
  const Section& section = this->Sections.at(this->Find(id));
  this->Reopen(file, section).FailAt(id - section.First, kind, expected, found);
}
}
