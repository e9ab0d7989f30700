// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Selection/Growth.h"

#include "Base/DisjointSets.h"
#include "Base/Parallel.h"
#include "Cell/CellNeighborhood.h"
#include "Criteria/MeshContext.h"
#include "Mesh/FacetLinks.h"
#include "Selection/SharedElements.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace camaron
{
namespace
{
constexpr std::int64_t None = std::numeric_limits<std::int64_t>::max();
constexpr double DegreesPerRadian = 57.295779513082320876798154814105;

/// Calls function(cell) for the cells of a mesh, with all threads.
template <typename Function>
void ForEachCell(const LinkedPiece& piece, Function&& function)
{
  ParallelForEach(piece.Topology->GetMesh().GetNumberOfCells(), MediumGrain, function);
}

//------------------------------------------------------------------------------
/// Edges of a surface where its normal changes too much.
class Creases
{
public:
  Creases(const LinkedPiece& piece, const Neighborhood& neighborhood)
  {
    const MeshView& mesh = piece.Topology->GetMesh();
    if (neighborhood.Adjacency != Adjacency::Facet || !(neighborhood.FeatureAngle < 180) ||
      !HasCellsOfDimension(mesh, 2))
    {
      return;
    }
    const FacetTable& edges = piece.Topology->GetSurfaceEdges();
    this->First = HasCellsOfDimension(mesh, 3) ? piece.Topology->GetFaces().GetNumberOfFacets() : 0;
    this->IsCrease.resize(edges.GetNumberOfFacets());
    const MeshContext context(*piece.Topology, piece.Options);
    const std::vector<Vector>& areas = context.GetCellVectors();
    std::vector<Vector> around;
    std::vector<Index> cells;
    for (Index edge = 0; edge < edges.GetNumberOfFacets(); ++edge)
    {
      this->FindNormals(piece, edges, edge, areas, cells, around);
      this->IsCrease[edge] = Turns(around, neighborhood.FeatureAngle);
    }
  }

  bool Has(vtkIdType element) const
  {
    return element >= this->First && !this->IsCrease.empty() &&
      this->IsCrease[element - this->First];
  }

private:
  /// The normals of all cells at an edge, as if each traversed it opposite to the owner.
  static void FindNormals(const LinkedPiece& piece, const FacetTable& edges, Index edge,
    const std::vector<Vector>& areas, std::vector<Index>& cells, std::vector<Vector>& normals)
  {
    normals.clear();
    edges.GetCells(edge, cells);
    for (const Index cell : cells)
    {
      if (piece.IsCopy(cell))
      {
        continue; // it is in the links
      }
      for (const CellFacet use : edges.GetCellFacets(cell))
      {
        if (use.Facet() == edge)
        {
          normals.push_back(use.IsReversed() ? areas[cell] : -areas[cell]);
        }
      }
    }
    if (piece.Options.Links)
    {
      piece.Options.Links->Edges.ForEach(edge, [&](const LinkedCell& cell, bool isReversed)
        { normals.push_back(isReversed ? cell.Area : -cell.Area); });
    }
  }

  static bool Turns(const std::vector<Vector>& normals, double limit)
  {
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
      for (std::size_t k = i + 1; k < normals.size(); ++k)
      {
        // Consistently oriented neighbors traverse their edge in opposite directions.
        const Vector other = -normals[k];
        const double angle = std::atan2(Norm(Cross(normals[i], other)), Dot(normals[i], other));
        if (angle * DegreesPerRadian > limit)
        {
          return true;
        }
      }
    }
    return false;
  }

  vtkIdType First = 0;
  std::vector<bool> IsCrease;
};

//------------------------------------------------------------------------------
/// The elements that connect cells.
class Bridges
{
public:
  Bridges(
    const std::vector<LinkedPiece>& pieces, const Neighborhood& neighborhood, Reducer& reducer)
    : Elements(MakeElements(pieces, neighborhood.Adjacency))
    , Shared(pieces, this->Elements, reducer)
  {
    for (const LinkedPiece& piece : pieces)
    {
      this->CreasesOf.emplace_back(piece, neighborhood);
    }
  }

  vtkIdType GetSize(std::size_t piece) const { return this->Elements[piece].GetSize(); }

  /// Calls visit(element) for the elements of a cell that connect it to others.
  template <typename Visit>
  void ForEach(std::size_t piece, vtkIdType cell, Visit&& visit) const
  {
    const Creases& creases = this->CreasesOf[piece];
    this->Elements[piece].ForEach(cell,
      [&](vtkIdType element)
      {
        if (!creases.Has(element))
        {
          visit(element);
        }
      });
  }

  SharedElements& GetShared() { return this->Shared; }

private:
  std::vector<CellElements> Elements;
  SharedElements Shared;
  std::vector<Creases> CreasesOf;
};

//------------------------------------------------------------------------------
/// The cells added to a selection in the last step, and the elements across which it continues.
class Front
{
public:
  Front(const Bridges& bridges, const LinkedPiece& piece, std::size_t number,
    const std::vector<unsigned char>& allowed, const std::vector<unsigned char>& marks)
  {
    std::vector<std::atomic<Index>> counts(bridges.GetSize(number));
    const auto forEachOther = [&](auto&& visit)
    {
      ForEachCell(piece,
        [&](vtkIdType cell)
        {
          if (!marks[cell] && allowed[cell] && !piece.IsCopy(cell))
          {
            bridges.ForEach(number, cell, [&](vtkIdType element) { visit(cell, element); });
          }
        });
    };
    forEachOther([&](vtkIdType, vtkIdType element)
      { counts[element].fetch_add(1, std::memory_order_relaxed); });
    this->Offsets.resize(counts.size() + 1);
    for (std::size_t element = 0; element < counts.size(); ++element)
    {
      this->Offsets[element + 1] = this->Offsets[element] + counts[element];
    }
    this->Others.resize(this->Offsets.back());
    forEachOther(
      [&](vtkIdType cell, vtkIdType element)
      {
        const Index place = counts[element].fetch_sub(1, std::memory_order_relaxed) - 1;
        this->Others[this->Offsets[element] + place] = static_cast<Index>(cell);
      });
    for (std::size_t cell = 0; cell < marks.size(); ++cell)
    {
      if (marks[cell])
      {
        this->Cells.push_back(static_cast<Index>(cell));
      }
    }
  }

  /// Finds the elements of the cells that have not been @a reached, and marks them as reached.
  void Leave(const Bridges& bridges, std::size_t number, std::vector<unsigned char>& reached)
  {
    for (const Index cell : this->Cells)
    {
      bridges.ForEach(number, cell,
        [&](vtkIdType element)
        {
          if (!reached[element])
          {
            reached[element] = 1;
            this->Reach(element);
          }
        });
    }
    this->Cells.clear();
  }

  /// Whether there are unprocessed cells.
  bool HasCells() const { return !this->Cells.empty(); }

  /// Continues across an element.
  void Reach(vtkIdType element) { this->Elements.push_back(static_cast<Index>(element)); }

  /// Continues to the other cells with the elements, and marks them.
  void Enter(std::vector<unsigned char>& marks)
  {
    for (const Index element : this->Elements)
    {
      for (vtkIdType i = this->Offsets[element]; i < this->Offsets[element + 1]; ++i)
      {
        const Index cell = this->Others[i];
        if (!marks[cell])
        {
          marks[cell] = 1;
          this->Cells.push_back(cell);
        }
      }
    }
    this->Elements.clear();
  }

private:
  std::vector<vtkIdType> Offsets; // of the elements
  std::vector<Index> Others;      // the cells that may be added
  std::vector<Index> Cells, Elements;
};

//------------------------------------------------------------------------------
/// The connected components of a set of cells, with labels that are the same in all pieces.
class Parts
{
public:
  Parts(Bridges& bridges, const CellMarks& cells, Reducer& reducer)
    : Cells(cells)
  {
    this->Join(bridges);
    this->JoinPieces(bridges, reducer);
  }

  std::int64_t GetLabel(std::size_t piece, vtkIdType cell)
  {
    return this->Labels[piece][this->Sets[piece].Find(cell)];
  }
  /// The rank that owns the label.
  static int GetProcess(std::int64_t label)
  {
    return static_cast<int>(label >> CellBits >> PieceBits);
  }

  /// Calls visit(piece, cell) for the cells of the set.
  template <typename Visit>
  void ForEach(Visit&& visit) const
  {
    for (std::size_t piece = 0; piece < this->Cells.size(); ++piece)
    {
      for (std::size_t cell = 0; cell < this->Cells[piece].size(); ++cell)
      {
        if (this->Cells[piece][cell])
        {
          visit(piece, static_cast<vtkIdType>(cell));
        }
      }
    }
  }

private:
  static constexpr int CellBits = 31, PieceBits = 14; // leaves 18 bits for ranks

  void Join(const Bridges& bridges)
  {
    for (std::size_t piece = 0; piece < this->Cells.size(); ++piece)
    {
      this->Sets.emplace_back(this->Cells[piece].size());
      this->FirstCells.emplace_back(bridges.GetSize(piece), -1);
    }
    this->ForEach(
      [&](std::size_t piece, vtkIdType cell)
      {
        DisjointSets& sets = this->Sets[piece];
        sets.Insert(cell);
        bridges.ForEach(piece, cell,
          [&](vtkIdType element)
          {
            Index& first = this->FirstCells[piece][element];
            if (first < 0)
            {
              first = static_cast<Index>(cell);
            }
            sets.Join(first, cell);
          });
      });
  }

  // Smaller labels spread over shared elements until nothing changes.
  void JoinPieces(Bridges& bridges, Reducer& reducer)
  {
    for (std::size_t piece = 0; piece < this->Cells.size(); ++piece)
    {
      const std::int64_t first = ((static_cast<std::int64_t>(reducer.GetProcess()) << PieceBits) +
                                   static_cast<std::int64_t>(piece))
        << CellBits;
      this->Labels.emplace_back(this->Cells[piece].size());
      for (std::size_t cell = 0; cell < this->Cells[piece].size(); ++cell)
      {
        this->Labels[piece][cell] = first + static_cast<std::int64_t>(cell);
      }
    }
    const std::vector<SharedElements::Element>& shared = bridges.GetShared().Get();
    std::vector<std::int64_t> values;
    for (std::int64_t hasChanged = 1; hasChanged;)
    {
      values.clear();
      for (const SharedElements::Element& element : shared)
      {
        const Index cell = this->FirstCells[element.Piece][element.Number];
        values.push_back(cell < 0 ? None : this->GetLabel(element.Piece, cell));
      }
      bridges.GetShared().Minimize(values);
      hasChanged = 0;
      for (std::size_t i = 0; i < shared.size(); ++i)
      {
        const Index cell = this->FirstCells[shared[i].Piece][shared[i].Number];
        if (cell >= 0 && values[i] < this->GetLabel(shared[i].Piece, cell))
        {
          this->Labels[shared[i].Piece][this->Sets[shared[i].Piece].Find(cell)] = values[i];
          hasChanged = 1;
        }
      }
      reducer.Max(&hasChanged, 1);
    }
  }

  const CellMarks& Cells;
  std::vector<DisjointSets> Sets;                // of the cells of each piece
  std::vector<std::vector<Index>> FirstCells;    // of each element
  std::vector<std::vector<std::int64_t>> Labels; // of the sets, at their representative cells
};

//------------------------------------------------------------------------------
bool IsInOnePiece(const std::vector<LinkedPiece>& pieces, Reducer& reducer)
{
  auto numberOfPieces = static_cast<std::int64_t>(pieces.size());
  reducer.Sum(&numberOfPieces, 1);
  return numberOfPieces == 1;
}

//------------------------------------------------------------------------------
// Whether any rank has new cells; if not, no further layer has.
bool IsAnyNew(bool isNewHere, Reducer& reducer)
{
  std::int64_t isNew = isNewHere ? 1 : 0;
  reducer.Max(&isNew, 1);
  return isNew != 0;
}
}

//------------------------------------------------------------------------------
void Grow(const std::vector<LinkedPiece>& pieces, const Neighborhood& neighborhood,
  int numberOfLayers, const CellMarks& allowed, Reducer& reducer, CellMarks& marks)
{
  if (neighborhood.Adjacency == Adjacency::Edge && IsInOnePiece(pieces, reducer))
  {
    if (!pieces.empty())
    {
      GrowOverEdges(pieces.front(), numberOfLayers, allowed.front(), marks.front());
    }
    return;
  }
  Bridges bridges(pieces, neighborhood, reducer);
  std::vector<Front> fronts;
  std::vector<std::vector<unsigned char>> reached;
  for (std::size_t piece = 0; piece < pieces.size() && numberOfLayers > 0; ++piece)
  {
    fronts.emplace_back(bridges, pieces[piece], piece, allowed[piece], marks[piece]);
    reached.emplace_back(bridges.GetSize(piece));
  }
  for (int layer = 0; layer < numberOfLayers; ++layer)
  {
    for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    {
      fronts[piece].Leave(bridges, piece, reached[piece]);
    }
    for (const SharedElements::Element& element : bridges.GetShared().Share(reached))
    {
      fronts[element.Piece].Reach(element.Number);
    }
    for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    {
      fronts[piece].Enter(marks[piece]);
    }
    const auto hasCells = [](const Front& front) { return front.HasCells(); };
    if (!IsAnyNew(std::any_of(fronts.begin(), fronts.end(), hasCells), reducer))
    {
      break;
    }
  }
}

//------------------------------------------------------------------------------
void GrowPoints(const std::vector<LinkedPiece>& pieces, Adjacency adjacency, int numberOfLayers,
  CellMarks allowed, Reducer& reducer, CellMarks& marks)
{
  const std::vector<CellElements> points = MakeElements(pieces, Adjacency::Vertex);
  SharedElements shared(pieces, points, reducer);
  shared.Share(allowed);
  shared.Share(marks);
  for (int layer = 0; layer < numberOfLayers; ++layer)
  {
    CellMarks next = marks;
    for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    {
      const MeshView& mesh = pieces[piece].Topology->GetMesh();
      CellFacets facets(mesh);
      const auto spread = [&](const vtkIdType* group, vtkIdType size)
      {
        if (std::any_of(group, group + size, [&](vtkIdType p) { return marks[piece][p] != 0; }))
        {
          std::for_each(group, group + size, [&](vtkIdType p) { next[piece][p] = 1; });
        }
      };
      std::vector<vtkIdType> corners;
      for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
      {
        if (adjacency == Adjacency::Vertex)
        {
          corners.clear();
          points[piece].ForEach(cell, [&](vtkIdType point) { corners.push_back(point); });
          spread(corners.data(), static_cast<vtkIdType>(corners.size()));
        }
        else if (adjacency == Adjacency::Facet)
        {
          facets.ForEach(
            cell, [&](const vtkIdType* group, vtkIdType size, vtkIdType) { spread(group, size); });
        }
        else
        {
          facets.ForEachEdge(cell,
            [&](vtkIdType a, vtkIdType b)
            {
              const vtkIdType ends[2] = { a, b };
              spread(ends, 2);
            });
        }
      }
    }
    shared.Share(next);
    bool isNew = false;
    for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    {
      for (std::size_t point = 0; point < marks[piece].size(); ++point)
      {
        const unsigned char mark = marks[piece][point];
        marks[piece][point] |= next[piece][point] & allowed[piece][point];
        isNew |= marks[piece][point] != mark;
      }
    }
    if (!IsAnyNew(isNew, reducer))
    {
      break;
    }
  }
}

//------------------------------------------------------------------------------
void Flood(const std::vector<LinkedPiece>& pieces, const Neighborhood& neighborhood,
  const CellMarks& allowed, Reducer& reducer, CellMarks& marks)
{
  Bridges bridges(pieces, neighborhood, reducer);
  CellMarks cells = marks;
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
  {
    ForEachCell(pieces[piece], [&](vtkIdType cell)
      { cells[piece][cell] |= allowed[piece][cell] && !pieces[piece].IsCopy(cell); });
  }
  Parts parts(bridges, cells, reducer);
  std::vector<std::int64_t> seeds;
  parts.ForEach(
    [&](std::size_t piece, vtkIdType cell)
    {
      if (marks[piece][cell])
      {
        seeds.push_back(parts.GetLabel(piece, cell));
      }
    });
  const auto sortOut = [&seeds]
  {
    std::sort(seeds.begin(), seeds.end());
    seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
  };
  sortOut();
  seeds = reducer.GatherItems(seeds);
  sortOut();
  parts.ForEach(
    [&](std::size_t piece, vtkIdType cell)
    {
      marks[piece][cell] =
        std::binary_search(seeds.begin(), seeds.end(), parts.GetLabel(piece, cell));
    });
}

//------------------------------------------------------------------------------
LargestParts FindLargestParts(const std::vector<LinkedPiece>& pieces,
  const Neighborhood& neighborhood, std::int64_t count,
  const std::vector<std::vector<vtkIdType>>& ids, Reducer& reducer, const CellMarks& marks)
{
  struct Part
  {
    std::int64_t Label, Size, Id;
    bool operator<(const Part& other) const
    {
      return std::make_tuple(-this->Size, this->Id) < std::make_tuple(-other.Size, other.Id);
    }
  };
  const auto add = [](std::map<std::int64_t, Part>& parts, const Part& part)
  {
    Part& known = parts.emplace(part.Label, Part{ part.Label, 0, None }).first->second;
    known.Size += part.Size;
    known.Id = std::min(known.Id, part.Id);
  };

  Bridges bridges(pieces, neighborhood, reducer);
  Parts parts(bridges, marks, reducer);
  std::map<std::int64_t, Part> own, whole;
  parts.ForEach([&](std::size_t piece, vtkIdType cell)
    { add(own, { parts.GetLabel(piece, cell), 1, ids[piece][cell] }); });

  // Every rank merges the parts whose labels it owns.
  std::vector<std::vector<Part>> sent(reducer.GetNumberOfProcesses());
  for (const auto& part : own)
  {
    sent[Parts::GetProcess(part.first)].push_back(part.second);
  }
  for (const std::vector<Part>& list : reducer.ExchangeItems(std::move(sent)))
  {
    for (const Part& part : list)
    {
      add(whole, part);
    }
  }
  std::vector<Part> largest;
  for (const auto& part : whole)
  {
    largest.push_back(part.second);
  }
  LargestParts result;
  result.Total = static_cast<std::int64_t>(largest.size());
  reducer.Sum(&result.Total, 1);
  const auto keepLargest = [&]
  {
    std::sort(largest.begin(), largest.end());
    largest.resize(
      std::min(largest.size(), count > 0 ? static_cast<std::size_t>(count) : largest.size()));
  };
  keepLargest();
  largest = reducer.GatherItems(largest);
  keepLargest();
  std::map<std::int64_t, std::size_t> numbers; // of labels
  for (const Part& part : largest)
  {
    numbers.emplace(part.Label, numbers.size());
    result.Sizes.push_back(part.Size);
  }
  result.Cells.resize(pieces.size());
  parts.ForEach(
    [&](std::size_t piece, vtkIdType cell)
    {
      const auto number = numbers.find(parts.GetLabel(piece, cell));
      if (number != numbers.end())
      {
        result.Cells[piece].push_back({ cell, number->second });
      }
    });
  return result;
}

//------------------------------------------------------------------------------
std::int64_t KeepComponent(const std::vector<LinkedPiece>& pieces, const Neighborhood& neighborhood,
  std::int64_t rank, const std::vector<std::vector<vtkIdType>>& ids, Reducer& reducer,
  CellMarks& marks)
{
  const LargestParts parts = FindLargestParts(pieces, neighborhood, rank, ids, reducer, marks);
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
  {
    std::fill(marks[piece].begin(), marks[piece].end(), static_cast<unsigned char>(0));
    for (const LargestParts::PartCell& entry : parts.Cells[piece])
    {
      marks[piece][entry.Cell] = entry.Part + 1 == static_cast<std::size_t>(rank);
    }
  }
  return parts.Total;
}
}
