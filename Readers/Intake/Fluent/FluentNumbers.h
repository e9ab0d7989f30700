// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentNumbers
 * @brief Reads the numbers in the text of a section in parallel, whatever its lines: ids and sizes
 * (std::int32_t), which are hexadecimal, or coordinates (double).
 */
#ifndef camaron_FluentNumbers_h
#define camaron_FluentNumbers_h

#include "Base/Buffer.h"

#include <algorithm> // for sizes of batches
#include <cstddef>   // for sizes of texts
#include <cstdint>   // for ids

namespace camaron
{
template <typename Number>
class FluentNumbers
{
public:
  static constexpr std::ptrdiff_t All = PTRDIFF_MAX;

  /// Of a section, whose end must be readable.
  FluentNumbers(const char* begin, const char* end)
    : Begin(begin)
    , Last(begin)
    , End(end)
  {
  }

  /// Bytes to read at once: enough for many threads, but only a small part of all.
  std::ptrdiff_t GetBatch() const
  {
    constexpr std::ptrdiff_t Part = 32, Least = 1 << 16, Most = 1 << 21;
    return std::max(Least, std::min(Most, (this->End - this->Begin) / Part));
  }
  /// Reads the words of the next bytes, which replace those before.
  void Read(std::ptrdiff_t bytes);
  /// The numbers up to the first word that is none.
  const Number* GetData() const { return this->Numbers.data(); }
  std::int64_t GetCount() const { return this->Count; }
  Buffer<Number> Take() { return std::move(this->Numbers); }
  /// Whether more bytes have more numbers.
  bool HasMore() const { return this->Last < this->End && this->Count == this->Words; }

  /// Moves behind the first of the numbers; the others are read again.
  void Skip(std::int64_t count);
  /// The place behind the first words.
  const char* Find(std::int64_t count) const;
  const char* GetBegin() const { return this->Begin; }
  const char* GetEnd() const { return this->End; }

private:
  vtkIdType CountWords(vtkIdType first, vtkIdType last) const;

  const char *Begin, *Last, *End;
  Buffer<Number> Numbers;
  std::int64_t Count = 0, Words = 0;
};
}

#endif
