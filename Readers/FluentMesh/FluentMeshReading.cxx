// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentMeshReading.h"

#include "FluentMeshFile.h"
#include "Intake/Fluent/FluentText.h"
#include "Intake/Pieces/ReadMappedFile.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkUnstructuredGrid.h"

#include <cstring>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool BeginsWith(const char* begin, const char* end, std::string_view text)
{
  return end - begin >= static_cast<std::ptrdiff_t>(text.size()) &&
    std::memcmp(begin, text.data(), text.size()) == 0;
}

constexpr double ScanShare = 0.1; // of the progress
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

//------------------------------------------------------------------------------
bool ReadContent(const std::string& name, const char* begin, const char* end,
  const PieceRequest& request, const FluentOptions& options, vtkUnstructuredGrid* grid,
  vtkMultiBlockDataSet* boundaries, Warnings& warnings, ScanError& error, const Progress& progress)
{
  const std::string other = RecognizeOther(begin, end);
  if (!other.empty())
  {
    const bool isFluent = BeginsWith(begin, end, HDF5); // in another format of Fluent
    error = { isFluent ? ErrorKind::Unsupported : ErrorKind::NotThisFormat,
      name + ": expected a Fluent mesh, found " + other };
    return false;
  }
  FluentMeshFile file(name, begin, end);
  const auto read = [&](FluentMeshFile& opened, bool otherOrder, Warnings& found)
  {
    error = ScanError();
    const bool good = opened.Scan(otherOrder, progress.Part(0, ScanShare)) &&
      ReadFluent(
        opened, request, options, grid, boundaries, found, error, progress.Part(ScanShare, 1));
    error = opened.HasFailed() ? opened.GetError() : error;
    return good;
  };
  if (read(file, false, warnings))
  {
    return true;
  }
  const bool isAboutNumbers = error.Kind == ErrorKind::Index || error.Kind == ErrorKind::Count ||
    error.Kind == ErrorKind::Truncated || error.Kind == ErrorKind::Syntax;
  if (progress.IsStopped() || !isAboutNumbers || !file.HasBinarySections())
  {
    return false;
  }
  // Some writers declare the wrong byte order.
  const ScanError first = error;
  FluentMeshFile again(name, begin, end);
  Warnings others;
  grid->Initialize();
  if (read(again, true, others))
  {
    warnings = others;
    warnings.Add("the binary data does not have the declared byte order");
    return true;
  }
  error = first;
  return false;
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
  vtkMultiBlockDataSet* boundaries, Warnings& warnings, ScanError& error, const Progress& progress,
  const FluentOptions& options)
{
  if (boundaries)
  {
    boundaries->Initialize();
  }
  const bool good = ReadMappedFile(path, request, grid, warnings, error, progress,
    [&](const MappedFile& file, const Progress& rest)
    {
      return ReadContent(file.GetName(), file.begin(), file.end(), request, options, grid,
        boundaries, warnings, error, rest);
    });
  if (!good && boundaries)
  {
    boundaries->Initialize();
  }
  return good;
}
}
