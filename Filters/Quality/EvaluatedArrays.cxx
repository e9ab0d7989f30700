// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EvaluatedArrays.h"

#include "Base/Hash.h"

#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <tuple>
#include <utility>

namespace camaron
{
//------------------------------------------------------------------------------
bool EvaluatedArrays::Source::operator==(const Source& other) const
{
  return std::tie(this->Arrays, this->Time, this->Points, this->Block) ==
    std::tie(other.Arrays, other.Time, other.Points, other.Block);
}

//------------------------------------------------------------------------------
bool EvaluatedArrays::Choice::operator==(const Choice& other) const
{
  const auto get = [](const Choice& of)
  {
    const EvaluationOptions& options = of.Options;
    return std::tie(options.Angles, options.TrustFaceOrientation, options.DegeneracyTolerance,
      options.ConvexityTolerance, options.PlanarityTolerance, options.ChecksStarShape,
      of.ConnectsBlocks, of.NumberOfPieces);
  };
  return get(*this) == get(other);
}

//------------------------------------------------------------------------------
EvaluatedArrays::Source EvaluatedArrays::GetSource(const DataSetLeaf& leaf)
{
  Source source;
  source.Block = leaf.Number;
  source.Arrays = ConnectivityKey(leaf.Data).GetArrays();
  const auto add = [&](vtkDataArray* array)
  {
    source.Arrays.emplace_back(
      array, array ? array->GetMTime() : 0, array ? array->GetNumberOfValues() : 0);
  };
  auto* points = vtkPointSet::SafeDownCast(leaf.Data);
  if (points && !source.Arrays.empty())
  {
    // Coordinates are hashed, because they are often modified in place.
    vtkDataArray* const coordinates =
      points->GetPoints() ? points->GetPoints()->GetData() : nullptr;
    add(coordinates);
    source.Points = coordinates ? HashContent(coordinates, 1) : 0;
  }
  else
  {
    source.Time = leaf.Data->GetMTime();
  }
  add(leaf.Data->GetCellGhostArray());
  add(leaf.Data->GetPointGhostArray());
  add(leaf.Data->GetPointData()->GetGlobalIds());
  add(leaf.Data->GetCellData()->GetGlobalIds());
  return source;
}

//------------------------------------------------------------------------------
std::uint64_t EvaluatedArrays::HashValues() const
{
  std::uint64_t hash = 1;
  for (const auto& kept : this->Kept)
  {
    for (vtkDoubleArray* array : kept.second)
    {
      hash = HashContent(array, hash);
    }
  }
  return hash;
}

//------------------------------------------------------------------------------
void EvaluatedArrays::Check(const std::vector<DataSetLeaf>& leaves,
  const EvaluationOptions& options, bool connectsBlocks, int numberOfPieces, Reducer& reducer)
{
  const Choice choice = { options, connectsBlocks, numberOfPieces };
  std::vector<Source> sources;
  for (const DataSetLeaf& leaf : leaves)
  {
    sources.push_back(GetSource(leaf));
  }
  std::int64_t isSame =
    sources == this->Sources && choice == this->Chosen && this->HashValues() == this->Content;
  reducer.Min(&isSame, 1);
  if (!isSame)
  {
    this->Clear();
  }
  this->Sources = std::move(sources);
  this->Chosen = choice;
}

//------------------------------------------------------------------------------
void EvaluatedArrays::Clear()
{
  this->Sources.clear();
  this->Kept.clear();
  this->Content = 0;
}

//------------------------------------------------------------------------------
const EvaluatedArrays::Arrays* EvaluatedArrays::Find(const std::string& criterion) const
{
  const auto found = this->Kept.find(criterion);
  return found == this->Kept.end() ? nullptr : &found->second;
}

//------------------------------------------------------------------------------
void EvaluatedArrays::Keep(std::map<std::string, Arrays> arrays)
{
  this->Kept = std::move(arrays);
  this->Content = this->HashValues();
}
}
