// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/LinkedPieces.h"

#include "Base/Parallel.h"
#include "Cell/CellNeighborhood.h"
#include "Mesh/CellFacets.h"
#include "Ranks/EqualKeys.h"
#include "Ranks/PieceBorders.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Identifies a facet across all pieces.
using FacetKey = std::array<std::uint64_t, 2>;

// A facet of a piece that another piece may have, too.
struct CandidateFacet
{
  FacetKey Key;
  std::int32_t Piece;
  Index Facet;
  std::int32_t Dimension; // of its cells
  bool Descends;          // whether its owner traverses the edge towards the smaller key

  const FacetKey& GetKey() const { return this->Key; }
  std::uint64_t GetHash() const { return this->Key[0]; }
};

// A cell at a shared facet.
struct Use
{
  FacetKey Key;
  LinkedCell Cell;
  std::int32_t Dimension;
  bool Descends, OwnerDescends;

  const FacetKey& GetKey() const { return this->Key; }
  std::uint64_t GetHash() const { return this->Key[0]; }
  auto GetOrder() const
  {
    return std::tie(this->Cell.Process, this->Cell.Piece, this->Cell.Facet, this->Cell.Cell);
  }
};
}

//------------------------------------------------------------------------------
class PieceLinker
{
public:
  PieceLinker(const std::vector<LinkedPiece>& pieces, camaron::Reducer& reducer)
    : Pieces(pieces)
    , Reducer(reducer)
    , Borders(pieces, reducer)
  {
  }

  std::vector<PieceLinks> Link()
  {
    for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
    {
      this->FindCandidates(static_cast<std::int32_t>(piece));
    }
    this->KeepShared();
    return this->MakeLinks();
  }

private:
  //----------------------------------------------------------------------------
  void FindCandidates(std::int32_t piece)
  {
    const std::vector<unsigned char> isNear = this->Borders.FindNearPoints(piece);
    if (isNear.empty())
    {
      return;
    }
    const MeshTopology& topology = *this->Pieces[piece].Topology;
    for (const int dimension : { 2, 3 })
    {
      if (HasCellsOfDimension(topology.GetMesh(), dimension))
      {
        this->FindCandidates(piece, topology.GetFacets(dimension), dimension, isNear);
      }
    }
  }

  //----------------------------------------------------------------------------
  void FindCandidates(std::int32_t piece, const FacetTable& table, int dimension,
    const std::vector<unsigned char>& isNear)
  {
    const MeshView& mesh = this->Pieces[piece].Topology->GetMesh();
    const vtkIdType numberOfCells = mesh.GetNumberOfCells();
    std::vector<std::vector<CandidateFacet>> found((numberOfCells + MediumGrain - 1) / MediumGrain);
    ParallelForEach(static_cast<vtkIdType>(found.size()), 1,
      [&](vtkIdType chunk)
      {
        CellFacets facets(mesh);
        std::vector<std::uint64_t> pointKeys;
        const vtkIdType last = std::min(numberOfCells, (chunk + 1) * MediumGrain);
        for (vtkIdType cell = chunk * MediumGrain; cell < last; ++cell)
        {
          table.ForEachOwned(cell, facets,
            [&](Index facet, const vtkIdType* points, vtkIdType size)
            {
              if (!table.IsCollapsed(facet) &&
                std::all_of(points, points + size, [&](vtkIdType p) { return isNear[p]; }))
              {
                this->AddCandidate(
                  piece, table, dimension, facet, points, size, pointKeys, found[chunk]);
              }
            });
        }
      });
    for (const std::vector<CandidateFacet>& part : found)
    {
      this->Candidates.insert(this->Candidates.end(), part.begin(), part.end());
    }
  }

  //----------------------------------------------------------------------------
  void AddCandidate(std::int32_t piece, const FacetTable& table, int dimension, Index facet,
    const vtkIdType* points, vtkIdType size, std::vector<std::uint64_t>& pointKeys,
    std::vector<CandidateFacet>& candidates) const
  {
    const LinkedPiece& from = this->Pieces[piece];
    pointKeys.clear();
    for (vtkIdType i = 0; i < size; ++i)
    {
      pointKeys.push_back(Hash(this->Borders.GetKey(piece, points[i])));
    }
    const bool descends = size == 2 && pointKeys[0] > pointKeys[1];
    std::sort(pointKeys.begin(), pointKeys.end());
    pointKeys.erase(std::unique(pointKeys.begin(), pointKeys.end()), pointKeys.end());
    if (pointKeys.size() < 2)
    {
      return; // a single position, with nothing in between
    }
    if (from.Options.Ghosts)
    {
      std::vector<Index> cells;
      table.GetCells(facet, cells);
      if (std::all_of(cells.begin(), cells.end(), [&](Index cell) { return from.IsCopy(cell); }))
      {
        return;
      }
    }
    const std::uint64_t seed =
      Mix(static_cast<std::uint64_t>(from.Block)) + static_cast<std::uint64_t>(dimension);
    FacetKey key = { Mix(seed), Mix(~seed) };
    for (const std::uint64_t pointKey : pointKeys)
    {
      key = { Mix(key[0] ^ pointKey), Mix(key[1] + pointKey) };
    }
    candidates.push_back({ key, piece, facet, dimension, descends });
  }

  //----------------------------------------------------------------------------
  // Keeps the candidates that at least two pieces have.
  void KeepShared()
  {
    using Group = std::vector<Received<CandidateFacet>>;
    const std::vector<char> isShared = AskAboutEqual(this->Candidates, this->Reducer,
      [](const Group& group) -> char
      {
        return std::any_of(group.begin(), group.end(), [&](const Received<CandidateFacet>& item)
          { return item.Process != group[0].Process || item.Sent->Piece != group[0].Sent->Piece; });
      });
    std::vector<CandidateFacet> shared;
    for (std::size_t i = 0; i < isShared.size(); ++i)
    {
      if (isShared[i])
      {
        shared.push_back(this->Candidates[i]);
      }
    }
    this->Candidates.swap(shared);
  }

  //----------------------------------------------------------------------------
  // The cells of this rank at shared facets, with all properties that others need.
  std::vector<Use> GetOwnUses() const
  {
    std::vector<Use> uses;
    std::vector<Index> cells;
    for (const CandidateFacet& candidate : this->Candidates)
    {
      const LinkedPiece& piece = this->Pieces[candidate.Piece];
      const FacetTable& table = piece.Topology->GetFacets(candidate.Dimension);
      table.GetCells(candidate.Facet, cells);
      for (const Index cell : cells)
      {
        if (piece.IsCopy(cell))
        {
          continue;
        }
        bool isReversed = false;
        for (const CellFacet use : table.GetCellFacets(cell))
        {
          isReversed = use.Facet() == candidate.Facet ? use.IsReversed() : isReversed;
        }
        Use use = {};
        use.Key = candidate.Key;
        use.Cell.Id = piece.Options.CellNumbers ? piece.Options.CellNumbers[cell]
          : piece.CellIds                       ? piece.CellIds[cell]
                                                : cell;
        use.Cell.Process = this->Reducer.GetProcess();
        use.Cell.Piece = candidate.Piece;
        use.Cell.Cell = cell;
        use.Cell.Facet = candidate.Facet;
        use.Dimension = candidate.Dimension;
        use.Descends = candidate.Descends != isReversed;
        use.OwnerDescends = candidate.Descends;
        uses.push_back(use);
      }
    }
    ParallelFor(static_cast<vtkIdType>(uses.size()), HeavyGrain,
      [&](vtkIdType begin, vtkIdType end)
      {
        CellGeometry geometry;
        for (vtkIdType i = begin; i < end; ++i)
        {
          LinkedCell& cell = uses[i].Cell;
          const LinkedPiece& piece = this->Pieces[cell.Piece];
          const MeshView& mesh = piece.Topology->GetMesh();
          GetCellCenter(mesh, cell.Cell, piece.Options, geometry, cell.Centroid, cell.Size);
          cell.Area = GetCellVector(mesh, cell.Cell, piece.Options, geometry);
        }
      });
    return uses;
  }

  //----------------------------------------------------------------------------
  // All cells at the facets that this rank shares.
  std::vector<PieceLinks> MakeLinks() const
  {
    std::vector<PieceLinks> links(this->Pieces.size());
    const std::int32_t process = this->Reducer.GetProcess();
    ForEachEqual(this->GetOwnUses(), this->Reducer,
      [&](std::vector<Use>& uses)
      {
        std::sort(uses.begin(), uses.end(),
          [](const Use& a, const Use& b) { return a.GetOrder() < b.GetOrder(); });
        for (auto own = uses.begin(); own != uses.end(); ++own)
        {
          if (own->Cell.Process != process)
          {
            continue;
          }
          const bool isSamePiece = own != uses.begin() && (own - 1)->Cell.Process == process &&
            (own - 1)->Cell.Piece == own->Cell.Piece;
          if (isSamePiece && (own - 1)->Cell.Facet == own->Cell.Facet)
          {
            continue;
          }
          FacetLinks& of =
            own->Dimension == 3 ? links[own->Cell.Piece].Faces : links[own->Cell.Piece].Edges;
          of.Process = process;
          of.Piece = own->Cell.Piece;
          if (!isSamePiece)
          {
            for (const Use& use : uses)
            {
              of.Cells.push_back(use.Cell);
              of.Descends.push_back(use.Descends);
            }
          }
          of.Entries.push_back({ own->Cell.Facet, own->OwnerDescends, of.Cells.size() - uses.size(),
            of.Cells.size() });
        }
      });
    for (std::size_t piece = 0; piece < links.size(); ++piece)
    {
      const MeshTopology& topology = *this->Pieces[piece].Topology;
      for (FacetLinks* of : { &links[piece].Faces, &links[piece].Edges })
      {
        if (of->Entries.empty())
        {
          continue;
        }
        const FacetTable& table =
          of == &links[piece].Faces ? topology.GetFaces() : topology.GetSurfaceEdges();
        std::sort(of->Entries.begin(), of->Entries.end(),
          [](const auto& a, const auto& b) { return a.Facet < b.Facet; });
        of->Marks.resize(table.GetNumberOfFacets());
        for (const auto& entry : of->Entries)
        {
          of->Marks[entry.Facet] = true;
        }
      }
    }
    return links;
  }

  const std::vector<LinkedPiece>& Pieces;
  camaron::Reducer& Reducer;
  const PieceBorders Borders;
  std::vector<CandidateFacet> Candidates;
};

//------------------------------------------------------------------------------
std::vector<PieceLinks> LinkPieces(const std::vector<LinkedPiece>& pieces, Reducer& reducer)
{
  return PieceLinker(pieces, reducer).Link();
}

//------------------------------------------------------------------------------
CellIds::CellIds(const std::vector<LinkedPiece>& pieces, Reducer& reducer)
  : Pieces(pieces)
  , Places(pieces.size())
{
  struct Part
  {
    std::int64_t Block, NumberOfCells;
    int Order, Process, Piece;
    auto GetOrder() const { return std::tie(this->Order, this->Process, this->Piece); }
  };
  std::int64_t lacksIds = 0;
  std::vector<Part> own;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    const vtkIdType size = pieces[p].Topology->GetMesh().GetNumberOfCells();
    lacksIds = lacksIds || (size > 0 && !pieces[p].CellIds);
    Index count = 0;
    for (vtkIdType cell = 0; cell < size && pieces[p].Options.Ghosts; ++cell)
    {
      this->Places[p].push_back(count);
      count += !pieces[p].IsCopy(cell);
    }
    own.push_back({ pieces[p].Block, pieces[p].Options.Ghosts ? count : size, pieces[p].Order,
      reducer.GetProcess(), static_cast<int>(p) });
  }
  reducer.Max(&lacksIds, 1);
  this->HasIds = !lacksIds;
  const std::vector<Part> all = reducer.GatherItems(own);
  for (std::size_t p = 0; p < own.size(); ++p)
  {
    std::int64_t first = 0, firstOfBlock = 0;
    for (const Part& part : all)
    {
      const bool isBefore = part.GetOrder() < own[p].GetOrder();
      firstOfBlock += part.Block < own[p].Block ? part.NumberOfCells : 0;
      first += part.Block == own[p].Block && isBefore ? part.NumberOfCells : 0;
    }
    this->First.push_back(firstOfBlock + first);
    this->FirstOfBlock.push_back(firstOfBlock);
  }
}

//------------------------------------------------------------------------------
std::int64_t CellIds::Get(std::size_t piece, vtkIdType cell) const
{
  return this->HasIds ? this->Pieces[piece].CellIds[cell]
                      : this->First[piece] +
      (this->Places[piece].empty() ? cell : vtkIdType(this->Places[piece][cell]));
}
}
