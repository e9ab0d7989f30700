// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentGrid.h"

#include "Base/Parallel.h"
#include "Intake/FaceMesh/GridArrays.h"
#include "Intake/Fluent/FluentCellNodes.h"

#include <algorithm>
#include <atomic>
#include <deque>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
/**
 * Creates cells in one pass over the faces. Faces are read in the order of their ids, and each adds
 * its data to the nodes of the cells on its sides, so only faces of incomplete pyramids and wedges
 * are stored. Nodes are in the same order as from GridBuilder.
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
  bool Build(FluentFaceBatches& batches, FluentInteriorZones& zones, vtkUnstructuredGrid* grid,
    const Progress& progress);

private:
  using Id = vtkTypeInt32;
  struct Triangle;
  struct Side;
  class Share;

  bool PlaceMixed();
  unsigned char GetType(vtkIdType cell) const
  {
    return this->CommonType != 0 ? this->CommonType : this->Types[cell];
  }
  vtkIdType GetOffset(vtkIdType cell) const
  {
    return this->CommonType != 0 ? this->CommonSize * cell : this->Offsets[cell];
  }
  template <typename SideOfFace>
  bool AddFaces(FluentFaceBatches& batches, FluentInteriorZones& zones, const Progress& progress);
  bool Finish(const Progress& progress);

  const FluentMesh& Mesh;
  vtkIdType Count;
  unsigned char CommonType = 0; ///< of all cells, or 0
  vtkIdType CommonSize = 0;     ///< number of nodes of each cell then
  Buffer<unsigned char> Types;
  Buffer<Id> Offsets;
  Buffer<Id> Nodes; ///< ids of the file, or data from which they follow; finally points
  FluentCellState* States = nullptr;
};

//------------------------------------------------------------------------------
// The data of a face for a tetrahedron, if there are no other cells.
struct FluentStandardCells::Triangle
{
  Id Cell;
  FluentTetrahedron::Face Face; ///< zeros for other faces

  void Make(const FluentFaceBatches::Batch& batch, const FluentFaceBatches::Face& face, int side)
  {
    this->Cell = face.Cells[side];
    this->Face = { 0, 0 };
    if (face.Size == 3)
    {
      this->Face = FluentTetrahedron::Face::Of(
        batch.GetNode(face, 0), batch.GetNode(face, 1 + side), batch.GetNode(face, 2 - side));
    }
  }
};

//------------------------------------------------------------------------------
// The data of a face for a cell: its nodes, oriented so that the normal points inward; missing ones
// are 0.
struct FluentStandardCells::Side
{
  static constexpr int MaxSize = 4;
  Id Cell;
  Id Nodes[MaxSize];

  /// The normal points into the first cell of the face. Members are written one by one, as copying
  /// the whole object would stall on the pending stores.
  void Make(const FluentFaceBatches::Batch& batch, const FluentFaceBatches::Face& face, int side)
  {
    const auto get = [&](std::int32_t i) { return batch.GetNode(face, i); };
    this->Cell = face.Cells[side];
    switch (face.Size)
    {
      case 2:
        this->Set(get(side), get(1 - side), 0, 0);
        break;
      case 3:
        this->Set(get(0), get(1 + side), get(2 - side), 0);
        break;
      case 4:
        this->Set(get(0), get(1 + 2 * side), get(2), get(3 - 2 * side));
        break;
      default:
        this->Set(0, 0, 0, 0); // not a face of such a cell
        break;
    }
  }
  void Set(Id a, Id b, Id c, Id d)
  {
    this->Nodes[0] = a;
    this->Nodes[1] = b;
    this->Nodes[2] = c;
    this->Nodes[3] = d;
  }
  int GetSize() const
  {
    return this->Nodes[3] != 0 ? 4 : this->Nodes[2] != 0 ? 3 : this->Nodes[1] != 0 ? 2 : 0;
  }
};

//------------------------------------------------------------------------------
// Adds faces to the cells of one share; only one thread changes these at a time.
class FluentStandardCells::Share
{
public:
  explicit Share(FluentStandardCells& cells)
    : Cells(cells)
    , Matcher(PointSource())
  {
  }

  bool Add(const Triangle* sides, vtkIdType size)
  {
    bool good = true;
    for (vtkIdType i = 0; i < size; ++i)
    {
      const vtkIdType next = sides[std::min(i + Ahead, size - 1)].Cell;
      this->Prefetch(next, 4 * next);
      const vtkIdType cell = sides[i].Cell;
      good &= FluentTetrahedron::Add(
        &this->Cells.Nodes[4 * cell], this->Cells.States[cell], sides[i].Face);
    }
    return good;
  }

  bool Add(const Side* sides, vtkIdType size)
  {
    return this->Cells.CommonType == VTK_HEXAHEDRON ? this->AddAs<VTK_HEXAHEDRON>(sides, size)
                                                    : this->AddAs<0>(sides, size);
  }

private:
  static constexpr vtkIdType Ahead = 16; // distance of prefetching, in sides

  void Prefetch(vtkIdType cell, vtkIdType offset) const
  {
    camaron::Prefetch(&this->Cells.States[cell]);
    camaron::Prefetch(&this->Cells.Nodes[offset]);
  }

  template <unsigned char Type>
  bool AddAs(const Side* sides, vtkIdType size)
  {
    const auto getOffset = [this](vtkIdType cell)
    { return Type == VTK_HEXAHEDRON ? 8 * cell : this->Cells.GetOffset(cell); };
    bool good = true;
    for (vtkIdType i = 0; i < size; ++i)
    {
      const vtkIdType next = sides[std::min(i + Ahead, size - 1)].Cell;
      this->Prefetch(next, getOffset(next));
      const Side& side = sides[i];
      good &= this->AddTo(Type != 0 ? Type : this->Cells.GetType(side.Cell),
        &this->Cells.Nodes[getOffset(side.Cell)], this->Cells.States[side.Cell], side);
    }
    return good;
  }

  bool AddTo(unsigned char type, Id* nodes, FluentCellState& state, const Side& side)
  {
    const int size = side.GetSize();
    if (type == VTK_TETRA)
    {
      return size == 3 &&
        FluentTetrahedron::Add(
          nodes, state, FluentTetrahedron::Face::Of(side.Nodes[0], side.Nodes[1], side.Nodes[2]));
    }
    if (state == FluentCellComplete)
    {
      return false;
    }
    switch (type)
    {
      case VTK_HEXAHEDRON:
        return size == 4 && AddToHexahedron(nodes, state, side.Nodes);
      case VTK_TRIANGLE:
      case VTK_QUAD:
        return size == 2 &&
          AddToRing(nodes, type == VTK_QUAD ? 4 : 3, state, side.Nodes[0], side.Nodes[1]);
      default:
        return this->AddToOther(type, nodes, state, side);
    }
  }

  /// A face of an incomplete cell.
  struct Waiting
  {
    Id Next;
    Side Face;
  };

  /// Faces of pyramids and wedges are kept until the last one arrives. The state is their number,
  /// and node 0 the index of the last one.
  bool AddToOther(unsigned char type, Id* nodes, FluentCellState& state, const Side& side)
  {
    constexpr int NumberOfFaces = 5;
    const Waiting waiting{ state > 0 ? nodes[0] : -1, side };
    if (state + 1 < NumberOfFaces)
    {
      ++state;
      nodes[0] = this->Keep(waiting);
      return true;
    }
    constexpr FaceDirection Inward = FaceDirection::Inward;
    constexpr FaceDirection directions[] = { Inward, Inward, Inward, Inward, Inward };
    IdList lists[NumberOfFaces];
    int triangles = 0, quads = 0;
    const Waiting* last = &waiting;
    for (int i = NumberOfFaces - 1; i >= 0; --i)
    {
      const int size = last->Face.GetSize();
      lists[i] = { reinterpret_cast<const char*>(last->Face.Nodes), size, 0 };
      triangles += size == 3;
      quads += size == 4;
      last = i > 0 ? &this->Kept[static_cast<std::size_t>(last->Next)] : nullptr;
    }
    if (PrimitiveMatcher::Guess(NumberOfFaces, triangles, quads) != type ||
      !this->Matcher.Match(type, lists, directions))
    {
      return false;
    }
    for (Id index = waiting.Next; index >= 0;)
    {
      Waiting& used = this->Kept[static_cast<std::size_t>(index)];
      const Id next = used.Next;
      used.Next = this->Free;
      this->Free = index;
      index = next;
    }
    std::copy(this->Matcher.GetNodes(),
      this->Matcher.GetNodes() + PrimitiveMatcher::GetNumberOfNodes(type), nodes);
    state = FluentCellComplete;
    return true;
  }
  Id Keep(const Waiting& face)
  {
    if (this->Free < 0)
    {
      this->Kept.push_back(face);
      return static_cast<Id>(this->Kept.size() - 1);
    }
    const Id index = this->Free;
    Waiting& place = this->Kept[static_cast<std::size_t>(index)];
    this->Free = place.Next;
    place = face;
    return index;
  }

  FluentStandardCells& Cells;
  std::deque<Waiting> Kept;
  Id Free = -1; ///< the first unused position in Kept
  PrimitiveMatcher Matcher;
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
  constexpr vtkIdType BlockSize = 1024;
  std::atomic<bool> areStandard{ true };
  std::atomic<vtkIdType> faces{ 0 };
  const vtkIdType nodes = ParallelScan(
    this->Count, BlockSize,
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
// Converts ids of the file to points; false if some cells are incomplete.
bool FluentStandardCells::Finish(const Progress& progress)
{
  constexpr vtkIdType BlockSize = 4096;
  const bool isWhole = this->Mesh.Piece.IsWhole();
  const auto maxNode = static_cast<std::uint32_t>(this->Mesh.Piece.GetNumberOfMeshPoints());
  std::atomic<bool> good{ true };
  return progress.For((this->Count + BlockSize - 1) / BlockSize,
           [&](vtkIdType first, vtkIdType last)
           {
             bool isGood = true;
             const vtkIdType end = std::min(last * BlockSize, this->Count);
             const vtkIdType firstCell = first * BlockSize;
             for (vtkIdType cell = firstCell; cell < end; ++cell)
             {
               isGood &= this->GetType(cell) == VTK_TETRA
                 ? FluentTetrahedron::Finish(
                     &this->Nodes[this->GetOffset(cell)], this->States[cell])
                 : this->States[cell] == FluentCellComplete;
             }
             Id* const begin = this->Nodes.data() + this->GetOffset(firstCell);
             Id* const lastNode = this->Nodes.data() + this->GetOffset(end);
             for (Id* node = begin; node < lastNode; ++node)
             {
               --*node;
               isGood &= static_cast<std::uint32_t>(*node) < maxNode;
             }
             for (Id* node = begin; node < lastNode && isGood && !isWhole; ++node)
             {
               *node = static_cast<Id>(this->Mesh.Piece.GetPoint(*node));
             }
             for (vtkIdType cell = firstCell; cell < end && this->CommonType != 0; ++cell)
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
template <typename SideOfFace>
bool FluentStandardCells::AddFaces(
  FluentFaceBatches& batches, FluentInteriorZones& zones, const Progress& progress)
{
  std::deque<Share> shares;
  for (int i = FluentFaceBatches::GetNumberOfShares(); i > 0; --i)
  {
    shares.emplace_back(*this);
  }
  return batches.ForEachSide<SideOfFace>(
    progress, [&](const FluentFaces::Run& run, const FluentFaceBatches::Face* faces, vtkIdType size)
    { zones.Add(run, this->Mesh, faces, size); },
    [](const FluentFaceBatches::Batch& batch, vtkIdType, const FluentFaceBatches::Face& face,
      int side, SideOfFace& made) { made.Make(batch, face, side); },
    [&](vtkIdType share, const SideOfFace* sides, vtkIdType size)
    { return shares[static_cast<std::size_t>(share)].Add(sides, size); });
}

//------------------------------------------------------------------------------
bool FluentStandardCells::Build(FluentFaceBatches& batches, FluentInteriorZones& zones,
  vtkUnstructuredGrid* grid, const Progress& progress)
{
  constexpr vtkIdType Grain = 65536;
  // Offsets of cells of one type are filled at the end; until then their memory is used for states.
  Buffer<FluentCellState> states(this->CommonType != 0 ? 0 : this->Count);
  this->States = this->CommonType != 0 ? reinterpret_cast<FluentCellState*>(this->Offsets.data())
                                       : states.data();
  ParallelFor(this->Count, Grain, [this](vtkIdType begin, vtkIdType end)
    { std::fill(this->States + begin, this->States + end, FluentCellState(0)); });
  this->Offsets[this->Count] = static_cast<Id>(this->GetOffset(this->Count));
  this->Nodes = Buffer<Id>(this->Offsets[this->Count]);
  const Progress part = progress.Part(0, 0.9);
  if (!(this->CommonType == VTK_TETRA ? this->AddFaces<Triangle>(batches, zones, part)
                                      : this->AddFaces<Side>(batches, zones, part)) ||
    !this->Finish(progress.Part(0.9, 1)))
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
bool StreamFluentStandardCells(const FluentMesh& mesh, FluentFaceBatches& batches,
  FluentInteriorZones& zones, vtkUnstructuredGrid* grid, const Progress& progress)
{
  FluentStandardCells cells(mesh);
  return cells.Place() && cells.Build(batches, zones, grid, progress);
}
}
