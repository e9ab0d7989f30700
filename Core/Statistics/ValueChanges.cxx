// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/ValueChanges.h"

#include <cmath>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
void AddChange(const ExactValue& from, const ExactValue& to, Better better, double tolerance,
  ValueChanges& changes)
{
  const double before = from.Value, after = to.Value;
  const bool wasNull = std::isnan(before), isNull = std::isnan(after);
  if (wasNull && isNull)
  {
    return;
  }
  ++changes.Compared;
  if (wasNull || isNull)
  {
    ++(wasNull ? changes.Improved : changes.Worsened);
    return;
  }
  // Halves, because the difference of two numbers may be out of range; infinities are unchanged if
  // equal.
  const double limit = tolerance * std::max(std::abs(before), std::abs(after)) / 2;
  const bool areClose =
    std::isfinite(limit) && std::abs(after / 2 - before / 2 + (to.Rest - from.Rest) / 2.0) <= limit;
  if (from == to || areClose)
  {
    ++changes.Unchanged;
  }
  else if (better != Better::Neither)
  {
    ++((from < to) == (better == Better::Bigger) ? changes.Improved : changes.Worsened);
  }
}
}

//------------------------------------------------------------------------------
ValueChanges CountChanges(const Population& before, const Population& after, Better better,
  double tolerance, Reducer& reducer)
{
  std::int64_t counts[4] = {};
  for (const ValueChanges& part : ForEachChunk<ValueChanges>(after,
         [&](ValueChanges& changes, const ValueBlock& block, vtkIdType begin, vtkIdType end)
         {
           const ValueBlock& other = before[&block - after.data()];
           for (vtkIdType i = begin; i < end; ++i)
           {
             if (block.Contains(i))
             {
               AddChange(other.GetExact(i), block.GetExact(i), better, tolerance, changes);
             }
           }
         }))
  {
    counts[0] += part.Compared;
    counts[1] += part.Improved;
    counts[2] += part.Worsened;
    counts[3] += part.Unchanged;
  }
  reducer.Sum(counts, 4);
  return { counts[0], counts[1], counts[2], counts[3] };
}

//------------------------------------------------------------------------------
void FindDifferences(const ValueBlock& before, const ValueBlock& after, vtkIdType begin,
  vtkIdType end, double* differences)
{
  for (vtkIdType i = begin; i < end; ++i)
  {
    const ExactValue from = before.GetExact(i), to = after.GetExact(i);
    differences[i] = from == to ? 0 : to.Value - from.Value + (to.Rest - from.Rest);
  }
}
}
