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
  };

  void Add(Section section) { this->Sections.push_back(std::move(section)); }
  /// Adds the rows of @a data, one per id from minId to maxId of @a ids; false if there are none.
  bool Add(const HDF5Object& ids, const HDF5Object& data);
  /// Sorts the sections and checks that none overlap, nor exceed @a last; if @a isComplete, that
  /// they contain all ids from 1 to @a last.
  void Finish(const HDF5Object& group, const char* what, std::int64_t last, bool isComplete);

  const std::vector<Section>& GetSections() const { return this->Sections; }
  /// Whether all these ids are in sections.
  bool Contains(std::int64_t first, std::int64_t last) const;

  /// Reads the values of ids from @a first on; ids without a section have 0. Rows of reals have
  /// three values, the last of which may be missing in the file.
  void Read(HDF5File& file, std::int64_t first, std::int64_t count, std::int32_t* values);
  void Read(HDF5File& file, std::int64_t first, std::int64_t count, double* values);
  /// Throws an error about the value of an id.
  [[noreturn]] void FailAt(HDF5File& file, std::int64_t id, ErrorKind kind,
    const std::string& expected, const std::string& found);

private:
  /// Calls read(section, first, count, offset) for the parts of a range that sections have.
  template <typename Visit>
  void ForSections(std::int64_t first, std::int64_t count, Visit&& visit) const;
  std::size_t Find(std::int64_t id) const;
  const HDF5Object& Open(HDF5File& file, const Section& section);

  std::vector<Section> Sections;
  HDF5Object Opened;
};

/// Sets the first and last id of a section, its attributes minId and maxId; false if it is empty.
bool GetRange(const HDF5Object& object, HDF5Column::Section& section);
/// Checks that a section has one row per id; none without ids.
void CheckCount(const HDF5Object& data, const HDF5Column::Section& section);
/// The sections in a group, after a check that it has as many as it says.
std::vector<std::string> GetSectionNames(const HDF5Object& group);
}

#endif
