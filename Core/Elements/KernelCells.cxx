// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elements/KernelCells.h"

#include "Base/Parallel.h"
#include "Cell/CellKernel.h"
#include "Mesh/CellFacets.h"
#include "Mesh/CellWriter.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace camaron
{
namespace
{
constexpr vtkIdType Chunk = 256; // cells
constexpr vtkIdType NumberOfReports = 100;
constexpr unsigned KernelNeeds = NeedsFaces | NeedsVolume;
constexpr unsigned char NotOurs =
  vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;

/// Kernels of a range of cells, each with its own points.
struct KernelPart
{
  std::vector<vtkIdType> Sources, Without; // cells with and without a kernel
  std::vector<double> Ratios;
  std::vector<double> Points;
  std::vector<unsigned char> Types;
  std::vector<vtkIdType> PointCounts, FaceCounts; // of every kernel; a polygon has no faces
  std::vector<vtkIdType> FaceSizes, FacePoints;   // ids of a kernel's points, from 0

  void AddPoint(const Vector& point)
  {
    this->Points.insert(this->Points.end(), { point.X, point.Y, point.Z });
  }
  void AddPolygon(const std::vector<Vector>& corners, const CellGeometry& cell)
  {
    for (const Vector& corner : corners)
    {
      this->AddPoint(cell.ToMesh(corner));
    }
    this->Types.push_back(VTK_POLYGON);
    this->PointCounts.push_back(static_cast<vtkIdType>(corners.size()));
    this->FaceCounts.push_back(0);
  }
  void AddPolyhedron(const ConvexPolyhedron& polyhedron, const CellGeometry& cell)
  {
    for (const Vector& point : polyhedron.GetPoints())
    {
      this->AddPoint(cell.ToMesh(point));
    }
    for (int f = 0; f < polyhedron.GetNumberOfFaces(); ++f)
    {
      const int* face = polyhedron.GetFace(f);
      this->FaceSizes.push_back(polyhedron.GetFaceSize(f));
      this->FacePoints.insert(this->FacePoints.end(), face, face + polyhedron.GetFaceSize(f));
    }
    this->Types.push_back(VTK_POLYHEDRON);
    this->PointCounts.push_back(static_cast<vtkIdType>(polyhedron.GetPoints().size()));
    this->FaceCounts.push_back(polyhedron.GetNumberOfFaces());
  }
};

//------------------------------------------------------------------------------
void FillGrid(const std::vector<KernelPart>& parts, vtkUnstructuredGrid* grid)
{
  CellWriter writer;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> ratios;
  ratios->SetName("KernelRatio");
  vtkIdType firstPoint = 0;
  for (const KernelPart& part : parts)
  {
    for (std::size_t i = 0; i < part.Points.size(); i += 3)
    {
      points->InsertNextPoint(part.Points.data() + i);
    }
    const vtkIdType* faceSize = part.FaceSizes.data();
    const vtkIdType* facePoint = part.FacePoints.data();
    for (std::size_t cell = 0; cell < part.Types.size(); ++cell)
    {
      ratios->InsertNextValue(part.Ratios[cell]);
      for (vtkIdType i = 0; i < part.PointCounts[cell]; ++i)
      {
        writer.AddPoint(firstPoint + i);
      }
      for (vtkIdType f = 0; f < part.FaceCounts[cell]; ++f, ++faceSize)
      {
        for (vtkIdType i = 0; i < *faceSize; ++i)
        {
          writer.AddFacePoint(firstPoint + *facePoint++);
        }
        writer.EndFace();
      }
      writer.EndCell(part.Types[cell]);
      firstPoint += part.PointCounts[cell];
    }
  }
  grid->SetPoints(points);
  writer.SetCells(grid);
  grid->GetCellData()->AddArray(ratios);
}

//------------------------------------------------------------------------------
void AddKernel(const MeshView& mesh, vtkIdType id, const EvaluationOptions& options,
  CellGeometry& cell, std::vector<Vector>& corners, KernelPart& part)
{
  cell.Load(mesh, id, options);
  cell.Normalize();
  if (!(cell.GetShapes() & PolygonsAndPolyhedra))
  {
    return;
  }
  cell.Compute(KernelNeeds);
  const bool isPolygon = (cell.GetShapes() & Polygons) != 0;
  const bool isSolid = cell.IsFinite() &&
    (isPolygon ? !cell.IsZeroArea(cell.GetPolygonArea())
               : !std::isnan(cell.GetVolume()) && !cell.IsZeroVolume(cell.GetVolume()));
  CellKernel& kernel = cell.GetKernel();
  if (!isSolid || kernel.GetRadius(cell) == 0)
  {
    part.Without.push_back(id);
    return;
  }
  part.Sources.push_back(id);
  part.Ratios.push_back(kernel.GetRatio(cell));
  if (isPolygon)
  {
    kernel.MakePolygon(cell, corners);
    part.AddPolygon(corners, cell);
  }
  else
  {
    kernel.MakePolyhedron(cell, [](double) { return true; });
    part.AddPolyhedron(kernel.GetPolyhedron(), cell);
  }
}

//------------------------------------------------------------------------------
// Global ids of some cells, or their indices without global ids.
vtkSmartPointer<vtkIdTypeArray> MakeIds(
  vtkDataSet* mesh, const std::vector<vtkIdType>& cells, const char* name)
{
  vtkDataArray* globalIds = mesh->GetCellData()->GetGlobalIds();
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName(name);
  ids->SetNumberOfValues(static_cast<vtkIdType>(cells.size()));
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    ids->SetValue(static_cast<vtkIdType>(i),
      globalIds ? static_cast<vtkIdType>(globalIds->GetTuple1(cells[i])) : cells[i]);
  }
  return ids;
}

//------------------------------------------------------------------------------
bool IsOurs(vtkUnsignedCharArray* ghosts, vtkIdType cell)
{
  return !ghosts || (ghosts->GetValue(cell) & NotOurs) == 0;
}
}

//------------------------------------------------------------------------------
bool MakeKernelCells(vtkDataSet* mesh, const EvaluationOptions& options, vtkDataArray* chosen,
  const std::function<bool(double)>& goesOn, vtkUnstructuredGrid* kernels)
{
  const MeshView view(mesh);
  vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray();
  const vtkIdType numberOfCells = view.GetNumberOfCells();
  const vtkIdType numberOfParts = (numberOfCells + Chunk - 1) / Chunk;
  const vtkIdType slab = numberOfParts / NumberOfReports + 1;
  std::vector<KernelPart> parts(numberOfParts);
  for (vtkIdType first = 0; first < numberOfParts; first += slab)
  {
    if (!goesOn(static_cast<double>(first) / numberOfParts))
    {
      return false;
    }
    ParallelFor(std::min(slab, numberOfParts - first), 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        CellGeometry cell;
        std::vector<Vector> corners;
        for (vtkIdType id = (first + begin) * Chunk;
          id < std::min(numberOfCells, (first + end) * Chunk); ++id)
        {
          if (IsOurs(ghosts, id) && (!chosen || chosen->GetComponent(id, 0) != 0))
          {
            AddKernel(view, id, options, cell, corners, parts[id / Chunk]);
          }
        }
      });
  }

  FillGrid(parts, kernels);
  std::vector<vtkIdType> sources, without;
  for (const KernelPart& part : parts)
  {
    sources.insert(sources.end(), part.Sources.begin(), part.Sources.end());
    without.insert(without.end(), part.Without.begin(), part.Without.end());
  }
  vtkCellData* data = kernels->GetCellData();
  const vtkSmartPointer<vtkDataArray> ratios = data->GetArray("KernelRatio");
  data->Initialize();
  data->CopyGlobalIdsOff();
  data->CopyFieldOff(vtkDataSetAttributes::GhostArrayName());
  data->CopyAllocate(mesh->GetCellData(), static_cast<vtkIdType>(sources.size()));
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(static_cast<vtkIdType>(sources.size()));
  std::copy(sources.begin(), sources.end(), ids->begin());
  data->CopyData(mesh->GetCellData(), ids, vtkIdType(0));
  data->AddArray(MakeIds(mesh, sources, "SourceCell"));
  data->AddArray(ratios);
  kernels->GetFieldData()->PassData(mesh->GetFieldData());
  kernels->GetFieldData()->AddArray(MakeIds(mesh, without, "CellsWithoutKernel"));
  return true;
}

//------------------------------------------------------------------------------
SurfacePolygons TakePolygons(vtkDataSet* mesh)
{
  const MeshView view(mesh);
  vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray();
  const CellFacets facets(view);
  std::vector<vtkIdType> points;
  SurfacePolygons polygons;
  for (vtkIdType cell = 0; cell < view.GetNumberOfCells(); ++cell)
  {
    if (facets.GetDimension(cell) != 2 || !IsOurs(ghosts, cell))
    {
      continue;
    }
    facets.GetPolygon(cell, points);
    polygons.Sizes.push_back(static_cast<vtkIdType>(points.size()));
    for (const vtkIdType point : points)
    {
      const Vector x = view.GetPoint(point);
      polygons.Corners.insert(polygons.Corners.end(), { x.X, x.Y, x.Z });
    }
  }
  return polygons;
}

namespace
{
//------------------------------------------------------------------------------
// One polyhedron with the polygons as faces. Points and faces are sorted, and faces start at their
// first point, so the result is bitwise independent of the order of the polygons.
vtkSmartPointer<vtkUnstructuredGrid> MakePolyhedron(const SurfacePolygons& polygons)
{
  using Place = std::array<double, 3>;
  const std::size_t numberOfCorners = polygons.Corners.size() / 3;
  std::vector<Place> corners(numberOfCorners);
  for (std::size_t i = 0; i < numberOfCorners; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      corners[i][k] = polygons.Corners[3 * i + k] + 0.0; // no negative zeros
    }
  }
  std::vector<Place> places(corners);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());

  std::vector<std::vector<vtkIdType>> faces;
  std::size_t corner = 0;
  for (const vtkIdType size : polygons.Sizes)
  {
    std::vector<vtkIdType> face;
    for (vtkIdType i = 0; i < size; ++i, ++corner)
    {
      face.push_back(
        std::lower_bound(places.begin(), places.end(), corners[corner]) - places.begin());
    }
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end());

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  CellWriter writer;
  for (const Place& place : places)
  {
    writer.AddPoint(points->InsertNextPoint(place.data()));
  }
  for (const auto& face : faces)
  {
    for (const vtkIdType point : face)
    {
      writer.AddFacePoint(point);
    }
    writer.EndFace();
  }
  writer.EndCell(VTK_POLYHEDRON);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  writer.SetCells(grid);
  return grid;
}
}

//------------------------------------------------------------------------------
SurfaceKernel MakeSurfaceKernel(const SurfacePolygons& polygons, const EvaluationOptions& options,
  const std::function<bool(double)>& goesOn, vtkUnstructuredGrid* kernel)
{
  if (!std::all_of(polygons.Corners.begin(), polygons.Corners.end(),
        [](double x) { return std::isfinite(x); }))
  {
    return SurfaceKernel::NotFinite;
  }
  const vtkSmartPointer<vtkUnstructuredGrid> grid = MakePolyhedron(polygons);
  CellGeometry cell;
  cell.Load(MeshView(grid), 0, options);
  cell.Normalize();
  cell.Compute(KernelNeeds);
  if (std::isnan(cell.GetVolume()) || cell.IsZeroVolume(cell.GetVolume()))
  {
    return SurfaceKernel::NotClosed;
  }
  if (!cell.GetKernel().MakePolyhedron(cell, goesOn))
  {
    return SurfaceKernel::Stopped;
  }
  const ConvexPolyhedron& polyhedron = cell.GetKernel().GetPolyhedron();
  if (polyhedron.IsEmpty())
  {
    return SurfaceKernel::Empty;
  }
  std::vector<KernelPart> parts(1);
  parts[0].AddPolyhedron(polyhedron, cell);
  parts[0].Ratios.push_back(std::min(1.0, polyhedron.GetVolume() / std::abs(cell.GetVolume())));
  FillGrid(parts, kernel);
  return SurfaceKernel::Found;
}
}
