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
#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

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
double FindGradient(const std::vector<Sample>& samples)
{
  Sample mean = { 0, 0, 0, 0 };
  for (const Sample& sample : samples)
  {
    for (int i = 0; i < 4; ++i)
    {
      mean[i] += sample[i] / static_cast<double>(samples.size());
    }
  }
  double matrix[3][3] = {}, right[3] = {}, vectors[3][3];
  for (const Sample& sample : samples)
  {
    for (int i = 0; i < 3; ++i)
    {
      right[i] += (sample[i] - mean[i]) * (sample[3] - mean[3]);
      for (int j = 0; j < 3; ++j)
      {
        matrix[i][j] += (sample[i] - mean[i]) * (sample[j] - mean[j]);
      }
    }
  }
  const double trace = matrix[0][0] + matrix[1][1] + matrix[2][2];
  if (!(trace > 0) || !std::isfinite(trace + right[0] + right[1] + right[2]))
  {
    return NaN;
  }
  double* rows[3] = { matrix[0], matrix[1], matrix[2] };
  double* columns[3] = { vectors[0], vectors[1], vectors[2] };
  double extents[3]; // squared, the largest first
  vtkMath::Jacobi(rows, extents, columns);
  // Directions in which the points do not extend, such as the normal of a polygon, do not
  // contribute to the gradient.
  constexpr double flat = 1e-12; // squared ratio of extents
  double length = 0;
  for (int i = 0; i < 3; ++i)
  {
    const double along =
      vectors[0][i] * right[0] + vectors[1][i] * right[1] + vectors[2][i] * right[2];
    length = extents[i] > flat * extents[0] ? std::hypot(length, along / extents[i]) : length;
  }
  return length;
}

//------------------------------------------------------------------------------
std::vector<double> FromPoints(vtkDataSet* data, vtkDataArray* array, bool takesGradient)
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
        values[cell] = takesGradient ? FindGradient(samples) : FindMean(samples);
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
CellField::CellField(const ElementBlocks& blocks, const std::string& name, bool isOfPoints,
  bool takesGradient, Reducer& reducer)
{
  if (takesGradient && !isOfPoints)
  {
    throw std::invalid_argument(
      "gradients need a point array; Cell Data To Point Data creates one from a cell array");
  }
  std::size_t numberOfArrays = 0;
  for (const ElementBlock& block : blocks.Get())
  {
    vtkDataArray* array =
      block.Data->GetAttributes(isOfPoints ? vtkDataObject::POINT : vtkDataObject::CELL)
        ->GetArray(name.c_str());
    numberOfArrays += array != nullptr;
    this->Rests = this->Rests || (array && !GetRests(array).empty());
    this->Values.push_back(!array ? std::vector<double>()
        : isOfPoints              ? FromPoints(block.Data, array, takesGradient)
                                  : FromCells(array));
  }
  blocks.RequireAny(numberOfArrays,
    "there is no " + std::string(isOfPoints ? "point" : "cell") + " array named '" + name + "'",
    reducer);
}
}
