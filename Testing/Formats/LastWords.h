// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::testing::LastWords
 * @brief A message to print if the program crashes, or hangs for a minute, while the object lives.
 */
#ifndef camaron_LastWords_h
#define camaron_LastWords_h

#include <string> // for the words

namespace camaron
{
namespace testing
{
class LastWords
{
public:
  explicit LastWords(const std::string& words);
  ~LastWords();
  LastWords(const LastWords&) = delete;
  void operator=(const LastWords&) = delete;
};
}
}

#endif
