// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/MappedFile.h"

#include <cerrno>
#include <cstring>

#if defined(_WIN32)
#include <fstream>
#include <iterator>
#else
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace camaron
{
//------------------------------------------------------------------------------
std::string GetFileName(const std::string& path)
{
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

#if defined(_WIN32)
//------------------------------------------------------------------------------
MappedFile::~MappedFile() = default;

//------------------------------------------------------------------------------
bool MappedFile::Open(const std::string& path, ScanError& error)
{
  this->Name = GetFileName(path);
  std::ifstream stream(path, std::ios::binary);
  this->Copy.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  if (!stream || stream.bad())
  {
    error = { ErrorKind::Open, this->Name + ": cannot read the file" };
    return false;
  }
  this->Data = this->Copy.empty() ? "" : this->Copy.data();
  this->Size = this->Copy.size();
  return true;
}
#else
namespace
{
#if defined(__SANITIZE_ADDRESS__)
constexpr bool MayMap = false;
#else
constexpr bool MayMap = true;
#endif

//------------------------------------------------------------------------------
/// @param expected size, as far as it is known
bool ReadAll(int file, std::size_t expected, std::vector<char>& content)
{
  constexpr std::size_t Block = std::size_t(1) << 22; // large enough that calls do not count
  std::size_t size = 0;
  for (;;)
  {
    const std::size_t block = size < expected ? expected - size : size > 0 ? Block : 1;
    content.resize(size + block);
    const ssize_t got = read(file, &content[size], block);
    if (got < 0 && errno == EINTR)
    {
      continue;
    }
    size += got > 0 ? static_cast<std::size_t>(got) : 0;
    if (got <= 0)
    {
      content.resize(size);
      content.shrink_to_fit();
      return got == 0;
    }
  }
}
}

//------------------------------------------------------------------------------
MappedFile::~MappedFile()
{
  if (this->Mapping)
  {
    munmap(this->Mapping, this->Size);
  }
}

//------------------------------------------------------------------------------
bool MappedFile::Open(const std::string& path, ScanError& error)
{
  this->Name = GetFileName(path);
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status;
  bool good = file >= 0 && fstat(file, &status) == 0;
  if (good && S_ISDIR(status.st_mode))
  {
    errno = EISDIR;
    good = false;
  }
  if (good)
  {
    const std::size_t size = S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 0;
    if (MayMap && size > 0)
    {
      void* mapping = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
      if (mapping != MAP_FAILED)
      {
        this->Mapping = mapping;
        this->Data = static_cast<const char*>(mapping);
        this->Size = size;
      }
    }
    if (!this->Mapping)
    {
      good = ReadAll(file, size, this->Copy);
      this->Data = this->Copy.empty() ? "" : this->Copy.data();
      this->Size = this->Copy.size();
    }
  }
  if (!good)
  {
    error = { ErrorKind::Open, this->Name + ": cannot read the file: " + std::strerror(errno) };
  }
  if (file >= 0)
  {
    close(file);
  }
  return good;
}
#endif
}
