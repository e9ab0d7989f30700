// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elements/ElementCriteria.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
Criterion ToCriterion(const ElementArray& row, bool isOfFaces)
{
  Criterion result;
  result.Range[0] = -HUGE_VAL;
  result.Range[1] = HUGE_VAL;
  if (const Criterion* ofCells = FindCriterion(row.Criterion))
  {
    std::copy_n(ofCells->Range, 2, result.Range);
    result.Ideal = ofCells->Ideal;
    result.Better = ofCells->Better;
    result.Notes.Consequence = ofCells->Notes.Consequence;
    if (isOfFaces && (ofCells->AcceptableFor & Polyhedra))
    {
      std::copy_n(ofCells->Acceptable, 2, result.Acceptable);
      result.AcceptableSource = ofCells->AcceptableSource;
      result.AcceptableIsHint = ofCells->AcceptableIsHint;
      result.AcceptableFor = Polygons;
    }
  }
  else
  {
    result.Ideal = row.Ideal;
    result.Better = row.Better;
  }
  result.Name = row.Name;
  result.Label = row.Label;
  result.Description = row.Description;
  result.AppliesTo = AnyCell;
  result.Unit = row.Unit;
  result.Kind = row.IdFunction || row.FlagFunction ? ValueKind::Integer : ValueKind::Real;
  return result;
}
}

//------------------------------------------------------------------------------
const std::vector<ElementTable>& GetElementTables()
{
  static const std::vector<ElementTable> tables = []
  {
    std::vector<ElementTable> all = { { "Face", GetFaceArrays(), {} },
      { "Edge", GetEdgeArrays(), {} }, { "Vertex", GetVertexArrays(), {} } };
    for (ElementTable& table : all)
    {
      for (const ElementArray& row : table.Arrays)
      {
        table.Criteria.push_back(ToCriterion(row, &table == &all.front()));
      }
    }
    return all;
  }();
  return tables;
}

//------------------------------------------------------------------------------
const Criterion* FindAnyCriterion(std::string_view name)
{
  if (const Criterion* ofCells = FindCriterion(name))
  {
    return ofCells;
  }
  for (const ElementTable& table : GetElementTables())
  {
    for (const Criterion& criterion : table.Criteria)
    {
      if (name == criterion.Name)
      {
        return &criterion;
      }
    }
  }
  return nullptr;
}
}
