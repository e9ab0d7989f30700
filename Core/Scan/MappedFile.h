// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MappedFile
 * @brief The bytes of a file, memory-mapped if possible.
 *
 * Reading needs no copy and no additional memory: the system's cache provides pages when they are
 * accessed. A file that cannot be mapped (a pipe, some file systems) is read completely. So is
 * every file under AddressSanitizer, which knows the bounds of an allocation but not those of a
 * mapped file.
 *
 * Files that gzip has compressed are decompressed in memory: begin() and end() are those of the
 * content.
 *
 * If another program writes the file meanwhile, bytes may change between two accesses, or all
 * become zero (see MappingGuard). Readers must therefore not rely on earlier reads where this
 * could lead outside of an array; they check HasAnyChanged now and then, and IsUnchanged at the
 * end.
 */
#ifndef camaron_MappedFile_h
#define camaron_MappedFile_h

#include "Scan/FileStates.h"
#include "Scan/ScanError.h"

#include <cstddef> // for std::size_t
#include <memory>  // for what is decompressed
#include <string>  // for paths
#include <vector>  // for copies

namespace camaron
{
/**
 * Keeps the process alive if a mapped file becomes shorter, or unreadable, while in use.
 *
 * When a page of a mapping is no longer in the file, accessing it raises the signal SIGBUS, which
 * ends the process. While guards exist, their signal handler replaces the whole mapping by zeros,
 * in the thread that raised the signal; the reader continues with zeros and detects this by
 * IsLost. Other faults are forwarded to the previous handler, which is restored with the last
 * guard.
 */
class MappingGuard
{
public:
  MappingGuard() = default;
  ~MappingGuard() { this->Leave(); }
  MappingGuard(const MappingGuard&) = delete;
  MappingGuard& operator=(const MappingGuard&) = delete;

  /**
   * Guards mapped memory, from its first page on. Returns false if there are too many guards, or
   * another handler was installed after this one and may not forward the signal.
   */
  bool Enter(void* mapping, std::size_t size);
  /// Must be called before the memory is unmapped.
  void Leave();

  /// Whether the mapping was replaced by zeros.
  bool IsLost() const;

private:
  int Slot = -1;
};

class Inflation;
class Progress;

class MappedFile
{
public:
  MappedFile();
  /// Opens @a path; if it cannot be read, the file is empty. Of a compressed file, only as much as
  /// programs need to recognize the format.
  explicit MappedFile(const std::string& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  ///@{
  /**
   * Opens @a path for reading; false with the reason in @a error, or if stopped. Call this once.
   * @param limit of a compressed file, decompress only this many bytes, if positive
   */
  bool Open(const std::string& path, ScanError& error);
  bool Open(
    const std::string& path, ScanError& error, const Progress& progress, std::size_t limit = 0);
  ///@}

  const char* begin() const { return this->Data; }
  const char* end() const { return this->Data + this->Size; }
  std::size_t size() const { return this->Size; }
  bool IsCompressed() const { return this->Content != nullptr; }
  /// Whether anything but padding follows the compressed content.
  bool HasTrailingData() const;
  /// Last part of the path, for messages.
  const std::string& GetName() const { return this->Name; }

  /// Whether the file is in the same state as when it was opened; false with the reason in
  /// @a error.
  bool IsUnchanged(ScanError& error) const;
  /// Whether any file that this thread has open was changed; for occasional checks.
  static bool HasAnyChanged();

  /// Whether files may be mapped. Tests set it where it is off.
#if defined(__SANITIZE_ADDRESS__)
  inline static bool MayMap = false;
#else
  inline static bool MayMap = true;
#endif

private:
  bool OpenAsIs(const std::string& path, ScanError& error);
  bool Map(std::size_t size);

  /// Identifies a state of a file.
  struct Stamp : FileStates::File
  {
    bool IsOfFile; ///< false for a pipe, for example
  };
  static bool GetStamp(int file, Stamp& stamp);
  bool HasStamp() const;

  int File = -1;
  Stamp Opened = {};
  std::string Name;
  const char* Data = "";
  std::size_t Size = 0;
  void* Mapping = nullptr;
  std::size_t MappedSize = 0;
  MappingGuard Guard;
  std::vector<char> Copy;             ///< the bytes, if the file could not be mapped
  std::unique_ptr<Inflation> Content; ///< of a compressed file
};

/// Last part of a path.
std::string GetFileName(const std::string& path);
/// A path without the last extension of a compressed file, ".gz".
std::string WithoutGz(const std::string& path);
}

#endif
