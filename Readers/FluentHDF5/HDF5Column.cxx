// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HDF5Column.h"

#include <algorithm>

namespace camaron
{
//------------------------------------------------------------------------------
void HDF5Column::Open(const HDF5Object& group, const char* what, std::int64_t last, bool isComplete,
  std::int64_t columns, const char* name, FunctionRef<std::int64_t(const HDF5Object&)> getValue)
{
  const std::vector<std::string> parts = group.GetNames();
  group.CheckDeclared("nSections", static_cast<std::int64_t>(parts.size()), "sections");
  this->Columns = columns;
  for (const std::string& part : parts)
  {
    HDF5Object data = group.Open(part);
    Section section{ data.GetNumber("minId"), data.GetNumber("maxId"), "",
      static_cast<std::int32_t>(getValue(data)) };
    if (section.Value == 0)
    {
      data = name ? data.Open(name) : std::move(data);
      // Unsigned, as damaged ids may be so far apart that the difference is out of range.
      const std::uint64_t wanted = section.IsEmpty()
        ? 0
        : static_cast<std::uint64_t>(section.Last) - static_cast<std::uint64_t>(section.First) + 1;
      data.Check(data.IsData() && static_cast<std::uint64_t>(data.GetCount()) == wanted,
        ErrorKind::Count, std::to_string(wanted) + " entries, as minId and maxId say",
        std::to_string(data.GetCount()));
      section.Path = data.GetPath();
      if (wanted > 0)
      {
        this->Columns = this->Columns > 0 ? this->Columns : data.GetColumns();
        data.CheckColumns(this->Columns);
        this->Single = this->Single && data.GetValueSize() <= static_cast<int>(sizeof(float));
      }
    }
    this->Add(std::move(section));
  }
  this->Columns = std::max<std::int64_t>(this->Columns, 1); // also without sections
  this->Finish(group, what, last, isComplete);
}

//------------------------------------------------------------------------------
void HDF5Column::Add(Section section)
{
  if (!section.IsEmpty())
  {
    this->Sections.push_back(std::move(section));
  }
}

//------------------------------------------------------------------------------
void HDF5Column::Finish(
  const HDF5Object& group, const char* what, std::int64_t last, bool isComplete)
{
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
template <typename Value>
void HDF5Column::Read(std::int64_t first, std::int64_t count, Value* values)
{
  const std::int64_t end = first + count;
  for (std::size_t i = this->Find(first); first < end;)
  {
    const Section* const next = i < this->Sections.size() ? &this->Sections[i] : nullptr;
    const bool isInside = next && next->First <= first;
    const std::int64_t nextEnd = !next ? end : isInside ? next->Last + 1 : next->First;
    const std::int64_t size = std::min(end, nextEnd) - first;
    if (isInside && !next->Path.empty())
    {
      if (this->Opened.GetPath() != next->Path)
      {
        this->Opened = HDF5Object(); // its cache is released before the next one is needed
        this->Opened = this->File.GetRoot().Open(next->Path);
        this->Opened.CheckColumns(this->Columns);
      }
      this->Opened.Read(first - next->First, size, values);
    }
    else
    {
      std::fill_n(values, size * this->Columns, static_cast<Value>(isInside ? next->Value : 0));
    }
    first += size;
    values += size * this->Columns;
    i += isInside;
  }
}
template void HDF5Column::Read(std::int64_t, std::int64_t, std::int32_t*);
template void HDF5Column::Read(std::int64_t, std::int64_t, double*);
}
