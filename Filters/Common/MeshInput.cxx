// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshInput.h"

#include "Mesh/GhostArrays.h"
#include "Mesh/MeshCheck.h"
#include "Mesh/MeshView.h"
#include "Mesh/PointSetHulls.h"
#include "Ranks/Collective.h"

#include "Scan/MappedFile.h"
#include "vtkAppendFilter.h"
#include "vtkCamaronCompat.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool HasCellsOfType(vtkUnstructuredGrid* grid, unsigned char type)
{
  const MeshView mesh(grid);
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    if (mesh.GetCellType(cell) == type)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// Calls visit(points) for every triangle of a strip, all with the orientation of the strip.
template <typename Visitor>
void ForEachTriangle(vtkIdList* strip, Visitor&& visit)
{
  for (vtkIdType i = 0; i + 2 < strip->GetNumberOfIds(); ++i)
  {
    const vtkIdType odd = i % 2;
    const vtkIdType triangle[3] = { strip->GetId(i), strip->GetId(i + 1 + odd),
      strip->GetId(i + 2 - odd) };
    visit(triangle);
  }
}

//------------------------------------------------------------------------------
// The triangles of a strip also share its global id.
void CopyCellData(vtkDataSet* from, vtkIdList* sources, vtkDataSet* to)
{
  to->GetCellData()->CopyGlobalIdsOn();
  to->GetCellData()->CopyAllocate(from->GetCellData(), sources->GetNumberOfIds());
  to->GetCellData()->CopyData(from->GetCellData(), sources, vtkIdType(0));
}

//------------------------------------------------------------------------------
// A grid in which the triangles of a strip replace it.
vtkSmartPointer<vtkUnstructuredGrid> SplitStrips(vtkUnstructuredGrid* grid)
{
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->SetPoints(grid->GetPoints());
  result->GetPointData()->ShallowCopy(grid->GetPointData());
  result->GetFieldData()->ShallowCopy(grid->GetFieldData());
  vtkNew<vtkIdList> sources, points;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = grid->GetCellType(cell);
    grid->GetCellPoints(cell, points);
    if (type == VTK_TRIANGLE_STRIP)
    {
      ForEachTriangle(points,
        [&](const vtkIdType* triangle)
        {
          result->InsertNextCell(VTK_TRIANGLE, 3, triangle);
          sources->InsertNextId(cell);
        });
      continue;
    }
    if (type == VTK_POLYHEDRON)
    {
      grid->GetFaceStream(cell, points); // the format that InsertNextCell expects
    }
    result->InsertNextCell(type, points);
    sources->InsertNextId(cell);
  }
  CopyCellData(grid, sources, result);
  return result;
}

constexpr unsigned char NoPart =
  vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;

//------------------------------------------------------------------------------
bool HasHidden(vtkDataSet* data)
{
  vtkUnsignedCharArray* const ghosts = data->GetCellGhostArray();
  const unsigned char* const flags = ghosts ? ghosts->GetPointer(0) : nullptr;
  const vtkIdType size = ghosts ? ghosts->GetNumberOfValues() : 0;
  return std::any_of(flags, flags + size, [](unsigned char flag) { return flag & NoPart; });
}

//------------------------------------------------------------------------------
// Hidden and refined cells are not part of a mesh, as in VTK's structured grids.
vtkSmartPointer<vtkUnstructuredGrid> WithoutHidden(vtkUnstructuredGrid* grid)
{
  if (!HasHidden(grid))
  {
    return grid;
  }
  vtkUnsignedCharArray* const ghosts = grid->GetCellGhostArray();
  vtkNew<vtkUnsignedCharArray> types;
  types->DeepCopy(GetCellTypes(grid));
  for (vtkIdType cell = 0; cell < ghosts->GetNumberOfValues(); ++cell)
  {
    if (ghosts->GetValue(cell) & NoPart)
    {
      types->SetValue(cell, VTK_EMPTY_CELL);
    }
  }
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->ShallowCopy(grid);
  result->SetPolyhedralCells(
    types, grid->GetCells(), grid->GetPolyhedronFaceLocations(), grid->GetPolyhedronFaces());
  return result;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> AsMesh(vtkDataSet* data)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return WithHulls(WithoutHidden(grid), VTK_CONVEX_POINT_SET);
  }
  if (vtkPolyData::SafeDownCast(data) && !HasHidden(data))
  {
    return data;
  }
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(data);
  if (!vtkPointSet::SafeDownCast(data))
  {
    append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION); // coordinates are computed
  }
  append->Update();
  vtkUnstructuredGrid* const grid = append->GetOutput();
  grid->GetPointData()->ShallowCopy(data->GetPointData()); // including global ids
  grid->GetCellData()->ShallowCopy(data->GetCellData());
  return WithoutHidden(grid);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> WithoutStrips(vtkDataSet* data)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    if (HasCellsOfType(grid, VTK_TRIANGLE_STRIP))
    {
      return SplitStrips(grid);
    }
    return data;
  }
  auto* surface = vtkPolyData::SafeDownCast(data);
  if (!surface || surface->GetNumberOfStrips() == 0)
  {
    return data;
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(surface->GetPoints());
  result->SetVerts(surface->GetVerts());
  result->SetLines(surface->GetLines());
  vtkNew<vtkCellArray> polygons;
  if (surface->GetPolys())
  {
    polygons->DeepCopy(surface->GetPolys());
  }
  const vtkIdType firstStrip = surface->GetNumberOfCells() - surface->GetNumberOfStrips();
  vtkNew<vtkIdList> sources;
  for (vtkIdType cell = 0; cell < firstStrip; ++cell)
  {
    sources->InsertNextId(cell);
  }
  vtkNew<vtkIdList> strip;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfStrips(); ++cell)
  {
    surface->GetStrips()->GetCellAtId(cell, strip);
    ForEachTriangle(strip,
      [&](const vtkIdType* triangle)
      {
        polygons->InsertNextCell(3, triangle);
        sources->InsertNextId(firstStrip + cell);
      });
  }
  result->SetPolys(polygons);
  result->GetPointData()->ShallowCopy(surface->GetPointData());
  result->GetFieldData()->ShallowCopy(surface->GetFieldData());
  CopyCellData(surface, sources, result);
  return result;
}

//------------------------------------------------------------------------------
void CheckLeaf(const DataSetLeaf& leaf)
{
  try
  {
    CheckGhosts(leaf.Data);
    CheckCells(leaf.Data);
  }
  catch (const std::runtime_error& error)
  {
    throw std::runtime_error((leaf.Name.empty() ? "" : leaf.Name + ": ") + error.what());
  }
}

//------------------------------------------------------------------------------
std::vector<DataSetLeaf> GetMeshes(vtkDataObject* input, Reducer& reducer)
{
  std::vector<DataSetLeaf> leaves = GetLeaves(input);
  RunCollectively(reducer,
    [&]
    {
      for (const DataSetLeaf& leaf : leaves)
      {
        CheckLeaf(leaf);
      }
    });
  return leaves;
}

//------------------------------------------------------------------------------
void CheckFaces(const std::vector<DataSetLeaf>& leaves, Reducer& reducer)
{
  PolyhedronFaces faces;
  for (const DataSetLeaf& leaf : leaves)
  {
    faces.Add(leaf.Data);
  }
  reducer.Sum(&faces.NumberWithFaces, 1);
  reducer.Sum(&faces.NumberOfPolyhedra, 1);
  faces.Check();
}

namespace
{
constexpr std::size_t MaxFileSize = 1 << 20; // larger files are not what the user meant

//------------------------------------------------------------------------------
std::vector<char> ReadHere(const std::string& path, const std::string& what)
{
  std::error_code failure; // ignored: opening the file reports it
  if (std::filesystem::is_other(std::filesystem::status(path, failure)))
  {
    throw std::runtime_error(
      GetFileName(path) + ": expected " + what + ", found a pipe or a device");
  }
  MappedFile file;
  ScanError error;
  if (!file.Open(path, error))
  {
    throw std::runtime_error(error.Message);
  }
  if (file.size() > MaxFileSize)
  {
    throw std::runtime_error(file.GetName() + ": the file is too large for " + what);
  }
  return { file.begin(), file.end() };
}
}

//------------------------------------------------------------------------------
std::string ReadSmallFile(const std::string& path, const std::string& what, Reducer& reducer)
{
  std::vector<char> bytes;
  RunCollectively(reducer,
    [&] { bytes = reducer.GetProcess() == 0 ? ReadHere(path, what) : std::vector<char>(); });
  std::vector<std::size_t> sizes;
  bytes = reducer.Gather(bytes, sizes);
  return { bytes.begin(), bytes.end() };
}
}
