// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/CellMesh/CellConversion.h"

#include "Base/Parallel.h"
#include "Intake/CellMesh/CellConverter.h"
#include "Intake/CellMesh/OutputMesh.h"
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
