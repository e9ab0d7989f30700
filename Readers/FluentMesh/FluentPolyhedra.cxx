// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentGrid.h"

#include "Base/Parallel.h"
#include "Intake/FaceMesh/GridArrays.h"

#include <algorithm>
#include <atomic>

namespace camaron
{
namespace
{
constexpr vtkIdType FacesAhead = 8; // distance of prefetching, in faces

//------------------------------------------------------------------------------
// Finds the distinct points of one cell after the other. The hash table need not be cleared between
// cells: its entries contain the cell to which they belong.
class Numbering
{
public:
  /// Begins a cell with at most this many face points.
  void Begin(std::size_t corners)
  {
    if (2 * corners > this->Table.size() || this->Cell == UINT32_MAX)
    {
      while ((std::size_t(1) << this->Bits) < 2 * corners)
      {
        ++this->Bits;
      }
      this->Table.assign(std::size_t(1) << this->Bits, 0);
      this->Cell = 0;
    }
    this->Ids.resize(std::max(this->Ids.size(), corners + 1));
    ++this->Cell;
    this->Count = 0;
  }
  void Add(vtkTypeInt32 id)
  {
    constexpr std::uint32_t Factor = 0x9e3779b1; // 2^32 / golden ratio (D. Knuth, TAOCP 3, 6.4)
    const std::uint64_t entry = std::uint64_t(this->Cell) << 32 | static_cast<std::uint32_t>(id);
    const std::size_t mask = this->Table.size() - 1;
    std::size_t slot = static_cast<std::uint32_t>(id) * Factor >> (32 - this->Bits);
    while (this->Table[slot] != entry && this->Table[slot] >> 32 == this->Cell)
    {
      slot = (slot + 1) & mask;
    }
    // A new id is counted without a branch, which would be mispredicted.
    this->Ids[this->Count] = id;
    this->Count += this->Table[slot] != entry;
    this->Table[slot] = entry;
  }
  const std::vector<vtkTypeInt32>& GetIds() const { return this->Ids; }
  std::uint32_t GetCount() const { return static_cast<std::uint32_t>(this->Count); }

private:
  std::vector<std::uint64_t> Table;
  std::vector<vtkTypeInt32> Ids;
  std::size_t Count = 0;
  std::uint32_t Cell = 0;
  int Bits = 4;
};

//------------------------------------------------------------------------------
/**
 * Creates polyhedra in two passes over the faces. The first one counts the faces and face points of
 * every cell, so the second can store each face at the positions of its cells in the grid. Faces,
 * points and their order are the same as from FluentCellFaces.
 */
class FluentPolyhedra
{
public:
  explicit FluentPolyhedra(const FluentMesh& mesh)
    : Mesh(mesh)
    , Count(mesh.Piece.GetNumberOfCells())
  {
  }

  /// Whether all cells are declared as polyhedra.
  bool AreAll() const;
  bool Build(FluentFaceBatches& batches, FluentInteriorZones& zones, vtkUnstructuredGrid* grid,
    const Progress& progress);

private:
  using Id = vtkTypeInt32;
  /// Positions of the next face of a cell and of its points.
  struct Cursor
  {
    std::uint32_t Face, Corner;
  };

  struct Side;

  bool CountFaces(FluentFaceBatches& batches, const Progress& progress);
  bool FindPlaces();
  bool Fill(FluentFaceBatches& batches, FluentInteriorZones& zones, const Progress& progress);
  bool AddTo(const Side& face);
  bool FindPoints(const Progress& progress);
  bool NumberPoints(Buffer<std::uint32_t>& counts, const Progress& progress);
  /// Begin of the points of a face.
  Id GetCorner(Id face) const
  {
    const Id offset = this->FaceOffsets[face];
    return offset < 0 ? ~offset : offset;
  }

  const FluentMesh& Mesh;
  vtkIdType Count;
  Buffer<Cursor> Cursors;           ///< per cell
  Buffer<std::uint32_t> CornerEnds; ///< per cell
  Buffer<Id> LocationOffsets;       ///< begins of the faces of every cell
  Buffer<Id> FaceOffsets; ///< begins of the points of every face, complemented if it was reversed
  Buffer<Id> Corners;     ///< points of faces
  Buffer<Id> Offsets;     ///< begins of the points of every cell
  Buffer<Id> Points;
  LargeVector<Index> Faces; ///< positions in the file of the faces of cells
};

//------------------------------------------------------------------------------
bool FluentPolyhedra::AreAll() const
{
  constexpr std::size_t MaxUses = std::size_t(1) << 30; // of FacetTable
  std::atomic<bool> good{ this->Count > 0 &&
    static_cast<std::size_t>(this->Mesh.Faces.GetCount()) <= MaxUses / 2 };
  ParallelFor(good ? this->Count : 0, HeavyGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      const bool isOne = this->Mesh.Piece.IsWhole() && this->Mesh.Cells.HaveOneElement(begin, end);
      for (vtkIdType cell = begin; cell < (isOne ? begin + 1 : end) && good; ++cell)
      {
        if (this->Mesh.GetShape(cell).Type != VTK_POLYHEDRON)
        {
          good = false;
        }
      }
    });
  return good;
}

//------------------------------------------------------------------------------
// Counts faces and face points of every cell in the cursors.
bool FluentPolyhedra::CountFaces(FluentFaceBatches& batches, const Progress& progress)
{
  this->Cursors = Buffer<Cursor>(this->Count);
  std::fill(this->Cursors.data(), this->Cursors.data() + this->Count, Cursor{ 0, 0 });
  struct Side
  {
    std::int32_t Cell, Size;
  };
  return batches.ForEachSide<Side>(
    FluentFaceBatches::Want::Cells, progress,
    [](const FluentFaces::Run&, const FluentFaceBatches::Face*, vtkIdType) {},
    [](const FluentFaceBatches::Batch&, vtkIdType, const FluentFaceBatches::Face& face, int side,
      Side& made)
    {
      made.Cell = face.Cells[side];
      made.Size = face.Size;
    },
    [&](vtkIdType, const Side* sides, vtkIdType size)
    {
      bool good = true;
      for (vtkIdType i = 0; i < size; ++i)
      {
        camaron::Prefetch(&this->Cursors[sides[std::min(i + FacesAhead, size - 1)].Cell]);
        Cursor& cursor = this->Cursors[sides[i].Cell];
        const std::uint32_t before = cursor.Corner;
        ++cursor.Face;
        cursor.Corner += static_cast<std::uint32_t>(sides[i].Size);
        good &= cursor.Corner >= before;
      }
      return good;
    });
}

//------------------------------------------------------------------------------
// Converts numbers to positions.
bool FluentPolyhedra::FindPlaces()
{
  this->LocationOffsets = Buffer<Id>(this->Count + 1);
  this->CornerEnds = Buffer<std::uint32_t>(this->Count);
  vtkIdType faces = 0, corners = 0;
  bool good = true;
  for (vtkIdType cell = 0; cell < this->Count && good; ++cell)
  {
    Cursor& cursor = this->Cursors[cell];
    const Cursor sizes = cursor;
    cursor = { static_cast<std::uint32_t>(faces), static_cast<std::uint32_t>(corners) };
    this->LocationOffsets[cell] = static_cast<Id>(faces);
    faces += sizes.Face;
    corners += sizes.Corner;
    this->CornerEnds[cell] = static_cast<std::uint32_t>(corners);
    good = sizes.Face > 0 && faces <= INT32_MAX && corners <= INT32_MAX;
  }
  if (!good)
  {
    return false;
  }
  this->LocationOffsets[this->Count] = static_cast<Id>(faces);
  this->FaceOffsets = Buffer<Id>(faces + 1);
  this->FaceOffsets[faces] = static_cast<Id>(corners);
  this->Corners = Buffer<Id>(corners);
  this->Faces.resize(static_cast<std::size_t>(faces), 0);
  return true;
}

//------------------------------------------------------------------------------
// The data of a face for one of its cells.
struct FluentPolyhedra::Side
{
  std::int32_t Cell;
  std::int32_t Size;
  Index Position;
  std::int8_t Swap, IsTurned;
  const char* Nodes;
};

//------------------------------------------------------------------------------
bool FluentPolyhedra::AddTo(const Side& face)
{
  const std::int32_t cell = face.Cell;
  Cursor& cursor = this->Cursors[cell];
  const auto size = static_cast<std::uint32_t>(face.Size);
  // The face fits, unless another program has changed the file.
  if (cursor.Face >= static_cast<std::uint32_t>(this->LocationOffsets[cell + 1]) ||
    size > this->CornerEnds[cell] - cursor.Corner)
  {
    return false;
  }
  const auto corner = static_cast<Id>(cursor.Corner);
  const auto maxNode = static_cast<std::uint64_t>(this->Mesh.Piece.GetNumberOfMeshPoints());
  this->FaceOffsets[cursor.Face] = face.IsTurned ? ~corner : corner;
  this->Faces[cursor.Face] = face.Position;
  Id* const place = &this->Corners[corner];
  bool good = true;
  const auto put = [&](std::int32_t i, Id& to)
  {
    const auto node = Load<std::int32_t>(face.Nodes + 4 * std::ptrdiff_t(i), face.Swap != 0);
    good &= static_cast<std::uint32_t>(node) - 1 < maxNode;
    to = static_cast<Id>(this->Mesh.Piece.GetPoint(node - 1));
  };
  if (face.IsTurned && face.Size > 0)
  {
    put(0, *place);
    for (std::int32_t i = 1; i < face.Size; ++i)
    {
      put(face.Size - i, place[i]);
    }
  }
  else
  {
    for (std::int32_t i = 0; i < face.Size; ++i)
    {
      put(i, place[i]);
    }
  }
  ++cursor.Face;
  cursor.Corner += size;
  return good;
}

//------------------------------------------------------------------------------
bool FluentPolyhedra::Fill(
  FluentFaceBatches& batches, FluentInteriorZones& zones, const Progress& progress)
{
  const bool visited = batches.ForEachSide<Side>(
    FluentFaceBatches::Want::All, progress,
    [&](const FluentFaces::Run& run, const FluentFaceBatches::Face* faces, vtkIdType size)
    { zones.Add(run, this->Mesh, faces, size); },
    [](const FluentFaceBatches::Batch& batch, vtkIdType position,
      const FluentFaceBatches::Face& face, int side, Side& made)
    {
      made.Cell = face.Cells[side];
      made.Size = face.Size;
      made.Position = static_cast<Index>(position);
      made.Swap = batch.GetRun().Swap;
      made.IsTurned = side == 0; // the normal points into the first cell
      made.Nodes = face.Nodes;
    },
    [&](vtkIdType, const Side* sides, vtkIdType size)
    {
      bool good = true;
      for (vtkIdType i = 0; i < size && good; ++i)
      {
        camaron::Prefetch(&this->Cursors[sides[std::min(i + FacesAhead, size - 1)].Cell]);
        good = this->AddTo(sides[i]);
      }
      return good;
    });
  if (!visited)
  {
    return false;
  }
  for (vtkIdType cell = 0; cell < this->Count; ++cell)
  {
    const Cursor& cursor = this->Cursors[cell];
    if (cursor.Face != static_cast<std::uint32_t>(this->LocationOffsets[cell + 1]) ||
      cursor.Corner != this->CornerEnds[cell])
    {
      return false;
    }
  }
  this->Cursors = Buffer<Cursor>();
  this->CornerEnds = Buffer<std::uint32_t>();
  return true;
}

//------------------------------------------------------------------------------
// Lists the points of every cell; false if their number differs from @a counts, which is corrected.
bool FluentPolyhedra::NumberPoints(Buffer<std::uint32_t>& counts, const Progress& progress)
{
  std::atomic<bool> good{ true };
  progress.For((this->Count + HeavyGrain - 1) / HeavyGrain,
    [&](vtkIdType first, vtkIdType last)
    {
      Numbering numbering;
      const vtkIdType end = std::min(last * HeavyGrain, this->Count);
      for (vtkIdType cell = first * HeavyGrain; cell < end; ++cell)
      {
        const Id begin = this->LocationOffsets[cell], endFace = this->LocationOffsets[cell + 1];
        numbering.Begin(
          static_cast<std::size_t>(this->GetCorner(endFace) - this->GetCorner(begin)));
        for (Id face = begin; face < endFace; ++face)
        {
          // In the order before the face was reversed.
          const Id corner = this->GetCorner(face), size = this->GetCorner(face + 1) - corner;
          const bool isTurned = this->FaceOffsets[face] < 0;
          for (Id i = 0; i < size; ++i)
          {
            numbering.Add(this->Corners[corner + (isTurned && i > 0 ? size - i : i)]);
          }
        }
        const std::uint32_t number = numbering.GetCount();
        if (number != counts[cell])
        {
          good = false;
          counts[cell] = number;
        }
        else
        {
          std::copy_n(numbering.GetIds().begin(), number, &this->Points[this->Offsets[cell]]);
        }
      }
    });
  return good;
}

//------------------------------------------------------------------------------
// A polyhedron is expected to be closed and without handles (Euler: points - edges + faces = 2); if
// some are not, the pass is repeated with the actual counts.
bool FluentPolyhedra::FindPoints(const Progress& progress)
{
  Buffer<std::uint32_t> counts(this->Count);
  ParallelFor(this->Count, HeavyGrain,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType cell = first; cell < last; ++cell)
      {
        const Id begin = this->LocationOffsets[cell], end = this->LocationOffsets[cell + 1];
        const Id points = (this->GetCorner(end) - this->GetCorner(begin)) / 2 - (end - begin) + 2;
        counts[cell] = static_cast<std::uint32_t>(std::max<Id>(1, points));
      }
    });
  for (const double part : { 0.5, 1. })
  {
    this->Offsets = Buffer<Id>(); // released before the next allocation
    this->Points = Buffer<Id>();
    this->Offsets = Buffer<Id>(this->Count + 1);
    vtkIdType total = 0;
    for (vtkIdType cell = 0; cell < this->Count; ++cell)
    {
      this->Offsets[cell] = static_cast<Id>(total);
      total += counts[cell];
      if (total > INT32_MAX)
      {
        return false;
      }
    }
    this->Offsets[this->Count] = static_cast<Id>(total);
    this->Points = Buffer<Id>(total);
    if (this->NumberPoints(counts, progress.Part(part - 0.5, part)))
    {
      break;
    }
  }
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
bool FluentPolyhedra::Build(FluentFaceBatches& batches, FluentInteriorZones& zones,
  vtkUnstructuredGrid* grid, const Progress& progress)
{
  if (!this->CountFaces(batches, progress.Part(0, 0.2)) || !this->FindPlaces() ||
    !this->Fill(batches, zones, progress.Part(0.2, 0.8)) ||
    !this->FindPoints(progress.Part(0.8, 1)))
  {
    return false;
  }
  const vtkIdType faces = this->FaceOffsets.size() - 1;
  Buffer<Id> locations(faces);
  Buffer<unsigned char> types(this->Count);
  std::fill(types.data(), types.data() + this->Count, static_cast<unsigned char>(VTK_POLYHEDRON));
  ParallelFor(faces, HeavyGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType face = begin; face < end; ++face)
      {
        locations[face] = static_cast<Id>(face);
        this->FaceOffsets[face] = this->GetCorner(static_cast<Id>(face));
      }
    });
  const auto typeArray = types.TakeArray<vtkUnsignedCharArray>();
  const auto cells = Arrays<Id>::MakeCells(this->Offsets, this->Points);
  const auto faceCells = Arrays<Id>::MakeCells(this->FaceOffsets, this->Corners);
  const auto locationCells = Arrays<Id>::MakeCells(this->LocationOffsets, locations);
  grid->SetPolyhedralCells(typeArray, cells, locationCells, faceCells);
  this->Mesh.ProvideFaces(grid, std::move(this->Faces));
  return true;
}
}

//------------------------------------------------------------------------------
bool StreamFluentPolyhedra(const FluentMesh& mesh, FluentFaceBatches& batches,
  FluentInteriorZones& zones, vtkUnstructuredGrid* grid, const Progress& progress)
{
  FluentPolyhedra polyhedra(mesh);
  return polyhedra.AreAll() && polyhedra.Build(batches, zones, grid, progress);
}
}
