// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ExactValue.h
 * @brief A 64-bit integer as the nearest double and a remainder.
 *
 * Statistics use doubles, which represent integers up to 2^53 exactly. For larger integers, the
 * difference to the nearest double is a small integer; with it, they are compared exactly.
 */
#ifndef camaron_ExactValue_h
#define camaron_ExactValue_h

#include "vtkType.h" // for vtkIdType

#include <cstdint> // for rests
#include <string>  // for text
#include <vector>  // for rests

class vtkDataArray;

namespace camaron
{
struct ExactValue
{
  double Value = 0;
  int Rest = 0; ///< difference of the integer to Value; 0 if Value is exact

  bool operator<(const ExactValue& other) const
  {
    return this->Value < other.Value || (this->Value == other.Value && this->Rest < other.Rest);
  }
  bool operator==(const ExactValue& other) const
  {
    return this->Value == other.Value && this->Rest == other.Rest;
  }
};

///@{
/// Exact representation of an integer.
ExactValue ToExact(std::int64_t integer);
ExactValue ToExact(std::uint64_t integer);
/// The same for a value of any array; other numbers are doubles. Slow: use it for single values.
ExactValue GetExact(vtkDataArray* array, vtkIdType i);
///@}

/// Whether an array contains unsigned integers.
bool IsUnsigned(vtkDataArray* array);

/// Whether it is a signed or unsigned 64-bit integer.
bool IsInteger64(const ExactValue& value);

///@{
/// Require IsInteger64: its bits, signed or unsigned, and all its digits.
std::uint64_t ToBits(const ExactValue& value);
std::string ToText(const ExactValue& value);
///@}

/// The remainders of all values; empty if all are 0.
std::vector<std::int16_t> GetRests(vtkDataArray* array);

/// Parses text that is a 64-bit integer and nothing else; otherwise returns false.
bool ParseInteger(const std::string& text, ExactValue& value);
}

#endif
