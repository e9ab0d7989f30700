// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Rows/BinaryScanner.h"

namespace camaron
{
//------------------------------------------------------------------------------
bool BinaryScanner::FailAtCount(const char* place, std::int32_t count, int bytes, const char* what)
{
  if (count < 0)
  {
    return this->FailAt(place, ErrorKind::Count, what, std::to_string(count));
  }
  return this->FailAt(place, ErrorKind::Truncated,
    "at least " + std::to_string(std::int64_t(count) * bytes) + " bytes after " + what + " (" +
      std::to_string(count) + ")",
    std::to_string(this->GetBytesLeft()));
}

//------------------------------------------------------------------------------
void BinaryScanner::FailAtEnd(const char* what)
{
  this->FailAt(this->Position, ErrorKind::Truncated, what,
    this->GetBytesLeft() == 0 ? "the end of the file"
                              : std::to_string(this->GetBytesLeft()) + " bytes up to its end");
}

//------------------------------------------------------------------------------
bool BinaryScanner::FailAt(
  const char* position, ErrorKind kind, const std::string& expected, const std::string& found)
{
  if (!this->HasFailed())
  {
    this->Error = { kind,
      this->Name + ": byte " + std::to_string(position - this->Begin) + ": expected " + expected +
        ", found " + found };
  }
  return false;
}
}
