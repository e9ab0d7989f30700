// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::BinaryScanner
 * @brief Reads 32-bit values of either byte order from memory, with bounds checks.
 *
 * After the first error all reads fail, as with TextScanner. Positions in messages are byte
 * offsets in the file.
 */
#ifndef camaron_BinaryScanner_h
#define camaron_BinaryScanner_h

#include "Intake/Rows/Bytes.h"
#include "Scan/ScanError.h"

#include <cstdint> // for integers of known size
#include <string>  // for messages

namespace camaron
{
class BinaryScanner
{
public:
  BinaryScanner(std::string name, const char* begin, const char* end, ByteOrder order)
    : Name(std::move(name))
    , Begin(begin)
    , End(end)
    , Position(begin)
    , Swap(order != GetByteOrder())
  {
  }

  const char* GetPosition() const { return this->Position; }
  void SetPosition(const char* position) { this->Position = position; }
  bool IsSwapped() const { return this->Swap; }
  vtkIdType GetBytesLeft() const { return this->End - this->Position; }

  /// Reads an integer. @a what describes the expected item in error messages.
  bool ReadInteger(std::int32_t& value, const char* what)
  {
    const char* place = this->Skip(4, what);
    if (place)
    {
      value = Load<std::int32_t>(place, this->Swap);
    }
    return place != nullptr;
  }
  /// Reads the number of records that follow, each of at least @a bytes bytes.
  bool ReadCount(std::int32_t& value, int bytes, const char* what)
  {
    const char* const place = this->Position;
    std::int32_t count = 0;
    if (!this->ReadInteger(count, what))
    {
      return false;
    }
    if (count < 0 || count > this->GetBytesLeft() / bytes)
    {
      return this->FailAtCount(place, count, bytes, what);
    }
    value = count;
    return true;
  }
  /// Skips @a bytes bytes and returns where they begin, or nullptr.
  const char* Skip(std::int64_t bytes, const char* what)
  {
    if (this->HasFailed() || this->GetBytesLeft() < bytes)
    {
      this->FailAtEnd(what);
      return nullptr;
    }
    const char* const place = this->Position;
    this->Position += bytes;
    return place;
  }

  /// Sets the error, unless there is one: "name: byte N: expected WHAT, found ..."; returns false.
  bool FailAt(
    const char* position, ErrorKind kind, const std::string& expected, const std::string& found);
  const ScanError& GetError() const { return this->Error; }
  bool HasFailed() const { return static_cast<bool>(this->Error); }

private:
  bool FailAtCount(const char* place, std::int32_t count, int bytes, const char* what);
  void FailAtEnd(const char* what);

  std::string Name;
  const char* Begin;
  const char* End;
  const char* Position;
  bool Swap;
  ScanError Error;
};
}

#endif
