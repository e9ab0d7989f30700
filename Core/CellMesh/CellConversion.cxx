// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellMesh/CellConversion.h"

#include "CellMesh/CellCutter.h"
#include "CellMesh/ConversionPlan.h"
#include "CellMesh/OutputMesh.h"
#include "Mesh/MeshTopology.h"
#include "Scan/MappedFile.h"
#include "vtkCamaronCompat.h"

#include "vtkDataSet.h"

#include <algorithm>
#include <cctype>
#include <memory>

namespace camaron
{
namespace
{
constexpr vtkIdType ChunkSize = 4096;
using Kind = ConversionStep::Kind;

//------------------------------------------------------------------------------
// What happened, per type of the input; merging does not depend on the order.
struct Findings
{
  std::array<Tally, 256> Unsupported;
  std::array<Tally, 256> Reduced;
  std::array<Tally, 256> Cut;
  Tally Surface;
  Tally Uncut;       // polygons that do not say where to cut
  Tally NotPositive; // cells with tetrahedra of no positive volume
  vtkIdType NumberOfNotPositive = 0;
  vtkIdType NumberOfFaces = 0;
  vtkIdType NumberOfTriangles = 0;
  vtkIdType NumberOfTetrahedra = 0;

  void Merge(const Findings& other)
  {
    for (std::size_t type = 0; type < 256; ++type)
    {
      this->Unsupported[type].Merge(other.Unsupported[type]);
      this->Reduced[type].Merge(other.Reduced[type]);
      this->Cut[type].Merge(other.Cut[type]);
    }
    this->Surface.Merge(other.Surface);
    this->Uncut.Merge(other.Uncut);
    this->NotPositive.Merge(other.NotPositive);
    this->NumberOfNotPositive += other.NumberOfNotPositive;
    this->NumberOfFaces += other.NumberOfFaces;
    this->NumberOfTriangles += other.NumberOfTriangles;
    this->NumberOfTetrahedra += other.NumberOfTetrahedra;
  }
};

//------------------------------------------------------------------------------
// The cells that a chunk of the input becomes.
struct CellChunk
{
  std::vector<unsigned char> Types;
  std::vector<std::int64_t> Ends; // of the points of every cell
  std::vector<std::int64_t> Points;
  std::vector<std::int64_t> Inputs;
};

//------------------------------------------------------------------------------
// Turns cells into those of the plan; one per thread.
class Converter
{
public:
  Converter(const MeshView& mesh, const ConversionPlan& plan, const CellConversion& how,
    const FacetTable* faces)
    : Mesh(mesh)
    , Plan(plan)
    , How(how)
    , Faces(faces)
    , Facets(mesh)
    , Cutter(mesh)
  {
  }

  void Convert(vtkIdType cell, CellChunk& chunk);
  Findings Found;

private:
  void Put(unsigned char type)
  {
    this->Chunk->Types.push_back(type);
    this->Chunk->Ends.push_back(static_cast<std::int64_t>(this->Chunk->Points.size()));
    this->Chunk->Inputs.push_back(this->Cell);
  }
  template <typename Ids>
  void Put(unsigned char type, const Ids& ids, vtkIdType size)
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->Chunk->Points.push_back(ids[i]);
    }
    this->Put(type);
  }
  void PutPolygon(const vtkIdType* points, vtkIdType size);
  void PutSurface();
  void PutPolyhedron();
  void PutTetrahedra();
  void AddOnce(Tally& tally)
  {
    if (!this->IsCounted)
    {
      tally.Add(this->Cell);
      this->IsCounted = true;
    }
  }

  const MeshView& Mesh;
  const ConversionPlan& Plan;
  const CellConversion& How;
  const FacetTable* Faces;
  CellFacets Facets;
  CellCutter Cutter;
  std::vector<vtkIdType> Polygon;
  CellChunk* Chunk = nullptr;
  vtkIdType Cell = 0;
  unsigned char Type = 0;
  bool IsCounted = false; // a cell counts once, however many parts it has
};

//------------------------------------------------------------------------------
void Converter::PutPolygon(const vtkIdType* points, vtkIdType size)
{
  const unsigned char type = this->Plan.GetPolygonType(size);
  if (type != VTK_EMPTY_CELL)
  {
    this->Put(type, points, size);
  }
  else if (size < 3 || !this->Plan.CutsPolygons())
  {
    this->AddOnce(this->Found.Unsupported[this->Type]);
  }
  else
  {
    if (!this->Cutter.CutPolygon(points, size))
    {
      this->Found.Uncut.Add(this->Cell);
    }
    this->AddOnce(this->Found.Cut[this->Type]);
    for (const CellCutter::Triangle& triangle : this->Cutter.GetTriangles())
    {
      this->Put(VTK_TRIANGLE, triangle, 3);
      ++this->Found.NumberOfTriangles;
    }
  }
}

//------------------------------------------------------------------------------
void Converter::PutSurface()
{
  this->Found.Surface.Add(this->Cell);
  const FacetTable::Range uses = this->Faces->GetCellFacets(this->Cell);
  const auto isWanted = [&](Index local)
  {
    const Index facet = uses[local].Facet();
    return this->How.Surface == SurfaceFaces::Boundary
      ? this->Faces->IsBoundary(facet)
      : this->Faces->GetCells(facet).First == this->Cell &&
        this->Faces->GetOwnerLocalFacet(facet) == local;
  };
  for (Index local = 0; local < uses.size(); ++local)
  {
    if (isWanted(local))
    {
      this->Polygon.clear();
      this->Facets.GetFacet(this->Cell, local, this->Polygon);
      ++this->Found.NumberOfFaces;
      this->PutPolygon(this->Polygon.data(), static_cast<vtkIdType>(this->Polygon.size()));
    }
  }
}

//------------------------------------------------------------------------------
void Converter::PutTetrahedra()
{
  if (this->Facets.GetNumberOfFacets(this->Cell) == 0)
  {
    this->AddOnce(this->Found.Unsupported[this->Type]); // a point set without its hull
    return;
  }
  this->Cutter.CutCell(this->Cell);
  this->AddOnce(this->Found.Cut[this->Type]);
  vtkIdType notPositive = 0;
  for (const CellCutter::Tetrahedron& tetrahedron : this->Cutter.GetTetrahedra())
  {
    this->Put(VTK_TETRA, tetrahedron, 4);
    ++this->Found.NumberOfTetrahedra;
    notPositive += this->Cutter.GetVolume(tetrahedron) > 0 ? 0 : 1;
  }
  if (notPositive > 0)
  {
    this->Found.NotPositive.Add(this->Cell);
    this->Found.NumberOfNotPositive += notPositive;
  }
}

//------------------------------------------------------------------------------
void Converter::PutPolyhedron()
{
  vtkIdType nodes[8];
  const unsigned char type = this->Cutter.MatchPolyhedron(this->Cell, nodes);
  if (type != VTK_POLYHEDRON && this->Plan.Holds(type))
  {
    this->Put(type, nodes, GetCellShape(type).NumberOfCorners);
  }
  else if (this->Plan.Holds(VTK_TETRA))
  {
    this->PutTetrahedra();
  }
  else
  {
    this->AddOnce(this->Found.Unsupported[this->Type]);
  }
}

//------------------------------------------------------------------------------
void Converter::Convert(vtkIdType cell, CellChunk& chunk)
{
  this->Chunk = &chunk;
  this->Cell = cell;
  this->Type = this->Mesh.GetCellType(cell);
  this->IsCounted = false;
  const ConversionStep& step = this->Plan[this->Type];
  const IndexRange points = this->Mesh.GetCellPoints(cell);
  if (step.LosesNodes)
  {
    this->Found.Reduced[this->Type].Add(cell);
  }
  switch (step.What)
  {
    case Kind::Nodes:
    {
      const vtkIdType size = step.NumberOfNodes ? step.NumberOfNodes : points.Size;
      for (vtkIdType i = 0; i < size; ++i)
      {
        chunk.Points.push_back(points[step.Order ? step.Order[i] : i]);
      }
      this->Put(step.Type);
      return;
    }
    case Kind::Polygon:
      this->Facets.GetPolygon(cell, this->Polygon);
      this->PutPolygon(this->Polygon.data(), static_cast<vtkIdType>(this->Polygon.size()));
      return;
    case Kind::Strip:
      for (vtkIdType i = 0; i + 2 < points.Size; ++i)
      {
        const vtkIdType triangle[3] = { points[i], points[i + 1 + i % 2], points[i + 2 - i % 2] };
        this->PutPolygon(triangle, 3);
      }
      return;
    case Kind::Lines:
      for (vtkIdType i = 0; i + 1 < points.Size; ++i)
      {
        const vtkIdType line[2] = { points[i], points[i + 1] };
        this->Put(step.Type, line, 2);
      }
      return;
    case Kind::Vertices:
      for (vtkIdType i = 0; i < points.Size; ++i)
      {
        const vtkIdType vertex = points[i];
        this->Put(step.Type, &vertex, 1);
      }
      return;
    case Kind::Surface:
      this->PutSurface();
      return;
    case Kind::Polyhedron:
      this->PutPolyhedron();
      return;
    case Kind::Tetrahedra:
      this->PutTetrahedra();
      return;
    default:
      this->Found.Unsupported[this->Type].Add(cell);
  }
}

//------------------------------------------------------------------------------
std::string Join(const std::vector<std::string>& parts)
{
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    text += (i == 0 ? "" : i + 1 < parts.size() ? ", " : " and ") + parts[i];
  }
  return text;
}

//------------------------------------------------------------------------------
// Says what cannot be written, and what would help.
std::string Refuse(const CellConversion& how, const Findings& found, const std::string& path)
{
  CellConversion cutting = how;
  cutting.Others = UnsupportedCells::Convert;
  const ConversionPlan plan(cutting);
  std::vector<std::string> kinds;
  bool triangles = false, tetrahedra = false;
  for (int type = 0; type < 256; ++type)
  {
    const Tally& tally = found.Unsupported[type];
    if (tally.Count == 0)
    {
      continue;
    }
    const auto step = plan[static_cast<unsigned char>(type)].What;
    tetrahedra = tetrahedra || step == Kind::Tetrahedra || step == Kind::Polyhedron;
    triangles =
      triangles || ((step == Kind::Surface || step == Kind::Polygon) && plan.CutsPolygons());
    kinds.push_back(std::to_string(tally.Count) + (tally.Count == 1 ? " cell" : " cells") +
      " of type " + GetCellTypeName(static_cast<unsigned char>(type)) +
      (tally.Count == 1 ? " (cell " : " (the first is cell ") + std::to_string(tally.First) + ")");
  }
  std::string help = "set Unsupported Cells to ";
  if (how.Others == UnsupportedCells::Refuse && (triangles || tetrahedra))
  {
    help += std::string("Convert to cut them into ") +
      (triangles && tetrahedra ? "triangles and tetrahedra"
          : triangles          ? "triangles"
                               : "tetrahedra") +
      ", or to ";
  }
  help += "Skip to leave them out";
  return GetFileName(path) + ": " + how.Format + " files cannot hold " + Join(kinds) + "; " + help;
}

//------------------------------------------------------------------------------
void AddPerType(Warnings& warnings, const std::array<Tally, 256>& tallies, const std::string& what)
{
  for (int type = 0; type < 256; ++type)
  {
    const std::string name = " of type " + GetCellTypeName(static_cast<unsigned char>(type)) + what;
    warnings.Add(tallies[type], "cell", "cells", name.c_str() + 1);
  }
}

//------------------------------------------------------------------------------
void Warn(const CellConversion& how, const Findings& found, Warnings& warnings)
{
  AddPerType(warnings, found.Reduced, " written without their nodes of higher order");
  const std::string faces = std::string("of three dimensions written by ") +
    (how.Surface == SurfaceFaces::Every ? "all their faces, " : "the faces of their boundary, ") +
    std::to_string(found.NumberOfFaces) + " polygons";
  warnings.Add(found.Surface, "cell", "cells", faces.c_str());
  std::array<Tally, 256> cut2D = found.Cut, cut3D = found.Cut;
  for (int type = 0; type < 256; ++type)
  {
    const bool isCell = GetCellShape(static_cast<unsigned char>(type)).Dimension == 3 &&
      how.Surface == SurfaceFaces::None;
    (isCell ? cut2D : cut3D)[type] = Tally();
  }
  AddPerType(warnings, cut2D, " cut into triangles");
  AddPerType(warnings, cut3D, " cut into tetrahedra");
  warnings.Add(found.Uncut, "cell", "cells",
    "with polygons that cross themselves or have no area, whose triangles are arbitrary");
  const std::string bad = "not convex, of which " + std::to_string(found.NumberOfNotPositive) +
    " tetrahedra have no positive volume";
  warnings.Add(found.NotPositive, "cell", "cells", bad.c_str());
  AddPerType(
    warnings, found.Unsupported, " left out, as " + how.Format + " files cannot hold them");
}
}

//------------------------------------------------------------------------------
std::string GetCellTypeName(unsigned char type)
{
  if (type == VTK_EMPTY_CELL)
  {
    return "empty cell";
  }
  const std::string name = GetCellClassName(type); // vtkQuadraticTetra
  if (name.compare(0, 3, "vtk") != 0)
  {
    return std::to_string(static_cast<int>(type));
  }
  std::string words;
  for (std::size_t i = 3; i < name.size(); ++i)
  {
    const bool isUpper = std::isupper(static_cast<unsigned char>(name[i])) != 0;
    const bool wasLower = i > 3 && !std::isupper(static_cast<unsigned char>(name[i - 1]));
    words += isUpper && wasLower ? " " : "";
    words += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  }
  return words;
}

//------------------------------------------------------------------------------
// Fills an OutputMesh.
class OutputMeshBuilder
{
public:
  explicit OutputMeshBuilder(OutputMesh& output)
    : Output(output)
  {
  }

  bool KeepsAll(const ConversionPlan& plan, bool& isCloud) const;
  void DropCells();
  bool Fill(vtkDataSet* mesh, const CellConversion& how, const ConversionPlan& plan,
    Findings& found, const Progress& progress);
  void DropPoints();

private:
  OutputMesh& Output;
};

//------------------------------------------------------------------------------
// Whether every cell stays as it is, and whether there are only vertices.
bool OutputMeshBuilder::KeepsAll(const ConversionPlan& plan, bool& isCloud) const
{
  const MeshView& mesh = this->Output.Input;
  std::array<std::atomic<bool>, 256> seen{};
  ParallelFor(mesh.GetNumberOfCells(), ChunkSize,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::bitset<256> types;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        types.set(mesh.GetCellType(cell));
      }
      for (std::size_t type = 0; type < 256; ++type)
      {
        if (types[type])
        {
          seen[type] = true;
        }
      }
    });
  bool keepsAll = true;
  isCloud = true;
  for (int type = 0; type < 256; ++type)
  {
    if (seen[type])
    {
      keepsAll = keepsAll && plan[static_cast<unsigned char>(type)].IsSame;
      isCloud = isCloud && GetCellShape(static_cast<unsigned char>(type)).Dimension == 0;
    }
  }
  return keepsAll;
}

//------------------------------------------------------------------------------
void OutputMeshBuilder::DropCells()
{
  this->Output.SameCells = false;
  this->Output.NumberOfCells = 0;
  this->Output.Offsets.assign(1, 0);
}

//------------------------------------------------------------------------------
bool OutputMeshBuilder::Fill(vtkDataSet* mesh, const CellConversion& how,
  const ConversionPlan& plan, Findings& found, const Progress& progress)
{
  OutputMesh& output = this->Output;
  const MeshView& view = output.Input;
  const vtkIdType numberOfCells = view.GetNumberOfCells();
  const vtkIdType numberOfChunks = (numberOfCells + ChunkSize - 1) / ChunkSize;
  std::unique_ptr<MeshTopology> topology;
  if (how.Surface != SurfaceFaces::None)
  {
    topology = std::make_unique<MeshTopology>(mesh);
    topology->GetFaces();
  }

  std::vector<CellChunk> chunks(static_cast<std::size_t>(numberOfChunks));
  std::mutex mutex;
  const bool done = progress.Part(0, 0.7).For(numberOfChunks,
    [&](vtkIdType first, vtkIdType last)
    {
      Converter converter(view, plan, how, topology ? &topology->GetFaces() : nullptr);
      for (vtkIdType chunk = first; chunk < last; ++chunk)
      {
        const vtkIdType end = std::min((chunk + 1) * ChunkSize, numberOfCells);
        for (vtkIdType cell = chunk * ChunkSize; cell < end; ++cell)
        {
          converter.Convert(cell, chunks[chunk]);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      found.Merge(converter.Found);
    });
  if (!done)
  {
    return false;
  }

  std::vector<vtkIdType> firstCells(1, 0), firstPoints(1, 0);
  for (const CellChunk& chunk : chunks)
  {
    firstCells.push_back(firstCells.back() + static_cast<vtkIdType>(chunk.Types.size()));
    firstPoints.push_back(firstPoints.back() + static_cast<vtkIdType>(chunk.Points.size()));
  }
  output.SameCells = false;
  output.NumberOfCells = firstCells.back();
  output.Types.resize(static_cast<std::size_t>(output.NumberOfCells));
  output.InputCells.resize(output.Types.size());
  output.Offsets.resize(output.Types.size() + 1);
  output.Connectivity.resize(static_cast<std::size_t>(firstPoints.back()));
  return progress.Part(0.7, 0.9).For(numberOfChunks,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType c = first; c < last; ++c)
      {
        CellChunk chunk = std::move(chunks[c]);
        std::copy(chunk.Types.begin(), chunk.Types.end(), output.Types.begin() + firstCells[c]);
        std::copy(
          chunk.Inputs.begin(), chunk.Inputs.end(), output.InputCells.begin() + firstCells[c]);
        std::copy(
          chunk.Points.begin(), chunk.Points.end(), output.Connectivity.begin() + firstPoints[c]);
        for (std::size_t i = 0; i < chunk.Ends.size(); ++i)
        {
          output.Offsets[firstCells[c] + i + 1] = firstPoints[c] + chunk.Ends[i];
        }
      }
    });
}

//------------------------------------------------------------------------------
// Points that only cells had which are no longer there would be new orphans.
void OutputMeshBuilder::DropPoints()
{
  OutputMesh& output = this->Output;
  const MeshView& view = output.Input;
  const vtkIdType numberOfPoints = view.GetNumberOfPoints();
  if (numberOfPoints > INT32_MAX)
  {
    return; // cannot be numbered anew; orphans do no harm
  }
  IdSet before(numberOfPoints), kept(numberOfPoints);
  ParallelFor(view.GetNumberOfCells(), ChunkSize,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const bool isVertex = GetCellShape(view.GetCellType(cell)).Dimension == 0;
        const IndexRange points = view.GetCellPoints(cell);
        for (vtkIdType i = 0; i < points.Size; ++i)
        {
          before.Add(points[i]);
          if (isVertex)
          {
            kept.Add(points[i]);
          }
        }
      }
    });
  auto& connectivity = output.Connectivity;
  const auto size = static_cast<vtkIdType>(connectivity.size());
  ParallelFor(size, ChunkSize,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        kept.Add(connectivity[i]);
      }
    });
  kept.AddMissing(before);
  const vtkIdType numberOfKept = kept.Number();
  if (numberOfKept == numberOfPoints)
  {
    return;
  }
  ParallelFor(size, ChunkSize,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        connectivity[i] = kept.GetNumber(connectivity[i]);
      }
    });
  output.SamePoints = false;
  output.NumberOfPoints = numberOfKept;
  output.InputPoints = kept.GetMembers();
  output.KeptPoints = std::move(kept);
}

//------------------------------------------------------------------------------
bool ConvertCells(vtkDataSet* mesh, const CellConversion& how, const std::string& path,
  OutputMesh& output, Warnings& warnings, ScanError& error, const Progress& progress)
{
  output = OutputMesh(mesh);
  OutputMeshBuilder builder(output);
  const ConversionPlan plan(how);
  bool isCloud = false;
  if (builder.KeepsAll(plan, isCloud))
  {
    return progress.Report(1);
  }
  if (isCloud && how.HoldsClouds && !plan.Holds(VTK_VERTEX) && !plan.Holds(VTK_POLY_VERTEX))
  {
    builder.DropCells();
    return progress.Report(1);
  }
  Findings found;
  if (!builder.Fill(mesh, how, plan, found, progress))
  {
    return false;
  }
  const bool isUnsupported = std::any_of(found.Unsupported.begin(), found.Unsupported.end(),
    [](const Tally& tally) { return tally.Count > 0; });
  if (isUnsupported && how.Others == UnsupportedCells::Refuse)
  {
    error = { ErrorKind::Unsupported, Refuse(how, found, path) };
    return false;
  }
  if (output.GetNumberOfCells() == 0)
  {
    error = { ErrorKind::Unsupported,
      GetFileName(path) + ": " + how.Format + " files can hold none of the " +
        std::to_string(output.GetInput().GetNumberOfCells()) + " cells; nothing is written" };
    return false;
  }
  Warn(how, found, warnings);
  builder.DropPoints();
  return progress.Report(1);
}
}
