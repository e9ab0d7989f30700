// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::HDF5Column
 * @brief Values of consecutive ids, which are stored in sections with their first and last id.
 *
 * Sections are sorted by their ids, whatever their names are. Only one of them is open at a time.
 */
#ifndef camaron_HDF5Column_h
#define camaron_HDF5Column_h

#include "HDF5File.h"

#include <functional> // for parts of groups

namespace camaron
{
class HDF5Column
{
public:
  struct Section
  {
    std::int64_t First, Last; ///< ids
    std::string Path;         ///< of the data set; empty if all values are the same
    std::int32_t Value = 0;   ///< which is this one

    /// Files state a range without ids as 1 to 0 or 0 to 0.
    bool IsEmpty() const
    {
      return this->First > this->Last || (this->First == 0 && this->Last == 0);
    }
    /// Sets the data set, after a check that it has one row per id.
    void SetData(const HDF5Object& data);
  };

  /// Adds the sections in a group, whose names have minId and maxId; @a find(part, section) sets
  /// the data or the value of each. Then calls Finish.
  using FindData = std::function<void(const HDF5Object&, Section&)>;
  void Open(const HDF5Object& group, const char* what, std::int64_t last, bool isComplete,
    const FindData& find);
  void Add(Section section) { this->Sections.push_back(std::move(section)); }
  /// Sorts the sections that have ids, and checks that none overlap, nor exceed @a last; if @a
  /// isComplete, that they contain all ids from 1 to @a last.
  void Finish(const HDF5Object& group, const char* what, std::int64_t last, bool isComplete);

  const std::vector<Section>& GetSections() const { return this->Sections; }
  std::int64_t GetLast() const { return this->Sections.empty() ? 0 : this->Sections.back().Last; }
  /// Whether all these ids are in sections.
  bool Contains(std::int64_t first, std::int64_t last) const;
  /// The path and position of the value of an id, "meshes/1/faces/c0/1[17]"; empty without one.
  std::string Locate(std::int64_t id) const;

  /// Reads the rows of ids from @a first on, each of @a columns values; zeros without a section.
  template <typename Value>
  void Read(HDF5File& file, std::int64_t first, std::int64_t count, Value* values,
    std::int64_t columns = 1);
  /// Throws an error about the value of an id.
  [[noreturn]] void FailAt(HDF5File& file, std::int64_t id, ErrorKind kind,
    const std::string& expected, const std::string& found);

private:
  std::size_t Find(std::int64_t id) const;
  const HDF5Object& Reopen(HDF5File& file, const Section& section);

  std::vector<Section> Sections;
  HDF5Object Opened;
};
}

#endif
