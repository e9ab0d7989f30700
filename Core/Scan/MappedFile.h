// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MappedFile
 * @brief The bytes of a whole file, mapped into memory where the system can.
 *
 * Reading costs no copy and no memory of our own: pages come from the system's cache when they are
 * touched. Where a file cannot be mapped (a pipe, some file systems) it is read as a whole. So it
 * is for AddressSanitizer, which knows where an allocation ends, but not where a mapped file does.
 *
 * Bytes of a file that another program writes meanwhile may change between two looks at them, or
 * all become zero (see MappingGuard). So readers must not rely on what they saw earlier where that
 * could lead out of an array; they ask now and then whether to go on, and at the end whether what
 * they have is of one file.
 */
#ifndef camaron_MappedFile_h
#define camaron_MappedFile_h

#include "Scan/MappingGuard.h"
#include "Scan/ScanError.h"

#include <cstddef> // for std::size_t
#include <string>  // for paths
#include <vector>  // for copies

namespace camaron
{
class MappedFile
{
public:
  MappedFile() = default;
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  /// Opens @a path for reading; false with the reason in @a error. Call it once.
  bool Open(const std::string& path, ScanError& error);

  const char* begin() const { return this->Data; }
  const char* end() const { return this->Data + this->Size; }
  std::size_t size() const { return this->Size; }
  /// Last part of the path, for messages.
  const std::string& GetName() const { return this->Name; }

  /// Whether the file is still as it was when it was opened; false with the reason in @a error.
  bool IsUnchanged(ScanError& error) const;
  /// Whether some file that this thread has open was changed; for a look now and then.
  static bool HasAnyChanged();

  /// Whether files may be mapped. Tests want it where it is off.
#if defined(__SANITIZE_ADDRESS__)
  inline static bool MayMap = false;
#else
  inline static bool MayMap = true;
#endif

private:
  bool Map(std::size_t size);

  /// What tells one state of a file from another.
  struct Stamp
  {
    long long Size = 0;
    long long Seconds = 0;
    long long Nanoseconds = 0;
    long long Device = 0;
    long long Node = 0;
    bool IsOfFile = false; ///< not of a pipe, say
  };
  static bool GetStamp(int file, Stamp& stamp);
  bool HasStamp() const;

  int File = -1;
  Stamp Opened;
  std::string Name;
  const char* Data = "";
  std::size_t Size = 0;
  void* Mapping = nullptr;
  MappingGuard Guard;
  std::vector<char> Copy; ///< the content where it could not be mapped
};

/// Last part of a path.
std::string GetFileName(const std::string& path);
}

#endif
