// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentWriting.h"

#include "Base/Text.h"
#include "Intake/CellMesh/ConvertedMesh.h"
#include "Intake/CellMesh/OutputWarnings.h"
#include "Scan/MappedFile.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// A 2D mesh must lie in a plane of constant z, except for rounding errors; @a z is the value with
// the greatest magnitude.
bool IsPlanar(const FluentOutput& mesh, double& z)
{
  constexpr double Rounding = 1e-12; // relative to the size of the mesh
  vtkBoundingBox box;
  for (vtkIdType point = 0; point < mesh.GetNumberOfPoints(); ++point)
  {
    double x[3];
    mesh.GetMesh().GetPoint(mesh.GetMeshPoint(point), x);
    if (std::isnan(x[2]))
    {
      return false;
    }
    box.AddPoint(x);
  }
  const double *low = box.GetMinPoint(), *high = box.GetMaxPoint();
  z = std::fabs(low[2]) > std::fabs(high[2]) ? low[2] : high[2];
  return high[2] - low[2] <= Rounding * box.GetDiagonalLength();
}
}

//------------------------------------------------------------------------------
int GetDimension(vtkDataSet* dataSet)
{
  const MeshView mesh(dataSet);
  int dimension = 0;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells() && dimension < 3; ++cell)
  {
    dimension = std::max(dimension, GetCellShape(mesh.GetCellType(cell)).Dimension);
  }
  return dimension;
}

//------------------------------------------------------------------------------
void WarnOfLostArrays(
  vtkDataSet* mesh, const char* format, Warnings& warnings, const std::vector<std::string>& more)
{
  WrittenArrays written;
  written.Fields = { "ZoneIds", "ZoneNames", "ZoneTypes", "ZoneBoundaryTypes", "ZoneType",
    FluentInteriorZones::ArrayName };
  std::vector<std::string> names = { "Zone", "BoundaryType" };
  names.insert(names.end(), more.begin(), more.end());
  for (const std::string& name : names)
  {
    vtkDataArray* const array = mesh->GetCellData()->GetArray(name.c_str());
    if (array && array->GetNumberOfComponents() == 1)
    {
      written.Cells.push_back(name);
    }
  }
  WarnOfArrays(mesh, format, warnings, written);
}

//------------------------------------------------------------------------------
bool WriteFluent(const std::string& path, vtkDataSet* mesh, UnsupportedCells others,
  Warnings& warnings, ScanError& error, const Progress& progress, FluentWrite write)
{
  OutputFile file(path);
  if (file.HasFailed())
  {
    return file.Finish(false, error);
  }
  const auto refuse = [&](const std::string& reason)
  {
    error = { ErrorKind::Unsupported, GetFileName(path) + ": " + reason };
    return false;
  };
  const int dimension = GetDimension(mesh);
  if (dimension < 2)
  {
    return refuse("expected cells of two or three dimensions, found none");
  }
  // Cells of one dimension less may be boundaries of others.
  CellConversion how{ "Fluent mesh",
    { VTK_EMPTY_CELL, VTK_LINE, VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON }, others };
  if (dimension == 3)
  {
    how.Held = { VTK_EMPTY_CELL, VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON, VTK_TETRA, VTK_PYRAMID,
      VTK_WEDGE, VTK_HEXAHEDRON, VTK_POLYHEDRON };
  }
  const vtkSmartPointer<vtkDataSet> cells = ConvertMesh(
    mesh, how, path, { "Zone", "BoundaryType" }, warnings, error, progress.Part(0, 0.2));
  if (!cells)
  {
    return false;
  }
  FluentOutput output(cells, dimension);
  std::string reason;
  if (!output.Build(warnings, reason, progress.Part(0.2, 0.5)))
  {
    return reason.empty() ? false : refuse(reason);
  }
  if (const int split = output.GetNumberOfSplitZones())
  {
    warnings.Add(CountOf(split, "zone with cells", "zones with cells") +
      " that are not consecutive, written as several sections");
  }
  if (output.GetFaces().empty())
  {
    return refuse("expected cells with faces, found none");
  }
  if (std::max(output.GetNumberOfPoints(), static_cast<vtkIdType>(output.GetFaces().size())) >
    INT32_MAX)
  {
    return refuse("more nodes or faces than Fluent can number");
  }
  double z = 0;
  if (dimension == 2 && !IsPlanar(output, z))
  {
    return refuse("expected a 2D mesh in a plane of constant z, found a curved or inclined one");
  }
  if (z != 0)
  {
    warnings.Add("the mesh is not exactly in the plane z = 0; z is not written");
  }
  WarnOfLostArrays(mesh, "Fluent mesh", warnings);
  return file.Finish(write(output, file, progress.Part(0.5, 1)), error);
}
}
