// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::NumberEncoder
 * @brief Appends numbers as text or as binary values of either byte order.
 */
#ifndef camaron_NumberEncoder_h
#define camaron_NumberEncoder_h

#include "Base/Number.h"
#include "Intake/Rows/Bytes.h"
#include "Intake/Write/RealFormat.h"

#include <string> // for bytes

namespace camaron
{
class NumberEncoder
{
public:
  NumberEncoder(bool isText, bool isBigEndian)
    : Text(isText)
    , Swap(isBigEndian != (GetByteOrder() == ByteOrder::Big))
  {
  }

  bool IsText() const { return this->Text; }
  /// In text, a blank follows.
  template <typename Number>
  void Append(std::string& bytes, Number number) const
  {
    if (this->Text)
    {
      AppendNumber(bytes, number);
      bytes += ' ';
    }
    else
    {
      AppendBytes(bytes, number, this->Swap);
    }
  }
  /// The same for get(0) to get(count - 1), which binary files store as a type.
  template <typename Number, typename Get>
  void Append(std::string& bytes, std::ptrdiff_t count, Get&& get) const
  {
    if (!this->Text)
    {
      AppendBytes<Number>(bytes, count, get, this->Swap);
      return;
    }
    AppendWords(bytes, count,
      [&get](std::ptrdiff_t i, char* to) { return std::to_chars(to, to + 32, get(i)).ptr; });
  }
  /// Ends a row of at least one number.
  void EndRow(std::string& bytes) const
  {
    if (this->Text)
    {
      bytes.back() = '\n';
    }
  }

private:
  bool Text;
  bool Swap;
};
}

#endif
