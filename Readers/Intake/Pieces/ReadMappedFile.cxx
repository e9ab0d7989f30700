// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Pieces/ReadMappedFile.h"

#include "Base/Parallel.h"

#include "vtkUnstructuredGrid.h"

#include <new>
#include <stdexcept>

namespace camaron
{
//------------------------------------------------------------------------------
bool ReadMappedFile(
  const std::string& path, ScanError& error, const Progress& progress, MappedFileReading read)
{
  bool good = false;
  const auto fail = [&]
  { error = { ErrorKind::Memory, GetFileName(path) + ": not enough memory for the mesh" }; };
  try
  {
    WithThreads(
      [&]
      {
        MappedFile file;
        constexpr double inflation = 0.4; // of the whole time
        if (file.Open(path, error, progress.Part(0, inflation)))
        {
          try
          {
            good = read(file, file.IsCompressed() ? progress.Part(inflation, 1) : progress);
          }
          catch (...)
          {
            if (file.IsUnchanged(error))
            {
              throw;
            }
          }
          // If the file was changed, this error replaces all others.
          good = file.IsUnchanged(error) && good;
        }
      });
  }
  catch (const std::bad_alloc&)
  {
    fail();
  }
  catch (const std::length_error&)
  {
    fail();
  }
  return good && !error;
}

//------------------------------------------------------------------------------
bool ReadMappedFile(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress, MappedFileReading read)
{
  grid->Initialize();
  bool hasTrailingData = false;
  const bool good = ReadMappedFile(path, error, progress,
    [&](const MappedFile& file, const Progress& part)
    {
      hasTrailingData = file.HasTrailingData();
      return read(file, part);
    });
  if (!good)
  {
    grid->Initialize();
    warnings = Warnings();
  }
  else if (hasTrailingData && request.Piece == 0)
  {
    warnings.Add("data after the compressed data is ignored");
  }
  return good;
}
}
