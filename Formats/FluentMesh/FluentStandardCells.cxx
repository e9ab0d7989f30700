// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentStandardCells.h"

#include "FluentCellNodes.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkTypeInt32Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <deque>

namespace camaron
{
namespace
{
constexpr vtkIdType Ahead = 8; // faces whose cells are fetched meanwhile

//------------------------------------------------------------------------------
// In how many shares the cells are made, a power of two: all look at all faces.
int GetNumberOfShares()
{
  constexpr int MaxShares = 8;
  const int threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  int shares = 1;
  while (2 * shares <= std::min(threads, MaxShares))
  {
    shares *= 2;
  }
  return shares;
}
}

//------------------------------------------------------------------------------
// The cells that one thread makes.
class FluentStandardCells::Share
{
public:
  Share(FluentStandardCells& cells, Buffer<FluentCellState>& states)
    : Cells(cells)
    , States(states)
    , Matcher(PointSource())
  {
  }

  vtkIdType NumberOfComplete = 0;

  /**
   * Adds faces to those of its cells: of many small ranges, so that all of @a shares, a power of
   * two, have some in every batch.
   */
  bool Add(const FluentFaceBatches::Face* faces, vtkIdType size, vtkIdType share, vtkIdType shares)
  {
    constexpr int RangeBits = 6;
    bool good = true;
    for (vtkIdType i = 0; i < size && good; ++i)
    {
      if (i + 2 * Ahead < size)
      {
        this->Prefetch(faces[i + Ahead], faces[i + 2 * Ahead]);
      }
      const FluentFaceBatches::Face& face = faces[i];
      for (int side = 0; side < 2; ++side)
      {
        const vtkIdType cell = face.Cells[side];
        if (cell >= 0 && (cell >> RangeBits & (shares - 1)) == share)
        {
          good = this->AddTo(cell, face, side) && good;
        }
      }
    }
    return good;
  }

private:
  void Prefetch(const FluentFaceBatches::Face& near, const FluentFaceBatches::Face& far) const
  {
    for (int side = 0; side < 2; ++side)
    {
      const vtkIdType next = near.Cells[side], later = far.Cells[side];
      if (next >= 0)
      {
        camaron::Prefetch(&this->Cells.Nodes[this->Cells.Offsets[next]]);
      }
      if (later >= 0)
      {
        camaron::Prefetch(&this->States[later]);
        camaron::Prefetch(&this->Cells.Types[later]);
        camaron::Prefetch(&this->Cells.Offsets[later]);
      }
    }
  }

  bool AddTo(vtkIdType cell, const FluentFaceBatches::Face& face, int side)
  {
    FluentCellState& state = this->States[cell];
    if (state == FluentCellComplete)
    {
      return false;
    }
    const unsigned char type = this->Cells.Types[cell];
    Id* const nodes = &this->Cells.Nodes[this->Cells.Offsets[cell]];
    // The normal points into the first cell.
    const Id* const listed = face.Nodes;
    bool good = false;
    switch (type)
    {
      case VTK_TETRA:
      {
        const Id inward[3] = { listed[0], listed[1 + side], listed[2 - side] };
        good = face.Size == 3 && AddToTetrahedron(nodes, state, inward);
        break;
      }
      case VTK_HEXAHEDRON:
      {
        const Id inward[4] = { listed[0], listed[1 + 2 * side], listed[2], listed[3 - 2 * side] };
        good = face.Size == 4 && AddToHexahedron(nodes, state, inward);
        break;
      }
      case VTK_TRIANGLE:
      case VTK_QUAD:
        good = face.Size == 2 &&
          AddToRing(nodes, type == VTK_QUAD ? 4 : 3, state, listed[side], listed[1 - side]);
        break;
      default:
        good = this->AddToOther(type, nodes, state, face, side);
    }
    if (good && state == FluentCellComplete)
    {
      ++this->NumberOfComplete;
      const vtkIdType size = this->Cells.Offsets[cell + 1] - this->Cells.Offsets[cell];
      for (vtkIdType i = 0; i < size; ++i)
      {
        nodes[i] = static_cast<Id>(this->Cells.Mesh.Piece.GetPoint(nodes[i] - 1));
      }
    }
    return good;
  }

  /// A face of an incomplete cell.
  struct Waiting
  {
    Id Next;
    std::int16_t Size;
    FaceDirection Direction;
    Id Nodes[4];
  };

  /// Faces of pyramids and wedges wait for the last of them. The state is their number, and node 0
  /// is the last that came.
  bool AddToOther(unsigned char type, Id* nodes, FluentCellState& state,
    const FluentFaceBatches::Face& face, int side)
  {
    constexpr int NumberOfFaces = 5;
    Waiting waiting{ state > 0 ? nodes[0] : -1, static_cast<std::int16_t>(face.Size),
      side == 0 ? FaceDirection::Inward : FaceDirection::Outward, {} };
    std::copy(face.Nodes, face.Nodes + face.Size, waiting.Nodes);
    if (state + 1 < NumberOfFaces)
    {
      ++state;
      nodes[0] = this->Keep(waiting);
      return true;
    }
    IdList lists[NumberOfFaces];
    FaceDirection directions[NumberOfFaces];
    int triangles = 0, quads = 0;
    const Waiting* last = &waiting;
    for (int i = NumberOfFaces - 1; i >= 0; --i)
    {
      lists[i] = { reinterpret_cast<const char*>(last->Nodes), last->Size, 0 };
      directions[i] = last->Direction;
      triangles += last->Size == 3;
      quads += last->Size == 4;
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
  Buffer<FluentCellState>& States;
  std::deque<Waiting> Kept;
  Id Free = -1; ///< the first place in Kept that is not used
  PrimitiveMatcher Matcher;
};

//------------------------------------------------------------------------------
bool FluentStandardCells::Place()
{
  constexpr vtkIdType BlockSize = 1024;
  this->Types = Buffer<unsigned char>(this->Count);
  this->Offsets = Buffer<Id>(this->Count + 1);
  std::atomic<bool> areStandard{ true };
  std::atomic<vtkIdType> faces{ 0 };
  const vtkIdType nodes = ParallelScan(
    this->Count, BlockSize,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType sum = 0, sumOfFaces = 0;
      for (vtkIdType cell = begin; cell < end && areStandard; ++cell)
      {
        const FluentShape shape = this->Mesh.GetShape(cell);
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
void FluentStandardCells::AddTo(
  FluentInteriorZones& zones, int zone, const FluentFaceBatches::Face* faces, vtkIdType size) const
{
  const auto getZone = [this](vtkIdType cell)
  { return this->Mesh.Cells.GetZone(this->Mesh.Piece.GetLeaf(cell)); };
  for (vtkIdType i = 0; i < size; ++i)
  {
    const FluentFaceBatches::Face& face = faces[i];
    if (face.Cells[0] >= 0 && face.Cells[1] >= 0)
    {
      zones.Add(zone, getZone(face.Cells[0]), getZone(face.Cells[1]), face.Size);
    }
  }
}

//------------------------------------------------------------------------------
bool FluentStandardCells::Build(FluentFaceBatches& batches, FluentInteriorZones& zones,
  vtkUnstructuredGrid* grid, const Progress& progress)
{
  this->Nodes = Buffer<Id>(this->Offsets[this->Count]);
  Buffer<FluentCellState> states(this->Count);
  std::fill(states.data(), states.data() + this->Count, FluentCellState(0));

  std::deque<Share> shares;
  for (int i = GetNumberOfShares(); i > 0; --i)
  {
    shares.emplace_back(*this, states);
  }
  const auto count = static_cast<vtkIdType>(shares.size());
  const bool visited = batches.ForEach(progress,
    [&](const FluentFaces::Run& run, const FluentFaceBatches::Face* faces, vtkIdType size)
    {
      if (zones.AreSeveral() && run.BoundaryType == FluentBoundary::Interior)
      {
        this->AddTo(zones, run.Zone, faces, size);
      }
      std::atomic<bool> good{ true };
      ParallelFor(count, 1,
        [&](vtkIdType first, vtkIdType last)
        {
          for (vtkIdType share = first; share < last; ++share)
          {
            if (!shares[static_cast<std::size_t>(share)].Add(faces, size, share, count))
            {
              good = false;
            }
          }
        });
      return good.load();
    });
  vtkIdType complete = 0;
  for (const Share& share : shares)
  {
    complete += share.NumberOfComplete;
  }
  if (!visited || complete != this->Count)
  {
    return false;
  }
  vtkNew<vtkCellArray> cells;
  const auto offsets = this->Offsets.TakeArray<vtkTypeInt32Array>();
  const auto nodes = this->Nodes.TakeArray<vtkTypeInt32Array>();
  cells->SetData(offsets.Get(), nodes.Get());
  grid->SetCells(this->Types.TakeArray<vtkUnsignedCharArray>(), cells);
  return true;
}
}
