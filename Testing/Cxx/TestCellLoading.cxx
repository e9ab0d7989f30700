// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What makes cells fast to evaluate changes none of their values: topologies that cells share.
#include "Mesh/RecentTopologies.h"

#include "CriteriaTesting.h"
#include "MeshElementsTesting.h"
#include "ReferenceShapes.h"

#include <random>

using namespace camaron;
using namespace camaron::testing;

//------------------------------------------------------------------------------
// If this fails, a cell whose points repeat in its faces as those of the cell before do is taken
// for one like it, although two of the points are the same.
TEST(CellLoading, PointsThatAreTheSame)
{
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  const Faces cube = GetFaces(FindReferenceShape("unit cube").Polyhedron, 0);
  const auto replace = [&](vtkIdType id, vtkIdType by)
  {
    Faces faces = cube;
    for (auto& face : faces)
    {
      std::replace(face.begin(), face.end(), id, by);
    }
    return faces;
  };
  const auto makeMesh = [&](const std::vector<Faces>& cells)
  { return MakePolyhedra(MakePolyhedron(points, cube)->GetPoints(), cells); };
  std::vector<Faces> cells;
  for (const auto& pair : { std::make_pair(6, 7), std::make_pair(0, 6), std::make_pair(5, 2) })
  {
    cells.insert(cells.end(), { cube, cube, replace(pair.first, pair.second), cube });
  }
  const Values together = EvaluateAll(makeMesh(cells));
  for (const char* name : { "VertexCount", "Volume", "SurfaceArea", "CellStatus", "EdgeCount" })
  {
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      ExpectSame(EvaluateAll(makeMesh({ cells[i] })).at(name)[0], together.at(name)[i], 0,
        name + std::to_string(i));
    }
  }
  EXPECT_EQ(together.at("VertexCount")[2], 7);
}

//------------------------------------------------------------------------------
// If this fails, a value is of something that only some of the cells before were asked for.
TEST(CellLoading, CollapsedAfterSound)
{
  const auto makeCubes = [](int number)
  {
    Points points;
    std::vector<Faces> cells;
    const Faces cube = GetFaces(FindReferenceShape("unit cube").Polyhedron, 0);
    const Grid standard = MakeStandardCell(VTK_HEXAHEDRON);
    for (int i = 0; i < number; ++i)
    {
      cells.push_back(cube);
      for (auto& face : cells.back())
      {
        std::for_each(face.begin(), face.end(), [i](vtkIdType& id) { id += 8 * i; });
      }
      for (vtkIdType corner = 0; corner < 8; ++corner)
      {
        double x[3];
        // The last one has an edge without a length.
        standard->GetPoint(i + 1 == number && corner == 6 ? 5 : corner, x);
        points.push_back({ x[0], x[1], x[2] });
      }
    }
    vtkNew<vtkPoints> all;
    all->SetDataTypeToDouble();
    for (const Point& point : points)
    {
      all->InsertNextPoint(point.data());
    }
    return MakePolyhedra(all, cells);
  };
  const Values alone = EvaluateAll(makeCubes(1)), together = EvaluateAll(makeCubes(40));
  for (const auto& row : alone)
  {
    const Criterion& criterion = *FindCriterion(row.first);
    if (criterion.CellFunction && !(criterion.Needs & NeedsMeanSizes))
    {
      ExpectSame(row.second[0], together.at(row.first).back(), 0, row.first);
      EXPECT_EQ(GetNullReason(row.second[0]), GetNullReason(together.at(row.first).back()))
        << row.first;
    }
  }
  EXPECT_EQ(alone.at("CornerScaledJacobian")[0], 0);
}

//------------------------------------------------------------------------------
// Ids with equal hashes are distinguished; numbers that are not given as they first occur are not
// recognized.
TEST(CellLoading, Recognize)
{
  RecentTopologies topologies;
  bool wasRepeated = false;
  const auto setFaces = [&](std::vector<int> numbers)
  {
    topologies.FaceOffsets = { 0, 3, 6, 9, 12 };
    topologies.FacePoints = std::move(numbers);
  };
  const std::vector<int> tetrahedron = { 0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0 };
  setFaces(tetrahedron);
  topologies.Find(4, false, wasRepeated);
  const auto isKnown = [&](std::vector<std::int64_t> ofNumbers)
  {
    setFaces({});
    std::vector<std::int64_t> ids;
    for (const int number : tetrahedron)
    {
      ids.push_back(ofNumbers[number]);
    }
    return topologies.Recognize(ids.data()) != nullptr;
  };
  std::mt19937 generator(1);
  std::uniform_int_distribution<std::int64_t> id(0, std::int64_t(1) << 40);
  for (int i = 0; i < 100000; ++i) // some of which meet
  {
    std::vector<std::int64_t> ids = { id(generator), id(generator), id(generator), id(generator) };
    ASSERT_TRUE(isKnown(ids));
    ids[i % 4] = ids[(i + 1 + i % 3) % 4];
    ASSERT_FALSE(isKnown(ids));
  }
  // Of a cell of many points.
  for (const int size : { 255, 256, 257, 1000 })
  {
    std::vector<std::int32_t> ids;
    std::vector<int> numbers;
    for (int i = 0; i < size; ++i)
    {
      ids.push_back(3 * i);
      numbers.push_back(i);
    }
    topologies.FaceOffsets = { 0, size };
    topologies.FacePoints = numbers;
    topologies.Find(size, false, wasRepeated);
    topologies.FaceOffsets = { 0, size };
    EXPECT_EQ(topologies.Recognize(ids.data()) != nullptr, size <= 256);
    ids[0] = ids[size - 1];
    EXPECT_EQ(topologies.Recognize(ids.data()), nullptr);
  }
  topologies = RecentTopologies();
  setFaces({ 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 });
  topologies.Find(4, false, wasRepeated);
  setFaces({});
  const std::int64_t ids[] = { 5, 7, 6, 5, 6, 8, 6, 7, 8, 7, 5, 8 };
  EXPECT_EQ(topologies.Recognize(ids), nullptr);
}
