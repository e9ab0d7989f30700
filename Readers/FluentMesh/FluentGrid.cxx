// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentGrid.h"

#include "Base/Parallel.h"
#include "Intake/FaceMesh/GridArrays.h"
#include "vtkCamaronCompat.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <mutex>

namespace camaron
{
namespace
{
constexpr vtkIdType CellsAhead = 8; // distance of prefetching, in cells
constexpr vtkIdType MaxInt32 = INT32_MAX;

//------------------------------------------------------------------------------
// Calls visit(cell, face) for the cells of the piece on both sides of all faces, in parallel.
template <typename Visit>
bool ForEachUse(const FluentMesh& mesh, const Progress& progress, Visit&& visit)
{
  return mesh.Faces.ForEach(progress,
    [&](const FluentFaces::Run& run, vtkIdType position, const FluentFace& face)
    {
      if (!run.Bounds || face.Nodes.Size == 0)
      {
        return;
      }
      for (int side = 0; side < 2; ++side)
      {
        const vtkIdType cell = mesh.FindCell(face.GetCell(side));
        if (cell >= 0)
        {
          visit(cell, position);
        }
      }
    });
}

//------------------------------------------------------------------------------
// The faces of every cell of a piece, collected from the cells of every face.
class FluentCellLists
{
public:
  /// Collects the positions of the faces of each cell, in any order; false if aborted.
  bool Find(const FluentMesh& mesh, const Progress& progress);

  Index* Get(vtkIdType cell) { return this->Lists.data() + this->Cursors[cell]; }
  const Index* Get(vtkIdType cell) const { return this->Lists.data() + this->Cursors[cell]; }
  vtkIdType GetSize(vtkIdType cell) const
  {
    return vtkIdType(this->Cursors[cell + 1]) - vtkIdType(this->Cursors[cell]);
  }
  /// Moves out the lists, one after the other.
  LargeVector<Index> Take() { return std::move(this->Lists); }

private:
  using Cursor = std::atomic<std::uint32_t>;
  /// Adds to a cursor and returns the new value. A single thread needs no locks.
  static std::uint32_t Add(Cursor& cursor, std::uint32_t value, bool alone)
  {
    if (!alone)
    {
      return cursor.fetch_add(value, std::memory_order_relaxed) + value;
    }
    const std::uint32_t sum = cursor.load(std::memory_order_relaxed) + value;
    cursor.store(sum, std::memory_order_relaxed);
    return sum;
  }

  /// Per cell its number of faces, then the end of its list, then the begin.
  std::vector<Cursor> Cursors;
  LargeVector<Index> Lists;
};

//------------------------------------------------------------------------------
bool FluentCellLists::Find(const FluentMesh& mesh, const Progress& progress)
{
  const vtkIdType count = mesh.Piece.GetNumberOfCells();
  this->Cursors = std::vector<Cursor>(static_cast<std::size_t>(count) + 1);
  const bool alone = vtkSMPTools::GetEstimatedNumberOfThreads() <= 1;
  if (!ForEachUse(mesh, progress.Part(0, 0.5),
        [this, alone](vtkIdType cell, vtkIdType) { Add(this->Cursors[cell], 1, alone); }))
  {
    return false;
  }
  const vtkIdType total = ParallelScan(
    count, HeavyGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType sum = 0;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        sum += this->Cursors[cell];
      }
      return sum;
    },
    [&](vtkIdType begin, vtkIdType end, vtkIdType before)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        before += this->Cursors[cell];
        this->Cursors[cell] = static_cast<std::uint32_t>(before);
      }
    });
  this->Cursors[count] = static_cast<std::uint32_t>(total);
  this->Lists.resize(static_cast<std::size_t>(total), 0);
  const bool finished = ForEachUse(mesh, progress.Part(0.5, 1),
    [&](vtkIdType cell, vtkIdType face)
    {
      const std::uint32_t place = Add(this->Cursors[cell], -1u, alone);
      if (place < this->Lists.size()) // unless the file has changed
      {
        this->Lists[place] = static_cast<Index>(face);
      }
    });
  return finished && std::is_sorted(this->Cursors.begin(), this->Cursors.end());
}

//------------------------------------------------------------------------------
// Actual type and size of a cell that differs from the expectation.
struct Exception
{
  vtkIdType Cell;
  unsigned char Type;
  vtkIdType Points;
};

//------------------------------------------------------------------------------
class FluentGridBuilder
{
public:
  FluentGridBuilder(
    const FluentMesh& mesh, vtkUnstructuredGrid* grid, Warnings& warnings, ScanError& error)
    : Mesh(mesh)
    , Count(mesh.Piece.GetNumberOfCells())
    , Grid(grid)
    , Messages(warnings)
    , Error(error)
  {
  }

  bool Build(const Progress& progress);

private:
  bool FillLists(const Progress& progress)
  {
    const Extent& total = this->Blocks.back();
    return std::max({ total.Points, total.PolyhedronFacePoints, this->Count }) > MaxInt32
      ? this->FillListsAs<vtkTypeInt64>(progress)
      : this->FillListsAs<vtkTypeInt32>(progress);
  }
  unsigned char Expect(vtkIdType cell, Extent& size) const;
  bool Measure(const Progress& progress);
  template <typename Id>
  bool FillListsAs(const Progress& progress);
  void Warn();

  /// Calls visit(scratch, block, begin, end) for blocks of cells in parallel.
  template <typename Visit>
  bool ForBlocks(const Progress& progress, Visit&& visit) const
  {
    return progress.For(this->GetNumberOfBlocks(),
      [&](vtkIdType first, vtkIdType last)
      {
        FluentCellFaces scratch(this->Mesh);
        for (vtkIdType block = first; block < last; ++block)
        {
          visit(
            scratch, block, block * HeavyGrain, std::min((block + 1) * HeavyGrain, this->Count));
        }
      });
  }
  vtkIdType GetNumberOfBlocks() const { return (this->Count + HeavyGrain - 1) / HeavyGrain; }
  std::int64_t GetId(vtkIdType cell) const
  {
    return this->Mesh.Cells.GetId(this->Mesh.Piece.GetLeaf(cell));
  }
  void PrefetchFaces(const Index* faces, vtkIdType count) const
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      this->Mesh.Faces.Prefetch(faces[i]);
    }
  }
  void AddExceptions(const std::vector<Exception>& more)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Found.insert(this->Found.end(), more.begin(), more.end());
  }

  const FluentMesh& Mesh;
  vtkIdType Count;
  vtkUnstructuredGrid* Grid;
  Warnings& Messages;
  ScanError& Error;
  std::mutex Mutex;
  FluentCellLists Lists;
  Buffer<unsigned char> Types;
  Buffer<std::uint32_t> Points;      ///< number of points of every cell
  std::vector<Extent> Blocks;        ///< begins of blocks of cells
  std::vector<Exception> Exceptions; ///< known ones, ascending
  std::vector<Exception> Found;      ///< newly found ones
  std::atomic<vtkIdType> NumberOfJoined{ 0 };
};

//------------------------------------------------------------------------------
// The expected type and size of a cell: a polyhedron is expected to be closed and without handles
// (Euler: points - edges + faces = 2).
unsigned char FluentGridBuilder::Expect(vtkIdType cell, Extent& size) const
{
  const vtkIdType count = this->Lists.GetSize(cell);
  if (count == 0)
  {
    return VTK_EMPTY_CELL;
  }
  std::int32_t triangles = 0, quads = 0;
  vtkIdType corners = 0;
  const Index* const faces = this->Lists.Get(cell);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const std::int32_t nodes = this->Mesh.Faces[faces[i]].Nodes.Size;
    triangles += nodes == 3;
    quads += nodes == 4;
    corners += nodes;
  }
  size.Faces = count;
  size.PolyhedronFacePoints = corners;
  FluentShape shape = this->Mesh.GetShape(cell);
  const bool isFlat = this->Mesh.Dimension == 2;
  const bool canJoin = !this->Mesh.Tree.Entries.empty() && count > shape.Faces;
  if (shape.Faces > 0 && shape.Faces != count && !canJoin)
  {
    shape = { static_cast<unsigned char>(isFlat ? VTK_POLYGON : VTK_POLYHEDRON), 0, 0 };
  }
  if (isFlat)
  {
    size.Points = shape.Nodes > 0 ? shape.Nodes : count;
    return shape.Type != VTK_EMPTY_CELL ? shape.Type
      : count == 3                      ? VTK_TRIANGLE
      : count == 4                      ? VTK_QUAD
                                        : VTK_POLYGON;
  }
  const unsigned char type = shape.Type != VTK_EMPTY_CELL
    ? shape.Type
    : PrimitiveMatcher::Guess(static_cast<std::int32_t>(count), triangles, quads);
  size.Points = type == VTK_POLYHEDRON ? std::max<vtkIdType>(1, corners / 2 - count + 2)
                                       : PrimitiveMatcher::GetNumberOfNodes(type);
  return type;
}

//------------------------------------------------------------------------------
bool FluentGridBuilder::Measure(const Progress& progress)
{
  this->Types = Buffer<unsigned char>(this->Count);
  this->Points = Buffer<std::uint32_t>(this->Count);
  this->Blocks.assign(static_cast<std::size_t>(this->GetNumberOfBlocks()) + 1, Extent());
  std::atomic<bool> isTooLarge{ false };
  const bool finished = progress.For(this->GetNumberOfBlocks(),
    [&](vtkIdType first, vtkIdType last)
    {
      auto exception = std::lower_bound(this->Exceptions.begin(), this->Exceptions.end(),
        first * HeavyGrain, [](const Exception& e, vtkIdType cell) { return e.Cell < cell; });
      for (vtkIdType block = first; block < last; ++block)
      {
        Extent sum;
        const vtkIdType end = std::min((block + 1) * HeavyGrain, this->Count);
        for (vtkIdType cell = block * HeavyGrain; cell < end; ++cell)
        {
          Extent size;
          this->Types[cell] = this->Expect(cell, size);
          if (exception != this->Exceptions.end() && exception->Cell == cell)
          {
            this->Types[cell] = exception->Type;
            size.Points = exception->Points;
            ++exception;
          }
          if (this->Types[cell] == VTK_POLYHEDRON)
          {
            size.PolyhedronFaces = size.Faces;
          }
          else
          {
            size.PolyhedronFacePoints = 0;
          }
          if (std::max(size.Points, size.PolyhedronFacePoints) > MaxInt32)
          {
            isTooLarge = true;
          }
          this->Points[cell] = static_cast<std::uint32_t>(size.Points);
          sum += size;
        }
        this->Blocks[block + 1] = sum;
      }
    });
  for (std::size_t block = 1; block < this->Blocks.size(); ++block)
  {
    this->Blocks[block] += this->Blocks[block - 1];
  }
  if (isTooLarge)
  {
    this->Error = { ErrorKind::Unsupported,
      "expected cells with fewer than 2147483648 vertices, found a larger one" };
    return false;
  }
  return finished;
}

//------------------------------------------------------------------------------
template <typename Id>
bool FluentGridBuilder::FillListsAs(const Progress& progress)
{
  const Extent& total = this->Blocks.back();
  Arrays<Id> arrays(this->Count, total, false);
  std::atomic<bool> hasChanged{ false };
  const bool finished = this->ForBlocks(progress,
    [&](FluentCellFaces& faces, vtkIdType block, vtkIdType begin, vtkIdType end)
    {
      std::vector<Exception> exceptions; // if there are any, the arrays are filled again
      std::vector<Index> order;
      const Extent& next = this->Blocks[block + 1];
      vtkIdType joined = 0;
      Id point = static_cast<Id>(this->Blocks[block].Points);
      Id face = static_cast<Id>(this->Blocks[block].PolyhedronFaces);
      Id corner = static_cast<Id>(this->Blocks[block].PolyhedronFacePoints);
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const unsigned char type = this->Types[cell];
        const vtkIdType size = this->Points[cell];
        if (cell + CellsAhead < end)
        {
          this->PrefetchFaces(
            this->Lists.Get(cell + CellsAhead), this->Lists.GetSize(cell + CellsAhead));
        }
        arrays.Offsets[cell] = point;
        if (total.PolyhedronFaces > 0)
        {
          arrays.LocationOffsets[cell] = face;
        }
        Index* const list = this->Lists.Get(cell);
        const vtkIdType count = this->Lists.GetSize(cell);
        if (type == VTK_EMPTY_CELL)
        {
          continue;
        }
        faces.Load(this->GetId(cell), list, count);
        if (type != VTK_POLYHEDRON && faces.Match(type))
        {
          for (vtkIdType node = 0; node < size; ++node)
          {
            arrays.Connectivity[point++] = static_cast<Id>(faces.GetNode(node));
          }
          joined += faces.HasJoined();
          if (this->Mesh.Dimension == 3 && !faces.HasJoined())
          {
            order.assign(list, list + count);
            for (int f = 0; f < static_cast<int>(count); ++f)
            {
              list[f] = order[static_cast<std::size_t>(faces.GetFace(f))];
            }
          }
          continue;
        }
        if (type != VTK_POLYHEDRON)
        {
          faces.Load(this->GetId(cell), list, count); // Match may have joined some
        }
        if (this->Mesh.Dimension == 2)
        {
          const bool isPolygon = type != VTK_POLYGON && faces.Match(VTK_POLYGON);
          exceptions.push_back(
            { cell, static_cast<unsigned char>(isPolygon ? VTK_POLYGON : VTK_EMPTY_CELL),
              isPolygon ? count : 0 });
          continue;
        }
        faces.MakeShell();
        if (type != VTK_POLYHEDRON || faces.GetNumberOfShellPoints() != size)
        {
          exceptions.push_back({ cell, VTK_POLYHEDRON, faces.GetNumberOfShellPoints() });
          continue;
        }
        if (face + faces.GetNumberOfShellFaces() > next.PolyhedronFaces ||
          corner + faces.GetNumberOfShellCorners() > next.PolyhedronFacePoints)
        {
          hasChanged = true; // the file, since cells were measured
          break;
        }
        for (vtkIdType i = 0; i < size; ++i)
        {
          arrays.Connectivity[point++] = static_cast<Id>(faces.GetShellPoint(i));
        }
        for (std::int32_t f = 0; f < faces.GetNumberOfShellFaces(); ++f)
        {
          arrays.Locations[face] = face;
          arrays.FaceOffsets[face++] = corner;
          faces.ForEachShellPoint(
            f, [&](vtkIdType id) { arrays.FaceConnectivity[corner++] = static_cast<Id>(id); });
        }
      }
      this->NumberOfJoined += joined;
      this->AddExceptions(exceptions);
    });
  if (finished && !hasChanged && this->Found.empty())
  {
    arrays.Types = std::move(this->Types);
    arrays.MoveTo(this->Grid);
  }
  return finished && !hasChanged;
}

//------------------------------------------------------------------------------
bool FluentGridBuilder::Build(const Progress& progress)
{
  if (!this->Lists.Find(this->Mesh, progress.Part(0, 0.4)) ||
    !this->Measure(progress.Part(0.4, 0.5)) || !this->FillLists(progress.Part(0.5, 0.9)))
  {
    return false;
  }
  if (!this->Found.empty())
  {
    // Some cells differ from the expectation; repeat with the known exceptions.
    std::sort(this->Found.begin(), this->Found.end(),
      [](const Exception& a, const Exception& b) { return a.Cell < b.Cell; });
    this->Exceptions = std::move(this->Found);
    this->Found.clear();
    this->NumberOfJoined = 0;
    if (!this->Measure(progress.Part(0.9, 0.91)) || !this->FillLists(progress.Part(0.91, 1)))
    {
      return false;
    }
  }
  this->Warn();
  // Worth the memory only for polyhedra.
  constexpr vtkIdType MaxUses = vtkIdType(1) << 30; // of FacetTable
  const Extent& total = this->Blocks.back();
  if (total.PolyhedronFaces > 0 && total.Faces <= MaxUses && this->NumberOfJoined == 0)
  {
    this->Mesh.ProvideFaces(this->Grid, this->Lists.Take());
  }
  return true;
}

//------------------------------------------------------------------------------
void FluentGridBuilder::Warn()
{
  Tally empty, broken, other, joined;
  const auto* const types =
    vtkUnsignedCharArray::SafeDownCast(GetCellTypes(this->Grid)); // of SetCells
  for (vtkIdType cell = 0; cell < this->Count; ++cell)
  {
    if (this->Mesh.Piece.IsGhostLeaf(this->Mesh.Piece.GetLeaf(cell)))
    {
      continue; // another piece reports these
    }
    const unsigned char type = types->GetValue(cell);
    const FluentShape shape = this->Mesh.GetShape(cell);
    if (type == VTK_EMPTY_CELL)
    {
      (this->Lists.GetSize(cell) == 0 ? empty : broken).Add(this->GetId(cell));
    }
    else if (shape.Faces > 0 && type != shape.Type)
    {
      other.Add(this->GetId(cell));
    }
    else if (shape.Faces > 0 && this->Lists.GetSize(cell) > shape.Faces)
    {
      joined.Add(this->GetId(cell));
    }
  }
  this->Messages.Add(empty, "cell", "cells", "without faces");
  this->Messages.Add(broken, "cell", "cells", "whose edges do not form a closed ring, left empty");
  this->Messages.Add(other, "cell", "cells",
    this->Mesh.Dimension == 2 ? "whose edges do not match the declared type, read as polygons"
                              : "whose faces do not match the declared type, read as polyhedra");
  this->Messages.Add(joined, "cell", "cells",
    "at hanging nodes, not connected to refined neighbors because split faces are joined (Join "
    "Split Faces)");
}
}

//------------------------------------------------------------------------------
bool BuildFluentCells(const FluentMesh& mesh, vtkUnstructuredGrid* grid, Warnings& warnings,
  ScanError& error, const Progress& progress)
{
  return FluentGridBuilder(mesh, grid, warnings, error).Build(progress);
}
}
