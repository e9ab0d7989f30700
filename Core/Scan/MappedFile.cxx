// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/MappedFile.h"

#include "Base/Progress.h"
#include "Base/Text.h"
#include "Scan/Inflation.h"

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

//------------------------------------------------------------------------------
std::string WithoutGz(const std::string& path)
{
  const std::size_t size = path.size() < 3 ? 0 : path.size() - 3;
  return ToLower(path.substr(size)) == ".gz" ? path.substr(0, size) : path;
}

//------------------------------------------------------------------------------
MappedFile::MappedFile() = default;

//------------------------------------------------------------------------------
MappedFile::MappedFile(const std::string& path)
{
  constexpr std::size_t enough = std::size_t(1) << 20;
  ScanError error;
  this->Size = this->Open(path, error, Progress(), enough) ? this->Size : 0;
}

//------------------------------------------------------------------------------
bool MappedFile::Open(const std::string& path, ScanError& error)
{
  return this->Open(path, error, Progress());
}

//------------------------------------------------------------------------------
bool MappedFile::Open(
  const std::string& path, ScanError& error, const Progress& progress, std::size_t limit)
{
  if (!this->OpenAsIs(path, error))
  {
    return false;
  }
  if (!Inflation::IsCompressed(this->begin(), this->end()))
  {
    return true;
  }
  this->Content = std::make_unique<Inflation>();
  const bool good =
    this->Content->Inflate(this->Name, this->begin(), this->end(), error, progress, limit);
  this->Data = this->Content->begin();
  this->Size = static_cast<std::size_t>(this->Content->end() - this->Content->begin());
  return good;
}

//------------------------------------------------------------------------------
bool MappedFile::HasTrailingData() const
{
  return this->Content && this->Content->HasTrailingData();
}

#if defined(_WIN32)
//------------------------------------------------------------------------------
MappedFile::~MappedFile() = default;

//------------------------------------------------------------------------------
bool MappedFile::HasAnyChanged()
{
  return false;
}

//------------------------------------------------------------------------------
bool MappedFile::IsUnchanged(ScanError&) const
{
  return true; // it was read completely
}

//------------------------------------------------------------------------------
bool MappedFile::OpenAsIs(const std::string& path, ScanError& error)
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
  FileStates::Add(path, { 0, 0, static_cast<long long>(this->Size), 0, 0 });
  return true;
}
#else
namespace
{
/// Files that a thread has open, in the order of opening.
thread_local std::vector<const MappedFile*> OpenFiles;

//------------------------------------------------------------------------------
/// @param expected size, or 0 if unknown
bool ReadAll(int file, std::size_t expected, std::vector<char>& content)
{
  // Small for small files, later large enough to make the cost of calls negligible.
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
  OpenFiles.erase(std::remove(OpenFiles.begin(), OpenFiles.end(), this), OpenFiles.end());
  if (this->Mapping)
  {
    this->Guard.Leave();
    munmap(this->Mapping, this->MappedSize);
  }
  if (this->File >= 0)
  {
    close(this->File);
  }
}

//------------------------------------------------------------------------------
bool MappedFile::GetStamp(int file, Stamp& stamp)
{
  struct stat status;
  if (fstat(file, &status) != 0)
  {
    return false;
  }
  if (S_ISDIR(status.st_mode))
  {
    errno = EISDIR;
    return false;
  }
#if defined(__APPLE__)
  const timespec& time = status.st_mtimespec;
#else
  const timespec& time = status.st_mtim;
#endif
  stamp = { { static_cast<long long>(status.st_dev), static_cast<long long>(status.st_ino),
              status.st_size, time.tv_sec, time.tv_nsec },
    S_ISREG(status.st_mode) };
  return true;
}

//------------------------------------------------------------------------------
bool MappedFile::Map(std::size_t size)
{
  void* mapping =
    MayMap && size > 0 ? mmap(nullptr, size, PROT_READ, MAP_PRIVATE, this->File, 0) : MAP_FAILED;
  if (mapping == MAP_FAILED)
  {
    return false;
  }
  if (!this->Guard.Enter(mapping, size))
  {
    munmap(mapping, size);
    return false;
  }
  this->Mapping = mapping;
  this->MappedSize = size;
  this->Data = static_cast<const char*>(mapping);
  this->Size = size;
  return true;
}

//------------------------------------------------------------------------------
bool MappedFile::OpenAsIs(const std::string& path, ScanError& error)
{
  this->Name = GetFileName(path);
  this->File = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  bool good = this->File >= 0 && GetStamp(this->File, this->Opened);
  OpenFiles.push_back(this);
  if (good)
  {
    const Stamp& stamp = this->Opened;
    if (stamp.IsOfFile)
    {
      FileStates::Add(path, stamp);
    }
    const auto size = static_cast<std::size_t>(stamp.IsOfFile ? stamp.Size : 0);
    if (!this->Map(size))
    {
      good = ReadAll(this->File, size, this->Copy);
      this->Data = this->Copy.empty() ? "" : this->Copy.data();
      this->Size = this->Copy.size();
    }
  }
  if (!good)
  {
    error = { ErrorKind::Open, this->Name + ": cannot read the file: " + std::strerror(errno) };
  }
  return good;
}

//------------------------------------------------------------------------------
bool MappedFile::HasStamp() const
{
  Stamp now;
  return !this->Opened.IsOfFile ||
    (GetStamp(this->File, now) && now.Size == this->Opened.Size &&
      now.Seconds == this->Opened.Seconds && now.Nanoseconds == this->Opened.Nanoseconds);
}

//------------------------------------------------------------------------------
bool MappedFile::IsUnchanged(ScanError& error) const
{
  const bool isSame = this->HasStamp();
  if (isSame && !this->Guard.IsLost())
  {
    return true;
  }
  error = { ErrorKind::Changed,
    this->Name + ": cannot read the file: " +
      (isSame ? std::strerror(EIO)
              : "another program changed it during reading; read it again when it is complete") };
  return false;
}

//------------------------------------------------------------------------------
bool MappedFile::HasAnyChanged()
{
  return std::any_of(OpenFiles.begin(), OpenFiles.end(),
    [](const MappedFile* file) { return file->Guard.IsLost() || !file->HasStamp(); });
}
#endif
}
