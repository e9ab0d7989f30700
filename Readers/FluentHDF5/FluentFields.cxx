// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentHDF5Reading.h"

#include "HDF5Column.h"
#include "Intake/Pieces/ReadMappedFile.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <limits>
#include <map>
#include <set>

namespace camaron
{
namespace
{
using FieldPaths = std::map<std::string, std::string>; ///< by names

//------------------------------------------------------------------------------
FieldPaths FindFields(HDF5File& file)
{
  // In each phase, "fields" lists the others; the reader's own arrays must not be replaced.
  static const std::set<std::string> skipped = { "fields", "Zone", "OriginalCellId",
    "GlobalCellIds", "vtkGhostType" };
  const HDF5Object root = file.GetRoot();
  root.Check(root.Has("results"), ErrorKind::NotThisFormat,
    "results of Fluent in the group results",
    root.Has("meshes") ? "a mesh only; the results are in the data file (.dat.h5)"
                       : "another content");
  const HDF5Object results = root.Open("results/1");
  FieldPaths paths;
  for (int phase = 1; results.Has("phase-" + std::to_string(phase)); ++phase)
  {
    const std::string cells = "phase-" + std::to_string(phase) + "/cells";
    if (!results.Has(cells))
    {
      continue;
    }
    const HDF5Object fields = results.Open(cells);
    const std::string suffix = phase > 1 ? "-phase_" + std::to_string(phase - 1) : "";
    for (const std::string& name : fields.GetNames())
    {
      if (skipped.count(name) > 0)
      {
        continue;
      }
      const HDF5Object field = fields.Open(name);
      if (!field.IsData() && !field.GetNames().empty())
      {
        paths.emplace(name + suffix, field.GetPath());
      }
    }
  }
  return paths;
}

//------------------------------------------------------------------------------
// Opens a data file, and calls use(file, paths, progress).
template <typename Use>
bool WithFields(const std::string& path, double expectedBytes, ScanError& error,
  const Progress& progress, Use&& use)
{
  return ReadMappedFile(path, error, progress,
    [&](const MappedFile& mapped, const Progress& part)
    {
      return UseHDF5(mapped, expectedBytes, error,
        [&](HDF5File& file) { return use(file, FindFields(file), part); });
    });
}

//------------------------------------------------------------------------------
// Adds the array; false if aborted.
template <typename Array>
bool ReadField(
  HDF5Column& field, const std::string& name, vtkUnstructuredGrid* grid, const Progress& progress)
{
  using Value = typename Array::ValueType;
  vtkCellData* const data = grid->GetCellData();
  auto* const ids = vtkIdTypeArray::SafeDownCast(data->GetArray("OriginalCellId"));
  auto* const positions = vtkIdTypeArray::SafeDownCast(data->GetArray("GlobalCellIds"));
  const auto getId = [&](vtkIdType cell) -> std::int64_t
  { return ids ? ids->GetValue(cell) : (positions ? positions->GetValue(cell) : cell) + 1; };
  const vtkIdType size = grid->GetNumberOfCells();
  const std::int64_t width = field.GetColumns();
  Buffer<Value> values(size * width);
  std::fill_n(values.data(), values.size(), std::numeric_limits<Value>::quiet_NaN());
  constexpr std::int64_t BatchSize = 65536; // values
  const std::int64_t most = std::max<std::int64_t>(BatchSize / width, 1);
  Buffer<double> rows(most * width);
  vtkIdType cell = 0; // ids ascend
  for (const HDF5Column::Section& section : field.GetSections())
  {
    for (; cell < size && getId(cell) < section.First; ++cell)
    {
    }
    while (cell < size && getId(cell) <= section.Last)
    {
      const std::int64_t first = getId(cell), count = std::min(most, section.Last + 1 - first);
      field.Read(first, count, rows.data());
      for (; cell < size && getId(cell) < first + count; ++cell)
      {
        for (std::int64_t i = 0; i < width; ++i)
        {
          values[cell * width + i] = static_cast<Value>(rows[(getId(cell) - first) * width + i]);
        }
      }
      if (!progress.Report(static_cast<double>(cell) / static_cast<double>(size)))
      {
        return false;
      }
    }
  }
  data->AddArray(values.template TakeArray<Array>(static_cast<int>(width), name.c_str()));
  return true;
}
}

//------------------------------------------------------------------------------
std::string GetFluentDataPath(const std::string& path)
{
  const std::string ending = ".cas.h5", name = WithoutGz(path);
  const std::size_t size = name.size() - std::min(ending.size(), name.size());
  if (name.substr(size) != ending)
  {
    return "";
  }
  const std::string data = name.substr(0, size) + ".dat.h5", compressed = data + ".gz";
  std::error_code failure;
  return !std::filesystem::exists(data, failure) && std::filesystem::exists(compressed, failure)
    ? compressed
    : data;
}

//------------------------------------------------------------------------------
std::vector<std::string> ListFluentFields(const std::string& path)
{
  std::vector<std::string> names;
  ScanError error;
  const auto list = [&names](HDF5File&, const FieldPaths& paths, const Progress&)
  {
    std::transform(paths.begin(), paths.end(), std::back_inserter(names),
      [](const auto& field) { return field.first; });
    return true;
  };
  std::error_code failure;
  if (std::filesystem::exists(path, failure))
  {
    WithFields(path, 0, error, Progress(), list);
  }
  return names;
}

//------------------------------------------------------------------------------
bool ReadFluentFields(const FluentFieldRequest& request, std::int64_t cells,
  vtkUnstructuredGrid* grid, Warnings& warnings, ScanError& error, const Progress& progress)
{
  std::error_code failure;
  if (!request.IsRequired && !std::filesystem::exists(request.Path, failure))
  {
    warnings.Add("there is no data file beside it, so the chosen cell arrays are missing");
    return true;
  }
  const double bytes = sizeof(double) * static_cast<double>(cells); // of a field
  const auto count = static_cast<double>(request.Names.size());
  return WithFields(request.Path, bytes * count, error, progress,
    [&](HDF5File& file, const FieldPaths& paths, const Progress& part)
    {
      for (std::size_t i = 0; i < request.Names.size(); ++i)
      {
        const auto found = paths.find(request.Names[i]);
        if (found == paths.end())
        {
          warnings.Add(file.GetName() + " has no field " + request.Names[i]);
          continue;
        }
        const HDF5Object group = file.GetRoot().Open(found->second);
        HDF5Column field(file);
        field.Open(group, "cells", cells, false, 0);
        const auto width = static_cast<double>(field.GetColumns());
        file.Charge(group, width > 1 ? bytes * width : 0);
        const auto read = field.IsSingle() ? ReadField<vtkFloatArray> : ReadField<vtkDoubleArray>;
        const auto done = static_cast<double>(i);
        if (!read(field, found->first, grid, part.Part(done / count, (done + 1) / count)))
        {
          return false;
        }
      }
      return true;
    });
}
}
