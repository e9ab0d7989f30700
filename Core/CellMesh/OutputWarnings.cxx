// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellMesh/OutputWarnings.h"

#include "Mesh/CellFacets.h"
#include "Mesh/MeshView.h"
#include "Mesh/Vector.h"
#include "Parallel.h"
#include "Scan/MappedFile.h"
#include "Scan/Number.h"
#include "Scan/RealFormat.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>

namespace camaron
{
namespace
{
constexpr int MaxComponents = 3; // of what is checked
constexpr vtkIdType ChunkSize = 1 << 16; // tuples that a thread checks in a row
constexpr const char* TimeArrayName = "TimeValue"; // of field data of readers of time steps

//------------------------------------------------------------------------------
// Whether a number is the same as one of so many significant decimal digits.
bool HasDigits(double value, int digits)
{
  if (value == 0 || !std::isfinite(value))
  {
    return true;
  }
  // A quotient of integers and powers of ten that are exact is the number nearest to the decimal one.
  constexpr int MaxPower = 22;
  constexpr double MaxInteger = 9007199254740992.; // 2^53
  const int decimals = digits - 1 - static_cast<int>(std::floor(std::log10(std::fabs(value))));
  if (std::abs(decimals) <= MaxPower)
  {
    static const auto powers = []
    {
      std::array<double, MaxPower + 1> all;
      all[0] = 1;
      for (std::size_t i = 1; i < all.size(); ++i)
      {
        all[i] = 10 * all[i - 1];
      }
      return all;
    }();
    const double power = powers[static_cast<std::size_t>(std::abs(decimals))];
    const double integer = std::round(decimals > 0 ? value * power : value / power);
    if (std::fabs(integer) < MaxInteger)
    {
      return (decimals > 0 ? integer / power : integer * power) == value;
    }
  }
  std::string text;
  RealFormat::Exponent(digits - 1).Append(text, value);
  double rounded = 0;
  ParseReal(text.data(), text.data() + text.size(), rounded);
  return rounded == value;
}

//------------------------------------------------------------------------------
// Whether the corners of a cell, no polyhedron, enclose a negative volume; not so if it may be
// zero.
bool IsInverted(const MeshView& mesh, CellFacets& facets, vtkIdType cell)
{
  const auto getPoint = [&mesh](vtkIdType id)
  {
    double x[3];
    mesh.GetPoint(id, x);
    return Vector{ x[0], x[1], x[2] };
  };
  constexpr double Rounding = 1e-12;
  const IndexRange nodes = mesh.GetCellPoints(cell);
  const Vector origin = getPoint(nodes[0]);
  if (mesh.GetCellType(cell) == VTK_TETRA)
  {
    // The same as below in short; most large meshes are of tetrahedra.
    const Vector a = getPoint(nodes[1]) - origin, b = getPoint(nodes[2]) - origin;
    const Vector c = getPoint(nodes[3]) - origin, area = Cross(a, b);
    const double volume = Dot(area, c);
    return volume < 0 && volume * volume > Rounding * Rounding * Norm2(area) * Norm2(c);
  }
  double volume = 0, sum = 0;
  facets.ForEach(cell,
    [&](const vtkIdType* points, vtkIdType size, vtkIdType)
    {
      // Of faces that are not plane, the mean of all ways to cut them.
      Vector center, area;
      Vector last = getPoint(points[size - 1]) - origin;
      for (vtkIdType i = 0; i < size; ++i)
      {
        const Vector x = getPoint(points[i]) - origin;
        center += x;
        area += Cross(last, x);
        last = x;
      }
      const double part = Dot(center, area) / static_cast<double>(size);
      volume += part;
      sum += std::fabs(part);
    });
  return volume < -Rounding * sum;
}

//------------------------------------------------------------------------------
// What tuples are called in messages.
struct TupleNames
{
  const char* Values;
  const char* One;
  const char* Many;
};

//------------------------------------------------------------------------------
// See CheckSinglePrecision; getTuple(id, values) may be called in parallel.
template <typename GetTuple>
bool CheckTuples(vtkIdType size, int components, GetTuple&& getTuple, const TupleNames& names,
  const std::string& path, Warnings& warnings, ScanError& error)
{
  constexpr double Greatest = std::numeric_limits<float>::max();
  const auto isTooLarge = [](double v) { return std::isfinite(v) && std::fabs(v) > Greatest; };
  Tally rounded, tooLarge;
  std::mutex mutex;
  ParallelFor(size, ChunkSize,
    [&](vtkIdType begin, vtkIdType end)
    {
      const auto isExact = [](double v) { return !std::isfinite(v) || static_cast<float>(v) == v; };
      Tally roundedHere, tooLargeHere;
      for (vtkIdType id = begin; id < end; ++id)
      {
        double x[MaxComponents];
        getTuple(id, x);
        if (std::any_of(x, x + components, isTooLarge))
        {
          tooLargeHere.Add(id);
        }
        else if (!std::all_of(x, x + components, isExact))
        {
          roundedHere.Add(id);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      rounded.Merge(roundedHere);
      tooLarge.Merge(tooLargeHere);
    });
  if (tooLarge.Count > 0)
  {
    double x[MaxComponents];
    getTuple(tooLarge.First, x);
    std::string found;
    AppendNumber(found, *std::find_if(x, x + components, isTooLarge));
    error = { ErrorKind::Unsupported,
      GetFileName(path) + ": expected " + names.Values +
        " up to 3.4e38, as they are written in single precision, found " + found + " of " +
        names.One + " " + std::to_string(tooLarge.First) };
    return false;
  }
  warnings.Add(rounded, names.One, names.Many, "rounded to single precision");
  return true;
}
}

//------------------------------------------------------------------------------
std::string DescribeArray(vtkAbstractArray* array)
{
  return array->GetName() && *array->GetName() ? array->GetName() : "an array without name";
}

//------------------------------------------------------------------------------
std::string DescribeArray(vtkDataSet* mesh, vtkAbstractArray* array, bool ofCells)
{
  const std::string name = DescribeArray(array);
  vtkFieldData* const others =
    ofCells ? static_cast<vtkFieldData*>(mesh->GetPointData()) : mesh->GetCellData();
  return others->HasArray(name.c_str()) ? name + (ofCells ? " of cells" : " of points") : name;
}

//------------------------------------------------------------------------------
void WarnOfArrays(
  vtkDataSet* mesh, const char* format, Warnings& warnings, const WrittenArrays& written)
{
  std::string arrays, fields;
  const auto list = [](vtkFieldData* data, const char* ownName, const vtkAbstractArray* globalIds,
                      const std::vector<std::string>& known, std::string& names, auto&& describe)
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      const std::string name = DescribeArray(array);
      if (array != globalIds && name != ownName &&
        std::find(known.begin(), known.end(), name) == known.end())
      {
        names += (names.empty() ? "" : ", ") + describe(array);
      }
    }
  };
  const char* const ghosts = vtkDataSetAttributes::GhostArrayName();
  vtkDataSetAttributes *const points = mesh->GetPointData(), *const cells = mesh->GetCellData();
  list(points, ghosts, points->GetGlobalIds(), written.Points, arrays,
    [mesh](vtkAbstractArray* array) { return DescribeArray(mesh, array, false); });
  list(cells, ghosts, cells->GetGlobalIds(), written.Cells, arrays,
    [mesh](vtkAbstractArray* array) { return DescribeArray(mesh, array, true); });
  list(mesh->GetFieldData(), TimeArrayName, nullptr, written.Fields, fields,
    [](vtkAbstractArray* array) { return DescribeArray(array); });
  if (!arrays.empty())
  {
    warnings.Add(std::string(format) +
      (written.Points.empty() && written.Cells.empty()
          ? " holds no arrays; not written: "
          : " cannot hold some arrays; not written: ") +
      arrays);
  }
  if (!fields.empty())
  {
    warnings.Add(std::string(format) +
      (written.Fields.empty() ? " holds no field data; not written: "
                              : " cannot hold some field data; not written: ") +
      fields);
  }
}

//------------------------------------------------------------------------------
bool CheckSinglePrecision(
  vtkDataSet* mesh, const std::string& path, Warnings& warnings, ScanError& error)
{
  const MeshView view(mesh);
  if (view.HasFloatPoints())
  {
    return true;
  }
  return CheckTuples(
    view.GetNumberOfPoints(), 3, [&view](vtkIdType id, double* x) { view.GetPoint(id, x); },
    { "coordinates", "point", "points" }, path, warnings, error);
}

//------------------------------------------------------------------------------
bool CheckSinglePrecision(vtkDataArray* array, int components, const char* one, const char* many,
  const std::string& path, Warnings& warnings, ScanError& error)
{
  if (!array || array->GetDataType() == VTK_FLOAT)
  {
    return true;
  }
  const int size = std::min(components, array->GetNumberOfComponents());
  return CheckTuples(
    array->GetNumberOfTuples(), size,
    [array, size](vtkIdType id, double* values)
    {
      for (int c = 0; c < size; ++c)
      {
        values[c] = array->GetComponent(id, c);
      }
    },
    { many, one, many }, path, warnings, error);
}

//------------------------------------------------------------------------------
void WarnOfDigits(vtkDataSet* mesh, int digits, Warnings& warnings)
{
  constexpr double EnoughOfSize = 1e-6;
  const int allDigits = MeshView(mesh).HasFloatPoints() ? 9 : 17;
  double bounds[6];
  mesh->GetBounds(bounds);
  const double greatest = std::fabs(*std::max_element(bounds, bounds + 6,
    [](double a, double b) { return std::fabs(a) < std::fabs(b); }));
  if (digits <= 0 || digits >= allDigits || mesh->GetNumberOfPoints() == 0 || !(greatest > 0) ||
    !std::isfinite(greatest))
  {
    return;
  }
  const double lastDigit = std::pow(10, std::floor(std::log10(greatest)) + 1 - digits);
  const double size = mesh->GetLength();
  if (size > 0 && lastDigit > EnoughOfSize * size)
  {
    std::string step, length;
    AppendNumber(step, static_cast<float>(lastDigit));
    AppendNumber(length, static_cast<float>(size));
    warnings.Add("coordinates are kept to " + step + " only, of a mesh of size " + length +
      ", as it is far from the origin: set Digits to 17 to keep them");
    return;
  }
  const MeshView view(mesh);
  Tally rounded;
  std::mutex mutex;
  ParallelFor(view.GetNumberOfPoints(), ChunkSize,
    [&](vtkIdType begin, vtkIdType end)
    {
      Tally roundedHere;
      for (vtkIdType id = begin; id < end; ++id)
      {
        double x[3];
        view.GetPoint(id, x);
        if (!std::all_of(x, x + 3, [digits](double v) { return HasDigits(v, digits); }))
        {
          roundedHere.Add(id);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      rounded.Merge(roundedHere);
    });
  const std::string fate =
    "rounded to " + std::to_string(digits) + " digits (Digits 17 keeps all)";
  warnings.Add(rounded, "point", "points", fate.c_str());
}

//------------------------------------------------------------------------------
void WarnOfInvertedCells(vtkDataSet* mesh, const char* format, Warnings& warnings)
{
  const MeshView view(mesh);
  Tally inverted;
  std::mutex mutex;
  ParallelFor(view.GetNumberOfCells(), ChunkSize,
    [&](vtkIdType begin, vtkIdType end)
    {
      Tally invertedHere;
      CellFacets facets(view);
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const CellShape& shape = GetCellShape(view.GetCellType(cell));
        if (shape.Dimension == 3 && !shape.ListsFaces && IsInverted(view, facets, cell))
        {
          invertedHere.Add(cell);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      inverted.Merge(invertedHere);
    });
  const std::string fate = std::string("inside out, which is lost, as ") + format +
    " files do not say on which side of a face a cell is";
  warnings.Add(inverted, "cell", "cells", fate.c_str());
}
}
