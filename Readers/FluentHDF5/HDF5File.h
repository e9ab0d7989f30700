// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::HDF5File
 * @brief Reads groups, attributes and data sets of an HDF5 file in memory, without trusting it.
 *
 * HDF5 reads the bytes where they are, so that no link leads to another file, and a file that
 * another program changes is noticed as for other formats. Links other than hard ones, external and
 * virtual data sets, and filters that are not HDF5's own are refused. Data sets are compared with
 * the size of the file before memory is allocated for them: one that expands more than deflate
 * can, or data sets that together expand more than 100 times, are refused.
 *
 * All functions throw ScanError. HDF5 must not be called from several threads at once.
 */
#ifndef camaron_HDF5File_h
#define camaron_HDF5File_h

#include "Base/Buffer.h"
#include "Base/Text.h"
#include "Scan/MappedFile.h"

#include "vtk_hdf5.h"

#include <cstdint> // for numbers
#include <set>     // for paths
#include <string>  // for names
#include <utility> // for std::exchange
#include <vector>  // for names

namespace camaron
{
/// An identifier of HDF5, released with the object.
class HDF5Id
{
public:
  explicit HDF5Id(hid_t id = -1)
    : Id(id)
  {
  }
  HDF5Id(HDF5Id&& other) noexcept
    : Id(std::exchange(other.Id, -1))
  {
  }
  HDF5Id& operator=(HDF5Id&& other) noexcept
  {
    std::swap(this->Id, other.Id);
    return *this;
  }
  ~HDF5Id()
  {
    if (this->Id >= 0)
    {
      H5Idec_ref(this->Id);
    }
  }
  operator hid_t() const { return this->Id; }

private:
  hid_t Id;
};

/// Keeps HDF5 from printing errors during its life.
class HDF5Silence
{
public:
  HDF5Silence()
  {
    H5Eget_auto2(H5E_DEFAULT, &this->Reporter, &this->Data);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~HDF5Silence() { H5Eset_auto2(H5E_DEFAULT, this->Reporter, this->Data); }
  HDF5Silence(const HDF5Silence&) = delete;
  HDF5Silence& operator=(const HDF5Silence&) = delete;

private:
  H5E_auto2_t Reporter = nullptr;
  void* Data = nullptr;
};

class HDF5Object;

class HDF5File
{
public:
  /// Whether a file with these first bytes may be HDF5.
  static bool IsHDF5(const char* begin, const char* end);

  /// Opens bytes that remain where they are. @param name for messages
  /// @param expected bytes of data sets that are no surprise, however small the file is
  HDF5File(std::string name, const char* begin, const char* end, double expected = 0);

  const std::string& GetName() const { return this->Name; }
  HDF5Object GetRoot();
  /// Counts memory as if a data set expanded to it.
  void Charge(const HDF5Object& object, double bytes);
  ///@{
  /// Throws an error about an object, "mesh.msh.h5: meshes/1/nodes: expected ..., found ..."; if a
  /// value is not in a range.
  [[noreturn]] void Fail(const std::string& path, ErrorKind kind, const std::string& expected,
    const std::string& found) const
  {
    throw ScanError{ kind,
      this->Name + ": " + path + (path.empty() ? "" : ": ") + "expected " + expected + ", found " +
        found };
  }
  void CheckRange(const std::string& path, std::int64_t value, std::int64_t least,
    std::int64_t most, const std::string& what) const
  {
    if (value < least || value > most)
    {
      this->Fail(path, ErrorKind::Index,
        what + " from " + std::to_string(least) + " to " + std::to_string(most),
        std::to_string(value));
    }
  }
  ///@}

private:
  friend class HDF5Object;
  std::string Name;
  const char* Begin;
  double Size;
  double Budget;                ///< bytes of data sets that may still be opened
  std::set<std::string> Opened; ///< paths of those that have been
  HDF5Silence Silence;
  HDF5Id Id;
};

/// Opens a file for @a use(file), and returns its result; false with the error if one is thrown.
template <typename Use>
bool UseHDF5(const MappedFile& mapped, double expected, ScanError& error, Use&& use)
{
  try
  {
    HDF5File file(mapped.GetName(), mapped.begin(), mapped.end(), expected);
    return use(file);
  }
  catch (const ScanError& failure)
  {
    error = failure;
    return false;
  }
}

/// A group or data set.
class HDF5Object
{
public:
  const std::string& GetPath() const { return this->Path; }
  bool IsData() const { return this->Data; }

  /// The integer of an attribute, which must exist and be in a range.
  std::int64_t GetNumber(
    const char* attribute, std::int64_t least = INT64_MIN, std::int64_t most = INT64_MAX) const;
  /// Checks that the integer of an attribute, if there is one, is @a count.
  void CheckDeclared(const char* attribute, std::int64_t count, const char* what) const;

  /// Names of the objects in a group, sorted as text.
  std::vector<std::string> GetNames() const;
  ///@{
  /// An object in a group, by its path from there.
  bool Has(const std::string& path) const;
  HDF5Object Open(const std::string& path) const;
  ///@}

  ///@{
  /// Numbers of rows of a data set, and of values per row (1 for one dimension).
  std::int64_t GetCount() const { return this->Count; }
  std::int64_t GetColumns() const { return this->Columns; }
  void CheckColumns(std::int64_t columns) const
  {
    this->Check(this->Columns == columns, ErrorKind::Count,
      "rows of " + CountOf(columns, "value", "values"), std::to_string(this->Columns));
  }
  ///@}
  /// Bytes of a value.
  int GetValueSize() const { return this->ValueSize; }
  /// Reads rows of a data set of integers (std::int32_t) or of reals (double). Integers that need
  /// more than 32 bits become the smallest or greatest number, or negative, so none is a valid id.
  template <typename Value>
  void Read(std::int64_t first, std::int64_t count, Value* values) const;
  /// All rows of a data set of integers, which have one each.
  std::vector<std::int32_t> ReadNumbers() const;
  /// A data set of one string.
  std::string ReadText() const;

  /// Throws an error about this object unless @a good.
  void Check(bool good, ErrorKind kind, const std::string& expected, const std::string& found) const
  {
    if (!good)
    {
      this->File->Fail(this->Path, kind, expected, found);
    }
  }

private:
  friend class HDF5File;
  void OpenData();
  bool FindFilters(hid_t properties);
  void ReadAs(hid_t type, std::int64_t first, std::int64_t count, void* values) const;
  void Inflate(std::int64_t first, std::int64_t last) const;
  template <typename Stored, typename Value>
  void ReadInflated(std::int64_t first, std::int64_t count, Value* values) const;

  HDF5File* File = nullptr;
  HDF5Id Id;
  std::string Path; ///< without a slash at the beginning
  bool Data = false;
  int TypeClass = -1, ValueSize = 0;
  bool IsShuffled = false;
  std::int64_t Count = 0, Columns = 1;
  std::int64_t ChunkRows = 0; ///< of data that are inflated here; 0 if HDF5 reads them
  ///@{
  /// The chunks inflated last. HDF5 would inflate with one thread, and keep more in memory.
  mutable std::int64_t FirstInflated = 0;
  mutable Buffer<char> Inflated;
  ///@}
};
}

#endif
