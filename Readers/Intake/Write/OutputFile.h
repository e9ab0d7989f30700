// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::OutputFile
 * @brief Writes a file that replaces the target only when it is complete.
 *
 * Data is written to a temporary file in the same folder, which Commit renames. Until then, and
 * after errors, an existing file is unchanged and no other file remains. Symbolic links are kept.
 * Devices and pipes are written directly. Write-protected files are not replaced, nor files
 * that InputFiles protects. The first error is kept.
 */
#ifndef camaron_OutputFile_h
#define camaron_OutputFile_h

#include "Scan/ScanError.h"

#include <cstdio> // for std::FILE
#include <string> // for paths

namespace camaron
{
class OutputFile
{
public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void Write(const char* bytes, std::size_t size);
  void Write(const std::string& bytes) { this->Write(bytes.data(), bytes.size()); }
  /**
   * Writes the remaining data; false with the reason in GetError(). If several files belong
   * together, close all before committing any, so they only appear if all fit on the disk.
   */
  bool Close();
  /// Closes and renames the file; false with the reason in GetError().
  bool Commit();
  /// Commits if everything was written; otherwise, and on errors, returns false with the reason in
  /// @a error, unless it has one.
  bool Finish(bool isWritten, ScanError& error)
  {
    const bool good = isWritten && this->Commit();
    error = error ? error : this->Error;
    return good;
  }

  const ScanError& GetError() const { return this->Error; }
  bool HasFailed() const { return static_cast<bool>(this->Error); }

private:
  void Fail(int code);

  std::string Name; ///< last part of the path, for messages
  std::string Target;
  std::string Temporary; ///< empty if the target is written directly
  std::FILE* File = nullptr;
  ScanError Error;
};
}

#endif
