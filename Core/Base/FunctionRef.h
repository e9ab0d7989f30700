// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FunctionRef.h
 * @brief A parameter that accepts any function object of a signature, as std::function_ref of
 * C++26.
 *
 * Unlike std::function it copies nothing, and so must not outlive the function object: it is for
 * parameters. A function that takes one is compiled once, not for each function object.
 */
#ifndef camaron_FunctionRef_h
#define camaron_FunctionRef_h

#include <memory>      // for std::addressof
#include <type_traits> // for std::enable_if_t
#include <utility>     // for std::forward

namespace camaron
{
template <typename Signature>
class FunctionRef;

template <typename Result, typename... Arguments>
class FunctionRef<Result(Arguments...)>
{
public:
  template <typename Function,
    typename = std::enable_if_t<!std::is_same_v<std::decay_t<Function>, FunctionRef>>>
  FunctionRef(Function&& function)
    : Object(const_cast<void*>(reinterpret_cast<const void*>(std::addressof(function))))
    , Call(
        [](void* object, Arguments... arguments) -> Result
        {
          auto& called = *reinterpret_cast<std::remove_reference_t<Function>*>(object);
          return static_cast<Result>(called(std::forward<Arguments>(arguments)...));
        })
  {
  }

  Result operator()(Arguments... arguments) const
  {
    return this->Call(this->Object, std::forward<Arguments>(arguments)...);
  }

private:
  void* Object;
  Result (*Call)(void*, Arguments...);
};
}

#endif
