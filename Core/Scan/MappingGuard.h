// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MappingGuard
 * @brief Keeps the process alive if a mapped file becomes shorter, or cannot be read, while it is
 * in use.
 *
 * The system answers access to a page of a mapping that is no longer in the file with the signal
 * SIGBUS, which ends the process. While there are guards, their own handler of that signal puts
 * memory full of zeros in the place of the whole mapping, in the thread that tripped over it;
 * whoever reads goes on with zeros, and finds out with IsLost. Faults elsewhere go on to the
 * handler that was there before, which comes back with the last guard.
 */
#ifndef camaron_MappingGuard_h
#define camaron_MappingGuard_h

#include <cstddef> // for std::size_t

namespace camaron
{
class MappingGuard
{
public:
  MappingGuard() = default;
  ~MappingGuard() { this->Leave(); }
  MappingGuard(const MappingGuard&) = delete;
  MappingGuard& operator=(const MappingGuard&) = delete;

  /**
   * Guards memory that was mapped, from its first page on. False if that cannot be done: there are
   * too many guards, or somebody else has put a handler before ours, who may not pass the signal
   * on.
   */
  bool Enter(void* mapping, std::size_t size);
  /// Must come before the memory is unmapped.
  void Leave();

  /// Whether there are zeros in the place of the mapping.
  bool IsLost() const;

private:
  int Slot = -1;
};
}

#endif
