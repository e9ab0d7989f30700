// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentNumbers
 * @brief Reads the numbers of a section that is in the file, in parallel: ids and sizes
 * (std::int32_t), which are hexadecimal in text, or coordinates (double).
 */
#ifndef camaron_FluentNumbers_h
#define camaron_FluentNumbers_h

#include "Base/Buffer.h"
#include "Intake/Fluent/FluentFile.h"
#include "Intake/Rows/Bytes.h"

#include <algorithm>   // for sizes of batches
#include <cstddef>     // for sizes of texts
#include <cstdint>     // for ids
#include <type_traits> // for sizes

namespace camaron
{
template <typename Number>
class FluentNumbers
{
public:
  static constexpr std::ptrdiff_t All = PTRDIFF_MAX;

  FluentNumbers(const FluentFile& file, const FluentSection& section)
    : Begin(section.Begin)
    , Last(section.Begin)
    , End(section.End)
    , Bytes(std::is_floating_point_v<Number> || section.IsText() ? section.RealSize : 4)
    , Swap(file.IsSwapped())
  {
  }

  /// Bytes to read at once: enough for many threads, but only a small part of all.
  std::ptrdiff_t GetBatch() const
  {
    constexpr std::ptrdiff_t Part = 32, Least = 1 << 16, Most = 1 << 23;
    return std::max(Least, std::min(Most, (this->End - this->Begin) / Part));
  }
  /**
   * Reads the numbers in the next bytes, which replace those before.
   * @param inPlace whether they may stay in the file, if it has them as in memory; another program
   * may change it
   */
  void Read(std::ptrdiff_t bytes, bool inPlace);
  /// The numbers up to the first word that is none.
  const Unaligned<Number>* GetData() const { return this->Data; }
  std::int64_t GetCount() const { return this->Count; }
  /// Whether more bytes have more numbers.
  bool HasMore() const { return this->Last < this->End && this->Count == this->Words; }

  /// Moves behind the first of the numbers; the others are read again.
  void Skip(std::int64_t count);
  /// The place of a number, or the end.
  const char* Find(std::int64_t i) const;
  const char* GetBegin() const { return this->Begin; }
  const char* GetEnd() const { return this->End; }

private:
  vtkIdType CountWords(vtkIdType first, vtkIdType last) const;
  void ReadText(std::ptrdiff_t bytes);
  void MakeRoom();

  const char *Begin, *Last, *End;
  int Bytes; ///< of a number; 0 in text
  bool Swap;
  Buffer<Number> Numbers; ///< unless they stay in the file
  const Unaligned<Number>* Data = nullptr;
  std::int64_t Count = 0, Words = 0;
};
}

#endif
