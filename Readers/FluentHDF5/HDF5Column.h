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

#include "Base/FunctionRef.h" // for values of groups
#include "HDF5File.h"

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
    /// The path of something else in the group of the data set.
    std::string GetPathOf(const char* name) const
    {
      return this->Path.substr(0, this->Path.rfind('/') + 1) + name;
    }
  };

  HDF5Column(HDF5File& file)
    : File(file)
  {
  }

  /// Adds the sections in a group, which have minId and maxId, and calls Finish. A section is a
  /// data set with a row of @a columns per id (0: as many as in the first section), or a group with
  /// one of this @a name, unless @a getValue gives all its ids another value than 0.
  void Open(
    const HDF5Object& group, const char* what, std::int64_t last, bool isComplete,
    std::int64_t columns = 1, const char* name = nullptr,
    FunctionRef<std::int64_t(const HDF5Object&)> getValue = [](const HDF5Object&) { return 0; });
  /// Adds a section, unless it is empty.
  void Add(Section section);
  /// Sorts the sections, and checks that none overlap, nor exceed @a last; if @a isComplete, that
  /// they contain all ids from 1 to @a last.
  void Finish(const HDF5Object& group, const char* what, std::int64_t last, bool isComplete);

  const std::vector<Section>& GetSections() const { return this->Sections; }
  std::int64_t GetColumns() const { return this->Columns; }
  /// Whether float stores all values.
  bool IsSingle() const { return this->Single; }
  /// Whether all these ids are in sections.
  bool Contains(std::int64_t first, std::int64_t last) const;
  /// The path and position of the value of an id, "meshes/1/faces/c0/1[17]"; empty without one.
  std::string Locate(std::int64_t id) const;

  /// Reads the rows of ids from @a first on; zeros without a section.
  template <typename Value>
  void Read(std::int64_t first, std::int64_t count, Value* values);

private:
  std::size_t Find(std::int64_t id) const;

  HDF5File& File;
  std::int64_t Columns = 1;
  bool Single = true;
  std::vector<Section> Sections;
  HDF5Object Opened;
};
}

#endif
