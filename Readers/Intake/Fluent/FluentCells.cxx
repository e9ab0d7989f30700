// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentCells.h"

#include "Intake/Fluent/FluentNumbers.h"

#include <algorithm>

namespace camaron
{
namespace
{
constexpr int MaxElement = 7;

constexpr FluentShape Shapes[] = { {}, { VTK_TRIANGLE, 3, 3, 2 }, { VTK_TETRA, 4, 4, 3 },
  { VTK_QUAD, 4, 4, 2 }, { VTK_HEXAHEDRON, 8, 6, 3 }, { VTK_PYRAMID, 5, 5, 3 },
  { VTK_WEDGE, 6, 5, 3 }, { VTK_POLYHEDRON } };

//------------------------------------------------------------------------------
// The cell type of a number, if it exists in this dimension.
FluentElement GetElement(std::int64_t number, int dimension)
{
  const int own = Shapes[number].Dimension;
  return own == 0 || own == dimension ? static_cast<FluentElement>(number) : FluentElement::Unknown;
}
}

//------------------------------------------------------------------------------
FluentShape GetFluentShape(FluentElement element, int dimension)
{
  return element == FluentElement::Polyhedron && dimension == 2
    ? FluentShape{ VTK_POLYGON }
    : Shapes[static_cast<std::size_t>(element)];
}

//------------------------------------------------------------------------------
// Reads the types of cells in a mixed section: one digit each, or one binary integer.
bool FluentCells::ReadElements(FluentFile& file, const FluentSection& section, Run& run)
{
  const std::int64_t count = run.End - run.Begin;
  const std::int64_t bytes = section.End - section.Begin;
  if (section.IsText() && count > (bytes + 1) / 2)
  {
    file.FailAt(section.Place, ErrorKind::Truncated,
      "the types of " + std::to_string(count) + " cells in the section that begins here",
      std::to_string(bytes) + " characters");
    return false;
  }
  FluentNumbers<std::int32_t> numbers(file, section);
  Buffer<std::int32_t> values;
  std::int64_t size = count;
  if (section.IsStored)
  {
    file.LoadStored(section, 0, count, values);
  }
  else
  {
    numbers.Read(numbers.All, true);
    size = numbers.GetCount();
    values = Buffer<std::int32_t>(size);
    std::copy_n(numbers.GetData(), size, values.data());
  }
  run.Elements.resize(static_cast<std::size_t>(count));
  for (std::int64_t i = 0; i < count; ++i)
  {
    const bool isNumber = i < size;
    if (!isNumber || values[i] < 0 || values[i] > MaxElement)
    {
      file.FailAt(numbers.Find(i), isNumber ? ErrorKind::Index : ErrorKind::Syntax,
        "the type of cell " + std::to_string(run.Begin + i + 1) + " from 0 to 7");
      return false;
    }
    run.Elements[static_cast<std::size_t>(i)] = camaron::GetElement(values[i], file.GetDimension());
  }
  if (section.IsText() && numbers.Find(count) < section.End)
  {
    file.FailAt(numbers.Find(count), ErrorKind::Count,
      "the end of the section after the types of " + std::to_string(count) + " cells");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool FluentCells::AddRun(FluentFile& file, const FluentSection& section)
{
  constexpr int Dead = 0, Inactive = 32;
  const std::int64_t lastEnd = this->Runs.empty() ? 0 : this->Runs.back().End;
  const std::int64_t element = section.GetElement();
  if (!file.CheckIds(section, lastEnd, file.DeclaredCells, "cells"))
  {
    return false;
  }
  if (element > MaxElement)
  {
    file.FailAt(
      section.Place, ErrorKind::Syntax, "a cell type from 0 to 7", std::to_string(element));
    return false;
  }
  Run run;
  run.Begin = section.Header[1] - 1;
  run.End = section.Header[2];
  run.Zone = static_cast<int>(section.Header[0]);
  run.Element = camaron::GetElement(element, file.GetDimension());
  const std::int64_t kind = section.HeaderSize > 3 ? section.Header[3] : 1;
  run.IsOfLeaves = kind != Dead && kind != Inactive && file.ZonesLeftOut.count(run.Zone) == 0;
  const bool hasElements = element == 0 &&
    (section.IsStored ||
      std::any_of(
        section.Begin, section.End, [&](char c) { return !section.IsText() || !IsSpace(c); }));
  if (run.IsOfLeaves && hasElements && !this->ReadElements(file, section, run))
  {
    return false;
  }
  this->Runs.push_back(std::move(run));
  return true;
}

//------------------------------------------------------------------------------
bool FluentCells::Load(FluentFile& file, std::int64_t maxCells)
{
  this->Count = std::max<std::int64_t>(file.DeclaredCells.Count, 0);
  const char* place = file.DeclaredCells.Place; // of the section with the greatest id
  for (const FluentSection& section : file.Cells)
  {
    place = section.Header[2] > this->Count ? section.Place : place;
    this->Count = std::max(this->Count, section.Header[2]);
  }
  if (this->Count > maxCells)
  {
    file.FailAt(place, ErrorKind::Count,
      "at most " + std::to_string(maxCells) + " cells for the number of faces",
      std::to_string(this->Count));
    return false;
  }
  const auto addUndeclared = [this](std::int64_t end)
  {
    const std::int64_t begin = this->Runs.empty() ? 0 : this->Runs.back().End;
    if (begin < end)
    {
      Run run;
      run.Begin = begin;
      run.End = end;
      this->Undeclared += end - begin;
      this->Runs.push_back(std::move(run));
    }
  };
  for (const FluentSection* section : FluentFile::SortById(file.Cells))
  {
    addUndeclared(section->Header[1] - 1);
    if (!this->AddRun(file, *section))
    {
      return false;
    }
  }
  addUndeclared(this->Count);
  for (Run& run : this->Runs)
  {
    run.Leaf = this->NumberOfLeaves;
    this->NumberOfLeaves += run.IsOfLeaves ? run.End - run.Begin : 0;
  }
  return true;
}
}
