// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Components: named sets of nodes or elements.
#include "Base/Parallel.h"
#include "Base/Text.h"
#include "MAPDLMesh.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
struct Range
{
  std::int64_t First;
  std::int64_t Last;
};

//------------------------------------------------------------------------------
// Reads the ids of a component: -b after a means all from a to b.
bool ReadRanges(
  const MAPDLComponent& component, std::vector<Range>& ranges, vtkIdType& count, MAPDLFault& fault)
{
  constexpr char Expected[] = "the number of a member of a component";
  count = 0;
  for (const char* text = component.Begin; text < component.End;)
  {
    const Line line(text, component.End);
    text = line.Next;
    if (ClassifyMAPDLLine(line) != MAPDLLine::Row)
    {
      continue;
    }
    const int fields = component.Fields.CountIntegers(line);
    for (int i = 0; i < fields; ++i)
    {
      std::int64_t value;
      if (!component.Fields.Read(line, i, Expected, value, fault))
      {
        return false;
      }
      ++count;
      if (value > 0)
      {
        ranges.push_back({ value, value });
      }
      else if (value < 0 && !ranges.empty() && -value >= ranges.back().First)
      {
        ranges.back().Last = -value;
      }
      else if (value < 0)
      {
        return fault.Set(line.Begin, ErrorKind::Syntax, Expected, std::to_string(value));
      }
    }
  }
  if (!component.IsEnded && count < component.NumberOfValues)
  {
    return fault.Set(component.End, ErrorKind::Truncated, "more members of a component");
  }
  return true;
}

//------------------------------------------------------------------------------
// Sorts ranges and merges overlaps.
void Unite(std::vector<Range>& ranges)
{
  std::sort(
    ranges.begin(), ranges.end(), [](const Range& a, const Range& b) { return a.First < b.First; });
  std::size_t kept = 0;
  for (const Range& range : ranges)
  {
    if (kept > 0 && range.First <= ranges[kept - 1].Last + 1)
    {
      ranges[kept - 1].Last = std::max(ranges[kept - 1].Last, range.Last);
    }
    else
    {
      ranges[kept++] = range;
    }
  }
  ranges.resize(kept);
}

//------------------------------------------------------------------------------
// Whether a single id is not defined in the deck; ranges may have gaps.
bool HasUndefined(const std::vector<Range>& ranges, const IdMap& map)
{
  return std::any_of(ranges.begin(), ranges.end(),
    [&](const Range& range) { return range.First == range.Last && map.Find(range.First) < 0; });
}

//------------------------------------------------------------------------------
// Sets flags[getIndex(position)] of the members.
template <typename GetIndex>
void Mark(const std::vector<Range>& ranges, const Buffer<std::int32_t>& ids, unsigned char* flags,
  GetIndex&& getIndex)
{
  ParallelFor(ids.size(), LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      // Ids mostly ascend, so that an id is in the same range as the one before, or in the next.
      auto after = ranges.begin(); // the first range beyond the id
      for (vtkIdType position = begin; position < end; ++position)
      {
        const std::int64_t id = ids[position];
        if ((after != ranges.end() && after->First <= id) ||
          (after != ranges.begin() && (after - 1)->First > id))
        {
          after = std::upper_bound(ranges.begin(), ranges.end(), id,
            [](std::int64_t sought, const Range& range) { return sought < range.First; });
        }
        const bool isMember = after != ranges.begin() && id <= (after - 1)->Last;
        if (const vtkIdType index = isMember ? getIndex(position) : -1; index >= 0)
        {
          flags[index] = 1;
        }
      }
    });
}
}

//------------------------------------------------------------------------------
bool MAPDLMesh::AddComponents(const CellMeshPiece& piece, std::size_t textSize,
  vtkUnstructuredGrid* grid, Warnings& warnings, const Progress& progress)
{
  const std::vector<MAPDLComponent>& components = this->Deck.Components;
  const auto size = static_cast<vtkIdType>(components.size());
  std::vector<std::vector<Range>> ranges(components.size());
  std::vector<MAPDLFault> faults(components.size());
  std::vector<vtkIdType> counts(components.size());
  if (!progress.Part(0, 0.5).For(size,
        [&](vtkIdType first, vtkIdType last)
        {
          for (vtkIdType i = first; i < last; ++i)
          {
            ReadRanges(components[i], ranges[i], counts[i], faults[i]);
            Unite(ranges[i]);
          }
        }))
  {
    return false;
  }
  IdMap elements;
  if (size > 0)
  {
    elements.Build(this->ElementIds.data(), this->ElementIds.size());
  }
  vtkIdType wrongCounts = 0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (faults[i])
    {
      this->Fault = faults[i];
      return false;
    }
    const MAPDLComponent& component = components[i];
    wrongCounts += component.NumberOfValues >= 0 && counts[i] < component.NumberOfValues;
  }
  vtkNew<vtkStringArray> nodeNames, elementNames;
  nodeNames->SetName("NodeComponents");
  elementNames->SetName("ElementComponents");
  // Many empty components of a large mesh would need far more memory than the size of the file.
  constexpr std::size_t LeastBound = std::size_t(1) << 26;
  const std::size_t bound = std::max(LeastBound, 8 * textSize);
  std::size_t bytes = 0;
  vtkIdType leftOut = 0, undefined = 0;
  for (vtkIdType i = 0; i < size && progress.Report(0.5 + 0.5 * i / size); ++i)
  {
    const MAPDLComponent& component = components[i];
    const bool ofNodes = component.OfNodes;
    bytes +=
      static_cast<std::size_t>(ofNodes ? this->GetNumberOfPoints() : this->GetNumberOfCells());
    if (bytes > bound)
    {
      ++leftOut;
      continue;
    }
    Buffer<unsigned char> flags(ofNodes ? piece.GetNumberOfPoints() : piece.GetNumberOfCells());
    std::fill(flags.data(), flags.data() + flags.size(), static_cast<unsigned char>(0));
    undefined += HasUndefined(ranges[i], ofNodes ? this->Nodes : elements);
    if (ofNodes)
    {
      Mark(ranges[i], this->NodeIds, flags.data(),
        [&piece](vtkIdType point) { return piece.FindPoint(point); });
    }
    else
    {
      Mark(ranges[i], this->ElementIds, flags.data(),
        [&piece](vtkIdType cell) { return piece.FindCell(cell); });
    }
    const auto array = flags.TakeArray<vtkUnsignedCharArray>();
    array->SetName(component.Name.c_str());
    vtkStringArray* const names = ofNodes ? nodeNames : elementNames;
    if (names->LookupValue(component.Name) < 0)
    {
      names->InsertNextValue(component.Name);
    }
    vtkDataSetAttributes* const attributes =
      ofNodes ? static_cast<vtkDataSetAttributes*>(grid->GetPointData()) : grid->GetCellData();
    attributes->AddArray(array);
  }
  for (vtkStringArray* names : { nodeNames.Get(), elementNames.Get() })
  {
    if (names->GetNumberOfValues() > 0)
    {
      grid->GetFieldData()->AddArray(names);
    }
  }
  if (wrongCounts > 0)
  {
    warnings.Add(CountOf(wrongCounts, "component has fewer members than it declares",
      "components have fewer members than they declare"));
  }
  if (undefined > 0)
  {
    warnings.Add(CountOf(undefined, "component refers to", "components refer to") +
      " nodes or elements that the deck does not define");
  }
  if (leftOut > 0)
  {
    warnings.Add(CountOf(leftOut, "component is", "components are") +
      " omitted, as all of them need far more memory than the size of the file");
  }
  return !progress.IsStopped();
}
}
