// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolyMeshFolder.h"

#include "Intake/Write/InputFiles.h"
#include "Intake/Write/OutputFile.h"
#include "Scan/MappedFile.h"

#include <algorithm>
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
void MoveOtherFiles(const fs::path& from, const fs::path& to, std::error_code& reason)
{
  for (fs::directory_iterator entry(from, reason), end; !reason && entry != end;
    entry.increment(reason))
  {
    if (!IsOfMesh(entry->path()))
    {
      fs::rename(entry->path(), to / entry->path().filename(), reason);
    }
  }
}

//------------------------------------------------------------------------------
ScanError MakeError(const std::string& name, const fs::path& path, const std::error_code& reason)
{
  const bool isFull = reason == std::errc::no_space_on_device;
  return { isFull ? ErrorKind::DiskFull : ErrorKind::Write,
    name + ": cannot write " + path.string() + ": " + reason.message() };
}
}

//------------------------------------------------------------------------------
PolyMeshFolder::PolyMeshFolder(const std::string& marker)
  : Marker(marker)
  , Mesh(fs::path(marker).parent_path() / "constant" / "polyMesh")
{
}

//------------------------------------------------------------------------------
PolyMeshFolder::~PolyMeshFolder()
{
  std::error_code ignored;
  if (!this->Temporary.empty())
  {
    fs::remove_all(this->Temporary, ignored);
  }
  std::for_each(this->Created.rbegin(), this->Created.rend(),
    [&](const fs::path& folder) { fs::remove(folder, ignored); }); // if empty
}

//------------------------------------------------------------------------------
bool PolyMeshFolder::Fail(const std::error_code& reason, ScanError& error) const
{
  error = MakeError(GetFileName(this->Marker.string()), this->Mesh, reason);
  return false;
}

//------------------------------------------------------------------------------
bool PolyMeshFolder::Check(bool overwrites, ScanError& error) const
{
  const std::string name = GetFileName(this->Marker.string()) + ": ";
  for (const char* file : { "points", "points.gz" })
  {
    const fs::path path = this->Mesh / file;
    std::error_code ignored;
    if (!InputFiles::FindProtected(path.string()).empty())
    {
      error = { ErrorKind::Write,
        name + "the mesh was read from this case: write to another folder" };
    }
    else if (!overwrites && fs::exists(path, ignored))
    {
      error = { ErrorKind::Write,
        name + "expected a case without a mesh, found " + path.string() +
          ": write to another folder, or set Overwrite" };
    }
  }
  return !error;
}

//------------------------------------------------------------------------------
std::string PolyMeshFolder::Open(ScanError& error)
{
  std::error_code reason;
  const fs::path constant = this->Mesh.parent_path();
  for (const fs::path& folder : { constant.parent_path(), constant })
  {
    if (!folder.empty() && fs::create_directory(folder, reason))
    {
      this->Created.push_back(folder);
    }
    if (reason)
    {
      this->Fail(reason, error);
      return "";
    }
  }
  const fs::path temporary =
    constant / ("polyMesh." + std::to_string(std::random_device()()) + ".part");
  if (!fs::create_directory(temporary, reason))
  {
    this->Fail(reason ? reason : std::make_error_code(std::errc::file_exists), error);
    return "";
  }
  this->Temporary = temporary;
  return temporary.string();
}

//------------------------------------------------------------------------------
bool PolyMeshFolder::Commit(ScanError& error)
{
  std::error_code reason;
  const fs::path old = this->Temporary.string() + ".old";
  const bool hasOld = fs::exists(this->Mesh, reason);
  if (hasOld && !reason)
  {
    fs::rename(this->Mesh, old, reason);
  }
  if (!reason)
  {
    fs::rename(this->Temporary, this->Mesh, reason);
  }
  if (reason)
  {
    std::error_code ignored;
    if (hasOld)
    {
      fs::rename(old, this->Mesh, ignored);
    }
    return this->Fail(reason, error);
  }
  this->Temporary.clear();
  this->Created.clear();
  if (hasOld)
  {
    MoveOtherFiles(old, this->Mesh, reason);
    if (!reason) // else nothing is lost
    {
      fs::remove_all(old, reason);
    }
  }
  if (!fs::exists(this->Marker, reason))
  {
    OutputFile marker(this->Marker.string());
    return marker.Finish(!marker.HasFailed(), error);
  }
  return true;
}

//------------------------------------------------------------------------------
std::string MakeSubfolder(const std::string& folder, const std::string& name, ScanError& error)
{
  const fs::path path = fs::path(folder) / name;
  std::error_code reason;
  fs::create_directory(path, reason);
  if (reason)
  {
    error = MakeError(name, path, reason);
  }
  return reason ? "" : path.string();
}
}
