// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elements/ElementArray.h"

#include "Base/Buffer.h"
#include "Base/Units.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
template <typename Array>
auto* Add(vtkPolyData* elements, const char* name)
{
  const auto array = MakeLargeArray<Array>(elements->GetNumberOfCells());
  array->SetName(name);
  std::fill_n(array->GetPointer(0), elements->GetNumberOfCells(), 0);
  elements->GetCellData()->AddArray(array);
  return array->GetPointer(0);
}

//------------------------------------------------------------------------------
// Sets the unit of an array of reals, and converts angles to it.
void SetUnit(vtkDoubleArray* array, enum Unit unit, AngleUnit angles)
{
  SetUnitLabel(array, GetUnitLabel(unit, angles));
  if (unit == Unit::Angle && angles == AngleUnit::Degrees)
  {
    constexpr double degree = 180 / 3.141592653589793238462643383279502884;
    double* values = array->GetPointer(0);
    // NaN keeps its reason.
    std::transform(values, values + array->GetNumberOfValues(), values,
      [](double value) { return std::isnan(value) ? value : degree * value; });
  }
}
}

//------------------------------------------------------------------------------
unsigned char* AddGhostArray(vtkPolyData* elements)
{
  return Add<vtkUnsignedCharArray>(elements, vtkDataSetAttributes::GhostArrayName());
}

//------------------------------------------------------------------------------
bool AddElementArrays(const ElementContext& context, const std::vector<ElementArray>& rows,
  const std::vector<std::string>& names, vtkPolyData* elements)
{
  vtkDataSet* piece = context.GetPiece();
  if (vtkPointSet* points = vtkPointSet::SafeDownCast(piece))
  {
    elements->SetPoints(points->GetPoints());
  }
  elements->GetPointData()->ShallowCopy(piece->GetPointData());
  const unsigned dimensions = context.GetDimensions();
  vtkCellData* data = elements->GetCellData();
  std::vector<const ElementArray*> ofFaces;
  std::vector<double*> faceValues;
  std::vector<std::pair<vtkDoubleArray*, enum Unit>> reals;
  constexpr double allOfFaces = 4; // they take the time of this number of other arrays
  const double steps = static_cast<double>(names.size()) + allOfFaces;
  double done = 0;
  for (const ElementArray& row : rows)
  {
    const bool isChosen = std::find(names.begin(), names.end(), row.Name) != names.end();
    if (!isChosen || !(row.Dimensions & dimensions) || data->HasArray(row.Name))
    {
      continue;
    }
    const ElementContext::Step step(context, done / steps, (done + 1) / steps);
    if (!context.GoesOn())
    {
      return false;
    }
    done += row.FacetFunction || row.ShapeFunction ? 0 : 1;
    if (row.IdFunction)
    {
      row.IdFunction(context, Add<vtkIdTypeArray>(elements, row.Name));
      continue;
    }
    if (row.FlagFunction)
    {
      row.FlagFunction(context, Add<vtkUnsignedCharArray>(elements, row.Name));
      continue;
    }
    double* values = Add<vtkDoubleArray>(elements, row.Name);
    reals.emplace_back(vtkDoubleArray::FastDownCast(data->GetArray(row.Name)), row.Unit);
    if (row.RealFunction)
    {
      row.RealFunction(context, values);
    }
    else
    {
      ofFaces.push_back(&row);
      faceValues.push_back(values);
    }
  }
  if (!ofFaces.empty())
  {
    const ElementContext::Step step(context, done / steps, 1);
    EvaluateFaces(context, ofFaces, faceValues);
  }
  for (const auto& array : reals)
  {
    SetUnit(array.first, array.second, context.GetOptions().Angles);
  }
  return context.GoesOn(1);
}
}
