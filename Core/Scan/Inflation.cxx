// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/Inflation.h"

#include "Base/Progress.h"

#include "vtk_zlib.h"

#include <algorithm>
#include <climits>
#include <cstdlib>
#include <cstring>

namespace camaron
{
namespace
{
// Meshes compress to a third or a tenth. Files of more bytes may not exceed the ratio above.
constexpr std::size_t Unchecked = std::size_t(16) << 20;
constexpr std::size_t MaxRatio = 100;

//------------------------------------------------------------------------------
// Releases zlib's memory.
struct Stream
{
  z_stream Z = {};
  bool Good;
  Stream()
  {
    constexpr int GzipOnly = 16; // added to the size of the window
    this->Good = inflateInit2(&this->Z, MAX_WBITS + GzipOnly) == Z_OK;
  }
  ~Stream()
  {
    if (this->Good)
    {
      inflateEnd(&this->Z);
    }
  }
};
}

//------------------------------------------------------------------------------
Inflation::~Inflation()
{
  std::free(this->Data);
}

//------------------------------------------------------------------------------
bool Inflation::IsCompressed(const char* begin, const char* end)
{
  return end - begin > 2 && std::memcmp(begin, "\x1f\x8b", 2) == 0;
}

//------------------------------------------------------------------------------
bool Inflation::Grow(std::size_t capacity)
{
  void* const data = std::realloc(this->Data, capacity);
  if (!data)
  {
    return false;
  }
  this->Data = static_cast<char*>(data);
  this->Capacity = capacity;
  return true;
}

//------------------------------------------------------------------------------
bool Inflation::Inflate(const std::string& name, const char* begin, const char* end,
  ScanError& error, const Progress& progress, std::size_t limit)
{
  const auto fail = [&](ErrorKind kind, const std::string& message)
  {
    error = { kind, name + ": " + message };
    return false;
  };
  Stream stream;
  if (!stream.Good)
  {
    return fail(ErrorKind::Memory, "not enough memory to decompress the file");
  }
  const char* next = begin;
  while (true)
  {
    if (this->Size == this->Capacity)
    {
      constexpr std::size_t First = std::size_t(1) << 16;
      std::size_t capacity = std::max(First, this->Capacity + this->Capacity / 2);
      capacity = limit > 0 ? std::min(capacity, limit) : capacity;
      if (limit > 0 && this->Size >= limit)
      {
        return true;
      }
      if (!this->Grow(capacity))
      {
        return fail(ErrorKind::Memory, "not enough memory to decompress the file");
      }
    }
    const std::size_t left = static_cast<std::size_t>(end - next);
    const std::size_t room = this->Capacity - this->Size;
    constexpr std::size_t Step = std::size_t(1) << 22; // between two reports
    stream.Z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(next));
    stream.Z.avail_in = static_cast<uInt>(std::min<std::size_t>(left, INT_MAX));
    stream.Z.next_out = reinterpret_cast<Bytef*>(this->Data + this->Size);
    stream.Z.avail_out = static_cast<uInt>(std::min(room, Step));
    const int status = inflate(&stream.Z, Z_NO_FLUSH);
    const char* const before = next;
    const std::size_t size = this->Size;
    next = reinterpret_cast<const char*>(stream.Z.next_in);
    this->Size = static_cast<std::size_t>(reinterpret_cast<char*>(stream.Z.next_out) - this->Data);
    const auto read = static_cast<std::size_t>(next - begin);
    if (status == Z_STREAM_END)
    {
      // Several members may follow each other; anything else at the end is ignored, as gzip does.
      if (!IsCompressed(next, end))
      {
        this->TrailingData = std::any_of(next, end, [](char c) { return c != '\0'; });
        return true;
      }
      inflateReset(&stream.Z);
    }
    else if (status != Z_OK && status != Z_BUF_ERROR)
    {
      return fail(ErrorKind::Syntax,
        "byte " + std::to_string(read) + ": expected gzip data, found " +
          (stream.Z.msg ? stream.Z.msg : "something else"));
    }
    else if (next == before && this->Size == size && left == 0)
    {
      return fail(ErrorKind::Truncated,
        "byte " + std::to_string(read) +
          ": expected more compressed data, found the end of the file");
    }
    if (this->Size > Unchecked && this->Size / MaxRatio > read)
    {
      return fail(ErrorKind::Unsupported,
        "byte " + std::to_string(read) + ": expected a mesh, found data that expands more than " +
          std::to_string(MaxRatio) + " times");
    }
    if (!progress.Report(static_cast<double>(read) / static_cast<double>(end - begin)))
    {
      return false;
    }
  }
}
}
