// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CrashMessage.h"

#if defined(__unix__) || defined(__APPLE__)
#include <csignal>
#include <cstring>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/common_interface_defs.h>
#endif

namespace
{
constexpr unsigned MaxSeconds = 60; // of wall-clock time, on a machine that may be busy
std::string Words;

//------------------------------------------------------------------------------
void Speak()
{
  // Only calls that are allowed in a signal handler.
  for (const char* part : { "\nIt happened with ", Words.c_str(), "\n" })
  {
    if (write(STDERR_FILENO, part, std::strlen(part)) < 0)
    {
      return;
    }
  }
}

//------------------------------------------------------------------------------
void Die(int signal)
{
  Speak();
  std::signal(signal, SIG_DFL);
  raise(signal);
}

//------------------------------------------------------------------------------
bool Listen()
{
  std::signal(SIGALRM, Die);
#if defined(__SANITIZE_ADDRESS__)
  __sanitizer_set_death_callback(Speak);
#else
  for (const int signal : { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT })
  {
    std::signal(signal, Die);
  }
#endif
  return true;
}
}

namespace camaron
{
namespace testing
{
//------------------------------------------------------------------------------
CrashMessage::CrashMessage(const std::string& words)
{
  static const bool listens = Listen();
  (void)listens;
  Words = words;
  alarm(MaxSeconds);
}

//------------------------------------------------------------------------------
CrashMessage::~CrashMessage()
{
  alarm(0);
}
}
}

#else
namespace camaron
{
namespace testing
{
CrashMessage::CrashMessage(const std::string&) {}
CrashMessage::~CrashMessage() = default;
}
}
#endif
