// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The ranges that a reader leaves with the points are those that VTK computes.
#include "PointRanges.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace camaron;

namespace
{
template <typename Array>
vtkSmartPointer<Array> MakeCoordinates(vtkIdType size)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(size);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-7, 3);
  for (vtkIdType i = 0; i < 3 * size; ++i)
  {
    array->SetValue(i, static_cast<typename Array::ValueType>(anywhere(random)));
  }
  return array;
}

void SetPoints(vtkUnstructuredGrid* grid, vtkDataArray* coordinates)
{
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  grid->SetPoints(points);
}

// Compares with what VTK computes of a copy, of which it knows nothing.
void ExpectRangesOfVTK(vtkUnstructuredGrid* grid)
{
  vtkDataArray* found = grid->GetPoints()->GetData();
  vtkSmartPointer<vtkDataArray> copy;
  copy.TakeReference(found->NewInstance());
  copy->SetNumberOfComponents(3);
  copy->InsertTuples(0, found->GetNumberOfTuples(), 0, found);
  const auto expectSame = [](const double* a, const double* b, int size)
  {
    for (int i = 0; i < size; ++i)
    {
      EXPECT_EQ(a[i], b[i]) << i;
    }
  };
  for (int c = -1; c < 3; ++c)
  {
    double range[2], expected[2];
    found->GetRange(range, c);
    copy->GetRange(expected, c);
    expectSame(range, expected, 2);
    found->GetFiniteRange(range, c);
    copy->GetFiniteRange(expected, c);
    expectSame(range, expected, 2);
  }
  vtkNew<vtkPoints> points;
  points->SetData(copy);
  expectSame(grid->GetPoints()->GetBounds(), points->GetBounds(), 6);
  grid->ComputeBounds();
  expectSame(grid->GetBounds(), points->GetBounds(), 6);
}

template <typename Array>
void TestRanges(vtkIdType size)
{
  const auto coordinates = MakeCoordinates<Array>(size);
  vtkNew<vtkUnstructuredGrid> grid;
  SetPoints(grid, coordinates);
  FindPointRanges(grid);
  EXPECT_EQ(grid->GetPoints()->GetData(), coordinates);
  EXPECT_EQ(coordinates->GetInformation()->Has(vtkDataArray::L2_NORM_FINITE_RANGE()), size > 0);
  ExpectRangesOfVTK(grid);
}
}

//------------------------------------------------------------------------------
TEST(PointRanges, AreThoseOfVTK)
{
  for (const vtkIdType size : { 0, 1, 2, 1000, 200000 })
  {
    TestRanges<vtkFloatArray>(size);
    TestRanges<vtkDoubleArray>(size);
  }
}

//------------------------------------------------------------------------------
// What is not finite has two kinds of ranges, and VTK's rules for NaN are VTK's.
TEST(PointRanges, AreLeftToVTKWhereTheyAreNotFinite)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double odd : { std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, 1e200 })
  {
    const auto coordinates = MakeCoordinates<vtkDoubleArray>(100000);
    coordinates->SetComponent(77777, 1, odd);
    vtkNew<vtkUnstructuredGrid> grid;
    SetPoints(grid, coordinates);
    EXPECT_FALSE(FindPointRanges(grid));
    EXPECT_FALSE(coordinates->GetInformation()->Has(vtkDataArray::L2_NORM_RANGE()));
    if (odd == odd)
    {
      ExpectRangesOfVTK(grid);
    }
  }
}

//------------------------------------------------------------------------------
// Whatever the type of the coordinates, and in a piece by the places in the whole mesh.
TEST(PointRanges, PointsThatAreNotFiniteAreCounted)
{
  const auto coordinates = MakeCoordinates<vtkDoubleArray>(200000);
  vtkNew<vtkUnstructuredGrid> grid;
  EXPECT_EQ(FindNotFinitePoints(grid).Count, 0);
  SetPoints(grid, coordinates);
  EXPECT_EQ(FindNotFinitePoints(grid).Count, 0);
  coordinates->SetComponent(150000, 2, std::numeric_limits<double>::quiet_NaN());
  coordinates->SetComponent(77777, 1, std::numeric_limits<double>::infinity());
  coordinates->SetComponent(77777, 2, -std::numeric_limits<double>::infinity());
  coordinates->SetComponent(9, 0, 1e200); // finite, though its square is not
  EXPECT_EQ(FindNotFinitePoints(grid).Count, 2);
  EXPECT_EQ(FindNotFinitePoints(grid).First, 77777);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("GlobalPointIds");
  ids->SetNumberOfValues(200000);
  for (vtkIdType i = 0; i < 200000; ++i)
  {
    ids->SetValue(i, 1000000 - i);
  }
  grid->GetPointData()->AddArray(ids);
  EXPECT_EQ(FindNotFinitePoints(grid).First, 850000);
}

//------------------------------------------------------------------------------
// Otherwise a filter that moves points in place would show the bounds of before.
TEST(PointRanges, FollowModifiedCoordinates)
{
  const auto coordinates = MakeCoordinates<vtkFloatArray>(1000);
  vtkNew<vtkUnstructuredGrid> grid;
  SetPoints(grid, coordinates);
  FindPointRanges(grid);
  ExpectRangesOfVTK(grid);
  coordinates->SetComponent(500, 2, 100);
  coordinates->Modified();
  ExpectRangesOfVTK(grid);
  EXPECT_EQ(grid->GetBounds()[5], 100);
}
