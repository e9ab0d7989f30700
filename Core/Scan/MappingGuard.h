// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MappingGuard
 * @brief Keeps the process alive if a mapped file becomes shorter, or unreadable, while in use.
 *
 * When a page of a mapping is no longer in the file, accessing it raises the signal SIGBUS, which
 * ends the process. While guards exist, their signal handler replaces the whole mapping by zeros,
 * in the thread that raised the signal; the reader continues with zeros and detects this by
 * IsLost. Other faults are forwarded to the previous handler, which is restored with the last
 * guard.
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
   * Guards mapped memory, from its first page on. Returns false if there are too many guards, or
   * another handler was installed after this one and may not forward the signal.
   */
  bool Enter(void* mapping, std::size_t size);
  /// Must be called before the memory is unmapped.
  void Leave();

  /// Whether the mapping was replaced by zeros.
  bool IsLost() const;

private:
  int Slot = -1;
};
}

#endif
