// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/MappedFile.h"

#include <cerrno>
#include <cstring>

#if defined(_WIN32)
#include <fstream>
#include <sstream>
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
  std::ostringstream content;
  if (!stream || (stream.peek() != EOF && !(content << stream.rdbuf())))
  {
    error = { ErrorKind::Open, this->Name + ": cannot read the file" };
    return false;
  }
  this->Copy = content.str();
  this->Data = this->Copy.data();
  this->Size = this->Copy.size();
  return true;
}
#else
namespace
{
//------------------------------------------------------------------------------
bool ReadAll(int file, std::string& content)
{
  constexpr std::size_t Block = std::size_t(1) << 22; // large enough that calls do not count
  std::size_t size = 0;
  for (;;)
  {
    content.resize(size + Block);
    const ssize_t got = read(file, &content[size], Block);
    if (got < 0 && errno == EINTR)
    {
      continue;
    }
    size += got > 0 ? static_cast<std::size_t>(got) : 0;
    if (got <= 0)
    {
      content.resize(size);
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
    if (S_ISREG(status.st_mode) && status.st_size > 0)
    {
      const auto size = static_cast<std::size_t>(status.st_size);
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
      good = ReadAll(file, this->Copy);
      this->Data = this->Copy.data();
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
