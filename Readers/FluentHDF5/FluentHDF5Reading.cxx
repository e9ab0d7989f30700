// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentHDF5Reading.h"

#include "FluentContainer.h"
#include "Intake/Pieces/ReadMappedFile.h"

#include "vtkUnstructuredGrid.h"

namespace camaron
{
//------------------------------------------------------------------------------
bool IsFluentHDF5(const std::string& path)
{
  const MappedFile file(path); // if compressed, only its beginning
  ScanError ignored;
  return HDF5File::IsHDF5(file.begin(), file.end()) &&
    (file.IsCompressed() ||
      UseHDF5(
        file, 0, ignored, [](HDF5File& content) { return content.GetRoot().Has("meshes/1"); }));
}

//------------------------------------------------------------------------------
std::vector<std::string> ListFluentZones(const std::string& path)
{
  std::vector<std::string> names;
  ScanError ignored; // reading reports it
  ReadMappedFile(path, ignored, Progress(),
    [&](const MappedFile& mapped, const Progress&)
    {
      return UseHDF5(mapped, 0, ignored,
        [&](HDF5File& file)
        {
          FluentContainer container(file);
          container.Open(Progress(), true);
          names = container.GetZoneNames();
          return true;
        });
    });
  return names;
}

//------------------------------------------------------------------------------
bool ReadFluentHDF5(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  vtkMultiBlockDataSet* boundaries, const std::vector<std::string>* zones,
  const FluentFieldRequest& fields, Warnings& warnings, ScanError& error, const Progress& progress)
{
  PieceExchange exchange(FindProcesses(request));    // also if this process fails before it is used
  constexpr double MeshShare = 0.8, OpenShare = 0.1; // of the progress
  const bool hasFields = fields.IsAny();
  Warnings unheard;
  Warnings& heard = request.Piece == 0 ? warnings : unheard; // of the file, not of the piece
  std::int64_t cells = 0;
  bool good = ReadMappedFile(path, request, grid, warnings, error,
    hasFields ? progress.Part(0, MeshShare) : progress,
    [&](const MappedFile& mapped, const Progress& part)
    {
      return UseHDF5(mapped, 0, error,
        [&](HDF5File& file)
        {
          FluentContainer container(file);
          if (!container.Open(part.Part(0, OpenShare)))
          {
            return false;
          }
          container.WarnOfUnused(heard);
          if (zones)
          {
            container.Choose(*zones, heard);
          }
          cells = container.DeclaredCells.Count;
          container.Exchange = &exchange;
          return ReadFluent(
            container, request, grid, boundaries, warnings, error, part.Part(OpenShare, 1));
        });
    });
  exchange.Close();
  if (good && hasFields)
  {
    good = ReadFluentFields(fields, cells, grid, heard, error, progress.Part(MeshShare, 1));
  }
  if (!good)
  {
    grid->Initialize();
  }
  return good;
}
}
