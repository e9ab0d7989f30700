// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::OutputFile
 * @brief Writes a file that appears under its name only when it is complete.
 *
 * Everything goes into a temporary file beside the target, which Commit renames. Until then, and if
 * anything fails, a file of that name stays as it was, and no other is left behind. A link stays
 * one. What is no regular file (a device, a pipe) is written directly. A file that is protected
 * against writing is not replaced. The first error sticks.
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
   * Writes what is still to be written; false with the reason in GetError(). Of several files that
   * belong together all are closed before any is committed, so that they appear only if all fit.
   */
  bool Close();
  /// Closes and completes the file; false with the reason in GetError().
  bool Commit();

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
