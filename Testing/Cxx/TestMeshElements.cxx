// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Faces, edges and vertices of meshes small enough to count them by hand, and sums that hold in
// every mesh.
#include "Criteria/Evaluation.h"
#include "MeshElementsTesting.h"
#include "Sanitized.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

using namespace camaron;
using namespace camaron::testing;

//------------------------------------------------------------------------------
// Progress runs from 0 to 1; wherever it is stopped, nothing more is asked and nothing breaks.
TEST(MeshElements, ProgressAndAbort)
{
  const Grid grid =
    MakeHexahedra(45, 45, 45, false); // more cells than are done between two reports
  const MeshTopology topology(grid);
  std::vector<double> reports;
  std::size_t limit = 0;
  const auto make = [&]
  {
    reports.clear();
    vtkNew<vtkPolyData> faces, edges, vertices;
    ElementContext context(grid, topology, {});
    context.SetProgress(
      [&](double done)
      {
        reports.push_back(done);
        return reports.size() < limit;
      });
    bool isFinished;
    {
      const ElementContext::Step step(context, 0, 0.6);
      isFinished = MakeFaces(context, GetNames(GetFaceArrays()), faces);
    }
    const ElementContext::Step step(context, 0.6, 1);
    isFinished = MakeEdges(context, GetNames(GetEdgeArrays()), edges) && isFinished;
    return MakeVertices(context, GetNames(GetVertexArrays()), vertices) && isFinished;
  };
  limit = 1000;
  EXPECT_TRUE(make());
  EXPECT_GT(reports.size(), 30u);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  EXPECT_EQ(reports.front(), 0);
  EXPECT_EQ(reports.back(), 1);
  const std::size_t all = reports.size();
  constexpr std::size_t growth = IsSanitized ? 8 : 3;
  for (limit = 1; limit < all; limit = limit * growth / 2 + 1)
  {
    EXPECT_FALSE(make());
    EXPECT_EQ(reports.size(), limit);
  }
}

//------------------------------------------------------------------------------
TEST(MeshElements, OfARowOfCubes)
{
  const Grid row = MakeRow(3);
  for (const Grid& grid : { row, ToPolyhedra(row) })
  {
    const Elements elements(grid);
    vtkPolyData* faces = elements.Faces;
    EXPECT_EQ(faces->GetNumberOfCells(), 16);
    EXPECT_EQ(Sum(faces, "IsBoundary"), 14);
    EXPECT_EQ(Sum(faces, "FaceCellCount"), 18);
    for (vtkIdType i = 0; i < 16; ++i)
    {
      EXPECT_EQ(faces->GetCellSize(i), 4);
      const bool isInner = Get(faces, "IsBoundary", i) == 0;
      EXPECT_EQ(Get(faces, "NeighborCell", i) >= 0, isInner);
      EXPECT_EQ(std::isnan(Get(faces, "NonOrthogonality", i)), !isInner);
      EXPECT_EQ(std::isnan(Get(faces, "BoundaryNonOrthogonality", i)), isInner);
      EXPECT_NEAR(Get(faces, "FaceSkewness", i), 0, 1e-12);
      EXPECT_NEAR(Get(faces, "FacePyramidVolume", i), 1.0 / 6, 1e-12);
      if (isInner)
      {
        EXPECT_EQ(Get(faces, "NeighborCell", i) - Get(faces, "OwnerCell", i), 1);
        EXPECT_NEAR(Get(faces, "FaceWeight", i), 0.5, 1e-12);
        EXPECT_NEAR(Get(faces, "VolumeRatio", i), 1, 1e-12);
      }
    }
    vtkPolyData* edges = elements.Edges;
    EXPECT_EQ(edges->GetNumberOfCells(), 28);
    EXPECT_EQ(Sum(edges, "EdgeLength"), 28);
    EXPECT_EQ(Sum(edges, "EdgeCellCount"), 36);
    EXPECT_EQ(Sum(edges, "EdgeFaceCount"), 4 * 16);
    EXPECT_EQ(Sum(edges, "IsBoundary"), 28);
    vtkPolyData* vertices = elements.Vertices;
    EXPECT_EQ(vertices->GetNumberOfCells(), 16);
    EXPECT_EQ(Sum(vertices, "VertexCellCount"), 24);
    EXPECT_EQ(Sum(vertices, "VertexEdgeCount"), 56);
    EXPECT_EQ(Sum(vertices, "VertexFaceCount"), 64);
    EXPECT_EQ(Sum(vertices, "UnusedPoint"), 0);
  }
}

//------------------------------------------------------------------------------
// The surface of a cube, with one face reversed and one missing.
TEST(MeshElements, OfASurface)
{
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 }, { 5, 5, 5 } };
  const Grid surface = MakeGrid(points,
    { { VTK_QUAD, { 0, 3, 2, 1 } }, { VTK_QUAD, { 0, 1, 5, 4 } }, { VTK_QUAD, { 1, 2, 6, 5 } },
      { VTK_QUAD, { 2, 3, 7, 6 } },
      { VTK_QUAD, { 0, 3, 7, 4 } } }); // the last one runs the other way
  const Elements elements(surface);
  EXPECT_EQ(elements.Faces->GetNumberOfCells(), 5);
  vtkPolyData* edges = elements.Edges;
  EXPECT_EQ(edges->GetNumberOfCells(), 12);
  EXPECT_EQ(Sum(edges, "IsBoundary"), 4);
  EXPECT_EQ(Sum(edges, "InconsistentEdge"), 3);
  for (vtkIdType i = 0; i < 12; ++i)
  {
    const double angle = Get(edges, "EdgeDihedralAngle", i);
    const bool isBoundary = Get(edges, "IsBoundary", i) != 0;
    // Rules do not check edges to which an array does not apply.
    EXPECT_EQ(GetNullReason(angle), isBoundary ? NullReason::NotApplicable : NullReason::Value);
    if (!isBoundary && Get(edges, "InconsistentEdge", i) == 0)
    {
      EXPECT_NEAR(angle, 90, 1e-9);
    }
  }
  EXPECT_EQ(Sum(elements.Vertices, "UnusedPoint"), 1);
  EXPECT_EQ(Get(elements.Vertices, "UnusedPoint", 8), 1);
  EXPECT_EQ(Sum(elements.Vertices, "IsBoundary"), 4);
}

//------------------------------------------------------------------------------
// Polygons collapsed to an edge change nothing there.
TEST(MeshElements, CollapsedPolygonsAtEdges)
{
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 1, 0, 1 } };
  const Cells sound = { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 1, 3 } } };
  Cells all = sound;
  all.push_back({ VTK_TRIANGLE, { 0, 1, 1 } });
  all.push_back({ VTK_QUAD, { 1, 2, 1, 2 } });
  const Elements alone(MakeGrid(points, sound)), with(MakeGrid(points, all));
  ASSERT_EQ(with.Edges->GetNumberOfCells(), 5);
  for (const char* name : { "BoundaryEdge", "InconsistentEdge", "EdgeDihedralAngle" })
  {
    for (vtkIdType i = 0; i < 5; ++i)
    {
      const double value = Get(with.Edges, name, i), expected = Get(alone.Edges, name, i);
      EXPECT_EQ(GetNullReason(value), GetNullReason(expected)) << name << " " << i;
      EXPECT_TRUE(value == expected || std::isnan(expected)) << name << " " << i;
    }
  }
  EXPECT_EQ(Sum(with.Edges, "BoundaryEdge"), 4);
  EXPECT_EQ(Sum(with.Edges, "InconsistentEdge"), 1);
}

//------------------------------------------------------------------------------
// Edges between polygons are to 2D meshes what faces are to 3D ones. By hand for a square and a
// sheared one of twice the area; for any sheet the worst edge of all is the worst one of a polygon.
TEST(MeshElements, FiniteVolumesOfPolygons)
{
  const double pi = std::acos(-1.0);
  const Grid pair =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 3, 1, 0 }, { 3, 2, 0 } },
      { { VTK_QUAD, { 0, 1, 2, 3 } }, { VTK_QUAD, { 2, 1, 4, 5 } } });
  const Elements two(pair);
  int inner = 0;
  for (vtkIdType i = 0; i < two.Edges->GetNumberOfCells(); ++i)
  {
    const bool isInner = Get(two.Edges, "EdgeCellCount", i) == 2;
    inner += isInner;
    for (const char* name : { "NonOrthogonality", "FaceWeight", "VolumeRatio" })
    {
      EXPECT_EQ(GetNullReason(Get(two.Edges, name, i)),
        isInner ? NullReason::Value : NullReason::NotApplicable);
    }
    EXPECT_EQ(std::isnan(Get(two.Edges, "BoundaryNonOrthogonality", i)), isInner);
    if (isInner)
    {
      // Centroids (0.5, 0.5) and (2, 1); the line between them meets the edge at height 2/3.
      EXPECT_NEAR(Get(two.Edges, "NonOrthogonality", i), std::atan2(0.5, 1.5) * 180 / pi, 1e-12);
      EXPECT_NEAR(Get(two.Edges, "FaceWeight", i), 1.0 / 3, 1e-15);
      EXPECT_NEAR(Get(two.Edges, "VolumeRatio", i), 0.5, 1e-15);
      EXPECT_NEAR(Get(two.Edges, "FaceSkewness", i), (2.0 / 3 - 0.5) / 0.5, 1e-12);
    }
  }
  EXPECT_EQ(inner, 1);

  std::mt19937 random(6);
  std::uniform_real_distribution<double> noise(-0.25, 0.25);
  Points points;
  Cells cells;
  const int size = 20;
  for (vtkIdType i = 0; i < (size + 1) * (size + 1); ++i)
  {
    const double x = i % (size + 1), y = i / (size + 1);
    points.push_back({ x + noise(random), y + noise(random), noise(random) });
    if (x < size && y < size)
    {
      cells.push_back({ VTK_QUAD, { i, i + 1, i + size + 2, i + size + 1 } });
    }
  }
  const Grid sheet = MakeGrid(points, cells);
  const Elements elements(sheet);
  const struct
  {
    const char *OfEdges, *OfCells;
    bool IsLargest;
  } rows[] = { { "NonOrthogonality", "MaxNonOrthogonality", true },
    { "BoundaryNonOrthogonality", "MaxBoundaryNonOrthogonality", true },
    { "FaceSkewness", "MaxFaceSkewness", true }, { "FaceWeight", "MinFaceWeight", false },
    { "VolumeRatio", "MinVolumeRatio", false },
    { "FacePyramidVolume", "MinFacePyramidVolume", false } };
  for (const auto& row : rows)
  {
    std::vector<double> values(sheet->GetNumberOfCells());
    ASSERT_TRUE(Evaluate(MeshTopology(sheet), {}, { { FindCriterion(row.OfCells), values.data() } },
      [](double) { return true; }));
    const double sign = row.IsLargest ? 1 : -1;
    double ofCells = -1e9, ofEdges = -1e9;
    for (const double value : values)
    {
      ofCells = std::isnan(value) ? ofCells : std::max(ofCells, sign * value);
    }
    for (vtkIdType i = 0; i < elements.Edges->GetNumberOfCells(); ++i)
    {
      const double value = Get(elements.Edges, row.OfEdges, i);
      ofEdges = std::isnan(value) ? ofEdges : std::max(ofEdges, sign * value);
    }
    EXPECT_NEAR(ofEdges, ofCells, 1e-9) << row.OfEdges;
  }
}

//------------------------------------------------------------------------------
// Which end is the worst follows from the criterion; undefined values do not count.
TEST(MeshElements, WorstOfTheCellsAround)
{
  const Grid row = MakeRow(3);
  const auto add = [&](const char* name, const std::vector<double>& values)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (const double value : values)
    {
      array->InsertNextValue(value);
    }
    row->GetCellData()->AddArray(array);
  };
  const double none = Null(NullReason::Degenerate);
  add("EdgeRatio", { 1, 5, 3 });
  add("EdgeLengthRatio", { none, 0.2, 0.5 });
  add("Diameter", { 1, 2, 3 });
  add("Pressure", { 1, 2, 3 });
  const Elements elements(row);
  const double ratios[] = { 1, 5, 5, 3 }, lengths[] = { none, 0.2, 0.2, 0.5 };
  for (vtkIdType i = 0; i < 16; ++i)
  {
    EXPECT_EQ(Get(elements.Vertices, "VertexWorstEdgeRatio", i), ratios[i / 4]);
    const double worst = Get(elements.Vertices, "VertexWorstEdgeLengthRatio", i);
    EXPECT_TRUE(i < 4 ? std::isnan(worst) : worst == lengths[i / 4]) << worst;
  }
  EXPECT_FALSE(elements.Vertices->GetCellData()->HasArray("VertexWorstDiameter"));
  EXPECT_FALSE(elements.Vertices->GetCellData()->HasArray("VertexWorstPressure"));
}

//------------------------------------------------------------------------------
// The arrays of faces are what the criteria of cells choose the smallest and the largest from.
TEST(MeshElements, BothEndsOfTheFacesOfCells)
{
  const Grid grid = Warp(MakeHexahedra(4, 4, 4, false), 4);
  const vtkIdType numberOfCells = grid->GetNumberOfCells();
  const Elements elements(grid);
  const auto ofCells = [&](const std::string& name)
  {
    std::vector<double> values(numberOfCells);
    EXPECT_TRUE(Evaluate(MeshTopology(grid), {}, { { FindCriterion(name), values.data() } },
      [](double) { return true; }))
      << name;
    return values;
  };
  for (const std::string name : { "NonOrthogonality", "BoundaryNonOrthogonality", "FaceSkewness",
         "FaceWeight", "VolumeRatio", "FaceFlatness", "Warpage", "FaceConcavity" })
  {
    std::vector<double> smallest(numberOfCells, std::numeric_limits<double>::quiet_NaN());
    std::vector<double> largest = smallest;
    for (vtkIdType i = 0; i < elements.Faces->GetNumberOfCells(); ++i)
    {
      for (const char* side : { "OwnerCell", "NeighborCell" })
      {
        const auto cell = static_cast<vtkIdType>(Get(elements.Faces, side, i));
        if (cell >= 0)
        {
          // Of two numbers of which one is none these are the other one.
          smallest[cell] = std::fmin(smallest[cell], Get(elements.Faces, name.c_str(), i));
          largest[cell] = std::fmax(largest[cell], Get(elements.Faces, name.c_str(), i));
        }
      }
    }
    const std::vector<double> least = ofCells("Min" + name), most = ofCells("Max" + name);
    int different = 0;
    for (vtkIdType cell = 0; cell < numberOfCells; ++cell)
    {
      ASSERT_EQ(std::isnan(least[cell]), std::isnan(smallest[cell])) << name << ' ' << cell;
      if (!std::isnan(least[cell]))
      {
        EXPECT_NEAR(least[cell], smallest[cell], 1e-9) << name << ' ' << cell;
        EXPECT_NEAR(most[cell], largest[cell], 1e-9) << name << ' ' << cell;
        different += most[cell] > least[cell] + 1e-6;
      }
    }
    EXPECT_GT(different, name == "FaceConcavity" ? -1 : 20) << name; // these are convex
  }

  // Of a face the smaller one of two.
  double smallest = std::numeric_limits<double>::infinity();
  for (vtkIdType i = 0; i < elements.Faces->GetNumberOfCells(); ++i)
  {
    smallest = std::min(smallest, Get(elements.Faces, "FacePyramidVolume", i));
  }
  const std::vector<double> pyramids = ofCells("MinFacePyramidVolume");
  EXPECT_NEAR(smallest, *std::min_element(pyramids.begin(), pyramids.end()), 1e-12);

  const Elements straight(MakeRow(3));
  EXPECT_NEAR(Sum(straight.Faces, "FaceTwist"), 16, 1e-12);
  EXPECT_NEAR(Sum(straight.Faces, "FaceFlatness"), 16, 1e-12);
}

//------------------------------------------------------------------------------
// If this fails, arrays of very large or small meshes are made of squares that are 0 or infinite.
TEST(MeshElements, ExtremeSizes)
{
  const Grid surface =
    MakeGrid({ { 0, 0, 0 }, { 2, 0, 0.5 }, { 1, 1, 0 }, { 0, 1.5, 0 }, { 3, 1, 1 } },
      { { VTK_POLYGON, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 2, 1, 4 } } });
  for (const Grid& mesh : { Warp(MakeHexahedra(3, 2, 2, true), 3), surface })
  {
    const auto scaled = [&mesh](int exponent)
    { return std::make_unique<Elements>(Scale(mesh, exponent)); };
    const auto usual = scaled(0);
    for (const int exponent :
      { 330, -330 }) // 1e99, 1e-99: volumes are numbers, their squares are not
    {
      const auto extreme = scaled(exponent);
      const auto compare =
        [exponent](vtkPolyData* expected, vtkPolyData* found, const std::vector<ElementArray>& rows)
      {
        for (const ElementArray& row : rows)
        {
          const int dimension = row.Unit == Unit::Length ? 1
            : row.Unit == Unit::Area                     ? 2
            : row.Unit == Unit::Volume                   ? 3
                                                         : 0;
          for (vtkIdType i = 0;
            expected->GetCellData()->HasArray(row.Name) && i < expected->GetNumberOfCells(); ++i)
          {
            const double value = std::ldexp(Get(found, row.Name, i), -exponent * dimension);
            const double before = Get(expected, row.Name, i);
            EXPECT_EQ(std::isnan(value), std::isnan(before)) << row.Name << " of " << i;
            if (!std::isnan(before))
            {
              EXPECT_NEAR(value, before, 1e-12 * std::max(1.0, std::abs(before)))
                << row.Name << " of " << i;
            }
          }
        }
      };
      compare(usual->Faces, extreme->Faces, GetFaceArrays());
      compare(usual->Edges, extreme->Edges, GetEdgeArrays());
      compare(usual->Vertices, extreme->Vertices, GetVertexArrays());
    }
  }
}

//------------------------------------------------------------------------------
// Bit for bit the same on one thread and on many.
TEST(MeshElements, IndependentOfThreads)
{
  const Grid grid = Warp(MakeTetrahedra(9), 9);
  std::vector<std::vector<double>> reference;
  for (const int threads : { 1, 2, 5 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
      [&]
      {
        const Elements elements(grid);
        std::vector<std::vector<double>> values;
        for (vtkPolyData* data :
          { elements.Faces.Get(), elements.Edges.Get(), elements.Vertices.Get() })
        {
          for (int a = 0; a < data->GetCellData()->GetNumberOfArrays(); ++a)
          {
            values.emplace_back();
            vtkDataArray* array = data->GetCellData()->GetArray(a);
            for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
            {
              const double value = array->GetComponent(i, 0);
              values.back().push_back(std::isnan(value) ? -1e300 : value);
            }
          }
        }
        reference = reference.empty() ? values : reference;
        EXPECT_EQ(reference, values) << threads;
      });
  }
}

//------------------------------------------------------------------------------
// Edges of curved cells are as long as the curve, whichever cell has them first and in whatever
// direction; those of linear cells, and straight ones, as the distance of their ends.
TEST(MeshElements, LengthsOfCurvedEdges)
{
  // A parabola through three points of a quarter of a circle, and an edge with its middle at 0.2.
  const double half = std::sqrt(0.5);
  const Points points = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0 }, { half, half, 0 }, { 0, 0.5, 0 },
    { 0.2, 0, 0 }, { 2, 2, 0 }, { 1.5, 1, 0 }, { 1, 1.5, 0 } };
  const std::vector<vtkIdType> below = { 0, 1, 2, 3, 4, 5 }, above = { 1, 0, 6, 3, 7, 8 };
  const std::map<std::pair<vtkIdType, vtkIdType>, double> expected = { { { 0, 1 }, 1.5624171253 },
    { { 1, 2 }, 1 }, { { 0, 2 }, 61.0 / 60 }, { { 0, 6 }, std::sqrt(5.0) },
    { { 1, 6 }, std::sqrt(5.0) } };
  double curved[2];
  for (const double scale : { 1.0, 1e-40, 1e40 })
  {
    for (const bool isTurned : { false, true })
    {
      Points scaled = points;
      for (Point& point : scaled)
      {
        for (double& coordinate : point)
        {
          coordinate *= scale;
        }
      }
      const Grid grid = MakeGrid(scaled,
        { { VTK_QUADRATIC_TRIANGLE, isTurned ? above : below },
          { VTK_QUADRATIC_TRIANGLE, isTurned ? below : above }, { VTK_TRIANGLE, { 0, 1, 2 } } });
      const MeshTopology topology(grid);
      const ElementContext context(grid, topology, EvaluationOptions());
      vtkNew<vtkPolyData> edges;
      MakeEdges(context, { "EdgeLength" }, edges);
      ASSERT_EQ(edges->GetNumberOfCells(), 5);
      for (vtkIdType edge = 0; edge < 5; ++edge)
      {
        const vtkIdType a = edges->GetCell(edge)->GetPointId(0),
                        b = edges->GetCell(edge)->GetPointId(1);
        const std::pair<vtkIdType, vtkIdType> ends = std::minmax(a, b);
        const double length = Get(edges, "EdgeLength", edge) / scale;
        EXPECT_NEAR(length, expected.at(ends), 2e-10) << ends.first << ' ' << ends.second;
        curved[isTurned] = ends.first == 0 && ends.second == 1 ? length : curved[isTurned];
      }
    }
    EXPECT_EQ(curved[0], curved[1]);
  }
}

//------------------------------------------------------------------------------
// Only what is asked for is there, and only where it means something.
TEST(MeshElements, Tables)
{
  const Grid row = MakeRow(1);
  const MeshTopology topology(row);
  const ElementContext context(row, topology, EvaluationOptions());
  vtkNew<vtkPolyData> edges;
  MakeEdges(context, { "EdgeLength", "BoundaryEdge" }, edges);
  EXPECT_EQ(edges->GetCellData()->GetNumberOfArrays(), 1);
  for (const auto* rows : { &GetFaceArrays(), &GetEdgeArrays(), &GetVertexArrays() })
  {
    std::set<std::pair<std::string, unsigned>> names;
    for (const ElementArray& array : *rows)
    {
      EXPECT_TRUE(names.emplace(array.Name, array.Dimensions).second) << array.Name;
      EXPECT_EQ((array.IdFunction != nullptr) + (array.FlagFunction != nullptr) +
          (array.RealFunction != nullptr) + (array.FacetFunction != nullptr) +
          (array.ShapeFunction != nullptr),
        1)
        << array.Name;
      EXPECT_GT(std::string(array.Description).size(), 10u);
      EXPECT_NE(std::string(array.Label), "") << array.Name;
      // A row is judged by a criterion of cells or by itself.
      const bool hasCriterion = array.Criterion[0] != '\0';
      EXPECT_EQ(hasCriterion, FindCriterion(array.Criterion) != nullptr) << array.Name;
      EXPECT_FALSE(hasCriterion && array.Better != Better::Neither) << array.Name;
    }
  }
}
