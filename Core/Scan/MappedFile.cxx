// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/MappedFile.h"

#include <algorithm>
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
/// @param expected size, or 0 if it is not known before the end
bool ReadAll(int file, std::size_t expected, std::vector<char>& content)
{
  // Small for small files, later large enough that calls do not count.
  constexpr std::size_t FirstBlock = std::size_t(1) << 16, LastBlock = std::size_t(1) << 22;
  std::size_t size = 0;
  ssize_t got = 1;
  while (got > 0 && (expected == 0 || size < expected))
  {
    const std::size_t block = std::min(std::max(size, FirstBlock), LastBlock);
    content.resize(expected > 0 ? expected : size + block);
    got = read(file, &content[size], content.size() - size);
    if (got < 0 && errno == EINTR)
    {
      got = 1;
      continue;
    }
    size += got > 0 ? static_cast<std::size_t>(got) : 0;
  }
  content.resize(size);
  content.shrink_to_fit();
  return got >= 0;
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
