// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HDF5Column.h"

#include <algorithm>
#include <utility>

namespace camaron
{
//------------------------------------------------------------------------------
bool GetRange(const HDF5Object& object, HDF5Column::Section& section)
{
  section.First = object.GetNumber("minId");
  section.Last = object.GetNumber("maxId");
  return section.First <= section.Last;
}

//------------------------------------------------------------------------------
void CheckCount(const HDF5Object& data, const HDF5Column::Section& section)
{
  // Unsigned, as damaged ids may be so far apart that the difference is out of range.
  const std::uint64_t wanted = section.First <= section.Last
    ? static_cast<std::uint64_t>(section.Last) - static_cast<std::uint64_t>(section.First) + 1
    : 0;
  data.Check(data.IsData() && static_cast<std::uint64_t>(data.GetCount()) == wanted,
    ErrorKind::Count, std::to_string(wanted) + " entries, as minId and maxId say",
    std::to_string(data.GetCount()));
}

//------------------------------------------------------------------------------
std::vector<std::string> GetSectionNames(const HDF5Object& group)
{
  const std::vector<std::string> names = group.GetNames();
  const auto declared = group.FindNumber("nSections");
  const auto size = static_cast<std::int64_t>(names.size());
  group.Check(!declared || *declared == size, ErrorKind::Count,
    std::to_string(declared.value_or(0)) + " sections, as nSections says", std::to_string(size));
  return names;
}

//------------------------------------------------------------------------------
bool HDF5Column::Add(const HDF5Object& ids, const HDF5Object& data)
{
  Section section;
  const bool hasIds = GetRange(ids, section);
  CheckCount(data, section);
  section.Path = data.GetPath();
  if (hasIds)
  {
    this->Add(std::move(section));
  }
  return hasIds;
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
    const bool follows = isComplete ? section.First == next : section.First >= next;
    group.Check(follows && section.Last >= section.First, ErrorKind::Index,
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
  for (std::size_t i = this->Find(first); first <= last; ++i)
  {
    if (i == this->Sections.size() || this->Sections[i].First > first)
    {
      return false;
    }
    first = this->Sections[i].Last + 1;
  }
  return true;
}

//------------------------------------------------------------------------------
const HDF5Object& HDF5Column::Open(HDF5File& file, const Section& section)
{
  if (this->Opened.GetPath() != section.Path)
  {
    this->Opened = HDF5Object(); // its cache is released before the next one is needed
    this->Opened = file.Reopen(section.Path);
  }
  return this->Opened;
}

//------------------------------------------------------------------------------
template <typename Visit>
void HDF5Column::ForSections(std::int64_t first, std::int64_t count, Visit&& visit) const
{
  const std::int64_t end = first + count;
  for (std::size_t i = this->Find(first);
    i < this->Sections.size() && this->Sections[i].First < end; ++i)
  {
    const Section& section = this->Sections[i];
    const std::int64_t from = std::max(first, section.First);
    visit(section, from, std::min(end, section.Last + 1) - from, from - first);
  }
}

//------------------------------------------------------------------------------
void HDF5Column::Read(HDF5File& file, std::int64_t first, std::int64_t count, std::int32_t* values)
{
  std::fill_n(values, this->Contains(first, first + count - 1) ? 0 : count, 0);
  this->ForSections(first, count,
    [&](const Section& section, std::int64_t from, std::int64_t size, std::int64_t offset)
    {
      if (section.Path.empty())
      {
        std::fill_n(values + offset, size, section.Value);
        return;
      }
      this->Open(file, section).Read(from - section.First, size, values + offset);
    });
}

//------------------------------------------------------------------------------
void HDF5Column::Read(HDF5File& file, std::int64_t first, std::int64_t count, double* values)
{
  this->ForSections(first, count,
    [&](const Section& section, std::int64_t from, std::int64_t size, std::int64_t offset)
    {
      const HDF5Object& data = this->Open(file, section);
      double* const rows = values + 3 * offset;
      data.Read(from - section.First, size, rows);
      for (std::int64_t row = data.GetColumns() == 2 ? size - 1 : -1; row >= 0; --row)
      {
        rows[3 * row + 2] = 0; // from the last on, as rows move to the end
        rows[3 * row + 1] = rows[2 * row + 1];
        rows[3 * row] = rows[2 * row];
      }
    });
}

//------------------------------------------------------------------------------
void HDF5Column::FailAt(HDF5File& file, std::int64_t id, ErrorKind kind,
  const std::string& expected, const std::string& found)
{
  const Section& section = this->Sections.at(this->Find(id));
  this->Open(file, section).FailAt(id - section.First, kind, expected, found);
}
}
