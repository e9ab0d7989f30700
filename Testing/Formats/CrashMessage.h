// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::testing::CrashMessage
 * @brief A message to print if the program crashes, or hangs for a minute, while the object lives.
 */
#ifndef camaron_CrashMessage_h
#define camaron_CrashMessage_h

#include <string> // for the words

namespace camaron
{
namespace testing
{
class CrashMessage
{
public:
  explicit CrashMessage(const std::string& words);
  ~CrashMessage();
  CrashMessage(const CrashMessage&) = delete;
  void operator=(const CrashMessage&) = delete;
};
}
}

#endif
