// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells that keep their shape when coordinates are rounded, without rounding them.
#include "Base/Number.h"
#include "Intake/CellMesh/RoundingMargin.h"
#include "Mesh/MeshView.h"

#include <gtest/gtest.h>

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

using namespace camaron;

namespace
{
constexpr double MaxChange = 0.01;
constexpr Rounding ToFloat = { std::numeric_limits<float>::epsilon() / 2,
  std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max() };

//------------------------------------------------------------------------------
/// Shapes of eight points: a cell of this type has the first of them.
struct CellOfCube
{
  unsigned char Type;
  std::vector<vtkIdType> Points; ///< of the cube; the faces of a polyhedron in VTK's form
};
const CellOfCube Cells[] = { { VTK_LINE, { 0, 1 } }, { VTK_POLY_LINE, { 0, 1, 2, 3, 7 } },
  { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_QUAD, { 0, 1, 2, 3 } }, { VTK_PIXEL, { 0, 1, 3, 2 } },
  { VTK_POLYGON, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 3, 4 } },
  { VTK_PYRAMID, { 0, 1, 2, 3, 4 } }, { VTK_WEDGE, { 0, 3, 1, 4, 7, 5 } },
  { VTK_VOXEL, { 0, 1, 3, 2, 4, 5, 7, 6 } }, { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } },
  { VTK_POLYHEDRON,
    { 6, 4, 0, 3, 2, 1, 4, 4, 5, 6, 7, 4, 0, 1, 5, 4, 4, 1, 2, 6, 5, 4, 2, 3, 7, 6, 4, 3, 0, 4,
      7 } } };

/// A sliver: all edges are long, but rounding may invert it.
const CellOfCube Sliver = { VTK_TETRA, { 0, 1, 2, 3 } };

//------------------------------------------------------------------------------
/// A cell in a cube with jittered points.
vtkSmartPointer<vtkUnstructuredGrid> MakeCell(
  const CellOfCube& cell, const Vector& origin, const Vector& size, vtkRandomSequence* random)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto jitter = [random]
  {
    random->Next();
    return 0.1 * random->GetValue();
  };
  for (int corner = 0; corner < 8; ++corner)
  {
    const double x = (corner % 4 == 1 || corner % 4 == 2) + jitter(), y = corner % 4 / 2 + jitter(),
                 z = corner / 4 + jitter(); // NOLINT(bugprone-integer-division)
    points->InsertNextPoint(origin.X + size.X * x, origin.Y + size.Y * y, origin.Z + size.Z * z);
  }
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  vtkNew<vtkIdList> ids;
  std::for_each(
    cell.Points.begin(), cell.Points.end(), [&](vtkIdType id) { ids->InsertNextId(id); });
  grid->InsertNextCell(cell.Type, ids);
  return grid;
}

//------------------------------------------------------------------------------
bool IsSafe(vtkUnstructuredGrid* grid, const Rounding& rounding = ToFloat)
{
  const MeshView mesh(grid);
  return RoundingMargin(mesh, rounding, MaxChange).AreSafe(0, mesh.GetNumberOfCells());
}

//------------------------------------------------------------------------------
Vector GetPlace(vtkPoints* points, vtkIdType id, bool isRounded)
{
  double x[3];
  points->GetPoint(id, x);
  return isRounded
    ? Vector{ static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2]) }
    : Vector{ x[0], x[1], x[2] };
}

//------------------------------------------------------------------------------
/// Of VTK's cell: the sum over the triangles of its faces.
double GetVolume(vtkCell* cell, bool isRounded)
{
  double volume = 0;
  const Vector origin = GetPlace(cell->GetPoints(), 0, isRounded);
  for (int f = 0; f < cell->GetNumberOfFaces(); ++f)
  {
    vtkCell* const face = cell->GetFace(f);
    const auto at = [&](vtkIdType i)
    {
      const bool isCrossed = face->GetCellType() == VTK_PIXEL && i > 1;
      return GetPlace(face->GetPoints(), isCrossed ? 5 - i : i, isRounded) - origin;
    };
    for (vtkIdType i = 1; i + 1 < face->GetNumberOfPoints(); ++i)
    {
      volume += Dot(at(0), Cross(at(i), at(i + 1)));
    }
  }
  return volume;
}

//------------------------------------------------------------------------------
/// The greatest relative change of the lengths of VTK's edges; infinite if the volume changes sign.
double GetChange(vtkUnstructuredGrid* grid)
{
  vtkCell* const cell = grid->GetCell(0);
  double greatest = 0;
  const auto compare = [&](vtkPoints* points, vtkIdType a, vtkIdType b)
  {
    const double before = Norm(GetPlace(points, b, false) - GetPlace(points, a, false)),
                 after = Norm(GetPlace(points, b, true) - GetPlace(points, a, true));
    greatest = std::max(greatest, std::abs(after - before) / before);
  };
  for (int e = 0; e < cell->GetNumberOfEdges(); ++e)
  {
    vtkPoints* const ends = cell->GetEdge(e)->GetPoints();
    compare(ends, 0, 1);
  }
  for (vtkIdType i = 0; cell->GetCellDimension() == 1 && i + 1 < cell->GetNumberOfPoints(); ++i)
  {
    compare(cell->GetPoints(), i, i + 1);
  }
  const bool isTurned =
    cell->GetCellDimension() == 3 && !(GetVolume(cell, false) * GetVolume(cell, true) > 0);
  return isTurned ? Infinity : greatest;
}
}

//------------------------------------------------------------------------------
// If this fails, writing in single precision takes far longer.
TEST(RoundingMargin, UsualCellsAreSafe)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  for (const CellOfCube& cell : Cells)
  {
    for (const Vector& origin : { Vector(), Vector{ -50, 1000, 3 } })
    {
      for (const Vector& size : { Vector{ 1, 1, 1 }, Vector{ 10, 1, 0.2 } })
      {
        EXPECT_TRUE(IsSafe(MakeCell(cell, origin, size, random))) << static_cast<int>(cell.Type);
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, a file may contain cells of another shape, or inverted ones, without an error.
TEST(RoundingMargin, SafeCellsKeepTheirShape)
{
  constexpr int Distances = 30, Repetitions = 40;
  vtkNew<vtkMinimalStandardRandomSequence> random;
  std::vector<CellOfCube> cells(std::begin(Cells), std::end(Cells));
  cells.push_back(Sliver);
  for (const CellOfCube& cell : cells)
  {
    int safe = 0, changed = 0;
    for (int i = 0; i < Distances * Repetitions; ++i)
    {
      const double far = std::ldexp(1., i % Distances);
      const double flat = std::ldexp(1., -(i / Distances % 10));
      const auto grid = MakeCell(cell, { far, -far / 3, far / 7 }, { 1, 1, flat }, random);
      const bool isSafe = IsSafe(grid);
      const double change = GetChange(grid);
      safe += isSafe;
      changed += change > MaxChange;
      ASSERT_TRUE(!isSafe || change <= MaxChange)
        << static_cast<int>(cell.Type) << " at " << far << " changes by " << change;
    }
    EXPECT_GT(safe, Repetitions) << static_cast<int>(cell.Type);
    EXPECT_GT(changed, Repetitions) << static_cast<int>(cell.Type);
  }
}

//------------------------------------------------------------------------------
// Such cells must be rounded and compared.
TEST(RoundingMargin, IsNotSureOfDefects)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  for (const CellOfCube& cell : Cells)
  {
    const auto make = [&](double size) { return MakeCell(cell, {}, { size, size, size }, random); };
    EXPECT_TRUE(IsSafe(make(1e30)));
    EXPECT_FALSE(IsSafe(make(1e39))) << "beyond single precision";
    EXPECT_FALSE(IsSafe(make(1e-44))) << "below single precision";
    EXPECT_FALSE(IsSafe(make(1), { 0.01, 0, Infinity })) << "with two digits";
    EXPECT_TRUE(IsSafe(make(1), { 1e-6, 0, Infinity })) << "with six digits";
    for (const double bad : { NaN, Infinity })
    {
      const auto grid = make(1);
      grid->GetPoints()->SetPoint(0, 1, bad, 1);
      EXPECT_FALSE(IsSafe(grid)) << static_cast<int>(cell.Type);
    }
    const auto same = make(1);
    same->GetPoints()->SetPoint(1, same->GetPoint(0));
    EXPECT_FALSE(IsSafe(same)) << static_cast<int>(cell.Type);
    const auto flat = MakeCell(cell, {}, { 1, 1, 0 }, random);
    flat->GetPoints()->SetPoint(4, 0.5, 0.7, 0); // not above another one
    EXPECT_FALSE(IsSafe(flat) && flat->GetCell(0)->GetCellDimension() == 3);
  }
}
