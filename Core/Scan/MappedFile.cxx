// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/MappedFile.h"

#include "Base/Progress.h"
#include "Base/Text.h"
#include "Scan/Inflation.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <mutex>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

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

namespace
{
/// A guarded mapping; unused while Begin is 0. The signal handler takes no locks.
struct Place
{
  std::atomic<std::uintptr_t> Begin{ 0 };
  std::atomic<std::uintptr_t> End{ 0 };
  std::atomic<bool> Lost{ false };
};
constexpr int NumberOfPlaces = 64; // files read at the same time; further files are copied
Place Places[NumberOfPlaces];

std::mutex Mutex; // protects the following members
int NumberOfGuards = 0;
bool IsInstalled = false;
struct sigaction Previous; // constant while this handler is installed

//------------------------------------------------------------------------------
bool Replace(const void* address)
{
  const auto fault = reinterpret_cast<std::uintptr_t>(address);
  for (Place& place : Places)
  {
    const std::uintptr_t begin = place.Begin.load();
    const std::uintptr_t end = place.End.load();
    if (begin != 0 && begin <= fault && fault < end)
    {
      // All of it, so that the contents do not change again.
      place.Lost = true;
      return mmap(reinterpret_cast<void*>(begin), end - begin, PROT_READ,
               MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0) != MAP_FAILED;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void OnBusError(int signal, siginfo_t* info, void* context)
{
  const int before = errno;
  const bool isOurs = Replace(info->si_addr);
  errno = before;
  if (isOurs)
  {
    return;
  }
  if (Previous.sa_flags & SA_SIGINFO)
  {
    Previous.sa_sigaction(signal, info, context);
  }
  else if (Previous.sa_handler == SIG_DFL || Previous.sa_handler == SIG_IGN)
  {
    // Ends the process when the access is repeated, as without this handler.
    sigaction(SIGBUS, &Previous, nullptr);
    if (info->si_code <= 0) // sent by a process
    {
      raise(signal);
    }
  }
  else
  {
    Previous.sa_handler(signal);
  }
}

//------------------------------------------------------------------------------
bool IsCurrent()
{
  struct sigaction current;
  return sigaction(SIGBUS, nullptr, &current) == 0 && (current.sa_flags & SA_SIGINFO) &&
    current.sa_sigaction == OnBusError;
}

//------------------------------------------------------------------------------
bool Install()
{
  if (IsInstalled)
  {
    return IsCurrent();
  }
  struct sigaction ours = {};
  ours.sa_sigaction = OnBusError;
  ours.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigemptyset(&ours.sa_mask);
  IsInstalled =
    sigaction(SIGBUS, nullptr, &Previous) == 0 && sigaction(SIGBUS, &ours, nullptr) == 0;
  return IsInstalled;
}
}

//------------------------------------------------------------------------------
bool MappingGuard::Enter(void* mapping, std::size_t size)
{
  this->Leave();
  const std::lock_guard<std::mutex> lock(Mutex);
  int slot = 0;
  while (slot < NumberOfPlaces && Places[slot].Begin != 0)
  {
    ++slot;
  }
  if (slot == NumberOfPlaces || !Install())
  {
    return false;
  }
  ++NumberOfGuards;
  this->Slot = slot;
  Place& place = Places[slot];
  place.Lost = false;
  place.End = reinterpret_cast<std::uintptr_t>(mapping) + size;
  place.Begin = reinterpret_cast<std::uintptr_t>(mapping);
  return true;
}

//------------------------------------------------------------------------------
void MappingGuard::Leave()
{
  if (this->Slot < 0)
  {
    return;
  }
  const std::lock_guard<std::mutex> lock(Mutex);
  Places[this->Slot].Begin = 0;
  this->Slot = -1;
  // A handler that is no longer the current one may still be called by that one.
  if (--NumberOfGuards == 0 && IsCurrent() && sigaction(SIGBUS, &Previous, nullptr) == 0)
  {
    IsInstalled = false;
  }
}

//------------------------------------------------------------------------------
bool MappingGuard::IsLost() const
{
  return this->Slot >= 0 && Places[this->Slot].Lost;
}
}
