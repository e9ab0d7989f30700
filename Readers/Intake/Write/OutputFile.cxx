// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Write/OutputFile.h"

#include "Intake/Write/InputFiles.h"
#include "Scan/MappedFile.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <random>

#ifndef _WIN32
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace fs = std::filesystem;

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// A unique name in the folder of the target, short enough for file systems.
std::string MakeTemporaryName(const std::string& target)
{
  constexpr std::size_t MaxLength = 200; // of the original name; names have at most 255 bytes
  static std::atomic<unsigned int> number{ std::random_device()() };
  const std::size_t name = target.size() - GetFileName(target).size();
  return target.substr(0, name + MaxLength) + "." + std::to_string(number++) + ".part";
}

//------------------------------------------------------------------------------
// Whether an existing file is not write-protected.
bool MayWrite(const std::string& path)
{
  std::FILE* const file = std::fopen(path.c_str(), "r+b");
  return file && std::fclose(file) == 0;
}

//------------------------------------------------------------------------------
// Whether a path is a link that another user left in a folder such as /tmp; many systems do not
// follow it either (fs.protected_symlinks of Linux).
bool IsForeignLink(const std::string& path)
{
#ifdef _WIN32
  return false;
#else
  const fs::path parent = fs::path(path).parent_path();
  struct stat link, folder;
  return lstat(path.c_str(), &link) == 0 && S_ISLNK(link.st_mode) &&
    stat(parent.empty() ? "." : parent.c_str(), &folder) == 0 && (folder.st_mode & S_ISVTX) != 0 &&
    (folder.st_mode & S_IWOTH) != 0 && link.st_uid != geteuid() && link.st_uid != folder.st_uid;
#endif
}
}

//------------------------------------------------------------------------------
OutputFile::OutputFile(const std::string& path)
  : Name(GetFileName(path))
  , Target(path)
{
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::none)
  {
    this->Fail(error.value());
    return;
  }
  if (IsForeignLink(path))
  {
    this->Fail(EACCES);
    return;
  }
  if (fs::is_directory(status))
  {
    this->Fail(EISDIR);
    return;
  }
  if (!InputFiles::FindProtected(path).empty())
  {
    this->Error = { ErrorKind::Write,
      this->Name + ": the mesh was read from this file: write to another one" };
    return;
  }
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    this->File = std::fopen(path.c_str(), "wb");
  }
  else
  {
    if (fs::exists(status))
    {
      if (!MayWrite(path))
      {
        this->Fail(errno);
        return;
      }
      const fs::path real = fs::canonical(path, error); // symbolic links are kept
      this->Target = error ? path : real.string();
    }
    else if (fs::is_symlink(fs::symlink_status(path, error)))
    {
      const fs::path real = fs::path(path).parent_path() / fs::read_symlink(path, error);
      this->Target = error ? path : real.string();
    }
    this->Temporary = MakeTemporaryName(this->Target);
    this->File = std::fopen(this->Temporary.c_str(), "wbx");
    if (this->File && fs::exists(status))
    {
      fs::permissions(this->Temporary, status.permissions(), error); // failure is ignored
    }
  }
  if (!this->File)
  {
    this->Temporary.clear();
    this->Fail(errno);
  }
}

//------------------------------------------------------------------------------
OutputFile::~OutputFile()
{
  if (this->File)
  {
    std::fclose(this->File);
  }
  if (!this->Temporary.empty())
  {
    std::remove(this->Temporary.c_str());
  }
}

//------------------------------------------------------------------------------
void OutputFile::Write(const char* bytes, std::size_t size)
{
  if (!this->HasFailed() && size > 0 && std::fwrite(bytes, 1, size, this->File) != size)
  {
    this->Fail(errno);
  }
}

//------------------------------------------------------------------------------
bool OutputFile::Close()
{
  if (!this->HasFailed() && this->File)
  {
    const int closed = std::fclose(this->File);
    this->File = nullptr;
    if (closed != 0)
    {
      this->Fail(errno);
    }
  }
  return !this->HasFailed();
}

//------------------------------------------------------------------------------
bool OutputFile::Commit()
{
  if (!this->Close())
  {
    return false;
  }
  if (!this->Temporary.empty())
  {
    std::error_code error;
    fs::rename(this->Temporary, this->Target, error);
    if (error)
    {
      this->Fail(error.value());
      return false;
    }
    this->Temporary.clear();
  }
  return true;
}

//------------------------------------------------------------------------------
void OutputFile::Fail(int code)
{
  if (!this->HasFailed())
  {
    this->Error = { code == ENOSPC || code == EFBIG ? ErrorKind::DiskFull : ErrorKind::Write,
      this->Name + ": cannot write the file: " + std::strerror(code) };
  }
}
}
