// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace camaron
{
namespace testing
{
namespace
{
const std::string Mark = "//// ";

//------------------------------------------------------------------------------
// The extension of the format in a line such as "//// ele", or empty; moves past the line.
std::string ReadMark(const std::string& bytes, std::size_t& at, const FormatUnderTest& format)
{
  if (bytes.compare(at, Mark.size(), Mark) == 0)
  {
    for (const std::string& extension : format.Extensions)
    {
      const std::size_t end = at + Mark.size() + extension.size();
      if (bytes.compare(at + Mark.size(), extension.size() + 1, extension + "\n") == 0)
      {
        at = end + 1;
        return extension;
      }
    }
  }
  return {};
}

//------------------------------------------------------------------------------
// The extension of the format with which the name of a file ends, such as "msh" or "msh.h5"; empty
// if it has none.
std::string GetExtension(const std::filesystem::path& path, const FormatUnderTest& format)
{
  std::string name = path.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  for (const std::string& extension : format.Extensions)
  {
    const std::string end = "." + extension;
    if (name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0)
    {
      return extension;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
std::string Load(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
  {
    throw std::runtime_error("cannot read " + path.string());
  }
  return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}
}

//------------------------------------------------------------------------------
std::size_t GetTotalSize(const MeshFiles& files)
{
  std::size_t size = 0;
  for (const MeshFile& file : files)
  {
    size += file.Bytes.size();
  }
  return size;
}

//------------------------------------------------------------------------------
std::size_t GetInflatedSize(const MeshFiles& files)
{
  constexpr std::size_t MostInflation = 100; // accepted by readers
  std::size_t size = 0;
  for (const MeshFile& file : files)
  {
    const bool isCompressed = file.Bytes.compare(0, 2, "\x1f\x8b") == 0 ||
      file.Bytes.compare(0, 4, "\x89HDF") == 0; // whose data sets are
    size += file.Bytes.size() * (isCompressed ? MostInflation : 1);
  }
  return size;
}

//------------------------------------------------------------------------------
std::string Pack(const MeshFiles& files, const FormatUnderTest& format)
{
  if (files.size() == 1 && files[0].Extension == format.Extensions[0])
  {
    return files[0].Bytes;
  }
  std::string bytes;
  for (const MeshFile& file : files)
  {
    bytes += (bytes.empty() ? "" : "\n") + Mark + file.Extension + "\n" + file.Bytes;
  }
  return bytes;
}

//------------------------------------------------------------------------------
MeshFiles Unpack(const std::string& bytes, const FormatUnderTest& format)
{
  std::size_t begin = 0;
  std::string extension = ReadMark(bytes, begin, format);
  if (extension.empty())
  {
    return { { format.Extensions[0], bytes } };
  }
  MeshFiles files;
  while (!extension.empty())
  {
    std::size_t end = bytes.find("\n" + Mark, begin);
    std::string nextExtension;
    std::size_t next = bytes.size();
    for (; end != std::string::npos; end = bytes.find("\n" + Mark, end + 1))
    {
      next = end + 1;
      nextExtension = ReadMark(bytes, next, format);
      if (!nextExtension.empty())
      {
        break;
      }
    }
    end = std::min(end, bytes.size());
    if (std::none_of(files.begin(), files.end(),
          [&](const MeshFile& file) { return file.Extension == extension; }))
    {
      files.push_back({ extension, bytes.substr(begin, end - begin) });
    }
    extension = nextExtension;
    begin = next;
  }
  return files;
}

//------------------------------------------------------------------------------
MeshFiles LoadMeshFiles(const std::filesystem::path& opened, const FormatUnderTest& format)
{
  MeshFiles files = { { GetExtension(opened, format), Load(opened) } };
  const std::string name = opened.filename().string();
  const std::string stem = name.substr(0, name.size() - files[0].Extension.size());
  for (const std::string& extension : format.Extensions)
  {
    const std::filesystem::path companion = opened.parent_path() / (stem + extension);
    if (extension != files[0].Extension && std::filesystem::exists(companion))
    {
      files.push_back({ extension, Load(companion) });
    }
  }
  return files;
}

//------------------------------------------------------------------------------
std::vector<std::filesystem::path> FindMeshFiles(
  const std::filesystem::path& folder, const FormatUnderTest& format)
{
  std::vector<std::filesystem::path> paths;
  if (std::filesystem::is_directory(folder))
  {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    {
      if (entry.is_regular_file() && !GetExtension(entry.path(), format).empty())
      {
        paths.push_back(entry.path());
      }
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

//------------------------------------------------------------------------------
std::filesystem::path Folder::GetParent()
{
  const std::filesystem::path memory = "/dev/shm";
  std::error_code error;
  return std::filesystem::is_directory(memory, error) ? memory
                                                      : std::filesystem::temp_directory_path();
}

//------------------------------------------------------------------------------
std::string Folder::Write(const MeshFiles& files, const std::string& name) const
{
  for (const MeshFile& file : files)
  {
    std::ofstream stream(this->GetPath() / (name + "." + file.Extension), std::ios::binary);
    stream << file.Bytes;
    if (!stream.flush())
    {
      throw std::runtime_error("cannot write to " + this->GetPath().string());
    }
  }
  return (this->GetPath() / (name + "." + files[0].Extension)).string();
}

//------------------------------------------------------------------------------
void Folder::Clear() const
{
  for (const auto& entry : std::filesystem::directory_iterator(this->GetPath()))
  {
    std::filesystem::remove_all(entry.path());
  }
}
}
}
