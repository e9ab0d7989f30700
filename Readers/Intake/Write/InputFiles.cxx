// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Write/InputFiles.h"

#include "Base/Text.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <sys/stat.h> // no other way to know that two of many files are the same

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

/// What tells apart files whatever their names: the device and the number of the file on it.
using FileId = std::pair<dev_t, ino_t>;

//------------------------------------------------------------------------------
/// Nothing if there is no such file.
std::optional<FileId> FindId(const fs::path& path)
{
  struct stat status = {};
  return stat(path.c_str(), &status) == 0 ? std::make_optional(FileId(status.st_dev, status.st_ino))
                                          : std::nullopt;
}

//------------------------------------------------------------------------------
std::optional<FileId> FindIdOfFolder(const fs::path& path)
{
  return FindId(path.parent_path().empty() ? "." : path.parent_path());
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
/// Whether a name is that of a deck of Mechanical APDL.
bool IsDeck(const fs::path& path)
{
  const std::string extension = ToLower(path.extension().string());
  return extension == ".cdb" || extension == ".dat" || extension == ".inp" || extension == ".mac";
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
/// What pieces of one Exodus file have in common: "can.e.4" of can.e.4.0 and can.e.4.3; empty for
/// other files.
std::string GetWholeOfPieces(const fs::path& path)
{
  const auto isNumber = [](const std::string& extension)
  {
    return extension.size() > 1 &&
      extension.find_first_not_of("0123456789", 1) == std::string::npos;
  };
  return isNumber(path.extension().string()) && isNumber(path.stem().extension().string())
    ? path.stem().string()
    : std::string();
}

//------------------------------------------------------------------------------
/// The files that exist now of those that were added, and of those that they name.
class KnownFiles
{
public:
  explicit KnownFiles(const std::vector<std::string>& paths)
  {
    for (const std::string& path : paths)
    {
      this->Input = &path;
      this->Add(path);
      const std::string whole = GetWholeOfPieces(path);
      const auto folder = whole.empty() ? std::nullopt : FindIdOfFolder(path);
      if (folder)
      {
        this->Pieces.emplace(std::make_pair(*folder, whole), &path);
      }
    }
    for (const std::string& path : paths)
    {
      this->Input = &path;
      this->Search(path);
      if (fs::path(path).extension() == ".foam")
      {
        this->Cases.push_back(&path);
      }
    }
  }

  /// The input that a file is, or to which it belongs; empty if there is none.
  std::string Find(const fs::path& target) const
  {
    const auto id = FindId(target), folder = FindIdOfFolder(target);
    if (!id || !folder)
    {
      return "";
    }
    const auto file = this->Files.find(*id);
    if (file != this->Files.end())
    {
      return *file->second;
    }
    const auto piece = this->Pieces.find({ *folder, GetWholeOfPieces(target) });
    if (piece != this->Pieces.end())
    {
      return *piece->second;
    }
    for (const Pattern& pattern : this->Patterns)
    {
      if (pattern.Folder == *folder && Matches(pattern.Name, target.filename().string()))
      {
        return *pattern.Input;
      }
    }
    for (const std::string* foam : this->Cases)
    {
      if (IsOfCase(*foam, target))
      {
        return *foam;
      }
    }
    return "";
  }

private:
  struct Pattern
  {
    FileId Folder;
    std::string Name;
    const std::string* Input;
  };

  /// Returns whether there is such a file.
  bool Add(const fs::path& path)
  {
    const auto id = FindId(path);
    return id && (this->Files.emplace(*id, this->Input), true);
  }

  /// Adds the files that a list or a deck names, unless it was searched before: they may name each
  /// other, or themselves.
  void Search(const fs::path& path)
  {
    const bool isList = IsList(path);
    if (!isList && !IsDeck(path))
    {
      return;
    }
    if (this->IsUnsearched(path))
    {
      isList ? this->SearchList(path) : this->SearchDeck(path);
    }
  }

  /// Whether a file is there and was not searched before; from now on, it was.
  bool IsUnsearched(const fs::path& path)
  {
    const auto id = FindId(path);
    std::error_code error;
    return id && fs::is_regular_file(path, error) && this->Searched.insert(*id).second;
  }

  void SearchList(const fs::path& list)
  {
    std::ifstream stream(list, std::ios::binary);
    const std::string text{ std::istreambuf_iterator<char>(stream),
      std::istreambuf_iterator<char>() };
    VisitNames(text,
      [&](std::string_view name)
      {
        constexpr std::size_t MaxName = 4096;
        if (name.size() >= MaxName)
        {
          return;
        }
        const fs::path path = list.parent_path() / fs::path(name);
        if (name.find('*') != std::string_view::npos)
        {
          const auto folder = FindIdOfFolder(path);
          if (folder)
          {
            this->Patterns.push_back({ *folder, path.filename().string(), this->Input });
          }
        }
        else if (this->Add(path) && IsList(path))
        {
          this->Search(path);
        }
      });
  }

  /// The command /INPUT, Name, Extension, Folder.
  void SearchDeck(const fs::path& deck)
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
      for (const fs::path& path : { folder / fields[1], folder / (fields[1] + '.' + fields[2]) })
      {
        if (this->Add(path) && this->IsUnsearched(path))
        {
          this->SearchDeck(path); // of any extension
        }
      }
    }
  }

  const std::string* Input = nullptr; // whose files are being added
  std::map<FileId, const std::string*> Files;
  std::map<std::pair<FileId, std::string>, const std::string*> Pieces;
  std::vector<Pattern> Patterns;
  std::vector<const std::string*> Cases;
  std::set<FileId> Searched;
};
}

//------------------------------------------------------------------------------
void InputFiles::Add(const std::string& path)
{
  if (!path.empty() && this->Known.insert(path).second)
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
std::vector<std::string> InputFiles::FindReplaced(const std::vector<std::string>& targets) const
{
  std::vector<std::string> inputs(targets.size());
  const bool isNew = std::none_of(targets.begin(), targets.end(),
    [](const std::string& target) { return FindId(target).has_value(); });
  if (isNew)
  {
    return inputs;
  }
  const KnownFiles known(this->Paths);
  std::transform(targets.begin(), targets.end(), inputs.begin(),
    [&](const std::string& target) { return known.Find(target); });
  return inputs;
}

//------------------------------------------------------------------------------
std::string InputFiles::FindReplaced(const std::string& target) const
{
  return this->FindReplaced(std::vector<std::string>{ target }).front();
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
