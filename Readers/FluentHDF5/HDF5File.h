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
 * All functions throw HDF5Error. HDF5 must not be called from several threads at once.
 */
#ifndef camaron_HDF5File_h
#define camaron_HDF5File_h

#include "Base/Buffer.h"
#include "Scan/ScanError.h"

#include <cstdint>  // for numbers
#include <optional> // for what may be missing
#include <set>      // for paths
#include <string>   // for names
#include <utility>  // for std::exchange
#include <vector>   // for names

namespace camaron
{
/// The error, with the name of the file and of the object in it.
struct HDF5Error
{
  ScanError Error;
};

/// An identifier of HDF5, released with the object.
class HDF5Id
{
public:
  HDF5Id() = default;
  explicit HDF5Id(std::int64_t id)
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
  ~HDF5Id();
  operator std::int64_t() const { return this->Id; }

private:
  std::int64_t Id = -1;
};

/// Keeps HDF5 from printing errors during its life.
class HDF5Silence
{
public:
  HDF5Silence();
  ~HDF5Silence();
  HDF5Silence(const HDF5Silence&) = delete;
  HDF5Silence& operator=(const HDF5Silence&) = delete;

private:
  int (*Reporter)(std::int64_t, void*) = nullptr;
  void* Data = nullptr;
};

class HDF5File;

/// A group or data set.
class HDF5Object
{
public:
  const std::string& GetPath() const { return this->Path; }
  bool IsData() const { return this->Data; }

  ///@{
  /// The integer of an attribute; without one, an error or nothing.
  std::int64_t GetNumber(const char* attribute) const;
  std::optional<std::int64_t> FindNumber(const char* attribute) const;
  ///@}
  /// Checks that the integer of an attribute, if there is one, is @a count.
  void CheckDeclared(const char* attribute, std::size_t count, const char* what) const;

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
  ///@}
  /// Bytes of a value.
  int GetValueSize() const { return this->ValueSize; }
  /// Reads rows of a data set of integers (std::int32_t) or of reals (double). Integers that need
  /// more than 32 bits become the smallest or greatest number, or negative, so none is a valid id.
  template <typename Value>
  void Read(std::int64_t first, std::int64_t count, Value* values) const;
  /// All rows of a data set of integers, after a check that there are @a count.
  std::vector<std::int32_t> ReadNumbers(std::int64_t count) const;
  /// A data set of one string.
  std::string ReadText() const;

  ///@{
  /// Throws an error about this object, "mesh.msh.h5: meshes/1/nodes: expected ..., found ...", or
  /// an entry of a data set, "mesh.msh.h5: meshes/1/faces/c0/1[17]: ...".
  [[noreturn]] void FailAt(std::int64_t index, ErrorKind kind, const std::string& expected,
    const std::string& found) const;
  void Check(bool good, ErrorKind kind, const std::string& expected, const std::string& found) const
  {
    if (!good)
    {
      this->FailAt(-1, kind, expected, found);
    }
  }
  ///@}

private:
  friend class HDF5File;
  void OpenData();
  bool FindFilters(std::int64_t properties);
  void ReadAs(std::int64_t type, std::int64_t first, std::int64_t count, void* values) const;
  const char* Inflate(std::int64_t chunk) const;
  template <typename Stored, typename Value>
  void ReadInflated(std::int64_t first, std::int64_t count, Value* values) const;

  HDF5File* File = nullptr;
  HDF5Id Id;
  std::string Path; ///< without a slash at the beginning
  bool Data = false;
  int TypeClass = -1, ValueSize = 0;
  bool IsUnsigned32 = false, IsShuffled = false;
  std::int64_t Count = 0, Columns = 1;
  std::int64_t ChunkRows = 0; ///< of data that are inflated here; 0 if HDF5 reads them
  ///@{
  /// The chunks inflated last. HDF5 would inflate with one thread, and keep more in memory.
  mutable std::int64_t FirstInflated = 0, NumberOfInflated = 0;
  mutable Buffer<char> Inflated;
  ///@}
};

class HDF5File
{
public:
  /// Whether a file with these first bytes may be HDF5.
  static bool IsHDF5(const char* begin, const char* end);

  /// Opens bytes that remain where they are. @param name for messages
  /// @param expected bytes of data sets that are no surprise, however small the file is
  HDF5File(std::string name, const char* begin, const char* end, double expected = 0);
  HDF5File(const HDF5File&) = delete;
  HDF5File& operator=(const HDF5File&) = delete;

  const std::string& GetName() const { return this->Name; }
  HDF5Object GetRoot();
  /// Counts memory as if a data set expanded to it.
  void Charge(const HDF5Object& object, double bytes);

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
}

#endif
