// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::testing::ScopedValue
 * @brief Gives a variable another value, and restores the old one when it goes out of scope.
 */
#ifndef camaron_ScopedValue_h
#define camaron_ScopedValue_h

namespace camaron
{
namespace testing
{
template <typename Value>
class ScopedValue
{
public:
  ScopedValue(Value& variable, Value value)
    : Variable(variable)
    , Before(variable)
  {
    variable = value;
  }
  ~ScopedValue() { this->Variable = this->Before; }
  ScopedValue(const ScopedValue&) = delete;
  void operator=(const ScopedValue&) = delete;

private:
  Value& Variable;
  Value Before;
};
}
}

#endif
