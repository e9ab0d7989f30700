// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TetGenFiles.h"

#include "Base/Text.h"

#include <filesystem>

namespace fs = std::filesystem;

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
constexpr const char* Extensions[] = { "node", "ele", "face", "edge", "neigh", "poly", "smesh" };
constexpr int NumberOfKinds = static_cast<int>(TetGenKind::None);

//------------------------------------------------------------------------------
// Position of the extension, after the dot; npos if there is none.
std::size_t FindExtension(const std::string& path)
{
  const std::size_t name = path.size() - GetFileName(path).size();
  const std::size_t dot = path.find_last_of('.');
  return dot == std::string::npos || dot < name ? std::string::npos : dot + 1;
}

//------------------------------------------------------------------------------
bool IsThere(const std::string& path)
{
  std::error_code error;
  return fs::exists(path, error);
}
}

//------------------------------------------------------------------------------
TetGenKind GetTetGenKind(const std::string& path)
{
  const std::string name = WithoutGz(path);
  const std::size_t at = FindExtension(name);
  const std::string extension = at == std::string::npos ? "" : ToLower(name.substr(at));
  int kind = 0;
  while (kind < NumberOfKinds && extension != Extensions[kind])
  {
    ++kind;
  }
  return static_cast<TetGenKind>(kind);
}

//------------------------------------------------------------------------------
bool IsTetGenVoronoi(const std::string& path)
{
  const std::string name = ToLower(GetFileName(WithoutGz(path)));
  for (const std::string end : { ".v.edge", ".v.face", ".v.cell" })
  {
    if (name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
std::string GetTetGenCompanion(const std::string& path, TetGenKind kind)
{
  return path.substr(0, FindExtension(WithoutGz(path))) + Extensions[static_cast<int>(kind)];
}

//------------------------------------------------------------------------------
bool HasTetGenCompanion(const std::string& path, TetGenKind kind)
{
  const std::string companion = GetTetGenCompanion(path, kind);
  return IsThere(companion) || IsThere(companion + ".gz");
}

//------------------------------------------------------------------------------
bool OpenTetGenCompanion(
  const std::string& path, TetGenKind kind, const char* content, MappedFile& file, ScanError& error)
{
  const std::string companion = GetTetGenCompanion(path, kind);
  if (!IsThere(companion) && IsThere(companion + ".gz"))
  {
    return file.Open(companion + ".gz", error);
  }
  if (!IsThere(companion))
  {
    error = { ErrorKind::Companion,
      GetFileName(path) + ": expected the file " + GetFileName(companion) + " with the " + content +
        " in the same folder, found no such file" };
    return false;
  }
  return file.Open(companion, error);
}
}
