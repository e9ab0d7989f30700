// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include "Base/Vector.h"
#include "Geometry/PolygonTriangulator.h"
#include "Mesh/CellFacets.h"
#include "MeshInput.h"
#include "PropertyValues.h"
#include "Ranks/Collective.h"
#include "Scan/MappedFile.h"
#include "Selection/SelectBySolid.h"
#include "Selection/Solids.h"
#include "Strategies/ShapeText.h"

#include "vtkBox.h"
#include "vtkCylinder.h"
#include "vtkImplicitFunction.h"
#include "vtkLinearTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkSphere.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>

namespace camaron
{
namespace
{
constexpr double RelativeTolerance = 1e-12; // of the diagonal of the mesh
constexpr std::size_t NumbersPerPlane = 6;  // a point and a normal

//------------------------------------------------------------------------------
struct PlacementName
{
  const char* Name;
  Placement Value;
};
const PlacementName PlacementNames[] = {
  { "Any vertex inside", Placement::AnyVertexInside },
  { "All vertices inside", Placement::AllVerticesInside },
  { "Centroid inside", Placement::CentroidInside },
  { "Intersects", Placement::Intersects },
  { "Cut by boundary", Placement::CutByBoundary },
};

Placement FindPlacement(const std::string& name)
{
  for (const PlacementName& known : PlacementNames)
  {
    if (name == known.Name)
    {
      return known.Value;
    }
  }
  throw std::invalid_argument("there is no placement named '" + name + "'");
}

//------------------------------------------------------------------------------
Vector GetVector(const double x[3])
{
  return { x[0], x[1], x[2] };
}

//------------------------------------------------------------------------------
// The half-space Normal * x <= Offset.
struct Side
{
  Vector Normal; // of any length except 0
  double Offset;
};

HalfSpace MakeHalfSpace(const Side& side)
{
  // Scaled first: squares of very long or short normals would overflow or underflow.
  const Vector& n = side.Normal;
  const double largest = std::max({ std::abs(n.X), std::abs(n.Y), std::abs(n.Z) });
  const Vector scaled = { n.X / largest, n.Y / largest, n.Z / largest };
  const double length = Norm(scaled);
  if (!std::isfinite(length) || !std::isfinite(side.Offset))
  {
    throw std::invalid_argument("a plane has a zero normal, or a coordinate that is not finite");
  }
  return { (1 / length) * scaled, side.Offset / largest / length };
}

//------------------------------------------------------------------------------
// The half-space whose plane contains a point.
HalfSpace MakeHalfSpace(const Vector& origin, const Vector& normal)
{
  const HalfSpace atOrigin = MakeHalfSpace(Side{ normal, 0 });
  return MakeHalfSpace(Side{ atOrigin.Normal, Dot(origin, atOrigin.Normal) });
}

//------------------------------------------------------------------------------
double GetRadius(double radius)
{
  CheckNumber("Radius", radius, 0.0);
  return radius;
}

//------------------------------------------------------------------------------
// The bounds of the points of all processes. Throws if squares of lengths could overflow or
// underflow.
Bounds FindBounds(const SelectionTask& task)
{
  const DistributedMesh& pieces = task.GetPieces(); // collective, so also without blocks
  Bounds own;
  for (std::size_t piece = 0; piece < task.Blocks.Get().size(); ++piece)
  {
    const MeshView mesh(pieces.GetMesh(piece));
    for (vtkIdType point = 0; point < mesh.GetNumberOfPoints(); ++point)
    {
      const Vector x = mesh.GetPoint(point);
      if (IsFinite(x))
      {
        own.Add(x);
      }
    }
  }
  Bounds all;
  for (const Bounds& bounds : task.Reducer.GatherItems(std::vector<Bounds>{ own }))
  {
    if (!bounds.IsEmpty())
    {
      all.Add(bounds);
    }
  }
  const double largest = std::max(GetLargestComponent(all.Low), GetLargestComponent(all.High));
  if (!all.IsEmpty() && largest > 0)
  {
    CheckNumber("The largest coordinate of the mesh", largest, 1e-30, 1e30);
  }
  return all;
}

//------------------------------------------------------------------------------
template <typename Solid>
std::string MarkInside(const SelectionTask& task, const Solid& solid, SelectionMarks& marks)
{
  const Placement placement = FindPlacement(task.Parameters.Placement);
  for (std::size_t piece = 0; piece < marks.size(); ++piece)
  {
    const MeshView mesh(task.GetPieces().GetMesh(piece));
    if (task.HasCells())
    {
      MarkCells(mesh, solid, placement, marks[piece]);
    }
    else
    {
      marks[piece] = FindPointsInside(mesh, solid);
    }
  }
  if (task.Parameters.InsideOut)
  {
    MarkElements(marks, [&](std::size_t b, vtkIdType i) { return !marks[b][i]; });
  }
  return "";
}

//------------------------------------------------------------------------------
// The transform from world coordinates to those of the shape.
vtkNew<vtkMatrix4x4> GetMatrix(vtkImplicitFunction* shape)
{
  vtkNew<vtkMatrix4x4> matrix;
  if (vtkAbstractTransform* transform = shape->GetTransform())
  {
    auto* linear = vtkLinearTransform::SafeDownCast(transform);
    if (!linear)
    {
      throw std::invalid_argument("the transform of the Shape must be linear");
    }
    matrix->DeepCopy(linear->GetMatrix());
  }
  return matrix;
}

//------------------------------------------------------------------------------
std::vector<HalfSpace> GetSides(vtkBox* box)
{
  const vtkNew<vtkMatrix4x4> matrix = GetMatrix(box);
  double bounds[6];
  box->GetBounds(bounds);
  std::vector<HalfSpace> sides;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector row = { matrix->GetElement(axis, 0), matrix->GetElement(axis, 1),
      matrix->GetElement(axis, 2) };
    const double shift = matrix->GetElement(axis, 3);
    sides.push_back(MakeHalfSpace(Side{ -row, shift - bounds[2 * axis] }));
    sides.push_back(MakeHalfSpace(Side{ row, bounds[2 * axis + 1] - shift }));
  }
  return sides;
}

//------------------------------------------------------------------------------
using Solid = std::variant<BallSolid, CylinderSolid, HalfSpaceSolid>;

Solid MakeSolid(vtkImplicitFunction* shape, const Bounds& bounds)
{
  const double tolerance = RelativeTolerance * bounds.GetDiagonal();
  if (auto* sphere = vtkSphere::SafeDownCast(shape))
  {
    return BallSolid(GetVector(sphere->GetCenter()), GetRadius(sphere->GetRadius()), tolerance);
  }
  if (auto* cylinder = vtkCylinder::SafeDownCast(shape))
  {
    vtkNew<vtkMatrix4x4> toWorld;
    vtkMatrix4x4::Invert(GetMatrix(cylinder), toWorld);
    const double* c = cylinder->GetCenter();
    const double* a = cylinder->GetAxis();
    const double center[4] = { c[0], c[1], c[2], 1 }, axis[4] = { a[0], a[1], a[2], 0 };
    double worldCenter[4], worldAxis[4];
    toWorld->MultiplyPoint(center, worldCenter);
    toWorld->MultiplyPoint(axis, worldAxis);
    return CylinderSolid(
      GetVector(worldCenter), GetVector(worldAxis), GetRadius(cylinder->GetRadius()), tolerance);
  }
  if (auto* box = vtkBox::SafeDownCast(shape))
  {
    return HalfSpaceSolid(GetSides(box), bounds, tolerance);
  }
  if (auto* plane = vtkPlane::SafeDownCast(shape))
  {
    // The function of ParaView's plane also has an offset and may be aligned to an axis, so
    // evaluate it; it is negative inside.
    double* origin = plane->GetOrigin();
    double normal[3];
    plane->EvaluateGradient(origin, normal);
    HalfSpace halfSpace = MakeHalfSpace(GetVector(origin), GetVector(normal));
    if (const double value = plane->EvaluateFunction(origin))
    {
      halfSpace.Offset -= value / Norm(GetVector(normal));
    }
    return HalfSpaceSolid({ halfSpace }, bounds, tolerance);
  }
  throw std::invalid_argument(shape
      ? std::string("Shape must be a sphere, box, cylinder or plane, not a ") +
        shape->GetClassName()
      : std::string("no Shape is chosen"));
}

//------------------------------------------------------------------------------
// The triangles of the surface on all processes.
std::vector<Simplex> GatherTriangles(const SelectionTask& task)
{
  std::vector<Simplex> triangles;
  const std::vector<DataSetLeaf> leaves = GetMeshes(task.Inputs.Surface, task.Reducer);
  RunCollectively(task.Reducer,
    [&]
    {
      for (const DataSetLeaf& leaf : leaves)
      {
        const vtkSmartPointer<vtkDataSet> data = AsMesh(leaf.Data);
        const MeshView mesh(data);
        CellFacets facets(mesh);
        CellBoundary boundary(mesh);
        for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
        {
          if (facets.GetDimension(cell) == 3)
          {
            throw std::invalid_argument("the Surface has 3D cells; apply Mesh Surface first");
          }
          if (facets.GetDimension(cell) == 2)
          {
            boundary.Load(cell);
            triangles.insert(
              triangles.end(), boundary.GetSimplices().begin(), boundary.GetSimplices().end());
          }
        }
      }
    });
  return task.Reducer.GatherItems(triangles);
}

//------------------------------------------------------------------------------
// The triangles of polygons that are given as rows of points.
std::vector<Simplex> MakeTriangles(const std::vector<std::vector<double>>& rows)
{
  std::vector<Simplex> triangles;
  std::vector<Vector> corners;
  PolygonTriangulator triangulator;
  for (const std::vector<double>& row : rows)
  {
    corners.clear();
    for (std::size_t i = 0; i + 2 < row.size(); i += 3)
    {
      corners.push_back(GetVector(&row[i]));
    }
    triangulator.Cut(corners.data(), static_cast<int>(corners.size()));
    for (const PolygonTriangulator::Triangle& t : triangulator.GetTriangles())
    {
      triangles.push_back({ { corners[t[0]], corners[t[1]], corners[t[2]] }, 3 });
    }
  }
  return triangles;
}

//------------------------------------------------------------------------------
// @a subject begins the message about an open surface, such as "the Surface is".
std::string MarkInSurface(const SelectionTask& task, std::vector<Simplex>&& triangles,
  const std::string& subject, SelectionMarks& marks)
{
  if (const std::size_t open = SurfaceSolid::CountOpenEdges(triangles))
  {
    throw std::invalid_argument(subject + " not closed: " + std::to_string(open) +
      (open == 1 ? " edge belongs" : " edges belong") + " to an odd number of polygons");
  }
  const Bounds bounds = FindBounds(task);
  return MarkInside(
    task, SurfaceSolid(std::move(triangles), RelativeTolerance * bounds.GetDiagonal()), marks);
}
}

//------------------------------------------------------------------------------
std::string SelectInShape(const SelectionTask& task, SelectionMarks& marks)
{
  const Bounds bounds = FindBounds(task);
  const Solid solid = MakeSolid(task.Parameters.Shape, bounds);
  return std::visit([&](const auto& known) { return MarkInside(task, known, marks); }, solid);
}

//------------------------------------------------------------------------------
std::string SelectInHalfSpaces(const SelectionTask& task, SelectionMarks& marks)
{
  const std::vector<double>& planes = task.Parameters.Planes;
  if (planes.empty())
  {
    throw std::invalid_argument("Planes is empty");
  }
  if (planes.size() % NumbersPerPlane != 0)
  {
    throw std::invalid_argument(
      "Planes: each plane is a point and a normal; expected a multiple of 6 numbers, found " +
      std::to_string(planes.size()));
  }
  const Bounds bounds = FindBounds(task);
  std::vector<HalfSpace> halfSpaces;
  for (std::size_t i = 0; i < planes.size(); i += NumbersPerPlane)
  {
    halfSpaces.push_back(MakeHalfSpace(GetVector(&planes[i]), GetVector(&planes[i + 3])));
  }
  const double tolerance = RelativeTolerance * bounds.GetDiagonal();
  return MarkInside(task, HalfSpaceSolid(halfSpaces, bounds, tolerance), marks);
}

//------------------------------------------------------------------------------
std::string SelectInSurface(const SelectionTask& task, SelectionMarks& marks)
{
  std::vector<Simplex> triangles = GatherTriangles(task);
  if (triangles.empty())
  {
    throw std::invalid_argument("no Surface is chosen, or it has no polygons");
  }
  return MarkInSurface(task, std::move(triangles), "the Surface is", marks);
}

//------------------------------------------------------------------------------
std::string SelectInShapeFile(const SelectionTask& task, SelectionMarks& marks)
{
  const std::string& path = task.Parameters.ShapeFile;
  if (path.empty())
  {
    throw std::invalid_argument("no Shape File is chosen");
  }
  const std::string name = GetFileName(path);
  const ShapeText shape = ParseShape(name, ReadSmallFile(path, "a shape", task.Reducer));
  if (shape.What == ShapeText::Kind::Polygons)
  {
    return MarkInSurface(task, MakeTriangles(shape.Rows), name + ": the polygons are", marks);
  }
  const Bounds bounds = FindBounds(task);
  const double tolerance = RelativeTolerance * bounds.GetDiagonal();
  if (shape.What == ShapeText::Kind::Sphere)
  {
    const std::vector<double>& row = shape.Rows[0];
    const BallSolid ball(GetVector(row.data()), GetRadius(row[3]), tolerance);
    return MarkInside(task, ball, marks);
  }
  std::vector<HalfSpace> halfSpaces;
  for (const std::vector<double>& row : shape.Rows)
  {
    halfSpaces.push_back(MakeHalfSpace(GetVector(row.data() + 3), GetVector(row.data())));
  }
  return MarkInside(task, HalfSpaceSolid(halfSpaces, bounds, tolerance), marks);
}

//------------------------------------------------------------------------------
std::vector<std::string> GetPlacementNames()
{
  std::vector<std::string> names;
  for (const PlacementName& known : PlacementNames)
  {
    names.emplace_back(known.Name);
  }
  return names;
}
}
