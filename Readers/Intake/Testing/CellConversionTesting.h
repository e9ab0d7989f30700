// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What the tests of conversions need: a conversion with all that it says, and meshes to convert.
#ifndef camaron_CellConversionTesting_h
#define camaron_CellConversionTesting_h

#include "TestMeshes.h"

#include "Base/Vector.h"
#include "Intake/CellMesh/CellConversion.h"
#include "Intake/CellMesh/OutputMesh.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace camaron
{
namespace testing
{
using Ids = std::vector<vtkIdType>;

//------------------------------------------------------------------------------
struct Converted
{
  OutputMesh Mesh;
  bool Success = false;
  ScanError Error;
  Warnings Warned;

  Ids Get(vtkIdType cell) const
  {
    const IndexRange points = this->Mesh.GetCellPoints(cell);
    Ids ids;
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      ids.push_back(points[i]);
    }
    return ids;
  }
  Vector Place(vtkIdType point) const
  {
    double x[3];
    this->Mesh.GetPoint(point, x);
    return { x[0], x[1], x[2] };
  }
  double GetVolume(vtkIdType tetrahedron) const
  {
    const Ids t = this->Get(tetrahedron);
    const Vector o = this->Place(t[0]);
    return Dot(Cross(this->Place(t[1]) - o, this->Place(t[2]) - o), this->Place(t[3]) - o) / 6;
  }
  double GetVolume() const
  {
    double volume = 0;
    for (vtkIdType cell = 0; cell < this->Mesh.GetNumberOfCells(); ++cell)
    {
      volume += this->GetVolume(cell);
    }
    return volume;
  }
  std::string GetWarnings() const
  {
    std::string text;
    for (const std::string& sentence : this->Warned.GetSentences())
    {
      text += sentence + "\n";
    }
    return text;
  }
};

//------------------------------------------------------------------------------
inline Converted Convert(vtkDataSet* mesh, CellTypeSet held,
  UnsupportedCells others = UnsupportedCells::Refuse, SurfaceFaces surface = SurfaceFaces::None)
{
  Converted result;
  CellConversion how{ "Foo", held };
  how.Others = others;
  how.Surface = surface;
  result.Success =
    ConvertCells(mesh, how, "some/where/mesh.foo", result.Mesh, result.Warned, result.Error);
  EXPECT_EQ(result.Success, result.Error.Kind == ErrorKind::None);
  return result;
}

//------------------------------------------------------------------------------
// A concave polygon in the plane z = 0, counter-clockwise: a comb with two teeth.
inline Grid MakeComb()
{
  return MakeGrid({ { 0, 0, 0 }, { 5, 0, 0 }, { 5, 4, 0 }, { 4, 1, 0 }, { 2, 1, 0 }, { 1, 4, 0 } },
    { { VTK_POLYGON, { 0, 1, 2, 3, 4, 5 } } });
}

//------------------------------------------------------------------------------
inline Grid MakeAllStandardCells()
{
  Points points;
  Cells cells;
  for (const int type : StandardTypes3D)
  {
    const Grid one = MakeStandardCell(type);
    const auto first = static_cast<vtkIdType>(points.size());
    cells.push_back({ type, {} });
    for (vtkIdType i = 0; i < one->GetNumberOfPoints(); ++i)
    {
      double x[3];
      one->GetPoint(i, x);
      points.push_back({ x[0] + 10.0 * cells.size(), x[1], x[2] });
      cells.back().second.push_back(first + i);
    }
  }
  return MakeGrid(points, cells);
}
}
}

#endif
