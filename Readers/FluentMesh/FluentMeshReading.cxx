// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentMeshReading.h"

#include "FluentMeshFile.h"
#include "Intake/Fluent/FluentText.h"
#include "Intake/Pieces/ReadMappedFile.h"

#include <string_view>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool BeginsWith(const char* begin, const char* end, std::string_view text)
{
  return std::string_view(begin, static_cast<std::size_t>(end - begin)).substr(0, text.size()) ==
    text;
}

constexpr std::string_view HDF5("\x89HDF\r\n\x1a\n", 8);

//------------------------------------------------------------------------------
// Recognizes files of other formats with the same extensions; empty if unknown.
std::string RecognizeOther(const char* begin, const char* end)
{
  if (BeginsWith(begin, end, HDF5))
  {
    return "a file of Fluent in HDF5 (Common Fluids Format), which the ANSYS Fluent HDF5 "
           "Reader and ParaView's FLUENT CFF reader open if it is named .cas.h5";
  }
  const char* const text = SkipSpaceFrom(begin, end);
  if (BeginsWith(text, end, "$MeshFormat") || BeginsWith(text, end, "$NOD") ||
    BeginsWith(text, end, "$Comments"))
  {
    return "a Gmsh file, which the reader of ParaView's GmshIO plugin opens";
  }
  if (text < end && IsDigit(*text))
  {
    return "a file that begins with a number, as those of Netgen and ADVENTURE do";
  }
  return std::string();
}
}

//------------------------------------------------------------------------------
bool IsFluentMesh(const std::string& path)
{
  const MappedFile file(path);
  return FluentMeshFile::IsFluent(file.begin(), file.end());
}

//------------------------------------------------------------------------------
bool ReadFluentMesh(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  vtkMultiBlockDataSet* boundaries, Warnings& warnings, ScanError& error, const Progress& progress)
{
  return ReadMappedFile(path, request, grid, warnings, error, progress,
    [&](const MappedFile& mapped, const Progress& rest)
    {
      const std::string other = RecognizeOther(mapped.begin(), mapped.end());
      if (!other.empty())
      {
        const bool isFluent = BeginsWith(mapped.begin(), mapped.end(), HDF5); // in another format
        error = { isFluent ? ErrorKind::Unsupported : ErrorKind::NotThisFormat,
          mapped.GetName() + ": expected a Fluent mesh, found " + other };
        return false;
      }
      constexpr double ScanShare = 0.1; // of the progress
      FluentMeshFile file(mapped.GetName(), mapped.begin(), mapped.end());
      const bool isRead = file.Scan(rest.Part(0, ScanShare)) &&
        ReadFluent(file, request, grid, boundaries, warnings, error, rest.Part(ScanShare, 1));
      error = file.HasFailed() ? file.GetError() : error;
      return isRead;
    });
}
}
