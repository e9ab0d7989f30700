// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentMesh.h"

#include "Base/Hash.h"
#include "Base/Parallel.h"
#include "Intake/FaceMesh/CellRing.h"
#include "Intake/FaceMesh/GridArrays.h"

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
 * Finds the nodes of a tetrahedron from sums: each face lacks one of the nodes, so the sum of its
 * node ids identifies that node once the sum of all is known. There are no searches, and no
 * branches except at the end, which makes it fast: a mesh has two faces per tetrahedron, in any
 * order, which defeats branch prediction.
 *
 * Node ids must not be 0. Until the end the nodes are the sums of the faces, modulo 2^31, with the
 * sign of the checksum. As sums of wrong faces may look valid, the state, 0 before the first face,
 * is a checksum of the nodes of all faces, with the number of faces in its low bits. A face of the
 * opposite orientation has the negative checksum.
 */
namespace FluentTetrahedron
{
constexpr std::uint32_t SumMask = 0x7fffffff;
constexpr int CountBits = 3;
constexpr std::uint32_t CountMask = (1 << CountBits) - 1;
/// Distinguish faces that lack different nodes; any odd numbers will do.
constexpr std::uint32_t Factors[4] = { 0x9e3779b1, 0x85ebca77, 0xc2b2ae3d, 0x27d4eb2f };

/// Hash function.
inline std::uint32_t Mix(std::uint32_t node)
{
  return static_cast<std::uint32_t>(node * HashFactor >> 32);
}
/// Changes its sign with the orientation of three nodes, whichever is first; for hashed ids.
inline std::uint32_t GetCheck(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
  return (a - b) * (b - c) * (c - a);
}

/// The data of a face, whose normal points inward, that a tetrahedron needs.
struct Face
{
  std::uint32_t Sum, Check;

  static Face Of(std::int32_t a, std::int32_t b, std::int32_t c)
  {
    const auto x = static_cast<std::uint32_t>(a), y = static_cast<std::uint32_t>(b),
               z = static_cast<std::uint32_t>(c);
    const std::uint32_t check = GetCheck(Mix(x), Mix(y), Mix(z));
    return { ((x + y + z) & SumMask) | (check & ~SumMask), check };
  }
};

/// Adds a face; false if there are four already.
inline bool Add(std::int32_t* nodes, std::uint32_t& state, const Face& face)
{
  const std::uint32_t count = state & CountMask;
  if (count > 3)
  {
    return false;
  }
  nodes[count] = static_cast<std::int32_t>(face.Sum);
  state += (face.Check * Factors[count] << CountBits) + 1;
  return true;
}

/// Determines the nodes when all faces have been added; false if they do not form a tetrahedron or
/// are oriented inconsistently; the nodes are then undefined. Among millions of cells, a checksum
/// may match both orientations; then the first face decides.
inline bool Finish(std::int32_t* nodes, std::uint32_t state)
{
  constexpr std::uint32_t Third = 0x2aaaaaab; // 3 * Third = 1 modulo 2^31
  const auto s0 = static_cast<std::uint32_t>(nodes[0]), s1 = static_cast<std::uint32_t>(nodes[1]),
             s2 = static_cast<std::uint32_t>(nodes[2]), s3 = static_cast<std::uint32_t>(nodes[3]);
  const std::uint32_t sum = (s0 + s1 + s2 + s3) * Third;
  // In the order of VTK's faces: the first lacks node 2, then 0, 1 and 3.
  const std::uint32_t n0 = (sum - s1) & SumMask, n1 = (sum - s2) & SumMask,
                      n2 = (sum - s0) & SumMask, n3 = (sum - s3) & SumMask;
  const std::uint32_t m0 = Mix(n0), m1 = Mix(n1), m2 = Mix(n2), m3 = Mix(n3);
  const std::uint32_t first = GetCheck(m0, m1, m3);
  const std::uint32_t outside = Factors[0] * first + Factors[1] * GetCheck(m1, m2, m3) +
    Factors[2] * GetCheck(m2, m0, m3) + Factors[3] * GetCheck(m0, m2, m1);
  const bool isPositive = state == ((0u - outside) << CountBits | 4);
  const bool mayBeMirrored = state == (outside << CountBits | 4);
  const bool isMirrored = mayBeMirrored && !(isPositive && (s0 ^ first) > SumMask);
  const std::uint32_t other = (n1 ^ n3) & (0u - static_cast<std::uint32_t>(isMirrored));
  nodes[0] = static_cast<std::int32_t>(n0);
  nodes[1] = static_cast<std::int32_t>(n1 ^ other);
  nodes[2] = static_cast<std::int32_t>(n2);
  nodes[3] = static_cast<std::int32_t>(n3 ^ other);
  return isPositive || mayBeMirrored;
}
}

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
  explicit FluentStandardCells(FluentMesh& mesh)
    : Mesh(mesh)
    , Count(mesh.Piece.GetNumberOfCells())
  {
  }

  /// Determines the position of every cell; false if some are of other types.
  bool Place();
  bool Build(vtkUnstructuredGrid* grid, const Progress& progress);

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

  unsigned char GetType(vtkIdType cell) const
  {
    return this->CommonType != 0 ? this->CommonType : this->Types[cell];
  }
  vtkIdType GetOffset(vtkIdType cell) const
  {
    return this->CommonType != 0 ? this->CommonSize * cell : this->Offsets[cell];
  }
  bool AddFaces(const Progress& progress);
  bool Finish(const Progress& progress);

  FluentMesh& Mesh;
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

  /// Adds the faces of a batch; false if one does not fit.
  bool Add(const FluentFaces::Run& run)
  {
    FluentMesh& mesh = this->Cells.Mesh;
    bool good = true;
    int block = 0;
    for (vtkIdType begin = run.Begin; begin < run.End; begin += FluentFaces::BlockSize, ++block)
    {
      const vtkIdType last = std::min(begin + FluentFaces::BlockSize, run.End);
      const bool isOwn = block % this->Cells.NumberOfShares == this->Number;
      if (isOwn)
      {
        mesh.InteriorZones.Add(run, begin, last, mesh.Cells);
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
  const bool isWhole = this->Mesh.Piece.IsWhole();
  this->Types = Buffer<unsigned char>(this->Count);
  this->Offsets = Buffer<Id>(this->Count + 1);
  std::atomic<bool> areStandard{ true };
  const vtkIdType nodes = ParallelScan(
    this->Count, HeavyGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType sum = 0;
      const bool isOne = isWhole && this->Mesh.Cells.HaveOneElement(begin, end);
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
  this->Offsets[this->Count] = static_cast<Id>(nodes);
  if (this->Count > 0 && isWhole && this->Mesh.Cells.HaveOneElement(0, this->Count))
  {
    this->CommonType = this->Types[0];
    this->CommonSize = this->Mesh.GetShape(0).Nodes;
  }
  return areStandard && nodes <= INT32_MAX;
}

//------------------------------------------------------------------------------
bool FluentStandardCells::AddFaces(const Progress& progress)
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
  return this->Mesh.Faces.ForEachBatch(progress, true,
    [&](const FluentFaces::Run& batch, const Progress& part)
    {
      std::atomic<bool> good{ true };
      ParallelForEach(batch.Bounds ? this->NumberOfShares : 0, 1,
        [&](vtkIdType share)
        {
          if (!shares[static_cast<std::size_t>(share)].Add(batch))
          {
            good = false;
          }
        });
      return good && part.Report(1);
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
             }
             if (!isGood)
             {
               good = false;
             }
           }) &&
    good;
}

//------------------------------------------------------------------------------
bool FluentStandardCells::Build(vtkUnstructuredGrid* grid, const Progress& progress)
{
  // Until the end, the memory of the offsets of cells of one type is used for states.
  Buffer<State> states(this->CommonType != 0 ? 0 : this->Count);
  this->States =
    this->CommonType != 0 ? reinterpret_cast<State*>(this->Offsets.data()) : states.data();
  ParallelFor(this->Count, LightGrain, [this](vtkIdType begin, vtkIdType end)
    { std::fill(this->States + begin, this->States + end, State(0)); });
  this->Nodes = Buffer<Id>(this->Offsets[this->Count]);
  if (!this->AddFaces(progress.Part(0, 0.9)) || !this->Finish(progress.Part(0.9, 1)))
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
bool StreamFluentStandardCells(
  FluentMesh& mesh, vtkUnstructuredGrid* grid, const Progress& progress)
{
  FluentStandardCells cells(mesh);
  return cells.Place() && cells.Build(grid, progress);
}
}
