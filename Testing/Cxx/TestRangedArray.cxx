// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Buffer.h"
#include "Base/Number.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>
#include <vector>

using namespace camaron;

namespace
{
//------------------------------------------------------------------------------
using Ranges = std::array<std::array<double, 2>, 4>;

// As ParaView asks for them, which gives everybody VTK's answer for an array of VTK.
Ranges GetRanges(vtkDataArray* array, vtkUnsignedCharArray* ghosts)
{
  vtkNew<vtkCellData> data;
  const int place = data->AddArray(array);
  if (ghosts)
  {
    data->AddArray(ghosts);
    data->SetGhostsToSkip(vtkDataSetAttributes::HIDDENCELL);
  }
  Ranges ranges;
  data->GetRange(place, ranges[0].data(), -1);
  data->GetFiniteRange(place, ranges[1].data(), 0);
  array->GetRange(ranges[2].data());
  array->GetFiniteRange(ranges[3].data());
  return ranges;
}

//------------------------------------------------------------------------------
template <typename Array>
void ExpectRangesOfVtk(const std::vector<double>& values)
{
  const auto size = static_cast<vtkIdType>(values.size());
  const auto ours = MakeLargeArray<Array>(size);
  ours->SetName("Values");
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    ours->SetValue(i, static_cast<typename Array::ValueType>(values[i]));
    const unsigned char marks[] = { 0, vtkDataSetAttributes::HIDDENCELL,
      vtkDataSetAttributes::DUPLICATECELL };
    ghosts->SetValue(i, marks[i % 3]);
  }
  vtkNew<Array> theirs;
  theirs->DeepCopy(ours);
  EXPECT_EQ(GetRanges(ours, nullptr), GetRanges(theirs, nullptr));
  EXPECT_EQ(GetRanges(ours, ghosts), GetRanges(theirs, ghosts));
}
}

//------------------------------------------------------------------------------
// A range that is not VTK's would give colors and histograms of other values; sizes are below and
// above what one thread does, and no multiple of the lanes.
TEST(RangedArray, HasRangesOfVtk)
{
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0, 1000);
  for (const std::size_t size : { 0, 1, 2, 3, 4, 7, 1000, 200001 })
  {
    std::vector<double> values(size);
    for (double& value : values)
    {
      value = normal(random);
    }
    ExpectRangesOfVtk<vtkDoubleArray>(values);
    ExpectRangesOfVtk<vtkFloatArray>(values);
    ExpectRangesOfVtk<vtkIdTypeArray>(values);
    for (std::size_t i = 0; i < size; i += 2)
    {
      values[i] = NaN;
    }
    ExpectRangesOfVtk<vtkDoubleArray>(values);
    for (std::size_t i = 1; i < size; i += 5)
    {
      values[i] = i % 2 ? Infinity : -Infinity;
    }
    ExpectRangesOfVtk<vtkDoubleArray>(values);
    ExpectRangesOfVtk<vtkDoubleArray>(std::vector<double>(size, NaN));
    ExpectRangesOfVtk<vtkDoubleArray>(std::vector<double>(size, Infinity));
    ExpectRangesOfVtk<vtkDoubleArray>(std::vector<double>(size, -1.5));
  }
}

//------------------------------------------------------------------------------
// Whoever gets the array may use it as any other one: a range that stays as it was, or is found of
// what is no longer there, would be wrong.
TEST(RangedArray, IsAnArrayLikeAnyOther)
{
  const auto array = MakeLargeArray<vtkDoubleArray>(2);
  array->SetValue(0, 3);
  array->SetValue(1, 4);
  EXPECT_EQ(array->GetRange()[1], 4);
  array->InsertNextValue(12);
  array->Modified();
  EXPECT_EQ(array->GetRange()[1], 12);
  array->SetNumberOfComponents(3);
  array->Modified();
  EXPECT_EQ(array->GetRange(2)[0], 12);
  EXPECT_EQ(array->GetRange(-1)[0], 13); // |(3, 4, 12)|
  EXPECT_STREQ(array->GetClassName(), "vtkDoubleArray");
  EXPECT_TRUE(vtkDoubleArray::FastDownCast(array));
  vtkSmartPointer<vtkDataArray> other;
  other.TakeReference(array->NewInstance());
  EXPECT_EQ(other->GetNumberOfValues(), 0);
  array->Initialize();
  array->Modified();
  EXPECT_GT(array->GetRange()[0], array->GetRange()[1]);
}
