// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::Inflation
 * @brief The content of a file that was compressed with gzip.
 *
 * Memory grows with what is inflated, so that nothing is believed of what the file says of its
 * size. A small file that inflates without end is given up.
 */
#ifndef camaron_Inflation_h
#define camaron_Inflation_h

#include "Base/Progress.h"
#include "Scan/MappedFile.h"

#include <cstddef> // for std::size_t

namespace camaron
{
class Inflation
{
public:
  Inflation() = default;
  ~Inflation();
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;

  /// Whether a file begins as gzip's do.
  static bool IsCompressed(const char* begin, const char* end);

  /**
   * Inflates a file; false with the reason in @a error, or if stopped.
   * @param limit if positive, as many bytes are enough
   */
  bool Inflate(
    const MappedFile& file, ScanError& error, const Progress& progress, std::size_t limit = 0);

  /// Whether something other than zeros, which are padding, follows what was inflated.
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
