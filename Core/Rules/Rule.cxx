// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rules/Rule.h"

#include "Base/Number.h"
#include "Elements/ElementCriteria.h"
#include "Rules/RuleLine.h"

#include "vtkCellType.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <tuple>

namespace camaron
{
namespace
{
constexpr double Largest = std::numeric_limits<double>::max();
constexpr double SmallestLimit = 1e-300; // smaller positive limits mean "above zero"

//------------------------------------------------------------------------------
std::string Join(const std::vector<std::string>& words, const char* separator)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() || word.empty() ? "" : separator) + word;
  }
  return text;
}

//------------------------------------------------------------------------------
// Integers as they are, other numbers with up to 6 digits.
std::string ToShortText(double value)
{
  constexpr double mostOfIntegers = 1e6;
  constexpr int precision = 6;
  std::string text;
  if (value == std::trunc(value) && std::abs(value) < mostOfIntegers)
  {
    AppendNumber(text, static_cast<int>(value));
    return text;
  }
  char digits[32];
  text.append(digits,
    std::to_chars(digits, digits + sizeof(digits), value, std::chars_format::general, precision)
      .ptr);
  return text;
}

//------------------------------------------------------------------------------
std::string ToExactText(double value)
{
  std::string text;
  AppendNumber(text, value);
  return text;
}

//------------------------------------------------------------------------------
// A range with a function that writes numbers, and the words between two included limits.
std::string WriteRange(
  const Rule& rule, std::string (*write)(double), const char* before, const char* between)
{
  if (rule.Low == rule.High && rule.LowIncluded && rule.HighIncluded)
  {
    return "= " + write(rule.Low);
  }
  const bool isPositive = rule.Low > 0 && rule.Low < SmallestLimit;
  const std::string low = isPositive ? "0" : write(rule.Low), high = write(rule.High);
  const bool includesLow = rule.LowIncluded && !isPositive;
  if (rule.Low > -Infinity && rule.High < Infinity && includesLow && rule.HighIncluded)
  {
    return before + low + between + high;
  }
  return Join({ rule.Low > -Infinity ? (includesLow ? ">= " : "> ") + low : "",
                rule.High < Infinity ? (rule.HighIncluded ? "<= " : "< ") + high : "" },
    " ");
}

//------------------------------------------------------------------------------
const std::vector<std::pair<const char*, unsigned>>& GetShapeNames()
{
  static const std::vector<std::pair<const char*, unsigned>> names = { { "2D cells", Polygons },
    { "3D cells", Polyhedra }, { "triangles", Triangles }, { "quadrangles", Quadrilaterals },
    { "tetrahedra", Tetrahedra }, { "pyramids", Pyramids }, { "wedges", Wedges },
    { "hexahedra", Hexahedra } };
  return names;
}
}

//------------------------------------------------------------------------------
const std::vector<CellFamily>& GetCellFamilies()
{
  static const std::vector<CellFamily> families = { { "triangles", VTK_TRIANGLE },
    { "quadrangles", VTK_QUAD }, { "polygons", VTK_POLYGON }, { "tetrahedra", VTK_TETRA },
    { "pyramids", VTK_PYRAMID }, { "wedges", VTK_WEDGE }, { "hexahedra", VTK_HEXAHEDRON },
    { "polyhedra", VTK_POLYHEDRON } };
  return families;
}

//------------------------------------------------------------------------------
const std::vector<std::string>& GetJudgedElements()
{
  static const std::vector<std::string> names = { "cells", "faces", "edges", "vertices" };
  return names;
}

//------------------------------------------------------------------------------
const std::vector<Criterion>* GetCriteriaOf(const std::string& elements)
{
  const std::vector<std::string>& known = GetJudgedElements();
  const auto found = std::find(known.begin(), known.end(), elements);
  return found == known.end() ? nullptr
    : found == known.begin()  ? &GetCriteria()
                              : &GetElementTables()[found - known.begin() - 1].Criteria;
}

//------------------------------------------------------------------------------
std::string Rule::GetElements(std::int64_t count) const
{
  const std::string plural = this->IsOfCells() ? "cells" : this->Scope->Value;
  return count != 1        ? plural
    : plural == "vertices" ? "vertex"
                           : plural.substr(0, plural.size() - 1);
}

//------------------------------------------------------------------------------
const Criterion* Rule::FindCriterion() const
{
  for (const camaron::Criterion& criterion : *GetCriteriaOf(this->GetElements()))
  {
    if (this->Criterion == criterion.Name)
    {
      return &criterion;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
bool Scope::operator==(const Scope& other) const
{
  return std::tie(this->Kind, this->Value, this->Array) ==
    std::tie(other.Kind, other.Value, other.Array);
}

//------------------------------------------------------------------------------
const char* Scope::GetName() const
{
  constexpr const char* names[] = { "shape", "type", "block", "array", "elements" };
  return names[static_cast<int>(this->Kind)];
}

//------------------------------------------------------------------------------
std::string Scope::GetText() const
{
  switch (this->Kind)
  {
    case ScopeKind::Family:
    case ScopeKind::Elements:
      return "of " + this->Value;
    case ScopeKind::CellType:
      return "of type " + QuoteName(this->Value);
    case ScopeKind::Block:
      return "in " + QuoteName(this->Value);
    default:
      return "where " + QuoteName(this->Array) + " = " + this->Value;
  }
}

//------------------------------------------------------------------------------
std::vector<int> Scope::GetFamilyIds() const
{
  const std::string list = ", " + this->Value + ", ";
  const auto has = [&](const std::string& name)
  { return list.find(", " + name + ", ") != std::string::npos; };
  std::vector<int> ids;
  for (const CellFamily& family : GetCellFamilies())
  {
    const bool isFlat =
      family.Id == VTK_TRIANGLE || family.Id == VTK_QUAD || family.Id == VTK_POLYGON;
    if (has(family.Name) || has(isFlat ? "2D cells" : "3D cells"))
    {
      ids.push_back(family.Id);
    }
  }
  return ids;
}

//------------------------------------------------------------------------------
std::optional<Scope> ToScope(unsigned shapes)
{
  std::vector<std::string> names;
  for (const auto& [name, shape] : GetShapeNames())
  {
    if (shapes & shape)
    {
      names.emplace_back(name);
    }
  }
  const bool isAll =
    (shapes & AnyCell) || names.empty() || (shapes & PolygonsAndPolyhedra) == PolygonsAndPolyhedra;
  return isAll ? std::nullopt
               : std::make_optional<Scope>({ ScopeKind::Family, Join(names, ", "), "" });
}

//------------------------------------------------------------------------------
Tolerance Tolerance::OfPercent(double percent, const std::string& text)
{
  Tolerance tolerance;
  tolerance.Percent = percent;
  tolerance.Exact = text;
  return tolerance;
}

//------------------------------------------------------------------------------
Tolerance Tolerance::OfCells(std::int64_t count)
{
  Tolerance tolerance;
  tolerance.Count = count;
  tolerance.Exact = std::to_string(count);
  return tolerance;
}

//------------------------------------------------------------------------------
std::int64_t Tolerance::GetCells(std::int64_t checked) const
{
  if (!this->Percent)
  {
    return this->Count;
  }
  // A product that is an integer but for rounding is that integer: 29 % of 100.
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  const double cells = static_cast<double>(checked) * *this->Percent / 100;
  return std::min(checked, static_cast<std::int64_t>(std::floor(cells * (1 + rounding))));
}

//------------------------------------------------------------------------------
std::string Tolerance::GetText() const
{
  return this->Percent ? ToShortText(*this->Percent) + "%" : this->Exact;
}

//------------------------------------------------------------------------------
bool Rule::HasRange() const
{
  return this->Low > -Infinity || this->High < Infinity;
}

//------------------------------------------------------------------------------
double Rule::GetLeast() const
{
  const double low = std::max(this->Low, -Largest);
  return this->LowIncluded ? low : std::nextafter(low, Infinity);
}

//------------------------------------------------------------------------------
double Rule::GetMost() const
{
  const double high = std::min(this->High, Largest);
  return this->HighIncluded ? high : std::nextafter(high, -Infinity);
}

//------------------------------------------------------------------------------
std::string Rule::GetRangeText() const
{
  return WriteRange(*this, ToShortText, "", " to ");
}

//------------------------------------------------------------------------------
std::string Rule::GetText() const
{
  return Join({ this->Criterion, this->GetRangeText(), this->GetScopeText() }, " ");
}

//------------------------------------------------------------------------------
std::string Rule::GetLineText() const
{
  return Join({ this->Criterion,
                this->HasRange() ? WriteRange(*this, ToExactText, "", " ") : std::string("* *"),
                this->GetScopeText(),
                this->Tolerance.IsZero() ? "" : "tolerate " + this->Tolerance.GetExactText(),
                this->UndefinedFails ? "" : "undefined passes" },
    " ");
}
}
