// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentMesh.h"

#include "Base/Parallel.h"
#include "Intake/FaceMesh/CellRing.h"
#include "Intake/FaceMesh/GridArrays.h"
#include "Intake/Fluent/FluentTetrahedron.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <deque>
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
 * The cells are divided into shares. Each thread reads all faces, but only adds them to the cells
 * of one share, in the order of the faces. So no two threads change the same cell.
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
  using State = std::uint32_t; ///< of a cell: PrimitiveMatcher::Complete with all faces
  struct Side;
  class Share;
  static constexpr int MaxShares = 8;

  /// Shares consist of many ranges of cells, so that all are used in every batch.
  int GetShare(vtkIdType cell) const
  {
    constexpr int RangeBits = 9;
    return static_cast<int>(cell >> RangeBits & (this->NumberOfShares - 1));
  }

  bool PlaceMixed();
  unsigned char GetType(vtkIdType cell) const
  {
    return this->CommonType != 0 ? this->CommonType : this->Types[cell];
  }
  vtkIdType GetOffset(vtkIdType cell) const
  {
    return this->CommonType != 0 ? this->CommonSize * cell : this->Offsets[cell];
  }
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
  State* States = nullptr;
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
  void Set(const FluentFace& face, int side, vtkIdType cell)
  {
    this->Cell = static_cast<Id>(cell);
    this->Size = face.Size;
    const auto set = [&](Id* nodes, auto... indices) { ((*nodes++ = face.Nodes[indices]), ...); };
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
  Share(FluentStandardCells& cells, int number)
    : Cells(cells)
    , Number(number)
    , Matcher(PointSource())
  {
  }

  /// Adds faces of a run from @a begin on, which must begin a block; false if one does not fit.
  bool Add(const FluentFaces::Run& run, vtkIdType begin, vtkIdType end, FluentInteriorZones& zones)
  {
    const FluentMesh& mesh = this->Cells.Mesh;
    bool good = true;
    for (int block = 0; begin < end; begin += FluentFaces::BlockSize, ++block)
    {
      const vtkIdType last = std::min(begin + FluentFaces::BlockSize, end);
      const bool isOwn = block % this->Cells.NumberOfShares == this->Number;
      if (isOwn)
      {
        zones.Add(run, begin, last, mesh.Cells);
      }
      FluentFaces::ForEachOf(run, begin, last,
        [&](vtkIdType, const FluentFace& face)
        {
          for (int side = 0; side < 2; ++side)
          {
            const vtkIdType cell = face.Size == 0 ? -1 : mesh.FindCell(face.GetCell(side));
            if (cell >= 0 && this->Cells.GetShare(cell) == this->Number)
            {
              this->Prefetch(cell);
              this->Next[this->NumberOfNext++].Set(face, side, cell);
              good = (this->NumberOfNext < Ahead || this->AddNext()) && good;
            }
          }
          // BuildFluentCells warns about these.
          good = !(isOwn && run.HasOddCells(face.GetCell(0), face.GetCell(1))) && good;
        });
    }
    return this->AddNext() && good;
  }

private:
  static constexpr int Ahead = 16; // distance of prefetching, in sides

  void Prefetch(vtkIdType cell) const
  {
    camaron::Prefetch(&this->Cells.States[cell]);
    camaron::Prefetch(&this->Cells.Nodes[this->Cells.GetOffset(cell)]);
  }

  /// Adds the next sides to their cells.
  bool AddNext()
  {
    bool good = true;
    for (int i = 0; i < this->NumberOfNext && good; ++i)
    {
      const Side& side = this->Next[i];
      const unsigned char type = this->Cells.GetType(side.Cell);
      Id* const nodes = &this->Cells.Nodes[this->Cells.GetOffset(side.Cell)];
      State& state = this->Cells.States[side.Cell];
      if (type == VTK_TETRA)
      {
        good = side.Size == 3 &&
          FluentTetrahedron::Add(
            nodes, state, FluentTetrahedron::Face::Of(side.Nodes[0], side.Nodes[1], side.Nodes[2]));
        continue;
      }
      good = state != PrimitiveMatcher::Complete &&
        (type == VTK_HEXAHEDRON
            ? side.Size == 4 && PrimitiveMatcher::AddToHexahedron(nodes, state, side.Nodes)
            : this->AddToOther(type, nodes, state, side));
    }
    this->NumberOfNext = 0;
    return good;
  }

  /// A face of an incomplete cell.
  struct Waiting
  {
    Id Next;
    Side Face;
  };

  /// Faces of other cells are kept until the last one arrives. The state is their number, and node
  /// 0 the index of the last one.
  bool AddToOther(unsigned char type, Id* nodes, State& state, const Side& side)
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
    state = PrimitiveMatcher::Complete;
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
  int Number;
  Side Next[Ahead]; ///< whose cells are being prefetched
  int NumberOfNext = 0;
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
  return shape.Faces > 0 && this->Count * shape.Nodes <= INT32_MAX;
}

//------------------------------------------------------------------------------
bool FluentStandardCells::PlaceMixed()
{
  std::atomic<bool> areStandard{ true };
  const vtkIdType nodes = ParallelScan(
    this->Count, HeavyGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType sum = 0;
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
      }
      return sum;
    },
    [&](vtkIdType begin, vtkIdType end, vtkIdType before)
    {
      for (vtkIdType cell = begin; cell < end && areStandard; ++cell)
      {
        this->Offsets[cell] += static_cast<Id>(before);
      }
    });
  if (!areStandard || nodes > INT32_MAX)
  {
    return false;
  }
  this->Offsets[this->Count] = static_cast<Id>(nodes);
  return true;
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
    shares.emplace_back(*this, i);
  }
  // Large enough that waiting for other threads costs little.
  constexpr vtkIdType Step = 64 * FluentFaces::BlockSize;
  return this->Mesh.Faces.ForEachBatch(progress, true,
    [&](const FluentFaces::Run& batch, const Progress& part)
    {
      std::atomic<bool> good{ true };
      const auto size = static_cast<double>(batch.End - batch.Begin);
      for (vtkIdType begin = batch.Begin; begin < batch.End && batch.Bounds && good; begin += Step)
      {
        const vtkIdType end = std::min(begin + Step, batch.End);
        ParallelForEach(this->NumberOfShares, 1,
          [&](vtkIdType share)
          {
            if (!shares[static_cast<std::size_t>(share)].Add(batch, begin, end, zones))
            {
              good = false;
            }
          });
        good = good && part.Report(static_cast<double>(end - batch.Begin) / size);
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
                 : this->States[cell] == PrimitiveMatcher::Complete;
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
  Buffer<State> states(this->CommonType != 0 ? 0 : this->Count);
  this->States =
    this->CommonType != 0 ? reinterpret_cast<State*>(this->Offsets.data()) : states.data();
  ParallelFor(this->Count, LightGrain, [this](vtkIdType begin, vtkIdType end)
    { std::fill(this->States + begin, this->States + end, State(0)); });
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
