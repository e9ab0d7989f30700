// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Write/InputFiles.h"

#include "Base/Text.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;

namespace camaron
{
namespace
{
thread_local const InputFiles* Protected = nullptr;

/// Extensions of files that name other files: of VTK, ParaView, Xdmf, EnSight and VisIt.
constexpr const char* Lists[] = { ".pvtu", ".pvtp", ".pvts", ".pvtr", ".pvti", ".vtm", ".vtmb",
  ".vtmg", ".vthb", ".vth", ".vtpc", ".vtpd", ".pvd", ".pvtk", ".series", ".xmf", ".xdmf", ".xmf2",
  ".xdmf2", ".xmf3", ".xdmf3", ".case", ".encas", ".sos", ".visit", ".pht" };
/// Lists and decks that were searched. They may name each other, or themselves.
using SeenFiles = std::vector<fs::path>;

//------------------------------------------------------------------------------
bool AreSame(const fs::path& a, const fs::path& b)
{
  std::error_code error;
  return fs::equivalent(a, b, error) && !error;
}

//------------------------------------------------------------------------------
bool IsList(const fs::path& path)
{
  const std::string extension = ToLower(path.extension().string());
  return std::find(std::begin(Lists), std::end(Lists), extension) != std::end(Lists);
}

//------------------------------------------------------------------------------
/// Whether a name is that of a pattern in which each * is a digit, as in EnSight's time series.
bool Matches(std::string_view pattern, std::string_view name)
{
  return pattern.size() == name.size() &&
    std::equal(pattern.begin(), pattern.end(), name.begin(), [](char p, char c)
      { return p == c || (p == '*' && std::isdigit(static_cast<unsigned char>(c))); });
}

//------------------------------------------------------------------------------
/// Calls @a visit with everything in a text that may be a name: what is between quotes, and words.
void VisitNames(std::string_view text, const std::function<void(std::string_view)>& visit)
{
  for (const std::string_view ends : { "\"'\n", " \t\r\n\"'<>=,;:()[]{}" })
  {
    for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end + 1)
    {
      end = std::min(text.find_first_of(ends, begin), text.size());
      if (end > begin)
      {
        visit(text.substr(begin, end - begin));
      }
    }
  }
}

//------------------------------------------------------------------------------
/// Whether a file is there and was not searched before; from now on, it was.
bool IsUnseen(const fs::path& path, SeenFiles& seen)
{
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  if (error || !fs::is_regular_file(real, error) ||
    std::find(seen.begin(), seen.end(), real) != seen.end())
  {
    return false;
  }
  seen.push_back(real);
  return true;
}

//------------------------------------------------------------------------------
bool Names(const fs::path& list, const fs::path& target, SeenFiles& seen);

//------------------------------------------------------------------------------
bool IsNamedBy(std::string_view name, const fs::path& list, const fs::path& target, SeenFiles& seen)
{
  const fs::path path = list.parent_path() / fs::path(name);
  if (name.find('*') != std::string_view::npos)
  {
    return AreSame(path.parent_path().empty() ? "." : path.parent_path(),
             target.parent_path().empty() ? "." : target.parent_path()) &&
      Matches(path.filename().string(), target.filename().string());
  }
  return AreSame(path, target) ||
    (IsList(path) && IsUnseen(path, seen) && Names(path, target, seen));
}

//------------------------------------------------------------------------------
/// Whether a list names a file, or names a list that does.
bool Names(const fs::path& list, const fs::path& target, SeenFiles& seen)
{
  std::ifstream stream(list, std::ios::binary);
  const std::string text{ std::istreambuf_iterator<char>(stream),
    std::istreambuf_iterator<char>() };
  bool isFound = false;
  VisitNames(text,
    [&](std::string_view name)
    {
      constexpr std::size_t MaxName = 4096;
      isFound = isFound || (name.size() < MaxName && IsNamedBy(name, list, target, seen));
    });
  return isFound;
}

//------------------------------------------------------------------------------
/// Whether a name is that of a deck of Mechanical APDL.
bool IsDeck(const fs::path& path)
{
  const std::string extension = ToLower(path.extension().string());
  return extension == ".cdb" || extension == ".dat" || extension == ".inp" || extension == ".mac";
}

//------------------------------------------------------------------------------
/// Whether a deck has the command /INPUT, Name, Extension, Folder for a file, or for a deck that
/// does.
bool Includes(const fs::path& deck, const fs::path& target, SeenFiles& seen)
{
  std::ifstream stream(deck, std::ios::binary);
  for (std::string line; std::getline(stream, line);)
  {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin == std::string::npos || ToLower(line.substr(begin, 4)) != "/inp")
    {
      continue;
    }
    std::string fields[4]; // the command, a name, an extension, a folder
    std::size_t field = 0;
    for (const char c : line.substr(begin, line.find('!') - begin))
    {
      field += c == ',';
      if (field == std::size(fields))
      {
        break;
      }
      if (!std::strchr(",'\" \t\r", c))
      {
        fields[field] += c;
      }
    }
    const fs::path folder = deck.parent_path() / fields[3];
    const std::string& name = fields[1];
    for (const fs::path& path : { folder / name, folder / (name + '.' + fields[2]) })
    {
      if (AreSame(path, target) || (IsUnseen(path, seen) && Includes(path, target, seen)))
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
/// Whether OpenFOAM's meshes, fields and settings are in a folder of this name: a time step such as
/// 0, 0.5 or 1e-05, "constant" or "system".
bool IsFolderOfCase(const std::string& name)
{
  return name == "constant" || name == "system" ||
    (!name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) &&
      name.find_first_not_of("0123456789.e+-") == std::string::npos);
}

//------------------------------------------------------------------------------
/// Whether a file is a mesh or a field of an OpenFOAM case: constant/polyMesh/points, 0.5/U,
/// processor0/constant/polyMesh/points; but no set, which is output of other programs.
bool IsOfCase(const fs::path& foam, const fs::path& target)
{
  std::error_code error;
  const fs::path file = fs::canonical(target, error);
  const fs::path folder = fs::canonical(foam, error).parent_path();
  const fs::path inside = file.lexically_relative(folder);
  auto part = inside.begin();
  if (error || inside.empty() || *part == "..")
  {
    return false;
  }
  if (part->string().rfind("processor", 0) == 0)
  {
    ++part;
  }
  return part != inside.end() && IsFolderOfCase(part->string()) &&
    file.parent_path().filename() != "sets";
}

//------------------------------------------------------------------------------
/// Whether two names are those of pieces of one Exodus file: can.e.4.0 and can.e.4.3.
bool ArePiecesOfOne(const fs::path& a, const fs::path& b)
{
  const auto isNumber = [](const std::string& extension)
  {
    return extension.size() > 1 &&
      extension.find_first_not_of("0123456789", 1) == std::string::npos;
  };
  const fs::path number = a.stem().extension();
  return isNumber(a.extension().string()) && isNumber(b.extension().string()) &&
    isNumber(number.string()) && a.stem() == b.stem() &&
    AreSame(a.parent_path().empty() ? "." : a.parent_path(),
      b.parent_path().empty() ? "." : b.parent_path());
}
}

//------------------------------------------------------------------------------
void InputFiles::Add(const std::string& path)
{
  if (!path.empty() && std::find(this->Paths.begin(), this->Paths.end(), path) == this->Paths.end())
  {
    this->Paths.push_back(path);
  }
}

//------------------------------------------------------------------------------
void InputFiles::Add(const InputFiles& others)
{
  for (const std::string& path : others.Paths)
  {
    this->Add(path);
  }
}

//------------------------------------------------------------------------------
std::string InputFiles::FindReplaced(const std::string& target) const
{
  std::error_code error;
  if (!fs::exists(target, error))
  {
    return "";
  }
  for (const std::string& path : this->Paths)
  {
    if (AreSame(path, target) || ArePiecesOfOne(path, target))
    {
      return path;
    }
  }
  SeenFiles seen;
  for (const std::string& path : this->Paths)
  {
    if ((IsList(path) && IsUnseen(path, seen) && Names(path, target, seen)) ||
      (IsDeck(path) && IsUnseen(path, seen) && Includes(path, target, seen)) ||
      (fs::path(path).extension() == ".foam" && IsOfCase(path, target)))
    {
      return path;
    }
  }
  return "";
}

//------------------------------------------------------------------------------
InputFiles::Protection::Protection(const InputFiles& files)
{
  Protected = &files;
}

//------------------------------------------------------------------------------
InputFiles::Protection::~Protection()
{
  Protected = nullptr;
}

//------------------------------------------------------------------------------
std::string InputFiles::FindProtected(const std::string& target)
{
  return Protected ? Protected->FindReplaced(target) : "";
}
}
