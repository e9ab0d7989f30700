// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/CellMesh/CellConversion.h"

#include "Base/Parallel.h"
#include "Intake/CellMesh/CellCutter.h"
#include "Intake/CellMesh/ConversionFindings.h"
#include "Intake/CellMesh/ConversionPlan.h"
#include "Intake/CellMesh/OutputMesh.h"
#include "Mesh/FacetTable.h"
#include "Mesh/MeshTopology.h"
#include "Scan/MappedFile.h"

#include "vtkDataSet.h"

#include <algorithm>
#include <memory>
#include <mutex>

namespace camaron
{
namespace
{
using Kind = ConversionStep::Kind;

//------------------------------------------------------------------------------
// The cells that a chunk of the input is converted to.
struct CellChunk
{
  std::vector<unsigned char> Types;
  std::vector<std::int64_t> Ends; ///< of the points of every cell
  std::vector<std::int64_t> Points;
  std::vector<std::int64_t> Inputs;
};

//------------------------------------------------------------------------------
// Converts single cells of a mesh according to a plan. Contains scratch memory: use one per thread.
class CellConverter
{
public:
  CellConverter(const MeshView& mesh, const ConversionPlan& plan, const CellConversion& how,
    const FacetTable* faces)
    : Mesh(mesh)
    , Plan(plan)
    , How(how)
    , Faces(faces)
    , Facets(mesh)
    , Cutter(mesh)
  {
  }

  /// Appends the cells that a cell is converted to.
  void Convert(vtkIdType cell, CellChunk& chunk);
  ConversionFindings Found;

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
  /// Appends the result of a step for the cell.
  void Put(const ConversionStep& step);
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
  bool IsCounted = false; // a cell counts once, regardless of its number of parts
};

//------------------------------------------------------------------------------
void CellConverter::PutPolygon(const vtkIdType* points, vtkIdType size)
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
    }
  }
}

//------------------------------------------------------------------------------
void CellConverter::PutSurface()
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
void CellConverter::PutTetrahedra()
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
    notPositive += this->Cutter.GetVolume(tetrahedron) > 0 ? 0 : 1;
  }
  if (notPositive > 0)
  {
    this->Found.NotPositive.Add(this->Cell);
    this->Found.NumberOfNotPositive += notPositive;
  }
}

//------------------------------------------------------------------------------
void CellConverter::PutPolyhedron()
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
void CellConverter::Convert(vtkIdType cell, CellChunk& chunk)
{
  this->Chunk = &chunk;
  this->Cell = cell;
  this->Type = this->Mesh.GetCellType(cell);
  this->IsCounted = false;
  const ConversionStep& step = this->Plan[this->Type];
  const Tally& leftOut = this->Found.Unsupported[this->Type];
  const vtkIdType leftOutBefore = leftOut.Count;
  this->Put(step);
  if (step.LosesNodes && leftOut.Count == leftOutBefore)
  {
    this->Found.Reduced[this->Type].Add(cell);
  }
}

//------------------------------------------------------------------------------
void CellConverter::Put(const ConversionStep& step)
{
  CellChunk& chunk = *this->Chunk;
  const vtkIdType cell = this->Cell;
  const IndexRange points = this->Mesh.GetCellPoints(cell);
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
// Whether every cell is kept, and whether there are only vertices.
bool KeepsAll(const MeshView& mesh, const ConversionPlan& plan, bool& isCloud)
{
  std::bitset<256> seen;
  std::mutex mutex;
  ParallelFor(mesh.GetNumberOfCells(), MediumGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::bitset<256> types;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        types.set(mesh.GetCellType(cell));
      }
      const std::lock_guard<std::mutex> lock(mutex);
      seen |= types;
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
// Reading the file creates a vertex for every point.
void WarnOfCloud(const MeshView& mesh, Warnings& warnings)
{
  const std::vector<bool> isVertex = mesh.FindUsedPoints();
  Tally alone;
  for (vtkIdType point = 0; point < mesh.GetNumberOfPoints(); ++point)
  {
    if (!isVertex[static_cast<std::size_t>(point)])
    {
      alone.Add(point);
    }
  }
  warnings.Add(
    alone, "point", "points", "without a cell (the reader creates a vertex for each)", FromZero);
}
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

  void DropCells()
  {
    this->Output.SameCells = false;
    this->Output.NumberOfCells = 0;
    this->Output.Offsets.assign(1, 0);
  }
  bool Fill(vtkDataSet* mesh, const CellConversion& how, const ConversionPlan& plan,
    ConversionFindings& found, const Progress& progress);
  vtkIdType DropPoints();

private:
  OutputMesh& Output;
};

//------------------------------------------------------------------------------
bool OutputMeshBuilder::Fill(vtkDataSet* mesh, const CellConversion& how,
  const ConversionPlan& plan, ConversionFindings& found, const Progress& progress)
{
  OutputMesh& output = this->Output;
  const MeshView& view = output.Input;
  const vtkIdType numberOfCells = view.GetNumberOfCells();
  const vtkIdType numberOfChunks = (numberOfCells + MediumGrain - 1) / MediumGrain;
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
      CellConverter converter(view, plan, how, topology ? &topology->GetFaces() : nullptr);
      for (vtkIdType chunk = first; chunk < last; ++chunk)
      {
        const vtkIdType end = std::min((chunk + 1) * MediumGrain, numberOfCells);
        for (vtkIdType cell = chunk * MediumGrain; cell < end; ++cell)
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
// Omits points whose cells are all omitted, which would be unused in the file. Returns their
// number.
vtkIdType OutputMeshBuilder::DropPoints()
{
  OutputMesh& output = this->Output;
  const MeshView& view = output.Input;
  const vtkIdType numberOfPoints = view.GetNumberOfPoints();
  if (numberOfPoints > INT32_MAX)
  {
    return 0; // cannot be renumbered; unused points do no harm
  }
  IdSet before(numberOfPoints), kept(numberOfPoints);
  ParallelFor(view.GetNumberOfCells(), MediumGrain,
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
  ParallelFor(size, MediumGrain,
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
    return 0;
  }
  ParallelFor(size, MediumGrain,
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
  return numberOfPoints - numberOfKept;
}

//------------------------------------------------------------------------------
bool ConvertCells(vtkDataSet* mesh, const CellConversion& how, const std::string& path,
  OutputMesh& output, Warnings& warnings, ScanError& error, const Progress& progress)
{
  output = OutputMesh(mesh);
  OutputMeshBuilder builder(output);
  const ConversionPlan plan(how);
  bool isCloud = false;
  if (KeepsAll(output.GetInput(), plan, isCloud))
  {
    return progress.Report(1);
  }
  if (isCloud && !plan.Holds(VTK_VERTEX) && !plan.Holds(VTK_POLY_VERTEX))
  {
    WarnOfCloud(output.GetInput(), warnings);
    builder.DropCells();
    return progress.Report(1);
  }
  ConversionFindings found;
  if (!builder.Fill(mesh, how, plan, found, progress))
  {
    return false;
  }
  if (HasUnsupported(found) && how.Others == UnsupportedCells::Refuse)
  {
    const bool holdsSome = output.GetNumberOfCells() > 0;
    error = { ErrorKind::Unsupported, DescribeRefusal(how, found, holdsSome, path) };
    return false;
  }
  if (output.GetNumberOfCells() == 0)
  {
    error = { ErrorKind::Unsupported,
      HasUnsupported(found) ? DescribeRefusal(how, found, false, path)
                            : GetFileName(path) + ": " + how.Format +
          " files can store none of the " + std::to_string(output.GetInput().GetNumberOfCells()) +
          " cells because they have too few points" +
          (how.Surface == SurfaceFaces::Boundary ? " or no boundary face" : "") };
    return false;
  }
  found.NumberOfLostPoints = builder.DropPoints();
  WarnOfConversion(how, found, warnings);
  return progress.Report(1);
}
}
