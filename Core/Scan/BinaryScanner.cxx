// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/BinaryScanner.h"

namespace camaron
{
//------------------------------------------------------------------------------
bool BinaryScanner::ReadInteger(std::int32_t& value, const char* what)
{
  const char* place = this->Skip(4, what);
  if (place)
  {
    value = Load<std::int32_t>(place, this->Swap);
  }
  return place != nullptr;
}

//------------------------------------------------------------------------------
bool BinaryScanner::ReadCount(std::int32_t& value, int bytes, const char* what)
{
  const char* place = this->Position;
  std::int32_t count;
  if (!this->ReadInteger(count, what))
  {
    return false;
  }
  if (count < 0)
  {
    this->FailAt(place, ErrorKind::Count, what, std::to_string(count));
    return false;
  }
  if (count > this->GetBytesLeft() / bytes)
  {
    this->FailAt(place, ErrorKind::Truncated,
      "at least " + std::to_string(std::int64_t(count) * bytes) + " bytes after " + what + " (" +
        std::to_string(count) + ")",
      std::to_string(this->GetBytesLeft()));
    return false;
  }
  value = count;
  return true;
}

//------------------------------------------------------------------------------
const char* BinaryScanner::Skip(std::int64_t bytes, const char* what)
{
  if (!this->HasFailed() && this->GetBytesLeft() < bytes)
  {
    this->FailAt(this->Position, ErrorKind::Truncated, what,
      this->GetBytesLeft() == 0 ? "the end of the file"
                                : std::to_string(this->GetBytesLeft()) + " bytes up to its end");
  }
  if (this->HasFailed())
  {
    return nullptr;
  }
  const char* place = this->Position;
  this->Position += bytes;
  return place;
}

//------------------------------------------------------------------------------
void BinaryScanner::FailAt(
  const char* position, ErrorKind kind, const std::string& expected, const std::string& found)
{
  if (!this->HasFailed())
  {
    this->Error = { kind,
      this->Name + ": byte " + std::to_string(position - this->Begin) + ": expected " + expected +
        ", found " + found };
  }
}
}
