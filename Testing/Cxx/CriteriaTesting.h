// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CriteriaTesting.h
 * @brief What the tests of criteria share: all criteria of a mesh at once, and comparisons.
 */
#ifndef camaron_CriteriaTesting_h
#define camaron_CriteriaTesting_h

#include "Base/Number.h"
#include "Criteria/Evaluation.h"

#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace camaron
{
namespace testing
{

/// Of every cell, by the name of the criterion.
using Values = std::map<std::string, std::vector<double>>;

inline Values EvaluateAll(vtkDataSet* mesh, const EvaluationOptions& options = {})
{
  Values values;
  std::vector<CriterionValues> rows;
  for (const Criterion& criterion : GetCriteria())
  {
    auto& array = values[criterion.Name];
    array.resize(mesh->GetNumberOfCells());
    rows.push_back({ &criterion, array.data() });
  }
  EXPECT_TRUE(Evaluate(MeshTopology(mesh), options, rows, [](double) { return true; }));
  return values;
}

inline void ExpectWithin(double expected, double value, double tolerance, const std::string& what)
{
  if (std::isnan(expected) || std::isinf(expected))
  {
    EXPECT_TRUE(std::isnan(expected) ? std::isnan(value) : expected == value)
      << what << ": " << value << " instead of " << expected;
    return;
  }
  EXPECT_NEAR(expected, value, tolerance) << what;
}

/// A known value: a small one to as many digits as a large one, and of 0 there is a rest of 1e-12
/// at most.
inline void ExpectNear(double expected, double value, double relative, const std::string& what)
{
  ExpectWithin(expected, value,
    expected == 0 ? std::min(relative, 1e-12) : relative * std::abs(expected), what);
}

/// Two values of the same, which below 1 may differ by as much as at 1: many are rests of what
/// should be 0.
inline void ExpectSame(double a, double b, double relative, const std::string& what)
{
  ExpectWithin(a, b, relative * std::max(1.0, std::abs(a)), what);
}

inline void ExpectSame(const Values& a, const Values& b, double relative, const std::string& what,
  const std::vector<std::string>& except = {})
{
  for (const auto& row : a)
  {
    if (std::find(except.begin(), except.end(), row.first) != except.end())
    {
      continue;
    }
    const auto& other = b.at(row.first);
    ASSERT_EQ(row.second.size(), other.size());
    for (std::size_t i = 0; i < other.size(); ++i)
    {
      ExpectSame(row.second[i], other[i], relative, what + ' ' + row.first);
      EXPECT_EQ(GetNullReason(row.second[i]), GetNullReason(other[i])) << what << row.first;
    }
  }
}

inline Grid Transform(vtkUnstructuredGrid* grid, const std::function<Point(const Point&)>& map)
{
  auto result = Grid::New();
  result->DeepCopy(grid);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    Point p;
    grid->GetPoint(i, p.data());
    result->GetPoints()->SetPoint(i, map(p).data());
  }
  return result;
}

inline Grid MakePolygon(const Points& points)
{
  std::vector<vtkIdType> ids(points.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    ids[i] = static_cast<vtkIdType>(i);
  }
  const int size = static_cast<int>(points.size());
  return MakeGrid(points,
    { { size == 3   ? VTK_TRIANGLE
        : size == 4 ? VTK_QUAD
                    : VTK_POLYGON,
      ids } });
}
}
}

#endif
