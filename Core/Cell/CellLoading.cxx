// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Loads the points and faces of a cell into CellGeometry.
#include "Base/LocalNumbers.h"
#include "Base/Vector.h"
#include "Cell/CellGeometry.h"
#include "Cell/Shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace camaron
{
namespace
{
constexpr int MaxStandardPoints = 12;
// Products of ten lengths stay in range.
constexpr double LargestUsualSize = 1e30, SmallestUsualSize = 1e-30;
}

//------------------------------------------------------------------------------
// A cell of a fixed 3D type whose points are all different.
struct CellGeometry::StandardCell
{
  CellTopology Topology;
  unsigned Shapes = 0;
};

//------------------------------------------------------------------------------
const CellGeometry::StandardCell* CellGeometry::GetStandardCells()
{
  static const std::array<StandardCell, 256> cells = []
  {
    std::array<StandardCell, 256> result;
    for (int type = 0; type < 256; ++type)
    {
      const CellShape& shape = GetCellShape(static_cast<unsigned char>(type));
      CellTopology& topology = result[type].Topology;
      topology.Clear();
      topology.NumberOfPoints = shape.NumberOfCorners;
      for (int f = 0; f < shape.NumberOfFaces; ++f)
      {
        topology.AddFace(
          shape.FacePoints + shape.FaceOffsets[f], shape.FaceOffsets[f + 1] - shape.FaceOffsets[f]);
      }
      if (shape.NumberOfFaces > 0)
      {
        topology.Finish();
        topology.FindShells();
        topology.MakeVertexFigures();
        topology.FindFacePairs();
        result[type].Shapes = Polyhedra | FindSimpleShape(topology);
      }
    }
    return result;
  }();
  return cells.data();
}

//------------------------------------------------------------------------------
const CellTopology& CellGeometry::GetTopologyOfType(unsigned char type)
{
  return GetStandardCells()[type].Topology;
}

//------------------------------------------------------------------------------
CellGeometry::CellGeometry()
  : CellShapes(&GetCellShape(0))
  , StandardCells(GetStandardCells())
  , Points(MaxStandardPoints)
{
}

//------------------------------------------------------------------------------
void CellGeometry::Load(const MeshView& mesh, vtkIdType cell, const EvaluationOptions& options)
{
  this->CellType = mesh.GetCellType(cell);
  this->Options = &options;
  this->Mesh = &mesh;
  this->CellId = cell;
  this->HasMap.reset();
  this->TrustFaceOrientation = options.TrustFaceOrientation;
  this->AngleFactor = GetAngleFactor(options.Angles);
  this->Shapes = 0;
  this->BoxScale.Length = -1;
  this->Diameter = -1;
  this->SurfaceArea = -1;
  this->KnownStatus.reset();
  this->Kernel.Clear();
  this->HasRepeatedPoint = false;
  this->DegenerateForm = false;
  this->OrientationSign = 1;
  this->LengthExponent = 0;
  this->NumberOfPoints = 0;
  const CellShape& shape = this->CellShapes[this->CellType];
  this->IsStandard = !shape.ListsFaces;
  if (shape.Dimension == 3)
  {
    this->IsStandard ? this->LoadStandard(mesh, shape, mesh.GetCellPoints(cell))
                     : this->LoadPolyhedron(mesh, cell);
  }
  else if (shape.Dimension == 2)
  {
    this->LoadPolygon(mesh, shape, mesh.GetCellPoints(cell));
    this->Shapes = Polygons |
      (this->NumberOfPoints == 3    ? Triangles
          : this->IsQuadrilateral() ? Quadrilaterals
                                    : 0u);
  }
  this->CheckCoordinates();
  if (shape.IsHigherOrder && shape.Dimension > 1)
  {
    this->DegenerateForm =
      this->NumberOfPoints < shape.NumberOfCorners && this->LoadDegenerateMap();
    this->HasRepeatedPoint = this->HasRepeatedPoint && !this->DegenerateForm;
    for (const vtkIdType node : mesh.GetCellPoints(cell))
    {
      this->Finite = this->Finite && camaron::IsFinite(mesh.GetPoint(node));
    }
  }
}

//------------------------------------------------------------------------------
// Sets Finite and HasUsualSize; for cells of usual size, only the largest coordinates are tested.
void CellGeometry::CheckCoordinates()
{
  const auto getSize = [](const Vector& v)
  { return std::abs(v.X) + std::abs(v.Y) + std::abs(v.Z); };
  const Vector* const points = this->Points.data();
  const int size = this->NumberOfPoints;
  bool isBelow = true;
  for (int i = 1; i < size; ++i)
  {
    isBelow &= getSize(points[i]) < LargestUsualSize;
  }
  this->Finite = size == 0 || camaron::IsFinite(this->Origin);
  this->HasUsualSize = isBelow && size > 1 && getSize(points[1]) > SmallestUsualSize;
  for (int i = 1; i < size && !isBelow; ++i)
  {
    this->Finite &= camaron::IsFinite(points[i]);
  }
}

//------------------------------------------------------------------------------
void CellGeometry::ChooseUnit()
{
  double largest = 0;
  for (int i = 1; i < this->NumberOfPoints; ++i)
  {
    largest = std::max(largest, GetLargestComponent(this->Points[i]));
  }
  this->LengthExponent = GetUnitExponent(largest);
  for (int i = 1; i < this->NumberOfPoints && this->LengthExponent != 0; ++i)
  {
    this->Points[i] = TimesPowerOfTwo(this->Points[i], -this->LengthExponent);
  }
}

//------------------------------------------------------------------------------
double CellGeometry::Rescale(double value, int dimension) const
{
  const double scaled = std::ldexp(value, dimension * this->LengthExponent);
  const bool isLost =
    std::isfinite(value) && (!std::isfinite(scaled) || (scaled == 0 && value != 0));
  return std::isnan(value) ? value : isLost ? Null(NullReason::Degenerate) : scaled;
}

//------------------------------------------------------------------------------
Vector CellGeometry::ToMesh(const Vector& place) const
{
  const double unit = std::ldexp(1.0, this->LengthExponent);
  return this->Origin + unit * place;
}

//------------------------------------------------------------------------------
Vector CellGeometry::ToUnit(const Vector& offset) const
{
  return TimesPowerOfTwo(offset, -this->LengthExponent);
}

//------------------------------------------------------------------------------
void CellGeometry::LoadStandard(
  const MeshView& mesh, const CellShape& shape, const IndexRange& points)
{
  const int size = shape.NumberOfCorners;
  vtkIdType ids[MaxStandardPoints];
  bool distinct = true;
  for (int i = 0; i < size; ++i)
  {
    ids[i] = points[i];
    for (int j = 0; j < i; ++j)
    {
      distinct = distinct && ids[j] != ids[i];
    }
  }
  if (!distinct)
  {
    this->LoadCollapsed(mesh, shape, points);
    return;
  }
  const Vector origin = mesh.GetPoint(ids[0]);
  Vector* to = this->Points.data(); // has room for every standard cell
  to[0] = Vector();
  for (int i = 1; i < size; ++i)
  {
    to[i] = mesh.GetPoint(ids[i]) - origin;
  }
  this->Origin = origin;
  this->NumberOfPoints = size;
  this->Nodes = points;
  this->Topology = &this->StandardCells[this->CellType].Topology;
  this->OwnTopology = nullptr;
  this->Shapes = this->StandardCells[this->CellType].Shapes;
}

//------------------------------------------------------------------------------
// A standard cell with a repeated point is reduced to the remaining faces.
void CellGeometry::LoadCollapsed(
  const MeshView& mesh, const CellShape& shape, const IndexRange& points)
{
  this->CornerIds.resize(shape.NumberOfCorners);
  for (int i = 0; i < shape.NumberOfCorners; ++i)
  {
    this->CornerIds[i] = points[i];
  }
  int locals[MaxStandardPoints];
  this->NumberPoints(mesh, this->CornerIds.data(), shape.NumberOfCorners, locals);
  std::vector<int>&offsets = this->OwnTopologies.FaceOffsets,
  &numbers = this->OwnTopologies.FacePoints;
  offsets.assign(shape.FaceOffsets, shape.FaceOffsets + shape.NumberOfFaces + 1);
  numbers.resize(offsets.back());
  for (int i = 0; i < offsets.back(); ++i)
  {
    numbers[i] = locals[shape.FacePoints[i]];
  }
  this->FindOwnTopology();
  this->Shapes = Polyhedra | FindSimpleShape(*this->Topology);
}

//------------------------------------------------------------------------------
void CellGeometry::LoadPolygon(
  const MeshView& mesh, const CellShape& shape, const IndexRange& points)
{
  const int size = static_cast<int>(shape.NumberOfCorners ? shape.NumberOfCorners
      : this->CellType == VTK_QUADRATIC_POLYGON           ? points.Size / 2
                                                          : points.Size);
  this->CornerIds.resize(size);
  for (int i = 0; i < size; ++i)
  {
    this->CornerIds[i] = points[this->CellType == VTK_PIXEL && i > 1 ? 5 - i : i];
  }
  this->OwnTopologies.FaceOffsets = { 0, size };
  this->OwnTopologies.FacePoints.resize(size);
  this->NumberPoints(mesh, this->CornerIds.data(), size, this->OwnTopologies.FacePoints.data());
  this->FindOwnTopology();
}

//------------------------------------------------------------------------------
void CellGeometry::LoadPolyhedron(const MeshView& mesh, vtkIdType cell)
{
  const IndexRange faces = mesh.GetPolyhedronFaces(cell);
  IndexRange corners; // of all faces, if they are contiguous
  bool isOneRun = true;
  this->OwnTopologies.FaceOffsets.resize(faces.Size + 1);
  int* offsets = this->OwnTopologies.FaceOffsets.data();
  offsets[0] = 0;
  for (vtkIdType f = 0; f < faces.Size; ++f)
  {
    const IndexRange points = mesh.GetPolyhedronFacePoints(faces[f]);
    corners = f == 0 ? IndexRange{ points.Values, points.Begin, 0 } : corners;
    isOneRun &= points.Begin == corners.Begin + corners.Size;
    corners.Size += points.Size;
    offsets[f + 1] = static_cast<int>(corners.Size);
  }
  const int size = offsets[faces.Size];
  if (isOneRun && corners.Values.Values32)
  {
    this->LoadCorners(mesh, corners.Values.Values32 + corners.Begin, size);
  }
  else if (isOneRun && corners.Values.Values64)
  {
    this->LoadCorners(mesh, corners.Values.Values64 + corners.Begin, size);
  }
  else
  {
    this->CornerIds.resize(size);
    vtkIdType* to = this->CornerIds.data();
    for (vtkIdType f = 0; f < faces.Size; ++f)
    {
      const IndexRange points = mesh.GetPolyhedronFacePoints(faces[f]);
      for (vtkIdType i = 0; i < points.Size; ++i)
      {
        *to++ = points[i];
      }
    }
    this->LoadCorners(mesh, this->CornerIds.data(), size);
  }
  this->Shapes = Polyhedra | FindSimpleShape(*this->Topology);
}

//------------------------------------------------------------------------------
// Loads the points of faces with known sizes, and their topology.
template <typename Id>
void CellGeometry::LoadCorners(const MeshView& mesh, const Id* ids, int size)
{
  if (RecentTopologies::Recent* const recent = this->OwnTopologies.Recognize(ids))
  {
    this->TakePoints(mesh, ids, recent->PointCorners.data(), recent->Topology.NumberOfPoints);
    this->OwnTopology = &recent->Topology;
    this->Topology = this->OwnTopology;
    return;
  }
  this->OwnTopologies.FacePoints.resize(size);
  this->NumberPoints(mesh, ids, size, this->OwnTopologies.FacePoints.data());
  this->FindOwnTopology(this->NumberOfPoints > MaxSimpleNodes);
}

//------------------------------------------------------------------------------
// Loads the distinct points of a list; @a numbers are their local numbers.
template <typename Id>
void CellGeometry::NumberPoints(const MeshView& mesh, const Id* ids, int size, int* numbers)
{
  thread_local LocalNumbers numbering; // one for all cells of a thread stays in the first-level
                                       // cache
  const int count = numbering.Number(size, [ids](int i) { return ids[i]; }, numbers);
  this->TakePoints(mesh, ids, numbering.GetFirsts(), count);
}

//------------------------------------------------------------------------------
template <typename Id>
void CellGeometry::TakePoints(const MeshView& mesh, const Id* ids, const int* corners, int count)
{
  this->NumberOfPoints = count;
  this->PointIds.resize(count);
  if (this->Points.size() < static_cast<std::size_t>(count))
  {
    this->Points.resize(2 * count);
  }
  this->Origin = count > 0 ? mesh.GetPoint(ids[corners[0]]) : this->Origin;
  for (int point = 0; point < count; ++point)
  {
    this->PointIds[point] = ids[corners[point]];
    this->Points[point] = mesh.GetPoint(this->PointIds[point]) - this->Origin;
  }
}

//------------------------------------------------------------------------------
void CellGeometry::FindOwnTopology(bool edgesCanWait)
{
  this->OwnTopology =
    &this->OwnTopologies.Find(this->NumberOfPoints, edgesCanWait, this->HasRepeatedPoint);
  this->Topology = this->OwnTopology;
}
}
