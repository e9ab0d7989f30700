// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolyMeshFolder.h"

#include "Intake/Write/InputFiles.h"

#include <algorithm>
#include <fstream>
#include <random>

namespace fs = std::filesystem;

namespace camaron
{
namespace
{
// What OpenFOAM keeps in a mesh; a new mesh makes all of it wrong.
constexpr const char* MeshFiles[] = { "points", "faces", "owner", "neighbour", "boundary",
  "cellZones", "faceZones", "pointZones", "sets", "cells", "meshModifiers", "parallelData",
  "globalIndices", "cellLevel", "pointLevel", "level0Edge", "surfaceIndex", "refinementHistory",
  "hexRef8", "cellProcAddressing", "faceProcAddressing", "pointProcAddressing",
  "boundaryProcAddressing", "tetBasePtIs", "cutCells" };

//------------------------------------------------------------------------------
bool IsOfMesh(const fs::path& path)
{
  const fs::path name = path.extension() == ".gz" ? path.stem() : path.filename();
  return std::any_of(
    std::begin(MeshFiles), std::end(MeshFiles), [&](const char* known) { return name == known; });
}

//------------------------------------------------------------------------------
// The files in a folder that are part of a mesh, or those that are not; none if there is no folder.
std::vector<fs::path> FindFiles(const fs::path& folder, bool ofMesh)
{
  std::vector<fs::path> files;
  if (fs::exists(folder))
  {
    const fs::directory_iterator all(folder);
    std::copy_if(begin(all), end(all), std::back_inserter(files),
      [&](const fs::path& file) { return IsOfMesh(file) == ofMesh; });
  }
  return files;
}
}

//------------------------------------------------------------------------------
PolyMeshFolder::PolyMeshFolder(const std::string& marker)
  : Marker(marker)
  , Mesh(fs::path(marker).parent_path() / "constant" / "polyMesh")
{
  std::error_code ignored;
  const fs::path real = fs::canonical(this->Mesh, ignored); // a symbolic link stays one
  this->Mesh = ignored ? this->Mesh : real;
}

//------------------------------------------------------------------------------
PolyMeshFolder::~PolyMeshFolder()
{
  std::error_code ignored;
  fs::remove_all(this->Temporary, ignored);
  std::for_each(this->Created.rbegin(), this->Created.rend(),
    [&](const fs::path& folder) { fs::remove(folder, ignored); }); // if empty
}

//------------------------------------------------------------------------------
bool PolyMeshFolder::Try(ScanError& error, FunctionRef<void()> change) const
{
  try
  {
    change();
    return true;
  }
  catch (const fs::filesystem_error& failure)
  {
    const bool isFull = failure.code() == std::errc::no_space_on_device;
    error = { isFull ? ErrorKind::DiskFull : ErrorKind::Write,
      this->Marker.filename().string() + ": cannot write " + this->Mesh.string() + ": " +
        failure.code().message() };
    return false;
  }
}

//------------------------------------------------------------------------------
bool PolyMeshFolder::Check(bool overwrites, ScanError& error) const
{
  const auto refuse = [&](const std::string& reason)
  {
    error = { ErrorKind::Write, this->Marker.filename().string() + ": " + reason };
    return false;
  };
  std::error_code unknown;
  const fs::file_status status = fs::symlink_status(this->Mesh, unknown);
  if (fs::exists(status) && !fs::is_directory(status))
  {
    return refuse("expected a folder, found " + this->Mesh.string());
  }
  for (const char* file : { "points", "points.gz" })
  {
    if (!InputFiles::FindProtected((this->Mesh / file).string()).empty())
    {
      return refuse("the mesh was read from this case: write to another folder");
    }
  }
  // Also of what is left of a mesh, nothing would remain.
  std::vector<fs::path> files;
  return this->Try(error, [&] { files = FindFiles(this->Mesh, true); }) &&
    (overwrites || files.empty() ||
      refuse("expected a case without a mesh, found " + files.front().string() +
        ": write to another folder, or set Overwrite"));
}

//------------------------------------------------------------------------------
bool PolyMeshFolder::Open(bool hasSets, ScanError& error)
{
  return this->Try(error,
    [&]
    {
      const fs::path constant = this->Mesh.parent_path();
      for (const fs::path& folder : { constant.parent_path(), constant })
      {
        if (!folder.empty() && fs::create_directory(folder))
        {
          this->Created.push_back(folder);
        }
      }
      this->Temporary = constant / ("polyMesh." + std::to_string(std::random_device()()) + ".part");
      fs::create_directory(this->Temporary);
      if (hasSets)
      {
        fs::create_directory(this->Temporary / "sets");
      }
    });
}

//------------------------------------------------------------------------------
bool PolyMeshFolder::Commit(ScanError& error)
{
  return this->Try(error,
    [&]
    {
      const fs::path old = this->Temporary.string() + ".old";
      if (fs::exists(this->Mesh))
      {
        fs::rename(this->Mesh, old);
      }
      std::error_code reason;
      fs::rename(this->Temporary, this->Mesh, reason);
      if (reason)
      {
        std::error_code ignored;
        fs::rename(old, this->Mesh, ignored);
        throw fs::filesystem_error("", reason);
      }
      this->Temporary.clear();
      this->Created.clear();
      for (const fs::path& file : FindFiles(old, false)) // until all are moved, nothing is lost
      {
        fs::rename(file, this->Mesh / file.filename());
      }
      fs::remove_all(old);
      if (!fs::exists(this->Marker) && !std::ofstream(this->Marker))
      {
        throw fs::filesystem_error("", std::make_error_code(std::errc::permission_denied));
      }
    });
}
}
