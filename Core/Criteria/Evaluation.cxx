// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/Evaluation.h"

#include "Base/Parallel.h"
#include "Cell/CellNeighborhood.h"
#include "Cell/NondegenerateTetrahedra.h"
#include "Criteria/MeshContext.h"
#include "Ranks/MeshFacts.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <utility>

namespace camaron
{
namespace
{
constexpr int MaxBlockSize = 16; // cells whose geometry is kept at the same time
constexpr int MaxBlockPoints =
  64; // approximate limit, so that the geometry stays in the first-level cache
constexpr vtkIdType SlabSize = 65536; // minimum number of cells between two reports of progress
constexpr vtkIdType NumberOfReports = 100;

//------------------------------------------------------------------------------
unsigned GetNeeds(const std::vector<CriterionValues>& criteria)
{
  return std::accumulate(criteria.begin(), criteria.end(), 0u,
    [](unsigned needs, const CriterionValues& row) { return needs | row.Criterion->Needs; });
}

//------------------------------------------------------------------------------
bool AppliesTo(const Criterion& criterion, const CellGeometry& cell)
{
  return (criterion.AppliesTo & (cell.GetShapes() | AnyCell)) != 0;
}

//------------------------------------------------------------------------------
// A value of a cell in the units of the mesh.
double ToMesh(const CellGeometry& cell, const Criterion& criterion, double value)
{
  return cell.ToMesh(value, cell.GetPower(criterion.Unit));
}

//------------------------------------------------------------------------------
class CellEvaluation
{
public:
  /// Stores the centers of the cells in @a centers, if given.
  CellEvaluation(const MeshView& mesh, const EvaluationOptions& options,
    const std::vector<CriterionValues>& criteria, CellCenters* centers)
    : Mesh(mesh)
    , Options(options)
    , Criteria(criteria)
    , Centers(centers)
    , TakesTetrahedra(!centers &&
        std::all_of(criteria.begin(), criteria.end(),
          [](const CriterionValues& row) { return row.Criterion->TetrahedronFunction != nullptr; }))
    , Needs(GetNeeds(criteria) | (centers ? CellNeighborhood::BaseNeeds : 0))
  {
  }

  void operator()(vtkIdType begin, vtkIdType end) const
  {
    std::vector<CellGeometry>& block = this->Blocks.Local();
    block.resize(MaxBlockSize);
    if (this->TakesTetrahedra)
    {
      this->EvaluateTetrahedra(block, begin, end);
    }
    else
    {
      this->EvaluateCells(block, begin, end);
    }
  }

private:
  // Evaluates sound tetrahedra together, and the cells between them like other cells.
  void EvaluateTetrahedra(std::vector<CellGeometry>& block, vtkIdType begin, vtkIdType end) const
  {
    NondegenerateTetrahedra tetrahedra;
    std::array<double, NondegenerateTetrahedra::Size> rest;
    for (vtkIdType first = begin; first < end; first += NondegenerateTetrahedra::Size)
    {
      const int size =
        static_cast<int>(std::min<vtkIdType>(NondegenerateTetrahedra::Size, end - first));
      const int numberOfSound =
        tetrahedra.Load(this->Mesh, first, size, this->Options, this->Needs);
      if (numberOfSound > 0)
      {
        for (const CriterionValues& row : this->Criteria)
        {
          double* const to = row.Values + first;
          row.Criterion->TetrahedronFunction(
            tetrahedra, size == NondegenerateTetrahedra::Size ? to : rest.data());
          if (size < NondegenerateTetrahedra::Size)
          {
            std::copy_n(rest.data(), size, to);
          }
        }
      }
      for (int i = 0; i < size && numberOfSound < size; ++i)
      {
        const int other = i;
        while (i < size && !tetrahedra.IsSound(i))
        {
          ++i;
        }
        if (other < i)
        {
          this->EvaluateCells(block, first + other, first + i);
        }
      }
    }
  }

  void EvaluateCells(std::vector<CellGeometry>& block, vtkIdType begin, vtkIdType end) const
  {
    int size = 0;
    for (vtkIdType first = begin; first < end; first += size)
    {
      const int limit = static_cast<int>(std::min<vtkIdType>(MaxBlockSize, end - first));
      unsigned common = ~0u; // shapes that all cells of the block have
      int points = 0;
      bool isNormalized = false;
      for (size = 0; size < limit && points < MaxBlockPoints; ++size)
      {
        CellGeometry& cell = block[size];
        cell.Load(this->Mesh, first + size, this->Options);
        cell.Normalize();
        cell.Compute(this->Needs);
        isNormalized |= cell.GetLengthExponent() != 0;
        if (this->Centers)
        {
          this->Centers->Set(first + size, cell);
        }
        points += cell.GetNumberOfPoints();
        common &= cell.IsFinite() ? cell.GetShapes() | AnyCell : 0u;
      }
      for (const CriterionValues& row : this->Criteria)
      {
        double* values = row.Values + first;
        if (row.Criterion->AppliesTo & common)
        {
          row.Criterion->CellFunction(block.data(), size, values);
        }
        else
        {
          for (int i = 0; i < size; ++i)
          {
            if (!AppliesTo(*row.Criterion, block[i]))
            {
              values[i] = Null(NullReason::NotApplicable);
            }
            else if (!block[i].IsFinite() && !row.Criterion->IsInteger())
            {
              values[i] = Null(NullReason::Degenerate);
            }
            else
            {
              row.Criterion->CellFunction(block.data() + i, 1, values + i);
            }
          }
        }
        for (int i = 0; isNormalized && i < size; ++i)
        {
          values[i] = ToMesh(block[i], *row.Criterion, values[i]);
        }
      }
    }
  }

  const MeshView& Mesh;
  const EvaluationOptions& Options;
  const std::vector<CriterionValues>& Criteria;
  CellCenters* Centers;
  bool TakesTetrahedra; ///< sound tetrahedra need no topology
  unsigned Needs;
  mutable vtkSMPThreadLocal<std::vector<CellGeometry>> Blocks; // reuse their memory between loops
};

//------------------------------------------------------------------------------
class NeighborEvaluation
{
public:
  NeighborEvaluation(const MeshTopology& topology, const EvaluationOptions& options,
    const std::vector<CriterionValues>& criteria, const CellCenters& centers)
    : Mesh(topology.GetMesh())
    , Options(options)
    , Criteria(criteria)
    , Needs(GetNeeds(criteria) | CellNeighborhood::BaseNeeds)
    , Neighborhood(topology, centers, options)
  {
  }

  void operator()(vtkIdType begin, vtkIdType end) const
  {
    CellGeometry cell;
    CellNeighborhood neighborhood = this->Neighborhood;
    for (vtkIdType id = begin; id < end; ++id)
    {
      cell.Load(this->Mesh, id, this->Options);
      cell.Normalize();
      bool isGood = cell.IsFinite() && (cell.GetShapes() & PolygonsAndPolyhedra);
      if (isGood)
      {
        cell.Compute(this->Needs);
        isGood = neighborhood.Load(id, cell);
      }
      for (const CriterionValues& row : this->Criteria)
      {
        row.Values[id] = !AppliesTo(*row.Criterion, cell) ? Null(NullReason::NotApplicable)
          : isGood ? ToMesh(cell, *row.Criterion, row.Criterion->NeighborFunction(neighborhood))
                   : Null(NullReason::Degenerate);
      }
    }
  }

private:
  const MeshView& Mesh;
  const EvaluationOptions& Options;
  const std::vector<CriterionValues>& Criteria;
  unsigned Needs;
  CellNeighborhood Neighborhood;
};
}

//------------------------------------------------------------------------------
unsigned GetNeeds(const std::vector<const Criterion*>& criteria)
{
  return std::accumulate(criteria.begin(), criteria.end(), 0u,
    [](unsigned needs, const Criterion* criterion) { return needs | criterion->Needs; });
}

//------------------------------------------------------------------------------
bool Evaluate(const MeshTopology& topology, const EvaluationOptions& givenOptions,
  const std::vector<CriterionValues>& criteria, const std::function<bool(double)>& progress)
{
  const unsigned needs = GetNeeds(criteria);
  Reducer alone;
  std::vector<LinkedPiece> pieces = { { &topology, givenOptions } };
  MeshFacts facts; // of this piece, where those of all pieces are not given
  facts.Find(needs & ~NeedsPointRegions, pieces, alone, [] { return true; });
  EvaluationOptions& options = pieces[0].Options;
  options.ChecksStarShape |= (needs & NeedsStarShape) != 0;

  const MeshView& mesh = topology.GetMesh();
  std::vector<CriterionValues> ofCells, ofMesh, ofNeighbors;
  for (const CriterionValues& row : criteria)
  {
    (row.Criterion->CellFunction          ? ofCells
        : row.Criterion->NeighborFunction ? ofNeighbors
                                          : ofMesh)
      .push_back(row);
  }
  const vtkIdType numberOfCells = mesh.GetNumberOfCells();
  const vtkIdType slab = std::max(SlabSize, numberOfCells / NumberOfReports + 1);
  // Criteria with neighbors need the centers of all cells, which are computed in the same pass as
  // criteria of single cells.
  const bool hasCellPass = !ofCells.empty() || !ofNeighbors.empty();
  const int passes = hasCellPass + !ofMesh.empty() + !ofNeighbors.empty();
  const double total = static_cast<double>(numberOfCells) * passes;
  double done = 0;
  const auto goesOn = [&] { return progress(total > 0 ? done / total : 0); };
  const auto inSlabs = [&](auto&& evaluate)
  {
    for (vtkIdType first = 0; first < numberOfCells; first += slab)
    {
      if (!goesOn())
      {
        return false;
      }
      const vtkIdType size = std::min(slab, numberOfCells - first);
      ParallelFor(size, HeavyGrain,
        [&](vtkIdType begin, vtkIdType end) { evaluate(first + begin, first + end); });
      done += static_cast<double>(size);
    }
    return true;
  };

  std::unique_ptr<CellCenters> centers;
  if (!ofNeighbors.empty())
  {
    centers = std::make_unique<CellCenters>(numberOfCells);
  }
  if (hasCellPass && !inSlabs(CellEvaluation(mesh, options, ofCells, centers.get())))
  {
    return false;
  }
  // Check for a stop first, because building the facet table takes time.
  if (!ofNeighbors.empty() &&
    (!goesOn() || !inSlabs(NeighborEvaluation(topology, options, ofNeighbors, *centers))))
  {
    return false;
  }
  centers.reset();
  if (!ofMesh.empty())
  {
    const MeshContext context(topology, options);
    for (const CriterionValues& row : ofMesh)
    {
      if (!goesOn())
      {
        return false;
      }
      row.Criterion->MeshFunction(context, 0, 0, row.Values);
    }
    return inSlabs(
      [&](vtkIdType begin, vtkIdType end)
      {
        for (const CriterionValues& row : ofMesh)
        {
          row.Criterion->MeshFunction(context, begin, end, row.Values + begin);
        }
      });
  }
  return true;
}
}
