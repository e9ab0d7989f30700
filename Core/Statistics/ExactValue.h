// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ExactValue.h
 * @brief Integers of 64 bits as a double and what that leaves of them.
 *
 * Statistics are made of doubles, which hold integers up to 2^53. What larger ones have beyond the
 * nearest double is a small integer; with it they are compared exactly.
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
  int Rest = 0; ///< not 0 for an integer that is no double; then Value is the nearest one

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
/// An integer as it is.
ExactValue ToExact(std::int64_t integer);
ExactValue ToExact(std::uint64_t integer);
/// The same of a value of any array, whose other numbers are doubles; for a few of them.
ExactValue GetExact(vtkDataArray* array, vtkIdType i);
///@}

/// Whether an array is of integers without a sign.
bool IsUnsigned(vtkDataArray* array);

/// Whether it is an integer that has 64 bits, with or without a sign.
bool IsInteger64(const ExactValue& value);

///@{
/// Of one that IsInteger64: the bits that it has as the one or the other type, and all its digits.
std::uint64_t ToBits(const ExactValue& value);
std::string ToText(const ExactValue& value);
///@}

/// What the nearest doubles leave of the values; empty if that is nothing.
std::vector<std::int16_t> GetRests(vtkDataArray* array);

/// Reads text that is an integer of 64 bits and nothing else; returns false for any other.
bool ParseInteger(const std::string& text, ExactValue& value);
}

#endif
