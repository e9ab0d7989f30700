// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentHDF5Reading.h"

#include "FluentContainer.h"
#include "FluentFields.h"
#include "Intake/Pieces/ReadMappedFile.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
void WarnOfUnused(const std::vector<std::string>& unused, Warnings& warnings)
{
  constexpr std::size_t MaxNames = 8;
  std::string list;
  for (std::size_t i = 0; i < std::min(unused.size(), MaxNames); ++i)
  {
    list += (i > 0 ? ", " : "") + unused[i];
  }
  if (!unused.empty())
  {
    warnings.Add(
      "the file has data that are not used: " + list + (unused.size() > MaxNames ? ", ..." : ""));
  }
}

//------------------------------------------------------------------------------
bool ReadContent(const MappedFile& file, const PieceRequest& request, PieceExchange& exchange,
  vtkUnstructuredGrid* grid, vtkMultiBlockDataSet* boundaries,
  const std::vector<std::string>& leftOut, std::int64_t& cells, Warnings& warnings,
  ScanError& error, const Progress& progress)
{
  constexpr double OpenShare = 0.1; // of the progress
  try
  {
    FluentContainer container(file.GetName(), file.begin(), file.end());
    if (!container.Open(progress.Part(0, OpenShare)))
    {
      return false;
    }
    container.LeaveOut(leftOut);
    cells = container.DeclaredCells.Count;
    container.Exchange = &exchange;
    if (request.Piece == 0)
    {
      WarnOfUnused(container.GetUnused(), warnings);
    }
    return ReadFluent(
      container, request, grid, boundaries, warnings, error, progress.Part(OpenShare, 1));
  }
  catch (const HDF5Error& failure)
  {
    error = failure.Error;
    return false;
  }
}
}

//------------------------------------------------------------------------------
bool IsFluentHDF5(const std::string& path)
{
  const MappedFile file(path);
  const bool isHDF5 = HDF5File::IsHDF5(file.begin(), file.end());
  if (!isHDF5 || file.IsCompressed()) // then only the beginning is at hand
  {
    return isHDF5;
  }
  try
  {
    return HDF5File("", file.begin(), file.end()).GetRoot().Has("meshes/1");
  }
  catch (const HDF5Error&)
  {
    return false;
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> ListFluentZones(const std::string& path)
{
  std::vector<std::string> names;
  ScanError error; // reading reports it
  ReadMappedFile(path, error, Progress(),
    [&names](const MappedFile& file, const Progress&)
    {
      try
      {
        names = FluentContainer(file.GetName(), file.begin(), file.end()).ListZones();
      }
      catch (const HDF5Error&)
      {
        names.clear();
      }
      return true;
    });
  return names;
}

//------------------------------------------------------------------------------
bool ReadFluentHDF5(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  vtkMultiBlockDataSet* boundaries, const std::vector<std::string>& leftOut,
  const FluentFieldRequest& fields, Warnings& warnings, ScanError& error, const Progress& progress)
{
  PieceExchange exchange(FindProcesses(request)); // also if this process fails before it is used
  constexpr double MeshShare = 0.8;               // of the progress
  const bool hasFields = fields.IsAny();
  std::int64_t cells = 0;
  bool good = ReadMappedFile(path, request, grid, warnings, error,
    hasFields ? progress.Part(0, MeshShare) : progress,
    [&](const MappedFile& file, const Progress& rest)
    {
      return ReadContent(
        file, request, exchange, grid, boundaries, leftOut, cells, warnings, error, rest);
    });
  exchange.Close();
  if (good && hasFields)
  {
    Warnings more;
    good = ReadFluentFields(fields, cells, grid, request.Piece == 0 ? warnings : more, error,
      progress.Part(MeshShare, 1));
  }
  if (!good)
  {
    grid->Initialize();
  }
  return good;
}
}
