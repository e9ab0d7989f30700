// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MappedFile
 * @brief The bytes of a whole file, mapped into memory where the system can.
 *
 * Reading costs no copy and no memory of our own: pages come from the system's cache when they are
 * touched. Where a file cannot be mapped (a pipe, some file systems) it is read as a whole. So it is for
 * AddressSanitizer, which knows where an allocation ends, but not where a mapped file does.
 */
#ifndef camaron_MappedFile_h
#define camaron_MappedFile_h

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

private:
  std::string Name;
  const char* Data = "";
  std::size_t Size = 0;
  void* Mapping = nullptr;
  std::vector<char> Copy; ///< the content where it could not be mapped
};

/// Last part of a path.
std::string GetFileName(const std::string& path);
}

#endif
