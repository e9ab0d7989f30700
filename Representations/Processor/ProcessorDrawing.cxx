// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ProcessorDrawing.h"

#include "InspectionArrays.h"

#include "Drawing/CollapsedCells.h"
#include "Drawing/SubdividedFacets.h"
#include "Mesh/CellShape.h"
#include "Mesh/MeshView.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkClipPolyData.h"
#include "vtkContourFilter.h"
#include "vtkCutter.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkExtractCells.h"
#include "vtkExtractEdges.h"
#include "vtkGeometryFilter.h"
#include "vtkHardwareSelector.h"
#include "vtkIdList.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlanes.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRecoverGeometryWireframe.h"
#include "vtkRenderer.h"
#include "vtkShrinkFilter.h"
#include "vtkSphere.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridGeometryFilter.h"
#include "vtkVertexGlyphFilter.h"

#include <algorithm>
#include <tuple>

namespace camaron
{
//------------------------------------------------------------------------------
bool IsCellInShape(const MeshView& mesh, vtkIdType cell, CutBy how, const ConvexShape& shape)
{
  const IndexRange points = mesh.GetCellPoints(cell);
  double centroid[3] = { 0, 0, 0 };
  vtkIdType inside = 0;
  for (vtkIdType i = 0; i < points.Size; ++i)
  {
    double x[3];
    mesh.GetPoint(points[i], x);
    for (int k = 0; k < 3; ++k)
    {
      centroid[k] += x[k] / static_cast<double>(points.Size);
    }
    inside += shape.Contains(x);
  }
  return how == CutBy::AnyVertex ? inside > 0
    : how == CutBy::AllVertices  ? inside == points.Size && inside > 0
                                 : shape.Contains(centroid);
}

namespace
{
constexpr const char* FaceIdsName = "InspectionFaceIds";

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

//------------------------------------------------------------------------------
// The function is negative inside.
vtkSmartPointer<vtkImplicitFunction> MakeFunction(const ConvexShape& shape)
{
  if (shape.Planes.empty())
  {
    auto sphere = vtkSmartPointer<vtkSphere>::New();
    sphere->SetRadius(1);
    vtkNew<vtkTransform> toUnitSphere;
    toUnitSphere->SetMatrix(shape.ToUnitSphere.data());
    sphere->SetTransform(toUnitSphere);
    return sphere;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (const std::array<double, 4>& plane : shape.Planes)
  {
    normals->InsertNextTuple(plane.data());
    points->InsertNextPoint(-plane[3] * plane[0], -plane[3] * plane[1], -plane[3] * plane[2]);
  }
  auto planes = vtkSmartPointer<vtkPlanes>::New();
  planes->SetPoints(points);
  planes->SetNormals(normals);
  return planes;
}

//------------------------------------------------------------------------------
// The cells that KeepCells.vs.glsl keeps. Ghost cells remain: faces next to them are not outer
// faces.
Grid KeepCells(vtkUnstructuredGrid* grid, const InspectionStyle& style)
{
  const MeshView mesh(grid);
  vtkUnsignedCharArray* ghosts = grid->GetCellGhostArray();
  vtkDataArray* selected = grid->GetCellData()->GetArray(SelectedArrayName);
  std::vector<vtkIdType> kept;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    const bool isHidden = ghosts && ghosts->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL;
    const bool isSelected = selected && selected->GetComponent(cell, 0) != 0;
    // Lines and vertices are drawn as LinesAndVertices does, unless these are points only.
    const bool isElsewhere =
      GetCellShape(mesh.GetCellType(cell)).Dimension < 2 && (style.Faces || style.Edges);
    if (!isHidden && !isElsewhere &&
      (style.CellsToDraw == DrawnCells::All ||
        isSelected == (style.CellsToDraw == DrawnCells::Selected)) &&
      (!style.CutsCells() || IsCellInShape(mesh, cell, style.Cut, style.Shape) == style.KeepInside))
    {
      kept.push_back(cell);
    }
  }
  if (kept.size() == static_cast<std::size_t>(mesh.GetNumberOfCells()))
  {
    return grid;
  }
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(grid);
  extract->SetCellIds(kept.data(), static_cast<vtkIdType>(kept.size()));
  extract->AssumeSortedAndUniqueIdsOn();
  extract->Update();
  return extract->GetOutput();
}

//------------------------------------------------------------------------------
// A copy with arrays of ids, which the filters pass on.
Grid WithIds(vtkUnstructuredGrid* grid)
{
  Grid copy = Grid::New();
  copy->ShallowCopy(grid);
  AddIds(copy->GetCellData(), CellIdsName, grid->GetNumberOfCells());
  AddIds(copy->GetPointData(), PointIdsName, grid->GetNumberOfPoints());
  return copy;
}

//------------------------------------------------------------------------------
// A cell as VTK's filters are to draw it: what remains of a cell that lists corners more than once,
// and Lagrange pyramids, which they cannot divide, by their vertices. False for all others.
bool Convert(const MeshView& mesh, CollapsedCells& collapsed, vtkIdType cell, int& type,
  std::vector<vtkIdType>& points)
{
  const IndexRange nodes = mesh.GetCellPoints(cell);
  points.clear();
  type = mesh.GetCellType(cell);
  if (type == VTK_LAGRANGE_PYRAMID || type == VTK_BEZIER_PYRAMID)
  {
    constexpr vtkIdType Corners = 5;
    type = VTK_PYRAMID;
    for (vtkIdType i = 0; i < std::min(nodes.Size, Corners); ++i)
    {
      points.push_back(nodes[i]);
    }
    return true;
  }
  const CollapsedShape* const shape = collapsed.Find(cell);
  if (!shape)
  {
    return false;
  }
  type = shape->GetType();
  for (const ParametricShape::Row& row : shape->GetNodes())
  {
    points.push_back(nodes[row.Places[0]]);
    if (row.Places.size() != 1)
    {
      return false; // it would need a new point
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// The grid with such cells.
Grid ConvertCells(vtkUnstructuredGrid* grid)
{
  if (!HasHigherOrderCells(grid))
  {
    return grid;
  }
  const MeshView mesh(grid);
  CollapsedCells collapsed(mesh);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> types;
  std::vector<vtkIdType> points;
  bool isConverted = false;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    int type = 0;
    if (Convert(mesh, collapsed, cell, type, points))
    {
      isConverted = true;
      cells->InsertNextCell(static_cast<vtkIdType>(points.size()), points.data());
      types->InsertNextValue(static_cast<unsigned char>(type));
      continue;
    }
    vtkNew<vtkIdList> ids;
    grid->GetCellPoints(cell, ids);
    cells->InsertNextCell(ids);
    types->InsertNextValue(mesh.GetCellType(cell));
  }
  if (!isConverted)
  {
    return grid;
  }
  Grid converted = Grid::New();
  converted->ShallowCopy(grid);
  converted->SetPolyhedralCells(
    types, cells, grid->GetPolyhedronFaceLocations(), grid->GetPolyhedronFaces());
  return converted;
}

//------------------------------------------------------------------------------
template <typename Filter>
vtkSmartPointer<vtkPolyData> Run(Filter* filter, vtkDataObject* data)
{
  filter->SetInputData(data);
  filter->Update();
  return filter->GetOutput();
}

//------------------------------------------------------------------------------
bool ArePointsPicked(vtkRenderer* renderer)
{
  vtkHardwareSelector* const selector = renderer->GetSelector();
  return selector && selector->GetFieldAssociation() == vtkDataObject::FIELD_ASSOCIATION_POINTS;
}

//------------------------------------------------------------------------------
// The outer faces as 2D cells of higher order, with their numbers.
Grid MakeCurvedFaces(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkUnstructuredGridGeometryFilter> filter;
  filter->MergingOff();
  filter->SetInputData(grid);
  filter->Update();
  const Grid faces = Grid::New();
  faces->ShallowCopy(filter->GetOutput());
  AddIds(faces->GetCellData(), FaceIdsName, faces->GetNumberOfCells());
  return faces;
}

//------------------------------------------------------------------------------
// The ids of points of curved faces, which the filter loses; -1 for new points.
void FindPointIds(vtkPolyData* surface, vtkUnstructuredGrid* faces, const char* nameOfOrigins)
{
  vtkDataArray* const origins = surface->GetPointData()->GetArray(nameOfOrigins);
  vtkDataArray* const known = faces->GetPointData()->GetArray(PointIdsName);
  if (!origins || !known) // as after an exact cut, which loses them
  {
    return;
  }
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(PointIdsName);
  ids->SetNumberOfValues(surface->GetNumberOfPoints());
  for (vtkIdType point = 0; point < surface->GetNumberOfPoints(); ++point)
  {
    const auto origin = static_cast<vtkIdType>(origins->GetComponent(point, 0));
    ids->SetValue(point, origin < 0 ? -1 : static_cast<vtkIdType>(known->GetComponent(origin, 0)));
  }
  surface->GetPointData()->AddArray(ids);
}

//------------------------------------------------------------------------------
// Marks the edges between polygons of different faces or cells; those between their parts are not
// drawn.
vtkSmartPointer<vtkPolyData> MarkEdges(vtkPolyData* surface, const char* nameOfIds)
{
  vtkNew<vtkRecoverGeometryWireframe> flags;
  flags->SetCellIdsAttribute(nameOfIds);
  return Run(flags.Get(), surface);
}

//------------------------------------------------------------------------------
// The part of the surface that an exact cut keeps, and the section of the cells. Points have no
// ids.
vtkSmartPointer<vtkPolyData> CutExactly(
  vtkPolyData* surface, vtkUnstructuredGrid* cells, const InspectionStyle& style)
{
  const vtkSmartPointer<vtkImplicitFunction> function = MakeFunction(style.Shape);
  vtkNew<vtkClipPolyData> clip;
  clip->SetClipFunction(function);
  clip->SetInsideOut(style.KeepInside);
  vtkNew<vtkCutter> cut;
  cut->SetCutFunction(function);
  cut->GenerateTrianglesOff();
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(MarkEdges(Run(clip.Get(), surface), FaceIdsName));
  append->AddInputData(MarkEdges(Run(cut.Get(), cells), CellIdsName));
  append->Update();
  const vtkSmartPointer<vtkPolyData> kept = append->GetOutput();
  kept->GetPointData()->RemoveArray(PointIdsName);
  return kept;
}

//------------------------------------------------------------------------------
// The marked edges as lines.
vtkSmartPointer<vtkPolyData> ExtractMarkedEdges(vtkPolyData* surface)
{
  auto edges = vtkSmartPointer<vtkPolyData>::New();
  vtkUnsignedCharArray* const marks = vtkUnsignedCharArray::SafeDownCast(
    surface->GetPointData()->GetAttribute(vtkDataSetAttributes::EDGEFLAG));
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; marks && cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, points);
    const vtkIdType size = points->GetNumberOfIds();
    for (vtkIdType i = 0; i < size; ++i)
    {
      const vtkIdType line[] = { points->GetId(i), points->GetId((i + 1) % size) };
      if (marks->GetValue(line[0]) != 0)
      {
        lines->InsertNextCell(2, line);
      }
    }
  }
  edges->SetPoints(surface->GetPoints());
  edges->SetLines(lines);
  return edges;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeFaces(Grid grid, const InspectionStyle& style)
{
  if (style.ShrinkFactor != 1)
  {
    vtkNew<vtkShrinkFilter> shrink;
    shrink->SetInputData(grid);
    shrink->SetShrinkFactor(style.ShrinkFactor);
    shrink->Update();
    grid = shrink->GetOutput();
  }
  const bool isCut = style.CutsExactly();
  const bool isCurved = style.SubdivisionLevel > 0 && HasHigherOrderCells(grid);
  const Grid cells = grid;
  grid = isCurved ? MakeCurvedFaces(grid) : grid;
  vtkNew<vtkExtractEdges> edges;
  if (isCurved && !isCut && style.DrawsEdgesAlone())
  {
    return Run(edges.Get(), grid);
  }
  vtkNew<vtkGeometryFilter> geometry;
  geometry->SetNonlinearSubdivisionLevel(style.SubdivisionLevel);
  geometry->SetPassThroughPointIds(isCurved);
  vtkSmartPointer<vtkPolyData> surface = Run(geometry.Get(), grid);
  if (isCut)
  {
    if (!isCurved)
    {
      AddIds(surface->GetCellData(), FaceIdsName, surface->GetNumberOfCells());
    }
    surface = CutExactly(surface, cells, style);
    if (style.DrawsEdgesAlone())
    {
      return ExtractMarkedEdges(surface);
    }
  }
  else if (isCurved)
  {
    FindPointIds(surface, grid, geometry->GetOriginalPointIdsName());
  }
  if (isCurved && !isCut && style.Edges)
  {
    return MarkEdges(surface, FaceIdsName);
  }
  if (style.Faces)
  {
    return surface;
  }
  if (style.Edges)
  {
    return Run(edges.Get(), surface);
  }
  vtkNew<vtkVertexGlyphFilter> points;
  return style.Points ? Run(points.Get(), surface) : vtkSmartPointer<vtkPolyData>::New();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeIsosurfaces(
  vtkUnstructuredGrid* grid, const InspectionStyle& style)
{
  if (!grid->GetPointData()->HasArray(style.IsosurfaceArray.c_str()))
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  vtkNew<vtkContourFilter> contour;
  contour->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, style.IsosurfaceArray.c_str());
  contour->ComputeNormalsOff(); // faces are flat
  contour->SetNumberOfContours(static_cast<int>(style.IsosurfaceValues.size()));
  for (std::size_t i = 0; i < style.IsosurfaceValues.size(); ++i)
  {
    contour->SetValue(static_cast<int>(i), style.IsosurfaceValues[i]);
  }
  return Run(contour.Get(), grid);
}
}

//------------------------------------------------------------------------------
bool ProcessorDrawing::Request::operator==(const Request& other) const
{
  const auto key = [](const Request& request)
  {
    const InspectionStyle& style = request.Style;
    return std::tie(request.Grid, request.Time, style.What, style.Faces, style.Edges, style.Points,
      style.Glass, style.CellsToDraw, style.ShrinkFactor, style.Cut, style.KeepInside, style.Shape,
      style.IsosurfaceArray, style.IsosurfaceValues, style.SubdivisionLevel);
  };
  return key(*this) == key(other);
}

//------------------------------------------------------------------------------
vtkPolyData* ProcessorDrawing::GetSurface(vtkUnstructuredGrid* grid, const InspectionStyle& style)
{
  const Request request{ grid, grid ? grid->GetMTime() : 0, style };
  if (this->Surface && request == this->Last)
  {
    return this->Surface;
  }
  this->Last = request;
  this->Surface = vtkSmartPointer<vtkPolyData>::New();
  if (grid && grid->GetNumberOfCells() > 0 && !style.Glass)
  {
    const Grid withIds = WithIds(ConvertCells(grid));
    if (style.What == Figure::Faces)
    {
      this->Surface = MakeFaces(KeepCells(withIds, style), style);
    }
    else if (style.What == Figure::Isosurfaces)
    {
      this->Surface = MakeIsosurfaces(withIds, style);
    }
  }
  return this->Surface;
}

//------------------------------------------------------------------------------
void ProcessorDrawing::Draw(vtkRenderer* renderer, vtkActor* actor, vtkMapper* coloring,
  vtkUnstructuredGrid* grid, const InspectionStyle& given)
{
  InspectionStyle style = given;
  if (ArePointsPicked(renderer))
  {
    style.SubdivisionLevel = std::min(style.SubdivisionLevel, 1); // whose points are all nodes
  }
  vtkPolyData* surface = this->GetSurface(grid, style);
  if (surface->GetNumberOfCells() == 0)
  {
    return;
  }
  this->Mapper->vtkMapper::ShallowCopy(coloring);
  this->Mapper->SetInputData(surface);
  this->Mapper->SetCellIdArrayName(CellIdsName);
  this->Mapper->SetPointIdArrayName(PointIdsName);
  this->Mapper->SetProcessIdArrayName(ProcessIdsName);
  this->Mapper->SetCompositeIdArrayName(BlockIdsName);

  vtkProperty* property = this->Actor->GetProperty();
  const bool areEdges = style.DrawsEdgesAlone();
  if (this->PropertyTime != actor->GetProperty()->GetMTime() || areEdges != this->AreEdges)
  {
    this->PropertyTime = actor->GetProperty()->GetMTime();
    this->AreEdges = areEdges;
    property->DeepCopy(actor->GetProperty());
    if (areEdges)
    {
      property->SetColor(property->GetEdgeColor());
      property->LightingOff();
    }
  }
  this->Mapper->SetScalarVisibility(this->Mapper->GetScalarVisibility() && !areEdges);
  property->SetEdgeVisibility(style.Faces && style.Edges);
  this->Actor->SetUserMatrix(actor->GetMatrix());
  this->Actor->SetPropertyKeys(actor->GetPropertyKeys());
  if (this->Actor->GetMTime() < actor->GetMTime())
  {
    this->Actor->Modified(); // it does not notice that its matrix has changed
  }
  this->Mapper->RenderPiece(renderer, this->Actor);
}
}
