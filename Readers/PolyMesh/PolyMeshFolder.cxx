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
  if (!this->Temporary.empty())
  {
    fs::remove_all(this->Temporary, ignored);
  }
  std::for_each(this->Created.rbegin(), this->Created.rend(),
    [&](const fs::path& folder) { fs::remove(folder, ignored); }); // if empty
}

//------------------------------------------------------------------------------
bool PolyMeshFolder::Finish(const std::error_code& reason, ScanError& error) const
{
  if (reason)
  {
    const bool isFull = reason == std::errc::no_space_on_device;
    error = { isFull ? ErrorKind::DiskFull : ErrorKind::Write,
      this->Marker.filename().string() + ": cannot write " + this->Mesh.string() + ": " +
        reason.message() };
  }
  return !reason;
}

//------------------------------------------------------------------------------
bool PolyMeshFolder::Check(bool overwrites, ScanError& error) const
{
  const std::string name = this->Marker.filename().string() + ": ";
  std::error_code unknown;
  const fs::file_status status = fs::symlink_status(this->Mesh, unknown);
  if (fs::exists(status) && !fs::is_directory(status))
  {
    error = { ErrorKind::Write, name + "expected a folder, found " + this->Mesh.string() };
    return false;
  }
  for (const char* file : { "points", "points.gz" })
  {
    if (!InputFiles::FindProtected((this->Mesh / file).string()).empty())
    {
      error = { ErrorKind::Write,
        name + "the mesh was read from this case: write to another folder" };
      return false;
    }
  }
  // Also of what is left of a mesh, nothing would remain.
  std::error_code none;
  for (fs::directory_iterator entry(this->Mesh, none), end; !overwrites && !none && entry != end;
    entry.increment(none))
  {
    if (IsOfMesh(entry->path()))
    {
      error = { ErrorKind::Write,
        name + "expected a case without a mesh, found " + entry->path().string() +
          ": write to another folder, or set Overwrite" };
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool PolyMeshFolder::Open(bool hasSets, ScanError& error)
{
  std::error_code reason;
  const fs::path constant = this->Mesh.parent_path();
  for (const fs::path& folder : { constant.parent_path(), constant })
  {
    if (!reason && !folder.empty() && fs::create_directory(folder, reason))
    {
      this->Created.push_back(folder);
    }
  }
  const std::string name = "polyMesh." + std::to_string(std::random_device()()) + ".part";
  if (!reason && fs::create_directory(constant / name, reason))
  {
    this->Temporary = constant / name;
  }
  if (!reason && hasSets)
  {
    fs::create_directory(this->Temporary / "sets", reason);
  }
  return this->Finish(reason, error);
}

//------------------------------------------------------------------------------
bool PolyMeshFolder::Commit(ScanError& error)
{
  std::error_code reason;
  const fs::path old = this->Temporary.string() + ".old";
  const bool hasOld = fs::exists(this->Mesh, reason);
  if (hasOld)
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
    fs::rename(old, this->Mesh, ignored);
    return this->Finish(reason, error);
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
  if (!fs::exists(this->Marker, reason) && !std::ofstream(this->Marker))
  {
    reason = std::make_error_code(std::errc::permission_denied);
  }
  return this->Finish(reason, error);
}
}
