// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellField.h"

#include "Base/Number.h"
#include "Base/Parallel.h"
#include "Mesh/MeshView.h"
#include "MeshInput.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace camaron
{
namespace
{
// Coordinates of a point, and the value there.
using Sample = std::array<double, 4>;

//------------------------------------------------------------------------------
double GetMagnitude(vtkDataArray* array, vtkIdType i)
{
  const int size = array->GetNumberOfComponents();
  double length = size == 1 ? array->GetComponent(i, 0) : 0;
  for (int c = 0; c < size && size > 1; ++c)
  {
    length = std::hypot(length, array->GetComponent(i, c));
  }
  return length;
}

//------------------------------------------------------------------------------
double FindMean(const std::vector<Sample>& samples)
{
  double sum = 0;
  for (const Sample& sample : samples)
  {
    sum += sample[3];
  }
  return samples.empty() ? NaN : sum / static_cast<double>(samples.size());
}

//------------------------------------------------------------------------------
std::vector<double> FromPoints(vtkDataSet* data, vtkDataArray* array)
{
  const vtkSmartPointer<vtkDataSet> mesh = AsMesh(data);
  const MeshView view(mesh);
  std::vector<double> values(view.GetNumberOfCells());
  ParallelFor(view.GetNumberOfCells(), 1 << 12,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<Sample> samples;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const IndexRange points = view.GetCellPoints(cell);
        samples.resize(points.Size);
        for (vtkIdType i = 0; i < points.Size; ++i)
        {
          view.GetPoint(points[i], samples[i].data());
          samples[i][3] = GetMagnitude(array, points[i]);
        }
        // The order of points in the cell may depend on how the mesh was split.
        std::sort(samples.begin(), samples.end());
        values[cell] = FindMean(samples);
      }
    });
  return values;
}

//------------------------------------------------------------------------------
std::vector<double> FromCells(vtkDataArray* array)
{
  std::vector<double> values(array->GetNumberOfTuples());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = GetMagnitude(array, static_cast<vtkIdType>(i));
  }
  return values;
}
}

//------------------------------------------------------------------------------
CellField::CellField(
  const ElementBlocks& blocks, const std::string& name, bool isOfPoints, Reducer& reducer)
{
  std::size_t numberOfArrays = 0;
  for (const ElementBlock& block : blocks.Get())
  {
    vtkDataArray* array =
      block.Data->GetAttributes(isOfPoints ? vtkDataObject::POINT : vtkDataObject::CELL)
        ->GetArray(name.c_str());
    numberOfArrays += array != nullptr;
    this->Rests = this->Rests || (array && !GetRests(array).empty());
    this->Values.push_back(!array ? std::vector<double>()
        : isOfPoints              ? FromPoints(block.Data, array)
                                  : FromCells(array));
  }
  blocks.RequireAny(numberOfArrays,
    "there is no " + std::string(isOfPoints ? "point" : "cell") + " array named '" + name + "'",
    reducer);
}
}
