// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PointSetHulls.h"

#include "Mesh/MeshView.h"
#include "Mesh/Vector.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkConvexPointSet.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool HasPointSets(vtkUnstructuredGrid* grid)
{
  const MeshView mesh(grid);
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    if (mesh.GetCellType(cell) == VTK_CONVEX_POINT_SET)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
Vector GetPoint(vtkPoints* points, vtkIdType id)
{
  double x[3];
  points->GetPoint(id, x);
  return { x[0], x[1], x[2] };
}

//------------------------------------------------------------------------------
bool AreFinite(vtkPoints* points, vtkIdList* ids)
{
  bool areFinite = true;
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    const Vector point = GetPoint(points, ids->GetId(i));
    areFinite = areFinite && std::isfinite(point.X) && std::isfinite(point.Y) && std::isfinite(point.Z);
  }
  return areFinite;
}

//------------------------------------------------------------------------------
Vector GetMean(vtkPoints* points)
{
  Vector sum;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    sum += GetPoint(points, i);
  }
  return (1.0 / static_cast<double>(points->GetNumberOfPoints())) * sum;
}

//------------------------------------------------------------------------------
// Gives flat or slender sets about the same size in all directions, which changes nothing about their hull: VTK loses
// points of those.
void MakeRound(vtkPoints* points, const Vector& mean)
{
  constexpr double slender = 0.01; // of squared sizes
  double covariance[3][3] = {}, axes[3][3], squares[3];
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const Vector point = GetPoint(points, i) - mean;
    const double x[3] = { point.X, point.Y, point.Z };
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        covariance[row][column] += x[row] * x[column];
      }
    }
  }
  double* rows[3] = { covariance[0], covariance[1], covariance[2] };
  double* vectors[3] = { axes[0], axes[1], axes[2] };
  vtkMath::Jacobi(rows, squares, vectors); // largest first, vectors in columns
  if (!(squares[2] > 0) || squares[2] > slender * squares[0])
  {
    return;
  }
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const Vector point = GetPoint(points, i) - mean;
    double x[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector along = { axes[0][axis], axes[1][axis], axes[2][axis] };
      x[axis] = Dot(point, along) / std::sqrt(squares[axis]);
    }
    points->SetPoint(i, x);
  }
}

//------------------------------------------------------------------------------
// Makes a triangle of a hull around @a inside face outward, which VTK's need not.
void TurnOutward(vtkIdList* triangle, vtkPoints* points, const Vector& inside)
{
  const auto get = [&](vtkIdType corner)
  { return GetPoint(points, triangle->GetId(corner)) - inside; };
  if (Dot(get(0), Cross(get(1), get(2))) < 0)
  {
    const vtkIdType second = triangle->GetId(1);
    triangle->SetId(1, triangle->GetId(2));
    triangle->SetId(2, second);
  }
}
}

//------------------------------------------------------------------------------
// Rare cells, so clarity first.
vtkSmartPointer<vtkUnstructuredGrid> WithHulls(vtkUnstructuredGrid* grid, int hullType)
{
  if (!HasPointSets(grid))
  {
    return grid;
  }
  vtkNew<vtkCellArray> connectivity, faces, locations;
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkConvexPointSet> cell;
  cell->GetPoints()->SetDataTypeToDouble();
  vtkNew<vtkIdList> points;
  vtkNew<vtkCellArray> cellFaces;
  for (vtkIdType id = 0; id < grid->GetNumberOfCells(); ++id)
  {
    const int type = grid->GetCellType(id);
    grid->GetCellPoints(id, points);
    connectivity->InsertNextCell(points);
    locations->InsertNextCell(0);
    if (type == VTK_CONVEX_POINT_SET)
    {
      constexpr vtkIdType least = 4; // points of a hull with a volume
      const bool isFinite = AreFinite(grid->GetPoints(), points);
      const bool hasHull = points->GetNumberOfIds() >= least && isFinite;
      Vector mean;
      if (hasHull)
      {
        grid->GetPoints()->GetPoints(points, cell->GetPoints());
        cell->GetPointIds()->DeepCopy(points);
        mean = GetMean(cell->GetPoints());
        MakeRound(cell->GetPoints(), mean);
        cell->Initialize();
      }
      int numberOfFaces = hasHull ? cell->GetNumberOfFaces() : 0;
      for (int f = 0; f < numberOfFaces; ++f)
      {
        vtkIdList* const triangle = cell->GetFace(f)->GetPointIds();
        TurnOutward(triangle, grid->GetPoints(), mean);
        locations->InsertCellPoint(faces->InsertNextCell(triangle));
      }
      if (!isFinite && hullType == VTK_CONVEX_POINT_SET)
      {
        // A face with all its points tells those who evaluate the cell.
        locations->InsertCellPoint(faces->InsertNextCell(points));
        numberOfFaces = 1;
      }
      locations->UpdateCellCount(numberOfFaces);
    }
    else if (type == VTK_POLYHEDRON)
    {
      grid->GetPolyhedronFaces(id, cellFaces);
      for (vtkIdType f = 0; f < cellFaces->GetNumberOfCells(); ++f)
      {
        cellFaces->GetCellAtId(f, points);
        locations->InsertCellPoint(faces->InsertNextCell(points));
      }
      locations->UpdateCellCount(static_cast<int>(cellFaces->GetNumberOfCells()));
    }
    types->InsertNextValue(
      static_cast<unsigned char>(type == VTK_CONVEX_POINT_SET ? hullType : type));
  }
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->SetPoints(grid->GetPoints());
  result->SetPolyhedralCells(types, connectivity, locations, faces);
  result->GetCellData()->ShallowCopy(grid->GetCellData());
  result->GetPointData()->ShallowCopy(grid->GetPointData());
  result->GetFieldData()->ShallowCopy(grid->GetFieldData());
  return result;
}
}
