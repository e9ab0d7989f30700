// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/CellMesh/OutputWarnings.h"

#include "Base/Number.h"
#include "Base/Parallel.h"
#include "Base/Text.h"
#include "Cell/CellGeometry.h"
#include "Intake/CellMesh/OutputMesh.h"
#include "Intake/Write/RealFormat.h"
#include "Mesh/CellFacets.h"
#include "Mesh/MeshView.h"
#include "Scan/MappedFile.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <mutex>

namespace camaron
{
namespace
{
constexpr int MaxComponents = 3;                             // limit of components checked
constexpr std::uint64_t MaxInteger = std::uint64_t(1) << 53; // limit of integers that double
                                                             // represents exactly
constexpr const char* TimeArrayName = "TimeValue"; // set as field data by readers of time series

//------------------------------------------------------------------------------
// The number nearest to a number that has this many significant decimal digits.
double RoundToDigits(double value, int digits)
{
  if (value == 0 || !std::isfinite(value))
  {
    return value;
  }
  // A quotient of exact integers and powers of ten is the double nearest to the decimal number.
  constexpr int MaxPower = static_cast<int>(std::size(detail::PowersOfTen)) - 1;
  const int decimals = digits - 1 - static_cast<int>(std::floor(std::log10(std::fabs(value))));
  if (std::abs(decimals) <= MaxPower)
  {
    const double power = detail::PowersOfTen[std::abs(decimals)];
    const double integer = std::round(decimals > 0 ? value * power : value / power);
    if (std::fabs(integer) < static_cast<double>(MaxInteger))
    {
      return decimals > 0 ? integer / power : integer * power;
    }
  }
  std::string text;
  RealFormat::Exponent(digits - 1).Append(text, value);
  double rounded = 0;
  ParseReal(text.data(), text.data() + text.size(), rounded);
  return rounded;
}

//------------------------------------------------------------------------------
bool IsExactInDouble(const vtkVariant& value)
{
  const bool isNegative =
    !value.IsUnsignedLong() && !value.IsUnsignedLongLong() && value.ToTypeInt64() < 0;
  const std::uint64_t bits = value.ToTypeUInt64();
  std::uint64_t magnitude = isNegative ? 0 - bits : bits;
  while (magnitude > MaxInteger && magnitude % 2 == 0)
  {
    magnitude /= 2;
  }
  return magnitude <= MaxInteger;
}

//------------------------------------------------------------------------------
// Counts the ids for which a test is true, in parallel; each thread has its own copy of the test.
template <typename Test>
Tally CountWhere(vtkIdType size, const Test& test)
{
  Tally count;
  std::mutex mutex;
  ParallelFor(size, LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      Test testHere = test;
      Tally countHere;
      for (vtkIdType id = begin; id < end; ++id)
      {
        if (testHere(id))
        {
          countHere.Add(id);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      count.Merge(countHere);
    });
  return count;
}

//------------------------------------------------------------------------------
// Number of significant decimal digits that tell all coordinates apart.
int GetExactDigits(const MeshView& mesh)
{
  return mesh.HasFloatPoints() ? std::numeric_limits<float>::max_digits10
                               : std::numeric_limits<double>::max_digits10;
}

//------------------------------------------------------------------------------
// The sign of the volume of a 3D cell as its faces are oriented; 0 if it is flat or not finite.
int GetSignOfVolume(const MeshView& mesh, CellFacets& facets, vtkIdType cell)
{
  constexpr double Flat = 1e-12; // relative to the cube of the size
  double volume = 0, size = 0;
  Vector origin;
  facets.ForEach(cell,
    [&](const vtkIdType* points, vtkIdType count, vtkIdType local)
    {
      origin = local == 0 && count > 0 ? mesh.GetPoint(points[0]) : origin;
      for (vtkIdType i = 1; i + 1 < count; ++i)
      {
        const Vector a = mesh.GetPoint(points[0]) - origin, b = mesh.GetPoint(points[i]) - origin,
                     c = mesh.GetPoint(points[i + 1]) - origin;
        volume += Dot(a, Cross(b, c));
        size = std::max(size, std::sqrt(std::max({ Norm2(a), Norm2(b), Norm2(c) })));
      }
    });
  return std::abs(volume) > Flat * size * size * size ? (volume > 0) - (volume < 0) : 0;
}

//------------------------------------------------------------------------------
// Calls visit(a, b) for the edges of a 1D, 2D or 3D cell.
template <typename Visit>
void ForEachEdge(const MeshView& mesh, CellFacets& facets, vtkIdType cell, Visit&& visit)
{
  if (facets.GetDimension(cell) != 1)
  {
    facets.ForEachEdge(cell, visit);
    return;
  }
  const IndexRange points = mesh.GetCellPoints(cell);
  for (vtkIdType i = 0; i + 1 < points.Size; ++i)
  {
    visit(points[i], points[i + 1]);
  }
}

//------------------------------------------------------------------------------
// Counts the written points with more significant digits.
Tally CountRounded(const OutputMesh& output, int digits)
{
  return CountWhere(output.GetNumberOfPoints(),
    [&output, digits](vtkIdType point)
    {
      double x[3];
      output.GetPoint(point, x);
      return std::any_of(
        x, x + 3, [digits](double v) { return v == v && RoundToDigits(v, digits) != v; });
    });
}

//------------------------------------------------------------------------------
// Whether coordinates are among the numbers with this many digits; else some may be.
bool AreExact(const MeshView& mesh, int digits)
{
  return digits == AllDigits || (digits == DigitsOfFloat && mesh.HasFloatPoints()) ||
    digits >= GetExactDigits(mesh);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> RoundPoints(vtkPoints* points, int digits)
{
  const auto rounded = vtkSmartPointer<vtkPoints>::New();
  rounded->SetDataType(digits == DigitsOfFloat ? VTK_FLOAT : VTK_DOUBLE);
  rounded->GetData()->DeepCopy(points->GetData());
  if (auto* const doubles = vtkDoubleArray::SafeDownCast(rounded->GetData()))
  {
    double* const values = doubles->GetPointer(0);
    ParallelFor(doubles->GetNumberOfValues(), LightGrain,
      [=](vtkIdType begin, vtkIdType end)
      {
        std::transform(values + begin, values + end, values + begin,
          [digits](double value) { return RoundToDigits(value, digits); });
      });
  }
  return rounded;
}

//------------------------------------------------------------------------------
// Names of tuples in messages.
struct TupleNames
{
  const char* Values;
  const char* One;
  const char* Many;
};

//------------------------------------------------------------------------------
// See CheckSinglePrecision; getTuple(id, values) must be thread-safe.
template <typename GetTuple>
bool CheckTuples(vtkIdType size, int components, GetTuple&& getTuple, const TupleNames& names,
  const std::string& path, Warnings& warnings, ScanError& error)
{
  constexpr double Greatest = std::numeric_limits<float>::max();
  const auto isTooLarge = [](double v) { return std::isfinite(v) && std::fabs(v) > Greatest; };
  const auto isRounded = [](double v) { return std::isfinite(v) && static_cast<float>(v) != v; };
  const auto count = [&](auto&& test)
  {
    return CountWhere(size,
      [&](vtkIdType id)
      {
        double x[MaxComponents];
        getTuple(id, x);
        return std::any_of(x, x + components, test);
      });
  };
  const Tally tooLarge = count(isTooLarge);
  if (tooLarge.Count > 0)
  {
    double x[MaxComponents];
    getTuple(tooLarge.First, x);
    std::string found;
    AppendNumber(found, *std::find_if(x, x + components, isTooLarge));
    error = { ErrorKind::Unsupported,
      GetFileName(path) + ": expected " + names.Values +
        " up to 3.4e38, because they are written in single precision, found " + found + " of " +
        names.One + " " + std::to_string(tooLarge.First) };
    return false;
  }
  warnings.Add(count(isRounded), names.One, names.Many, "rounded to single precision");
  return true;
}
}

//------------------------------------------------------------------------------
std::string DescribeArray(vtkAbstractArray* array)
{
  return array->GetName() && *array->GetName() ? array->GetName() : "an unnamed array";
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
void WarnOfArrays(vtkDataSet* mesh, const char* format, Warnings& warnings,
  const std::optional<WrittenArrays>& known)
{
  const WrittenArrays written = known.value_or(WrittenArrays());
  std::string arrays, fields;
  const auto list = [](vtkFieldData* data, const char* ownName, const vtkAbstractArray* globalIds,
                      const std::vector<std::string>& own, std::string& names, auto&& describe)
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      const std::string name = DescribeArray(array);
      if (array != globalIds && name != ownName &&
        std::find(own.begin(), own.end(), name) == own.end())
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
      (!known ? " stores no arrays; not written: "
          : written.Points.empty() && written.Cells.empty()
          ? " stores no other arrays; not written: "
          : " cannot store some arrays; not written: ") +
      arrays);
  }
  if (!fields.empty())
  {
    warnings.Add(std::string(format) +
      (written.Fields.empty() ? " stores no field data; not written: "
                              : " cannot store some field data; not written: ") +
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
bool CheckRoundedCells(vtkDataSet* mesh, int digits, const std::string& path, ScanError& error)
{
  constexpr double MaxChange = 0.01;
  // An edge that is shorter than this part of its coordinates is none: so many ulps are lost by
  // computing them.
  constexpr double Noise = 64 * std::numeric_limits<double>::epsilon();
  const MeshView view(mesh);
  auto* const points = vtkPointSet::SafeDownCast(mesh);
  if (!points || points->GetNumberOfPoints() == 0 || AreExact(view, digits))
  {
    return true;
  }
  const auto rounded = vtkSmartPointer<vtkPointSet>::Take(points->NewInstance());
  rounded->ShallowCopy(points);
  rounded->SetPoints(RoundPoints(points->GetPoints(), digits));
  const MeshView roundedView(rounded);

  struct Worst
  {
    double Change = MaxChange;
    vtkIdType Cell = -1;
  };
  Worst worst;
  vtkIdType firstTurned = -1; // or flattened
  std::mutex mutex;
  ParallelFor(view.GetNumberOfCells(), MediumGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      Worst worstHere;
      vtkIdType turnedHere = -1;
      CellFacets facets(view);
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        ForEachEdge(view, facets, cell,
          [&](vtkIdType a, vtkIdType b)
          {
            const Vector from = view.GetPoint(a), to = view.GetPoint(b);
            const double length = Norm(to - from),
                         now = Norm(roundedView.GetPoint(b) - roundedView.GetPoint(a)),
                         change = std::abs(now - length) / length; // NaN if both are 0
            const bool isNoise = length <= Noise * std::max(Norm(from), Norm(to));
            worstHere = change > worstHere.Change && std::isfinite(now) && !isNoise
              ? Worst{ change, cell }
              : worstHere;
          });
        if (turnedHere < 0 && facets.GetDimension(cell) == 3)
        {
          const int sign = GetSignOfVolume(view, facets, cell);
          turnedHere =
            sign != 0 && sign != GetSignOfVolume(roundedView, facets, cell) ? cell : turnedHere;
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      if (worstHere.Change > worst.Change ||
        (worstHere.Change == worst.Change && worstHere.Cell < worst.Cell))
      {
        worst = worstHere;
      }
      if (turnedHere >= 0 && (firstTurned < 0 || turnedHere < firstTurned))
      {
        firstTurned = turnedHere;
      }
    });
  if (worst.Cell < 0 && firstTurned < 0)
  {
    return true;
  }
  std::string found =
    "cell " + std::to_string(firstTurned) + ", which rounding inverts or flattens";
  if (worst.Cell >= 0)
  {
    found = "an edge of cell " + std::to_string(worst.Cell) + " that changes by ";
    AppendNumber(found, std::round(1000 * worst.Change) / 10);
    found += " %";
  }
  error = { ErrorKind::Unsupported,
    GetFileName(path) + ": expected cells that keep their shape " +
      (digits == DigitsOfFloat ? "in single precision"
                               : "with coordinates of " + std::to_string(digits) + " digits") +
      ", found " + found +
      (digits == DigitsOfFloat ? ": move" : ": write more digits (Digits), move") +
      " the mesh to the origin, or allow rounding (Allow Rounding)" };
  return false;
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
void WarnOfIntegers(vtkDataArray* array, Warnings& warnings)
{
  constexpr int sizeOfLong = 8;
  if (array->GetDataTypeSize() < sizeOfLong || array->GetDataType() == VTK_DOUBLE)
  {
    return;
  }
  const int components = array->GetNumberOfComponents();
  double greatest = 0;
  for (int c = 0; c < components; ++c)
  {
    const double* const range = array->GetFiniteRange(c);
    greatest = std::max({ greatest, -range[0], range[1] }); // the range of an empty array is
                                                            // reversed
  }
  // Ranges are rounded, too.
  if (greatest < static_cast<double>(MaxInteger))
  {
    return;
  }
  const Tally rounded = CountWhere(array->GetNumberOfTuples(),
    [&](vtkIdType tuple)
    {
      bool isExact = true;
      for (int c = 0; c < components; ++c)
      {
        isExact &= IsExactInDouble(array->GetVariantValue(tuple * components + c));
      }
      return !isExact;
    });
  const std::string fate = "of the array " + DescribeArray(array) + " rounded to double";
  warnings.Add(rounded, "value", "values", fate.c_str());
}

//------------------------------------------------------------------------------
int ChooseDigits(vtkDataSet* mesh, const OutputMesh& output)
{
  constexpr int few = std::numeric_limits<float>::max_digits10;
  const int exact = GetExactDigits(MeshView(mesh));
  return exact > few && CountRounded(output, few).Count == 0 ? few : exact;
}

//------------------------------------------------------------------------------
void WarnOfDigits(vtkDataSet* mesh, const OutputMesh& output, int digits, Warnings& warnings)
{
  constexpr double EnoughOfSize = 1e-6;
  double bounds[6];
  mesh->GetBounds(bounds);
  const double greatest = std::fabs(*std::max_element(
    bounds, bounds + 6, [](double a, double b) { return std::fabs(a) < std::fabs(b); }));
  if (AreExact(MeshView(mesh), digits) || mesh->GetNumberOfPoints() == 0 || !(greatest > 0) ||
    !std::isfinite(greatest))
  {
    return;
  }
  Tally rounded = CountRounded(output, digits);
  if (rounded.Count == 0)
  {
    return;
  }
  const auto getLastDigit = [digits](double value)
  { return std::pow(10, std::floor(std::log10(value)) + 1 - digits); };
  const double lastDigit = getLastDigit(greatest);
  const double size = mesh->GetLength();
  if (size > 0 && lastDigit > EnoughOfSize * size)
  {
    std::string step, length;
    RealFormat::Significant(6).Append(step, lastDigit);
    RealFormat::Significant(6).Append(length, size);
    const double sizeDigit = getLastDigit(size); // at the origin
    warnings.Add("coordinates are rounded to multiples of " + step + " in a mesh of size " +
      length +
      (sizeDigit > EnoughOfSize * size ? ", because they have " + CountOf(digits, "digit", "digits")
                                       : ", because it is far from the origin") +
      "; set Digits to 17 for full precision");
    return;
  }
  rounded.First = output.GetInputPoint(rounded.First);
  const std::string fate =
    "rounded to " + std::to_string(digits) + " digits (set Digits to 17 for full precision)";
  warnings.Add(rounded, "point", "points", fate.c_str());
}

//------------------------------------------------------------------------------
void WarnOfInvertedCells(vtkDataSet* mesh, const char* format, Warnings& warnings)
{
  const MeshView view(mesh);
  EvaluationOptions options;
  options.DegeneracyTolerance =
    1e-12; // regardless of the precision of the points, because flat cells have no orientation
  const Tally inverted = CountWhere(view.GetNumberOfCells(),
    [&, geometry = CellGeometry()](vtkIdType cell) mutable
    {
      const CellShape& shape = GetCellShape(view.GetCellType(cell));
      if (shape.Dimension != 3 || shape.ListsFaces)
      {
        return false;
      }
      geometry.Load(view, cell, options);
      geometry.Normalize();
      if (!geometry.IsFinite())
      {
        return false;
      }
      geometry.Compute(NeedsVolume);
      return geometry.GetVolume() < 0 && !geometry.IsZeroVolume(geometry.GetVolume());
    });
  const std::string fate = std::string("with inverted orientation, which is lost because ") +
    format + " files do not store on which side of a face a cell lies";
  warnings.Add(inverted, "cell", "cells", fate.c_str());
}
}
