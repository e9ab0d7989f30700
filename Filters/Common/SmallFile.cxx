// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmallFile.h"

#include "Scan/MappedFile.h"

#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace camaron
{
namespace
{
constexpr std::size_t MaxFileSize = 1 << 20; // larger files are not what the user meant

//------------------------------------------------------------------------------
// A zero byte and the text, or an error message, which does not begin with a zero byte.
std::vector<char> ReadHere(const std::string& path, const std::string& what)
{
  MappedFile file;
  ScanError error;
  std::error_code failure; // ignored: opening the file reports it
  const std::filesystem::file_status status = std::filesystem::status(path, failure);
  if (std::filesystem::is_other(status))
  {
    error = { ErrorKind::NotThisFormat,
      GetFileName(path) + ": expected " + what + ", found a pipe or a device" };
  }
  else if (file.Open(path, error) && file.size() > MaxFileSize)
  {
    error = { ErrorKind::NotThisFormat, file.GetName() + ": the file is too large for " + what };
  }
  if (error)
  {
    return { error.Message.begin(), error.Message.end() };
  }
  std::vector<char> bytes(1, '\0');
  bytes.insert(bytes.end(), file.begin(), file.end());
  return bytes;
}
}

//------------------------------------------------------------------------------
std::string ReadSmallFile(const std::string& path, const std::string& what, Reducer& reducer)
{
  std::vector<std::size_t> sizes;
  const std::vector<char> bytes =
    reducer.Gather(reducer.GetProcess() == 0 ? ReadHere(path, what) : std::vector<char>(), sizes);
  if (bytes.empty() || bytes[0] != '\0')
  {
    throw std::runtime_error(std::string(bytes.begin(), bytes.end()));
  }
  return { bytes.begin() + 1, bytes.end() };
}
}
