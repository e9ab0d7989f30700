// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/LinkedPieces.h"

#include "Base/Parallel.h"
#include "Cell/CellNeighborhood.h"
#include "Mesh/CellFacets.h"
#include "Ranks/PieceBorders.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace camaron
{
namespace
{
constexpr vtkIdType CellChunk = 1 << 14;
constexpr vtkIdType Grain = 1024;

//------------------------------------------------------------------------------
// Identifies a facet across all pieces.
struct Key
{
  std::uint64_t High, Low;
  bool operator==(const Key& k) const { return this->High == k.High && this->Low == k.Low; }
  bool operator<(const Key& k) const
  {
    return std::tie(this->High, this->Low) < std::tie(k.High, k.Low);
  }
};

// A facet of a piece that another piece may have, too.
struct Candidate
{
  camaron::Key Key;
  std::int32_t Piece;
  Index Facet;
  std::int32_t Dimension; // of its cells
  bool Descends;          // whether its owner traverses the edge towards the smaller key
};

struct CandidateKey
{
  camaron::Key Key;
  std::int32_t Piece;
};

// A cell at a shared facet.
struct Use
{
  camaron::Key Key;
  LinkedCell Cell;
  std::int32_t Dimension;
  bool Descends, OwnerDescends;

  auto GetOrder() const
  {
    return std::tie(
      this->Key, this->Cell.Process, this->Cell.Piece, this->Cell.Facet, this->Cell.Cell);
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
    , NumberOfProcesses(reducer.GetNumberOfProcesses())
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
    return this->MakeLinks(this->ExchangeUses());
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
    std::vector<std::vector<Candidate>> found((numberOfCells + CellChunk - 1) / CellChunk);
    ParallelFor(static_cast<vtkIdType>(found.size()), 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        CellFacets facets(mesh);
        std::vector<std::uint64_t> pointKeys;
        for (vtkIdType chunk = begin; chunk < end; ++chunk)
        {
          const vtkIdType last = std::min(numberOfCells, (chunk + 1) * CellChunk);
          for (vtkIdType cell = chunk * CellChunk; cell < last; ++cell)
          {
            const FacetTable::Range uses = table.GetCellFacets(cell);
            if (uses.size() == 0)
            {
              continue;
            }
            facets.ForEach(cell,
              [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
              {
                const Index facet = uses[static_cast<Index>(local)].Facet();
                if (table.GetCells(facet).First == cell &&
                  std::all_of(points, points + size, [&](vtkIdType p) { return isNear[p]; }) &&
                  table.GetOwnerLocalFacet(facet) == static_cast<Index>(local))
                {
                  this->AddCandidate(
                    piece, table, dimension, facet, points, size, pointKeys, found[chunk]);
                }
              });
          }
        }
      });
    for (const std::vector<Candidate>& part : found)
    {
      this->Candidates.insert(this->Candidates.end(), part.begin(), part.end());
    }
  }

  //----------------------------------------------------------------------------
  void AddCandidate(std::int32_t piece, const FacetTable& table, int dimension, Index facet,
    const vtkIdType* points, vtkIdType size, std::vector<std::uint64_t>& pointKeys,
    std::vector<Candidate>& candidates) const
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
    Key key = { Mix(seed), Mix(~seed) };
    for (const std::uint64_t pointKey : pointKeys)
    {
      key = { Mix(key.High ^ pointKey), Mix(key.Low + pointKey) };
    }
    candidates.push_back({ key, piece, facet, dimension, descends });
  }

  //----------------------------------------------------------------------------
  std::size_t GetJudge(const Key& key) const
  {
    return static_cast<std::size_t>(key.High % this->NumberOfProcesses);
  }

  //----------------------------------------------------------------------------
  // Keeps the candidates that at least two pieces have.
  void KeepShared()
  {
    std::vector<CandidateKey> keys;
    for (const Candidate& candidate : this->Candidates)
    {
      keys.push_back({ candidate.Key, candidate.Piece });
    }
    const std::vector<char> isShared = this->Reducer.Ask(
      keys, [this](const CandidateKey& key) { return this->GetJudge(key.Key); }, Judge);
    std::vector<Candidate> shared;
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
      if (isShared[i])
      {
        shared.push_back(this->Candidates[i]);
      }
    }
    this->Candidates.swap(shared);
  }

  //----------------------------------------------------------------------------
  // For every key of every rank, whether another piece has it, too.
  static std::vector<std::vector<char>> Judge(const std::vector<std::vector<CandidateKey>>& keys)
  {
    struct Item
    {
      camaron::Key Key;
      std::int32_t Process, Piece;
      std::size_t Place;
    };
    std::vector<Item> items;
    std::vector<std::vector<char>> verdicts(keys.size());
    for (std::size_t process = 0; process < keys.size(); ++process)
    {
      verdicts[process].resize(keys[process].size());
      for (std::size_t i = 0; i < keys[process].size(); ++i)
      {
        items.push_back(
          { keys[process][i].Key, static_cast<std::int32_t>(process), keys[process][i].Piece, i });
      }
    }
    std::sort(
      items.begin(), items.end(), [](const Item& a, const Item& b) { return a.Key < b.Key; });
    for (auto first = items.begin(); first != items.end();)
    {
      const auto last = std::find_if(
        first, items.end(), [&](const Item& item) { return !(item.Key == first->Key); });
      const bool isShared = std::any_of(first, last, [&](const Item& item)
        { return item.Process != first->Process || item.Piece != first->Piece; });
      for (; first != last; ++first)
      {
        verdicts[first->Process][first->Place] = isShared;
      }
    }
    return verdicts;
  }

  //----------------------------------------------------------------------------
  // The cells of this rank at shared facets, with all properties that others need.
  std::vector<Use> GetOwnUses() const
  {
    std::vector<Use> uses;
    std::vector<Index> cells;
    for (const Candidate& candidate : this->Candidates)
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
    ParallelFor(static_cast<vtkIdType>(uses.size()), Grain,
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
  // All cells at the facets that this rank shares, sorted.
  std::vector<Use> ExchangeUses()
  {
    std::vector<std::vector<Use>> sent(this->NumberOfProcesses);
    for (const Use& use : this->GetOwnUses())
    {
      sent[this->GetJudge(use.Key)].push_back(use);
    }
    std::vector<Use> judged = Join(this->Reducer.ExchangeItems(std::move(sent)));
    sent.assign(this->NumberOfProcesses, {});
    for (auto first = judged.begin(); first != judged.end();)
    {
      const auto last =
        std::find_if(first, judged.end(), [&](const Use& use) { return !(use.Key == first->Key); });
      for (auto use = first; use != last; ++use)
      {
        if (use == first || use->Cell.Process != (use - 1)->Cell.Process)
        {
          std::vector<Use>& answer = sent[use->Cell.Process];
          answer.insert(answer.end(), first, last);
        }
      }
      first = last;
    }
    return Join(this->Reducer.ExchangeItems(std::move(sent)));
  }

  //----------------------------------------------------------------------------
  static std::vector<Use> Join(const std::vector<std::vector<Use>>& parts)
  {
    std::vector<Use> all;
    for (const std::vector<Use>& part : parts)
    {
      all.insert(all.end(), part.begin(), part.end());
    }
    std::sort(all.begin(), all.end(),
      [](const Use& a, const Use& b) { return a.GetOrder() < b.GetOrder(); });
    return all;
  }

  //----------------------------------------------------------------------------
  std::vector<PieceLinks> MakeLinks(const std::vector<Use>& uses) const
  {
    std::vector<PieceLinks> links(this->Pieces.size());
    const std::int32_t process = this->Reducer.GetProcess();
    for (auto first = uses.begin(); first != uses.end();)
    {
      const auto last =
        std::find_if(first, uses.end(), [&](const Use& use) { return !(use.Key == first->Key); });
      for (auto own = first; own != last; ++own)
      {
        if (own->Cell.Process != process)
        {
          continue;
        }
        const bool isSamePiece = own != first && (own - 1)->Cell.Process == process &&
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
          for (auto use = first; use != last; ++use)
          {
            of.Cells.push_back(use->Cell);
            of.Descends.push_back(use->Descends);
          }
        }
        of.Entries.push_back({ own->Cell.Facet, own->OwnerDescends,
          of.Cells.size() - (last - first), of.Cells.size() });
      }
      first = last;
    }
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
  const int NumberOfProcesses;
  const PieceBorders Borders;
  std::vector<Candidate> Candidates;
};

//------------------------------------------------------------------------------
std::vector<PieceLinks> LinkPieces(const std::vector<LinkedPiece>& pieces, Reducer& reducer)
{
  return PieceLinker(pieces, reducer).Link();
}
}
