// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::Inflation
 * @brief The decompressed content of a gzip file.
 *
 * Memory grows with the output; sizes that the file declares are not trusted. Decompression fails
 * if a small file expands excessively.
 */
#ifndef camaron_Inflation_h
#define camaron_Inflation_h

#include "Scan/ScanError.h"

#include <cstddef> // for std::size_t
#include <string>  // for names

namespace camaron
{
class Progress;

class Inflation
{
public:
  Inflation() = default;
  ~Inflation();
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;

  /// Whether a file begins with the signature of gzip.
  static bool IsCompressed(const char* begin, const char* end);

  /**
   * Decompresses the bytes of a file; false with the reason in @a error, or if stopped.
   * @param name of the file, for errors
   * @param limit if positive, stop after this many bytes
   */
  bool Inflate(const std::string& name, const char* begin, const char* end, ScanError& error,
    const Progress& progress, std::size_t limit = 0);

  /// Whether anything but zeros, which are padding, follows the compressed data.
  bool HasTrailingData() const { return this->TrailingData; }

  const char* begin() const { return this->Data ? this->Data : ""; }
  const char* end() const { return this->begin() + this->Size; }

private:
  bool Grow(std::size_t capacity);

  char* Data = nullptr;
  std::size_t Size = 0;
  std::size_t Capacity = 0;
  bool TrailingData = false;
};
}

#endif
