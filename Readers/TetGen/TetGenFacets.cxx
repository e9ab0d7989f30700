// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TetGenFacets.h"

#include "Mesh/CellShape.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
constexpr char FacetNode[] = "a node of a facet";

//------------------------------------------------------------------------------
// Reads the number of nodes and the nodes, which may continue over several lines.
bool ReadPolygon(TextRow& row, const TetGenNodes& nodes, CellSink& sink)
{
  constexpr char Size[] = "the number of nodes of a polygon";
  std::int64_t size;
  if (!row.ReadInteger(size, Size))
  {
    return false;
  }
  if (size < 1)
  {
    return row.FailAtLast(ErrorKind::Count, std::string(Size) + ", at least 1");
  }
  sink.BeginCell(GetPolygonType(size));
  for (std::int64_t i = 0; i < size; ++i)
  {
    std::int32_t point;
    if (!nodes.ReadPoint(row, point, FacetNode))
    {
      return false;
    }
    sink.AddPoint(point);
  }
  return true;
}

//------------------------------------------------------------------------------
void AddField(vtkFieldData* fields, const char* name, const std::vector<double>& values,
  const std::vector<const char*>& components)
{
  if (values.empty())
  {
    return;
  }
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(components.size()));
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / components.size()));
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    array->SetComponentName(static_cast<vtkIdType>(i), components[i]);
  }
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  fields->AddArray(array);
}
}

//------------------------------------------------------------------------------
bool TetGenFacets::Read(TextScanner& scanner, const TextLines* lines, const TetGenNodes& nodes,
  bool isSmesh, const Progress& progress)
{
  constexpr char Expected[] = "the number of facets and a flag for markers";
  *this = TetGenFacets();
  this->Mesh.NumberOfPoints = nodes.GetCount();
  std::int64_t numbers[2] = { 0, 0 };
  constexpr int FewestBytes = 4; // "1 0" and a line end, or an empty facet of a .poly file
  if (!ReadTetGenHeader(scanner, numbers, 2, ErrorKind::Syntax, Expected) ||
    !scanner.ReadCount(
      this->Count, isSmesh ? FewestBytes : FewestBytes / 2, "the number of facets"))
  {
    return false;
  }
  scanner.SkipLine();
  this->HasMarkers = numbers[1] != 0;
  this->Markers.assign(static_cast<std::size_t>(this->Count), 0);
  this->Unmarked = IdSet(this->HasMarkers ? this->Count : 0);
  const bool good = isSmesh
    ? ReadCells(RowSequence(scanner, lines, this->Count), this->Mesh, progress,
        [&](vtkIdType facet, TextRow& row, CellSink& sink)
        {
          return ReadPolygon(row, nodes, sink) &&
            (!this->HasMarkers || this->ReadMarker(row, facet));
        })
    : (lines && this->ReadPairs(scanner, lines, nodes, progress)) ||
      (!progress.IsStopped() && this->ReadOneByOne(scanner, nodes, progress));
  this->NumberOfCells = this->Mesh.NumberOfCells;
  return good;
}

//------------------------------------------------------------------------------
// Most large files have one polygon per facet, on two lines in total, and can be read in parallel.
bool TetGenFacets::ReadPairs(
  TextScanner& scanner, const TextLines* lines, const TetGenNodes& nodes, const Progress& progress)
{
  TextScanner attempt = scanner;
  const RowSequence rows(attempt, lines, 2 * this->Count);
  std::vector<CellSink> sinks(rows.GetNumberOfParts());
  const bool good = rows.ForEach(progress,
    [&](vtkIdType line, vtkIdType part, TextRow& row)
    {
      if (line % 2 == 1)
      {
        return ReadPolygon(row, nodes, sinks[part]);
      }
      std::int64_t polygons, holes = 0;
      return row.ReadInteger(polygons, "") && polygons == 1 &&
        (!row.HasMore() || (row.ReadInteger(holes, "") && holes == 0)) &&
        this->ReadMarker(row, line / 2);
    });
  ScanError error;
  if (!good || !FillCells(sinks, this->Mesh, error))
  {
    return false;
  }
  scanner = attempt;
  return true;
}

//------------------------------------------------------------------------------
bool TetGenFacets::ReadOneByOne(
  TextScanner& scanner, const TetGenNodes& nodes, const Progress& progress)
{
  constexpr vtkIdType ReportEvery = 4096;
  this->Unmarked =
    IdSet(this->HasMarkers ? this->Count : 0); // the attempt above may have added some
  std::vector<CellSink> sinks(1);
  for (vtkIdType facet = 0; facet < this->Count; ++facet)
  {
    if (!this->ReadFacet(scanner, nodes, facet, sinks[0]) ||
      (facet % ReportEvery == 0 && !progress.Report(static_cast<double>(facet) / this->Count)))
    {
      return false;
    }
  }
  return FillCells(sinks, this->Mesh, scanner);
}

//------------------------------------------------------------------------------
bool TetGenFacets::ReadFacet(
  TextScanner& scanner, const TetGenNodes& nodes, vtkIdType facet, CellSink& sink)
{
  constexpr char Polygons[] = "the number of polygons of a facet";
  constexpr char NumberOfHoles[] = "the number of holes of a facet";
  std::int64_t polygons, holes = 0;
  TextRow header(scanner);
  if (!scanner.ReadCount(polygons, 4, Polygons) ||
    (header.HasMore() && !scanner.ReadCount(holes, 4, NumberOfHoles)) ||
    !this->ReadMarker(header, facet))
  {
    return false;
  }
  scanner.SkipLine();
  for (std::int64_t i = 0; i < polygons; ++i)
  {
    TextRow row(scanner);
    if (!ReadPolygon(row, nodes, sink))
    {
      return false;
    }
    scanner.SkipLine();
    this->Facets.push_back(static_cast<std::int32_t>(facet));
  }
  for (std::int64_t i = 0; i < holes; ++i)
  {
    if (!this->ReadHole(scanner, facet))
    {
      return false;
    }
  }
  if (holes > 0)
  {
    this->WithHoles.Add(facet);
  }
  return true;
}

//------------------------------------------------------------------------------
bool TetGenFacets::ReadMarker(TextRow& row, vtkIdType facet)
{
  std::int32_t& marker = this->Markers[static_cast<std::size_t>(facet)];
  marker = 0;
  if (!row.HasMore())
  {
    this->Unmarked.Add(facet);
    return true;
  }
  return ReadTetGenInteger(row, marker, "the marker of a facet");
}

//------------------------------------------------------------------------------
bool TetGenFacets::ReadHole(TextScanner& scanner, vtkIdType facet)
{
  TextRow row(scanner, RowLayout::OneLine);
  std::int64_t id;
  double x[3];
  if (!row.ReadInteger(id, "the number of a hole of a facet") ||
    !row.ReadPoint(x, "a coordinate of a hole of a facet"))
  {
    return false;
  }
  this->Holes.insert(this->Holes.end(), x, x + 3);
  this->FacetsOfHoles.push_back(static_cast<std::int32_t>(facet));
  scanner.SkipLine();
  return true;
}

//------------------------------------------------------------------------------
void TetGenFacets::AddArrays(vtkUnstructuredGrid* grid, const CellMeshPiece& piece)
{
  const vtkIdType size = piece.GetNumberOfCells();
  Buffer<std::int32_t> facets(size), markers(this->HasMarkers ? size : 0);
  for (vtkIdType i = 0; i < this->NumberOfCells; ++i)
  {
    if (const vtkIdType cell = piece.FindCell(i); cell >= 0)
    {
      facets[cell] = this->Facets.empty() ? static_cast<std::int32_t>(i) : this->Facets[i];
      if (this->HasMarkers)
      {
        markers[cell] = this->Markers[facets[cell]];
      }
    }
  }
  AddIntegers(grid->GetCellData(), "Facet", std::move(facets));
  if (this->HasMarkers)
  {
    AddIntegers(grid->GetCellData(), "BoundaryMarker", std::move(markers));
  }
}

//------------------------------------------------------------------------------
void TetGenFacets::AddFields(vtkFieldData* fields) const
{
  AddField(fields, "FacetHoles", this->Holes, { "x", "y", "z" });
  if (!this->FacetsOfHoles.empty())
  {
    vtkNew<vtkIntArray> facets;
    facets->SetName("FacetOfHole");
    facets->SetNumberOfTuples(static_cast<vtkIdType>(this->FacetsOfHoles.size()));
    std::copy(this->FacetsOfHoles.begin(), this->FacetsOfHoles.end(), facets->GetPointer(0));
    fields->AddArray(facets);
  }
}

//------------------------------------------------------------------------------
void TetGenFacets::Warn(Warnings& warnings) const
{
  WarnOfUnmarked(this->Unmarked, warnings, "facet", "facets");
  warnings.Add(
    this->WithHoles, "facet", "facets", "with holes, which are not cut out of the polygons");
}

//------------------------------------------------------------------------------
bool TetGenSeeds::Read(TextScanner& scanner, int dimension)
{
  *this = TetGenSeeds();
  constexpr int BytesPerNumber = 2;
  constexpr double None = -1; // no largest volume
  for (const bool isRegion : { false, true })
  {
    if (!scanner.SkipSpace())
    {
      return true;
    }
    std::int64_t count;
    const char* const counted = isRegion ? "the number of regions" : "the number of holes";
    if (!scanner.ReadCount(count, BytesPerNumber * (1 + dimension), counted))
    {
      return false;
    }
    scanner.SkipLine();
    for (std::int64_t i = 0; i < count; ++i)
    {
      TextRow row(scanner, RowLayout::OneLine);
      std::int64_t id;
      double values[5] = { 0, 0, 0, 0, None };
      bool good = row.ReadInteger(id, isRegion ? "the number of a region" : "the number of a hole");
      for (int c = 0; c < dimension && good; ++c)
      {
        good = row.ReadReal(values[c],
          isRegion ? "a coordinate of a point in a region" : "a coordinate of a point in a hole");
      }
      for (int c = 3; isRegion && c < 5 && good && row.HasMore(); ++c)
      {
        good = row.ReadReal(values[c], "an attribute or a maximum volume of a region");
      }
      if (!good)
      {
        return false;
      }
      scanner.SkipLine();
      std::vector<double>& seeds = isRegion ? this->Regions : this->Holes;
      seeds.insert(seeds.end(), values, values + (isRegion ? 5 : 3));
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void TetGenSeeds::AddFields(vtkFieldData* fields) const
{
  AddField(fields, "Holes", this->Holes, { "x", "y", "z" });
  AddField(fields, "Regions", this->Regions, { "x", "y", "z", "attribute", "largest size" });
}
}
