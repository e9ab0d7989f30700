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

  /// Adds faces to those of its cells.
  bool Add(const FluentFaceBatches::Batch& batch, const FluentFaceBatches::Face* faces,
    vtkIdType size, vtkIdType share, vtkIdType shares)
  {
    switch (this->Cells.CommonType)
    {
      case VTK_TETRA:
        return this->AddAs<VTK_TETRA>(batch, faces, size, share, shares);
      case VTK_HEXAHEDRON:
        return this->AddAs<VTK_HEXAHEDRON>(batch, faces, size, share, shares);
      default:
        return this->AddAs<0>(batch, faces, size, share, shares);
    }
  }

private:
  template <unsigned char Type>
  vtkIdType GetOffset(vtkIdType cell) const
  {
    return Type == VTK_TETRA   ? 4 * cell
      : Type == VTK_HEXAHEDRON ? 8 * cell
                               : vtkIdType(this->Cells.Offsets[cell]);
  }

  template <unsigned char Type>
  bool AddAs(const FluentFaceBatches::Batch& batch, const FluentFaceBatches::Face* faces,
    vtkIdType size, vtkIdType share, vtkIdType shares)
  {
    constexpr std::int32_t MaxSize = 4;
    bool good = true;
    for (vtkIdType i = 0; i < size && good; ++i)
    {
      const FluentFaceBatches::Face& next = faces[std::min(i + Ahead, size - 1)];
      const FluentFaceBatches::Face& face = faces[i];
      const bool isUsed = face.Cells[0] >= 0 || face.Cells[1] >= 0;
      if (isUsed && face.Size > MaxSize)
      {
        return false;
      }
      Id nodes[MaxSize] = {};
      for (std::int32_t j = 0; isUsed && j < face.Size; ++j)
      {
        nodes[j] = batch.GetNode(face, j);
      }
      const FluentTetrahedron::Face triangle = Type == VTK_TETRA && face.Size == 3
        ? FluentTetrahedron::Face(nodes)
        : FluentTetrahedron::Face();
      for (int side = 0; side < 2; ++side)
      {
        const vtkIdType nextCell = std::max(next.Cells[side], 0);
        camaron::Prefetch(&this->States[nextCell]);
        camaron::Prefetch(&this->Cells.Nodes[this->GetOffset<Type>(nextCell)]);
        const vtkIdType cell = face.Cells[side];
        if (cell < 0 || FluentFaceBatches::GetShare(cell, shares) != share)
        {
          continue;
        }
        Id* const place = &this->Cells.Nodes[this->GetOffset<Type>(cell)];
        FluentCellState& state = this->States[cell];
        good &= Type == VTK_TETRA
          ? face.Size == 3 && FluentTetrahedron::Add(place, state, triangle, side)
          : this->AddTo(
              Type != 0 ? Type : this->Cells.Types[cell], place, state, nodes, face.Size, side);
      }
    }
    return good;
  }

  bool AddTo(unsigned char type, Id* nodes, FluentCellState& state, const Id* listed,
    std::int32_t size, int side)
  {
    // The normal points into the first cell.
    if (type == VTK_TETRA)
    {
      return size == 3 &&
        FluentTetrahedron::Add(nodes, state, FluentTetrahedron::Face(listed), side);
    }
    if (state == FluentCellComplete)
    {
      return false;
    }
    switch (type)
    {
      case VTK_HEXAHEDRON:
      {
        const Id inward[4] = { listed[0], listed[1 + 2 * side], listed[2], listed[3 - 2 * side] };
        return size == 4 && AddToHexahedron(nodes, state, inward);
      }
      case VTK_TRIANGLE:
      case VTK_QUAD:
        return size == 2 &&
          AddToRing(nodes, type == VTK_QUAD ? 4 : 3, state, listed[side], listed[1 - side]);
      default:
        return this->AddToOther(type, nodes, state, listed, size, side);
    }
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
  bool AddToOther(unsigned char type, Id* nodes, FluentCellState& state, const Id* listed,
    std::int32_t size, int side)
  {
    constexpr int NumberOfFaces = 5;
    Waiting waiting{ state > 0 ? nodes[0] : -1, static_cast<std::int16_t>(size),
      side == 0 ? FaceDirection::Inward : FaceDirection::Outward, {} };
    std::copy(listed, listed + size, waiting.Nodes);
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
  const unsigned char first = this->Count > 0 ? this->Mesh.GetShape(0).Type : 0;
  std::atomic<bool> areStandard{ true }, isUniform{ true };
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
        if (shape.Type != first)
        {
          isUniform = false;
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
  this->CommonType = isUniform ? first : 0;
  return true;
}

//------------------------------------------------------------------------------
// From ids of the file to points; false if not all cells have all faces.
bool FluentStandardCells::Finish(const Buffer<std::uint32_t>& states, const Progress& progress)
{
  constexpr vtkIdType BlockSize = 4096;
  const vtkIdType maxNode = this->Mesh.Piece.GetNumberOfMeshPoints();
  std::atomic<bool> good{ true };
  return progress.For((this->Count + BlockSize - 1) / BlockSize,
           [&](vtkIdType first, vtkIdType last)
           {
             bool isGood = true;
             const vtkIdType end = std::min(last * BlockSize, this->Count);
             for (vtkIdType cell = first * BlockSize; cell < end && isGood; ++cell)
             {
               Id* const nodes = &this->Nodes[this->Offsets[cell]];
               Id* const last = &this->Nodes[this->Offsets[cell + 1]];
               isGood = this->Types[cell] == VTK_TETRA
                 ? FluentTetrahedron::Finish(nodes, states[cell], maxNode)
                 : states[cell] == FluentCellComplete;
               for (Id* node = nodes; node < last && isGood; ++node)
               {
                 isGood =
                   static_cast<std::uint32_t>(*node) - 1 < static_cast<std::uint64_t>(maxNode);
                 *node = isGood ? static_cast<Id>(this->Mesh.Piece.GetPoint(*node - 1)) : 0;
               }
             }
             if (!isGood)
             {
               good = false;
             }
           }) &&
    good;
}

//------------------------------------------------------------------------------
bool FluentStandardCells::Build(FluentFaceBatches& batches, FluentInteriorZones& zones,
  vtkUnstructuredGrid* grid, const Progress& progress)
{
  this->Nodes = Buffer<Id>(this->Offsets[this->Count]);
  Buffer<FluentCellState> states(this->Count);
  std::fill(states.data(), states.data() + this->Count, FluentCellState(0));

  std::deque<Share> shares;
  for (int i = FluentFaceBatches::GetNumberOfShares(); i > 0; --i)
  {
    shares.emplace_back(*this, states);
  }
  const auto count = static_cast<vtkIdType>(shares.size());
  const bool visited = batches.ForEach(FluentFaceBatches::Want::All, progress.Part(0, 0.9),
    [&](const FluentFaceBatches::Batch& batch)
    {
      return FluentFaceBatches::ForEachShare(count,
        [&](vtkIdType share)
        {
          return batch.ForEachBlock(
            [&](vtkIdType, const FluentFaceBatches::Face* faces, vtkIdType size)
            {
              if (share == 0)
              {
                zones.Add(batch.GetRun(), this->Mesh, faces, size);
              }
              return shares[static_cast<std::size_t>(share)].Add(batch, faces, size, share, count);
            });
        });
    });
  if (!visited || !this->Finish(states, progress.Part(0.9, 1)))
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
