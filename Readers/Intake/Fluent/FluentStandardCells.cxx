// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentMesh.h"

#include "Base/Parallel.h"
#include "Intake/FaceMesh/CellRing.h"
#include "Intake/FaceMesh/GridArrays.h"
#include "Intake/Fluent/FluentCellNodes.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <deque>
#include <numeric>
#include <vector>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
/**
 * Creates cells in one pass over the faces. Faces are read in the order of their ids, and each adds
 * its data to the nodes of the cells on its sides, so only faces of incomplete cells of few faces
 * are stored. Nodes are in the same order as from GridBuilder.
 *
 * Any thread may read a face; it sorts its sides by the shares of their cells, which are sets of
 * cells. Each thread then processes one share, in the order of the faces. So no two threads change
 * the same cell.
 */
class FluentStandardCells
{
public:
  explicit FluentStandardCells(const FluentMesh& mesh)
    : Mesh(mesh)
    , Count(mesh.Piece.GetNumberOfCells())
  {
  }

  /// Determines the position of every cell; false if some are of other types.
  bool Place();
  bool Build(FluentInteriorZones& zones, vtkUnstructuredGrid* grid, const Progress& progress);

private:
  using Id = vtkTypeInt32;
  struct Face
  {
    const char* Nodes; ///< ids of the file, from 1; not checked
    std::int32_t Size;
    Id Cells[2]; ///< of the piece, -1 for none
    Id GetNode(int i, bool swap) const
    {
      return Load<std::int32_t>(this->Nodes + 4 * std::ptrdiff_t(i), swap);
    }
  };
  struct Side;
  class Share;
  static constexpr int MaxShares = 8;
  using Begins = std::array<std::uint32_t, MaxShares + 1>;

  /// Shares consist of many ranges of cells, so that all are used in every batch.
  std::size_t GetShare(Id cell) const
  {
    constexpr int RangeBits = 9;
    return static_cast<std::size_t>(cell >> RangeBits & (this->NumberOfShares - 1));
  }
  Begins SortSides(const Face* faces, vtkIdType count, bool swap, Side* sides) const;

  bool PlaceMixed();
  unsigned char GetType(vtkIdType cell) const
  {
    return this->CommonType != 0 ? this->CommonType : this->Types[cell];
  }
  vtkIdType GetOffset(vtkIdType cell) const
  {
    return this->CommonType != 0 ? this->CommonSize * cell : this->Offsets[cell];
  }
  bool FindFaces(const FluentFaces::Run& run, vtkIdType begin, vtkIdType end, Face* faces) const;
  bool AreNodesGood(const Face& face, bool swap) const;
  bool AddFaces(FluentInteriorZones& zones, const Progress& progress);
  bool Finish(const Progress& progress);

  const FluentMesh& Mesh;
  vtkIdType Count;
  int NumberOfShares = 1;       ///< a power of two
  unsigned char CommonType = 0; ///< of all cells, or 0
  vtkIdType CommonSize = 0;     ///< number of nodes of each cell then
  Buffer<unsigned char> Types;
  Buffer<Id> Offsets;
  Buffer<Id> Nodes; ///< ids of the file, or data from which they follow; finally points
  FluentCellState* States = nullptr;
};

//------------------------------------------------------------------------------
// The data of a face for a cell: its nodes, oriented so that the normal points inward.
struct FluentStandardCells::Side
{
  static constexpr int MaxSize = 4;
  Id Cell;
  Id Nodes[MaxSize];
  int Size; ///< 0 for faces of other cells

  /// The normal points into the first cell of the face. Members are written one by one, as copying
  /// the whole object would stall on the pending stores.
  void Set(const Face& face, int side, bool swap)
  {
    this->Cell = face.Cells[side];
    this->Size = face.Size;
    const auto set = [&](Id* nodes, auto... indices)
    { ((*nodes++ = face.GetNode(indices, swap)), ...); };
    switch (face.Size)
    {
      case 2:
        set(this->Nodes, side, 1 - side);
        break;
      case 3:
        set(this->Nodes, 0, 1 + side, 2 - side);
        break;
      case 4:
        set(this->Nodes, 0, 1 + 2 * side, 2, 3 - 2 * side);
        break;
      default:
        this->Size = 0;
    }
  }
};

//------------------------------------------------------------------------------
// Adds faces to the cells of one share.
class FluentStandardCells::Share
{
public:
  explicit Share(FluentStandardCells& cells)
    : Cells(cells)
    , Matcher(PointSource())
  {
  }

  /// False if a face does not fit.
  bool Add(const Side* sides, vtkIdType size)
  {
    bool good = true;
    for (vtkIdType i = 0; i < size && good; ++i)
    {
      const vtkIdType next = sides[std::min(i + Ahead, size - 1)].Cell;
      this->Prefetch(next, this->Cells.GetOffset(next));
      const Side& side = sides[i];
      const unsigned char type = this->Cells.GetType(side.Cell);
      Id* const nodes = &this->Cells.Nodes[this->Cells.GetOffset(side.Cell)];
      FluentCellState& state = this->Cells.States[side.Cell];
      if (type == VTK_TETRA)
      {
        good = side.Size == 3 &&
          FluentTetrahedron::Add(
            nodes, state, FluentTetrahedron::Face::Of(side.Nodes[0], side.Nodes[1], side.Nodes[2]));
        continue;
      }
      good = state != FluentCellComplete &&
        (type == VTK_HEXAHEDRON ? side.Size == 4 && AddToHexahedron(nodes, state, side.Nodes)
                                : this->AddToOther(type, nodes, state, side));
    }
    return good;
  }

private:
  static constexpr vtkIdType Ahead = 16; // distance of prefetching, in sides

  void Prefetch(vtkIdType cell, vtkIdType offset) const
  {
    camaron::Prefetch(&this->Cells.States[cell]);
    camaron::Prefetch(&this->Cells.Nodes[offset]);
  }

  /// A face of an incomplete cell.
  struct Waiting
  {
    Id Next;
    Side Face;
  };

  /// Faces of other cells are kept until the last one arrives. The state is their number, and node
  /// 0 the index of the last one.
  bool AddToOther(unsigned char type, Id* nodes, FluentCellState& state, const Side& side)
  {
    constexpr int MaxFaces = 5;
    const bool isFlat = type == VTK_TRIANGLE || type == VTK_QUAD;
    const int size = type == VTK_TRIANGLE ? 3 : type == VTK_QUAD ? 4 : MaxFaces;
    const Waiting waiting{ state > 0 ? nodes[0] : -1, side };
    if (static_cast<int>(state) + 1 < size)
    {
      ++state;
      nodes[0] = this->Keep(waiting);
      return true;
    }
    constexpr FaceDirection Inward = FaceDirection::Inward;
    constexpr FaceDirection directions[] = { Inward, Inward, Inward, Inward, Inward };
    IdList lists[MaxFaces];
    const Waiting* last = &waiting;
    for (int i = size - 1; i >= 0; --i)
    {
      lists[i] = { reinterpret_cast<const char*>(last->Face.Nodes), last->Face.Size, 0 };
      last = i > 0 ? &this->Kept[static_cast<std::size_t>(last->Next)] : nullptr;
    }
    if (!(isFlat ? this->Ring.Make(lists, directions, size)
                 : PrimitiveMatcher::Guess(lists, size) == type &&
              this->Matcher.Match(type, lists, directions)))
    {
      return false;
    }
    for (Id index = waiting.Next; index >= 0;)
    {
      this->Free.push_back(index);
      index = this->Kept[static_cast<std::size_t>(index)].Next;
    }
    std::copy_n(isFlat ? this->Ring.GetPoints().data() : this->Matcher.GetNodes(),
      isFlat ? size : PrimitiveMatcher::GetNumberOfNodes(type), nodes);
    state = FluentCellComplete;
    return true;
  }
  Id Keep(const Waiting& face)
  {
    if (this->Free.empty())
    {
      this->Free.push_back(static_cast<Id>(this->Kept.size()));
      this->Kept.emplace_back();
    }
    const Id index = this->Free.back();
    this->Free.pop_back();
    this->Kept[static_cast<std::size_t>(index)] = face;
    return index;
  }

  FluentStandardCells& Cells;
  std::deque<Waiting> Kept;
  std::vector<Id> Free; ///< unused positions in Kept
  PrimitiveMatcher Matcher;
  CellRing Ring;
};

//------------------------------------------------------------------------------
bool FluentStandardCells::Place()
{
  this->Types = Buffer<unsigned char>(this->Count);
  this->Offsets = Buffer<Id>(this->Count + 1);
  if (this->Count == 0 || !this->Mesh.Piece.IsWhole() ||
    !this->Mesh.Cells.HaveOneElement(0, this->Count))
  {
    return this->PlaceMixed();
  }
  const FluentShape shape = this->Mesh.GetShape(0);
  this->CommonType = shape.Type;
  this->CommonSize = shape.Nodes;
  return shape.Faces > 0 && this->Count * shape.Nodes <= INT32_MAX &&
    this->Count * shape.Faces <= 2 * this->Mesh.Faces.GetCount();
}

//------------------------------------------------------------------------------
bool FluentStandardCells::PlaceMixed()
{
  std::atomic<bool> areStandard{ true };
  std::atomic<vtkIdType> faces{ 0 };
  const vtkIdType nodes = ParallelScan(
    this->Count, HeavyGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType sum = 0, sumOfFaces = 0;
      const bool isOne = this->Mesh.Piece.IsWhole() && this->Mesh.Cells.HaveOneElement(begin, end);
      FluentShape shape = this->Mesh.GetShape(begin);
      for (vtkIdType cell = begin; cell < end && areStandard; ++cell)
      {
        shape = isOne ? shape : this->Mesh.GetShape(cell);
        if (shape.Faces == 0)
        {
          areStandard = false;
        }
        this->Types[cell] = shape.Type;
        this->Offsets[cell] = static_cast<Id>(sum);
        sum += shape.Nodes;
        sumOfFaces += shape.Faces;
      }
      faces += sumOfFaces;
      return sum;
    },
    [&](vtkIdType begin, vtkIdType end, vtkIdType before)
    {
      for (vtkIdType cell = begin; cell < end && areStandard; ++cell)
      {
        this->Offsets[cell] += static_cast<Id>(before);
      }
    });
  if (!areStandard || nodes > INT32_MAX || faces > 2 * this->Mesh.Faces.GetCount())
  {
    return false;
  }
  this->Offsets[this->Count] = static_cast<Id>(nodes);
  return true;
}

//------------------------------------------------------------------------------
// Checks the nodes of faces without cells in the piece; those of others are checked when the cells
// are finished.
bool FluentStandardCells::AreNodesGood(const Face& face, bool swap) const
{
  const auto maxNode = static_cast<std::uint64_t>(this->Mesh.Piece.GetNumberOfMeshPoints());
  bool good = true;
  for (int i = 0; i < face.Size; ++i)
  {
    good &= static_cast<std::uint32_t>(face.GetNode(i, swap)) - 1 < maxNode;
  }
  return good;
}

//------------------------------------------------------------------------------
// Faces of one block; false if ids are invalid, or if BuildFluentCells warns about a face.
bool FluentStandardCells::FindFaces(
  const FluentFaces::Run& run, vtkIdType begin, vtkIdType end, Face* faces) const
{
  bool good = true;
  FluentFaces::ForEachOf(run, begin, end,
    [&](vtkIdType position, const FluentFace& record)
    {
      Face& face = faces[position - begin];
      face.Nodes = record.Nodes.Ids;
      face.Size = record.Nodes.Size;
      for (int side = 0; side < 2; ++side)
      {
        const std::int32_t id = record.GetCell(side);
        good &= id >= 0 && id <= this->Mesh.Cells.GetCount();
        face.Cells[side] = face.Size == 0 ? -1 : static_cast<Id>(this->Mesh.FindCell(id));
      }
      good &= !run.HasOddCells(record.GetCell(0), record.GetCell(1));
      if (std::max(face.Cells[0], face.Cells[1]) < 0)
      {
        good &= this->AreNodesGood(face, run.Swap);
      }
    });
  return good;
}

//------------------------------------------------------------------------------
// Sorts the sides of faces with a cell in the piece by the share of the cell; returns where the
// shares begin.
FluentStandardCells::Begins FluentStandardCells::SortSides(
  const Face* faces, vtkIdType count, bool swap, Side* sides) const
{
  Begins begins{};
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (const Id cell : faces[i].Cells)
    {
      begins[this->GetShare(std::max(cell, 0)) + 1] += cell >= 0;
    }
  }
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  Begins places = begins;
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (int side = 0; side < 2; ++side)
    {
      const Id cell = faces[i].Cells[side];
      if (cell >= 0)
      {
        sides[places[this->GetShare(cell)]++].Set(faces[i], side, swap);
      }
    }
  }
  return begins;
}

//------------------------------------------------------------------------------
bool FluentStandardCells::AddFaces(FluentInteriorZones& zones, const Progress& progress)
{
  while (
    2 * this->NumberOfShares <= std::min(vtkSMPTools::GetEstimatedNumberOfThreads(), MaxShares))
  {
    this->NumberOfShares *= 2;
  }
  std::deque<Share> shares;
  for (int i = 0; i < this->NumberOfShares; ++i)
  {
    shares.emplace_back(*this);
  }
  // Large enough that waiting for other threads costs little, and small enough for the processor's
  // cache, and compared with the memory of the cells.
  constexpr vtkIdType BlocksPerShare = 32, BlockSize = FluentFaces::BlockSize;
  constexpr vtkIdType CellsPerBlock = 8 * BlockSize;
  const vtkIdType most = this->NumberOfShares == 1 ? 1 : this->NumberOfShares * BlocksPerShare;
  const vtkIdType blocks = std::max<vtkIdType>(1, std::min(most, this->Count / CellsPerBlock));
  const vtkIdType step = std::min(blocks * BlockSize, this->Mesh.Faces.GetCount());
  Buffer<Side> sides(2 * step);
  std::vector<Begins> begins(static_cast<std::size_t>(blocks)); // of shares in sides
  return this->Mesh.Faces.ForEachBatch(progress, true,
    [&](const FluentFaces::Run& batch, const Progress& part)
    {
      std::atomic<bool> good{ true };
      for (vtkIdType begin = batch.Begin; begin < batch.End && batch.Bounds && good; begin += step)
      {
        const vtkIdType count = std::min(step, batch.End - begin);
        const vtkIdType used = (count + BlockSize - 1) / BlockSize;
        ParallelFor(used, BlocksPerShare / 4,
          [&](vtkIdType firstBlock, vtkIdType lastBlock)
          {
            std::vector<Face> faces(static_cast<std::size_t>(BlockSize));
            for (vtkIdType block = firstBlock; block < lastBlock; ++block)
            {
              const vtkIdType first = begin + block * BlockSize;
              const vtkIdType last = std::min(first + BlockSize, begin + count);
              if (!this->FindFaces(batch, first, last, faces.data()))
              {
                good = false;
                continue;
              }
              zones.Add(batch, first, last, this->Mesh.Cells);
              begins[static_cast<std::size_t>(block)] = this->SortSides(
                faces.data(), last - first, batch.Swap, sides.data() + 2 * block * BlockSize);
            }
          });
        ParallelForEach(good ? this->NumberOfShares : 0, 1,
          [&](vtkIdType share)
          {
            const auto i = static_cast<std::size_t>(share);
            for (vtkIdType block = 0; block < used && good; ++block)
            {
              const Begins& places = begins[static_cast<std::size_t>(block)];
              const Side* const own = sides.data() + 2 * block * BlockSize + places[i];
              if (!shares[i].Add(own, vtkIdType(places[i + 1]) - places[i]))
              {
                good = false;
              }
            }
          });
        good = good &&
          part.Report(static_cast<double>(begin + count - batch.Begin) /
            static_cast<double>(batch.End - batch.Begin));
      }
      return good.load();
    });
}

//------------------------------------------------------------------------------
// Converts ids of the file to points; false if some cells are incomplete.
bool FluentStandardCells::Finish(const Progress& progress)
{
  const bool isWhole = this->Mesh.Piece.IsWhole();
  const auto maxNode = static_cast<std::uint32_t>(this->Mesh.Piece.GetNumberOfMeshPoints());
  std::atomic<bool> good{ true };
  return progress.ForBlocks(this->Count, MediumGrain,
           [&](vtkIdType first, vtkIdType end)
           {
             bool isGood = true;
             for (vtkIdType cell = first; cell < end; ++cell)
             {
               isGood &= this->GetType(cell) == VTK_TETRA
                 ? FluentTetrahedron::Finish(
                     &this->Nodes[this->GetOffset(cell)], this->States[cell])
                 : this->States[cell] == FluentCellComplete;
             }
             Id* const begin = this->Nodes.data() + this->GetOffset(first);
             Id* const lastNode = this->Nodes.data() + this->GetOffset(end);
             for (Id* node = begin; node < lastNode; ++node)
             {
               --*node;
               isGood &= static_cast<std::uint32_t>(*node) < maxNode;
             }
             for (Id* node = begin; node < lastNode && isGood && !isWhole; ++node)
             {
               *node = static_cast<Id>(this->Mesh.Piece.FindPoint(*node));
             }
             for (vtkIdType cell = first; cell < end && this->CommonType != 0; ++cell)
             {
               this->Offsets[cell] = static_cast<Id>(this->GetOffset(cell));
               this->Types[cell] = this->CommonType;
             }
             if (!isGood)
             {
               good = false;
             }
           }) &&
    good;
}

//------------------------------------------------------------------------------
bool FluentStandardCells::Build(
  FluentInteriorZones& zones, vtkUnstructuredGrid* grid, const Progress& progress)
{
  // Offsets of cells of one type are filled at the end; until then their memory is used for states.
  Buffer<FluentCellState> states(this->CommonType != 0 ? 0 : this->Count);
  this->States = this->CommonType != 0 ? reinterpret_cast<FluentCellState*>(this->Offsets.data())
                                       : states.data();
  ParallelFor(this->Count, LightGrain, [this](vtkIdType begin, vtkIdType end)
    { std::fill(this->States + begin, this->States + end, FluentCellState(0)); });
  this->Offsets[this->Count] = static_cast<Id>(this->GetOffset(this->Count));
  this->Nodes = Buffer<Id>(this->Offsets[this->Count]);
  if (!this->AddFaces(zones, progress.Part(0, 0.9)) || !this->Finish(progress.Part(0.9, 1)))
  {
    return false;
  }
  // SetCells would search for polyhedra.
  grid->SetPolyhedralCells(this->Types.TakeArray<vtkUnsignedCharArray>(),
    Arrays<Id>::MakeCells(this->Offsets, this->Nodes), nullptr, nullptr);
  return true;
}
}

//------------------------------------------------------------------------------
bool StreamFluentStandardCells(const FluentMesh& mesh, FluentInteriorZones& zones,
  vtkUnstructuredGrid* grid, const Progress& progress)
{
  FluentStandardCells cells(mesh);
  return cells.Place() && cells.Build(zones, grid, progress);
}
}
