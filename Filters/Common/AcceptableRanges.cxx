// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AcceptableRanges.h"

#include "Base/Parallel.h"
#include "Cell/CellGeometry.h"
#include "Cell/Shapes.h"
#include "Elements/ElementCriteria.h"
#include "Mesh/CellShape.h"
#include "Mesh/MeshView.h"
#include "MeshInput.h"
#include "PropertyValues.h"
#include "Rules/ParsedRules.h"
#include "Scan/MappedFile.h"

#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace camaron
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkStringArray> MakePresetNames(const char* first)
{
  auto names = vtkSmartPointer<vtkStringArray>::New();
  names->InsertNextValue(first);
  for (const Preset& preset : GetPresets())
  {
    names->InsertNextValue(preset.Name);
  }
  return names;
}

//------------------------------------------------------------------------------
std::vector<Preset::Rule> ReadRanges(const std::string& lines, const std::string& path,
  Reducer& reducer, const Criterion* (*find)(std::string_view))
{
  std::vector<Preset::Rule> rules = ParseRanges({ "Ranges", lines }, find);
  if (!path.empty())
  {
    const auto ofFile =
      ParseRanges({ GetFileName(path), ReadSmallFile(path, "a file of ranges", reducer) }, find);
    rules.insert(rules.end(), ofFile.begin(), ofFile.end());
  }
  return rules;
}

//------------------------------------------------------------------------------
AcceptableRanges::AcceptableRanges(
  const std::string& name, const std::string& file, Reducer& reducer, const std::string& lines)
  : IsDefault(lines.empty() && file.empty() && name == GetDefaultRangesName())
{
  const Preset* preset = FindPreset(name);
  if (!preset && name != GetDefaultRangesName())
  {
    throw std::invalid_argument("there is no preset named '" + name + "'");
  }
  this->Rules = ReadRanges(lines, file, reducer, FindAnyCriterion);
  if (preset)
  {
    this->Rules.insert(this->Rules.end(), preset->Rules.begin(), preset->Rules.end());
  }
}

//------------------------------------------------------------------------------
const Preset::Rule* AcceptableRanges::FindRule(const std::string& name) const
{
  const auto rule = std::find_if(this->Rules.begin(), this->Rules.end(),
    [&](const Preset::Rule& candidate) { return name == candidate.Criterion; });
  return rule == this->Rules.end() ? nullptr : &*rule;
}

//------------------------------------------------------------------------------
bool AcceptableRanges::HasRule(const std::string& name) const
{
  return this->IsDefault ? FindAnyCriterion(name) != nullptr : this->FindRule(name) != nullptr;
}

//------------------------------------------------------------------------------
bool AcceptableRanges::IsHint(const Criterion& criterion) const
{
  const Preset::Rule* const rule = this->FindRule(criterion.Name);
  return rule ? rule->IsHint : criterion.AcceptableIsHint;
}

namespace
{
//------------------------------------------------------------------------------
// Whether a range for some shapes applies to all cells to which the criterion applies.
bool IsForAll(unsigned shapes, unsigned appliesTo)
{
  shapes |= shapes & Polygons ? SimplePolygons : NoShapes;
  shapes |= shapes & Polyhedra ? SimplePolyhedra : NoShapes;
  return (shapes & AnyCell) || (appliesTo & ~shapes) == 0;
}
}

//------------------------------------------------------------------------------
std::optional<AcceptableRange> AcceptableRanges::Find(
  const std::string& name, const std::string& unit) const
{
  const Criterion* criterion = FindAnyCriterion(name);
  if (!criterion)
  {
    return std::nullopt;
  }
  AcceptableRange range;
  const Preset::Rule* const rule = this->FindRule(name);
  if (rule || criterion->HasAcceptableRange())
  {
    const double* const limits = rule ? rule->Acceptable : criterion->Acceptable;
    range.Low = limits[0];
    range.High = limits[1];
    range.Shapes = rule ? rule->AcceptableFor : criterion->AcceptableFor;
  }
  if (IsForAll(range.Shapes, criterion->AppliesTo))
  {
    range.Shapes = AnyCell;
  }
  if (std::isinf(range.Low) && std::isinf(range.High))
  {
    return std::nullopt;
  }
  if (criterion->Unit == Unit::Angle && unit == criterion->UnitLabel(AngleUnit::Radians))
  {
    range.Low = vtkMath::RadiansFromDegrees(range.Low);
    range.High = vtkMath::RadiansFromDegrees(range.High);
  }
  return range;
}

//------------------------------------------------------------------------------
unsigned GetJudgedShapes(const Criterion& criterion)
{
  return IsForAll(criterion.AcceptableFor, criterion.AppliesTo) ? AnyCell : criterion.AcceptableFor;
}

//------------------------------------------------------------------------------
const char* GetBetterName(Better better)
{
  return better == Better::Bigger ? "Bigger" : better == Better::Smaller ? "Smaller" : "Neither";
}

//------------------------------------------------------------------------------
std::optional<WorstEnd> FindWorstEnd(const std::string& name)
{
  const Criterion* criterion = FindAnyCriterion(name);
  if (!criterion)
  {
    return std::nullopt;
  }
  if (criterion->Better == Better::Neither)
  {
    // A one-sided range implies a bad end: a volume must be above zero.
    const bool low = std::isfinite(criterion->Acceptable[0]);
    const bool high = std::isfinite(criterion->Acceptable[1]);
    return low == high ? std::nullopt
                       : std::optional<WorstEnd>(low ? WorstEnd::Smallest : WorstEnd::Largest);
  }
  return criterion->Better == Better::Smaller ? WorstEnd::Largest : WorstEnd::Smallest;
}

//------------------------------------------------------------------------------
std::optional<WorstEnd> FindWorstEnd(const std::string& name, const std::string& choice)
{
  return ParseChoice<std::optional<WorstEnd>>("Worst Values", choice,
    { { "By criterion", FindWorstEnd(name) }, { "Largest", WorstEnd::Largest },
      { "Smallest", WorstEnd::Smallest } });
}

namespace
{
constexpr int MaxSimpleFaces = 6; // polyhedra with more faces are general polyhedra
using ShapesOfTypes = std::array<unsigned, 256>;

//------------------------------------------------------------------------------
const ShapesOfTypes& GetShapesOfTypes()
{
  static const ShapesOfTypes shapes = []
  {
    ShapesOfTypes result = {};
    for (int type = 0; type < 256; ++type)
    {
      const CellShape& shape = GetCellShape(static_cast<unsigned char>(type));
      if (shape.Dimension == 2)
      {
        const int corners = shape.NumberOfCorners;
        result[type] = Polygons |
          (corners == 3      ? Triangles
              : corners == 4 ? Quadrilaterals
                             : NoShapes);
      }
      else if (shape.Dimension == 3)
      {
        result[type] = Polyhedra |
          (shape.ListsFaces
              ? NoShapes
              : FindSimpleShape(CellGeometry::GetTopologyOfType(static_cast<unsigned char>(type))));
      }
    }
    return result;
  }();
  return shapes;
}

//------------------------------------------------------------------------------
// Whether the type of a cell is not sufficient to find its shape.
bool DependsOnTopology(const MeshView& mesh, vtkIdType cell, const CellShape& shape)
{
  return shape.ListsFaces ? mesh.GetPolyhedronFaces(cell).Size <= MaxSimpleFaces
                          : shape.Dimension == 2 && shape.NumberOfCorners == 0;
}
}

//------------------------------------------------------------------------------
std::vector<std::uint16_t> FindCellShapes(vtkDataSet* data)
{
  const ShapesOfTypes& ofTypes = GetShapesOfTypes();
  std::vector<std::uint16_t> shapes(data->GetNumberOfCells());
  const auto numberOfCells = static_cast<vtkIdType>(shapes.size());
  if (!vtkUnstructuredGrid::SafeDownCast(data) && !vtkPolyData::SafeDownCast(data))
  {
    for (vtkIdType cell = 0; cell < numberOfCells; ++cell)
    {
      shapes[cell] = static_cast<std::uint16_t>(ofTypes[data->GetCellType(cell) & 255]);
    }
    return shapes;
  }
  const vtkSmartPointer<vtkDataSet> owner = AsMesh(data);
  const MeshView mesh(owner);
  const EvaluationOptions options;
  constexpr vtkIdType grain = 1 << 13;
  ParallelFor(numberOfCells, grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      CellGeometry geometry;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const unsigned char type = mesh.GetCellType(cell);
        unsigned found = ofTypes[type];
        if (DependsOnTopology(mesh, cell, GetCellShape(type)))
        {
          geometry.Load(mesh, cell, options);
          found = geometry.GetShapes();
        }
        shapes[cell] = static_cast<std::uint16_t>(found);
      }
    });
  return shapes;
}

//------------------------------------------------------------------------------
bool BlockShapes::Judge(BlockValues& values, const std::optional<AcceptableRange>& range)
{
  if (!range || (range->Shapes & AnyCell) || this->Blocks.GetKind() != ElementKind::Cells)
  {
    return false;
  }
  if (this->Shapes.empty())
  {
    for (const ElementBlock& block : this->Blocks.Get())
    {
      this->Shapes.push_back(FindCellShapes(block.Data));
    }
  }
  values.SetShapes(this->Shapes, range->Shapes);
  return true;
}
}
