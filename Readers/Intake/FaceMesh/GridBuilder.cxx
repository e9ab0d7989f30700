// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/FaceMesh/GridBuilder.h"

#include "Base/Parallel.h"
#include "Intake/FaceMesh/CellRing.h"
#include "Intake/FaceMesh/CellShell.h"
#include "Intake/FaceMesh/GridArrays.h"
#include "Intake/FaceMesh/PrimitiveMatcher.h"
#include "Mesh/CellShape.h"
#include "Mesh/MeshTopology.h"

#include "vtkCellType.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>

namespace camaron
{
namespace
{
constexpr vtkIdType BlockSize = IdLists::BlockSize;
constexpr vtkIdType Ahead = 8; // number of items to prefetch
constexpr vtkIdType MaxInt32 = INT32_MAX;
const ScanError MeshHasChanged = { ErrorKind::Changed,
  "expected the same mesh in all passes, found a different one" };

//------------------------------------------------------------------------------
// The cell that an item of the piece becomes.
struct Shape
{
  unsigned char Type = VTK_EMPTY_CELL;
  Extent Size;
};

//------------------------------------------------------------------------------
// The actual shape of an item that differs from the one expected from its numbers of faces and
// points.
struct Exception
{
  vtkIdType Item;
  unsigned char Type;
  vtkIdType Points;
};

//------------------------------------------------------------------------------
class GridBuilder
{
public:
  GridBuilder(FaceMesh& mesh, const PieceRequest& request, vtkUnstructuredGrid* grid,
    Warnings& warnings, ScanError& error)
    : Mesh(mesh)
    , Request(request)
    , Grid(grid)
    , Messages(warnings)
    , Error(error)
  {
  }

  bool Build(const Progress& progress)
  {
    if (!this->Piece.Select(this->Mesh, this->Request, progress.Part(0, 0.2)))
    {
      return false;
    }
    const bool takesPoints = !this->Mesh.HasSides || this->Mesh.Points.Data;
    if (takesPoints && !TakePoints(this->Mesh, this->Piece, this->Grid, progress.Part(0.2, 0.25)))
    {
      this->Error = progress.IsStopped() ? ScanError() : MeshHasChanged;
      return false;
    }
    if (this->Piece.IsCloud())
    {
      this->Total.Points = this->Piece.GetNumberOfItems();
    }
    else if (!this->Measure(progress.Part(0.25, 0.35)))
    {
      return false;
    }
    bool finished = this->Fill(progress.Part(0.35, 0.9));
    if (finished && !this->Exceptions.empty())
    {
      // Some items differ from the expectation; measure again with their actual shapes.
      finished = this->Measure(progress.Part(0.9, 0.91)) && this->Fill(progress.Part(0.91, 1));
      if (finished && !this->Exceptions.empty())
      {
        this->Error = MeshHasChanged;
        finished = false;
      }
    }
    if (!finished)
    {
      this->Grid->Initialize();
      return false;
    }
    this->Mesh = FaceMesh(); // its lists are no longer needed
    AddPieceIds(this->Piece, this->Request, this->Grid);
    return true;
  }

private:
  /// @param getSize returns the size of face f of the item; also receives its id
  template <typename GetSize>
  Shape Expect(
    vtkIdType item, const IdList& cell, const Exception* exception, const GetSize& getSize) const;
  unsigned char Guess(
    vtkIdType item, std::int32_t faces, std::int32_t triangles, std::int32_t quads) const;
  void FindDirections(
    vtkIdType item, const IdList& cell, std::vector<FaceDirection>& directions) const;
  bool Measure(const Progress& progress);
  bool Fill(const Progress& progress)
  {
    const bool wide = std::max({ this->Total.Points, this->Total.PolyhedronFacePoints,
                        this->Piece.GetNumberOfItems() }) > MaxInt32;
    return wide ? this->FillAs<vtkTypeInt64>(progress) : this->FillAs<vtkTypeInt32>(progress);
  }
  template <typename Id>
  bool FillAs(const Progress& progress);
  template <typename Id>
  bool FillCells(Arrays<Id>& arrays, const Progress& progress);
  template <typename Id>
  void FillCloud(Arrays<Id>& arrays);
  template <typename Id>
  void TurnSecondUses(Arrays<Id>& arrays) const;

  /// Lists that a thread has read.
  struct Lists
  {
    IdListGroup Cells; ///< of a block
    IdListGroup Faces; ///< of the current item
  };

  /**
   * Calls @a visit(i, cell, shape) for the items of one block in order, with the faces of each
   * cell and its expected shape. If @a readFaces, @a lists contains the item's faces during the
   * call.
   */
  template <typename Visit>
  void ForBlock(vtkIdType block, bool readFaces, Lists& lists, Visit&& visit) const
  {
    const vtkIdType first = block * BlockSize;
    const vtkIdType last = std::min(first + BlockSize, this->Piece.GetNumberOfItems());
    this->ReadCells(first, last, lists.Cells);
    auto next = std::lower_bound(this->Exceptions.begin(), this->Exceptions.end(), first,
      [](const Exception& e, vtkIdType i) { return e.Item < i; });
    for (vtkIdType i = first; i < last; ++i)
    {
      this->PrefetchFaces(GetList(lists.Cells, i - first + Ahead));
      const vtkIdType item = this->Piece.GetItem(i);
      const IdList cell = GetList(lists.Cells, i - first);
      if (readFaces)
      {
        this->ReadFaces(item, cell, lists.Faces);
      }
      const bool isException = next != this->Exceptions.end() && next->Item == i;
      if (!isException && item < this->NumberOfUniformCells)
      {
        visit(i, cell, this->UniformShape);
        continue;
      }
      const Exception* const exception = isException ? &*next++ : nullptr;
      visit(i, cell,
        readFaces ? this->Expect(item, cell, exception,
                      [&](std::int32_t f, vtkIdType) { return lists.Faces[f].Size; })
                  : this->Expect(item, cell, exception,
                      [this](std::int32_t, vtkIdType id) { return this->Mesh.Faces.GetSize(id); }));
    }
  }
  void ReadCells(vtkIdType first, vtkIdType last, IdListGroup& cells) const;
  void ReadFaces(vtkIdType item, const IdList& cell, IdListGroup& faces) const
  {
    if (item < this->Mesh.Cells.GetCount())
    {
      this->Mesh.Faces.Read(cell, faces);
      return;
    }
    const auto face = static_cast<std::int32_t>(this->Piece.GetFace(item));
    this->Mesh.Faces.Read({ reinterpret_cast<const char*>(&face), 1, 0 }, faces);
  }
  static IdList GetList(const IdListGroup& lists, vtkIdType i)
  {
    return i < lists.size() ? lists[i] : IdList();
  }
  void PrefetchFaces(const IdList& cell) const
  {
    for (std::int32_t f = 0; f < cell.Size; ++f)
    {
      this->Mesh.Faces.Prefetch(cell[f]);
    }
  }
  /// Whether a block only has cells of the common shape.
  bool IsUniform(vtkIdType block) const
  {
    return this->Piece.IsWhole() && this->Exceptions.empty() &&
      (block + 1) * BlockSize <= this->NumberOfUniformCells;
  }
  vtkIdType GetNumberOfBlocks() const
  {
    return (this->Piece.GetNumberOfItems() + BlockSize - 1) / BlockSize;
  }

  FaceMesh& Mesh;
  const PieceRequest& Request;
  vtkUnstructuredGrid* Grid;
  Warnings& Messages;
  ScanError& Error;
  FaceMeshPiece Piece;
  vtkIdType NumberOfUniformCells = 0; ///< all cells, if they are expected to have a common shape
  Shape UniformShape;
  Extent Total;
  std::vector<Extent> Blocks;                      ///< where blocks of items begin
  std::vector<Exception> Exceptions;               ///< ascending
  std::vector<std::array<vtkIdType, 2>> OpenCells; ///< in the mesh and in the piece, ascending
};

//------------------------------------------------------------------------------
// The shape expected from the sizes of its faces: a polyhedron is expected to be closed and without
// handles (Euler: points - edges + faces = 2).
template <typename GetSize>
Shape GridBuilder::Expect(
  vtkIdType item, const IdList& cell, const Exception* exception, const GetSize& getSize) const
{
  Shape shape;
  const vtkIdType numberOfCells = this->Mesh.Cells.GetCount();
  if (item >= numberOfCells)
  {
    const std::int32_t size = getSize(0, this->Piece.GetFace(item));
    shape.Type = GetPolygonType(size);
    shape.Size.Points = size;
    return shape;
  }

  std::int32_t faces = 0, triangles = 0, quads = 0;
  vtkIdType corners = 0;
  const std::int32_t commonSize = this->Mesh.Faces.GetCommonSize();
  if (commonSize > 0)
  {
    faces = cell.Size;
    triangles = commonSize == 3 ? faces : 0;
    quads = commonSize == 4 ? faces : 0;
    corners = vtkIdType(commonSize) * faces;
  }
  else
  {
    for (std::int32_t f = 0; f < cell.Size; ++f)
    {
      const std::int32_t size = getSize(f, cell[f]);
      faces += size > 0;
      triangles += size == 3;
      quads += size == 4;
      corners += size;
    }
  }
  if (faces == 0)
  {
    return shape;
  }
  shape.Size.Faces = faces;
  shape.Type = exception ? exception->Type
    : faces == cell.Size ? this->Guess(item, faces, triangles, quads)
                         : static_cast<unsigned char>(VTK_POLYHEDRON);
  if (shape.Type == VTK_POLYHEDRON)
  {
    shape.Size.PolyhedronFaces = faces;
    shape.Size.PolyhedronFacePoints = corners;
    shape.Size.Points =
      exception ? exception->Points : std::max<vtkIdType>(1, corners / 2 - faces + 2);
  }
  else
  {
    shape.Size.Points = exception ? exception->Points
      : this->Mesh.Dimension == 2 ? faces
                                  : PrimitiveMatcher::GetNumberOfNodes(shape.Type);
  }
  return shape;
}

//------------------------------------------------------------------------------
// The type of a cell with these numbers of faces; a declared one if it matches them.
unsigned char GridBuilder::Guess(
  vtkIdType item, std::int32_t faces, std::int32_t triangles, std::int32_t quads) const
{
  const bool isFlat = this->Mesh.Dimension == 2;
  const unsigned char guess = !isFlat ? PrimitiveMatcher::Guess(faces, triangles, quads)
    : faces > 2                       ? GetPolygonType(faces)
                                      : static_cast<unsigned char>(VTK_POLYGON);
  const unsigned char declared = this->Mesh.Types.size() > 0
    ? this->Mesh.Types[item]
    : static_cast<unsigned char>(VTK_EMPTY_CELL);
  return declared == VTK_EMPTY_CELL || declared == guess ? guess
    : isFlat                                             ? VTK_POLYGON
                                                         : VTK_POLYHEDRON;
}

//------------------------------------------------------------------------------
// The directions of the faces of a cell, from the cells on both sides; if it is on both sides of a
// face, which is listed twice then, the first is that into which the face points.
void GridBuilder::FindDirections(
  vtkIdType item, const IdList& cell, std::vector<FaceDirection>& directions) const
{
  directions.resize(static_cast<std::size_t>(cell.Size));
  std::int32_t last = -1;
  for (std::int32_t f = 0; f < cell.Size; ++f)
  {
    const std::int32_t face = cell[f];
    const bool isInward = face != last && this->Mesh.Sides[2 * vtkIdType(face)] == item;
    directions[f] = isInward ? FaceDirection::Inward : FaceDirection::Outward;
    last = face;
  }
}

//------------------------------------------------------------------------------
void GridBuilder::ReadCells(vtkIdType first, vtkIdType last, IdListGroup& cells) const
{
  const vtkIdType numberOfCells = this->Mesh.Cells.GetCount();
  if (this->Piece.IsWhole())
  {
    this->Mesh.Cells.ReadBlock(first, std::min(last, numberOfCells), cells);
    return;
  }
  std::array<std::int32_t, BlockSize> items;
  for (vtkIdType i = first; i < last; ++i)
  {
    // Items that are not cells have an empty list here.
    items[static_cast<std::size_t>(i - first)] =
      static_cast<std::int32_t>(std::min(this->Piece.GetItem(i), numberOfCells));
  }
  this->Mesh.Cells.Read(
    { reinterpret_cast<const char*>(items.data()), static_cast<std::int32_t>(last - first), 0 },
    cells);
}

//------------------------------------------------------------------------------
bool GridBuilder::Measure(const Progress& progress)
{
  const std::int32_t cellSize = this->Mesh.Cells.GetCommonSize();
  const std::int32_t faceSize = this->Mesh.Faces.GetCommonSize();
  if (cellSize > 0 && faceSize > 0 && this->Mesh.Types.size() == 0)
  {
    this->NumberOfUniformCells = this->Mesh.Cells.GetCount();
    this->UniformShape = this->Expect(0, { nullptr, cellSize, 0 }, nullptr,
      [faceSize](std::int32_t, vtkIdType) { return faceSize; });
  }
  this->Blocks.assign(static_cast<std::size_t>(this->GetNumberOfBlocks()) + 1, Extent());
  std::atomic<bool> isTooLarge{ false };
  const bool finished = progress.For(this->GetNumberOfBlocks(),
    [&](vtkIdType first, vtkIdType last)
    {
      Lists lists;
      for (vtkIdType block = first; block < last; ++block)
      {
        Extent& sum = this->Blocks[block + 1];
        const auto add = [&](const Shape& shape)
        {
          sum += shape.Size;
          if (shape.Size.PolyhedronFacePoints > MaxInt32)
          {
            isTooLarge = true;
          }
        };
        if (this->IsUniform(block))
        {
          for (vtkIdType i = 0; i < BlockSize; ++i)
          {
            add(this->UniformShape);
          }
          continue;
        }
        this->ForBlock(
          block, false, lists, [&](vtkIdType, const IdList&, const Shape& shape) { add(shape); });
      }
    });
  for (std::size_t block = 1; block < this->Blocks.size(); ++block)
  {
    this->Blocks[block] += this->Blocks[block - 1];
  }
  this->Total = this->Blocks.back();

  if (isTooLarge)
  {
    this->Error = { ErrorKind::Unsupported,
      "expected cells with fewer than 2147483648 vertices, found a larger one" };
    return false;
  }
  // A face belongs to two cells, rarely to more. A small file that lists large faces repeatedly
  // must not exhaust memory.
  constexpr vtkIdType MaxUses = 16;
  if (finished &&
    this->Total.PolyhedronFacePoints >
      MaxUses * std::max(BlockSize, this->Mesh.Faces.GetNumberOfIds()))
  {
    this->Error = { ErrorKind::Count,
      "expected about two cells per face, found " +
        std::to_string(this->Total.PolyhedronFacePoints) + " face vertices in cells and " +
        std::to_string(this->Mesh.Faces.GetNumberOfIds()) + " in the list of faces" };
    return false;
  }
  return finished;
}

//------------------------------------------------------------------------------
template <typename Id>
bool GridBuilder::FillCells(Arrays<Id>& arrays, const Progress& progress)
{
  std::mutex mutex;
  std::vector<std::array<vtkIdType, 2>> open;
  std::vector<Exception> exceptions;
  std::atomic<bool> hasChanged{ false }; // since it was measured
  const bool provide = !arrays.CellFaces.empty();
  const bool polyhedra = arrays.Locations.size() > 0;
  const bool finished = progress.For(this->GetNumberOfBlocks(),
    [&](vtkIdType first, vtkIdType last)
    {
      PrimitiveMatcher matcher(this->Mesh.Points);
      CellShell shell(this->Mesh.Points);
      CellRing ring;
      std::vector<FaceDirection> directions;
      std::vector<std::array<vtkIdType, 2>> localOpen;
      std::vector<Exception> localExceptions;
      Lists lists;
      const IdListGroup& faces = lists.Faces;
      Extent at = this->Blocks[first];

      const auto fill = [&](vtkIdType i, const IdList& cell, const Shape& shape)
      {
        const vtkIdType item = this->Piece.GetItem(i);
        arrays.Types[i] = shape.Type;
        arrays.Offsets[i] = static_cast<Id>(at.Points);
        if (polyhedra)
        {
          arrays.LocationOffsets[i] = static_cast<Id>(at.PolyhedronFaces);
        }
        Id* ids = arrays.Connectivity.data() + at.Points;
        const auto count = static_cast<std::int32_t>(faces.size());
        if (this->Mesh.HasSides)
        {
          this->FindDirections(item, cell, directions);
        }
        if (shape.Type == VTK_POLYHEDRON)
        {
          shell.Load(cell, faces.data());
          const auto& points = shell.GetPoints();
          if ((this->Mesh.HasSides && shell.GetNumberOfFaces() != count) ||
            shell.GetNumberOfFaces() != shape.Size.PolyhedronFaces ||
            shell.GetNumberOfCorners() != shape.Size.PolyhedronFacePoints)
          {
            hasChanged = true;
            return;
          }
          if (static_cast<vtkIdType>(points.size()) != shape.Size.Points)
          {
            localExceptions.push_back({ i, VTK_POLYHEDRON, static_cast<vtkIdType>(points.size()) });
            return;
          }
          for (std::int32_t f = 0; f < count && this->Mesh.HasSides; ++f)
          {
            if (directions[static_cast<std::size_t>(f)] == FaceDirection::Inward)
            {
              shell.Turn(f);
            }
          }
          if (!this->Mesh.HasSides && !shell.Orient())
          {
            localOpen.push_back({ { item, i } });
          }
          for (const std::int32_t id : points)
          {
            *ids++ = static_cast<Id>(this->Piece.GetPoint(id));
          }
          Id* facePoints = arrays.FaceConnectivity.data() + at.PolyhedronFacePoints;
          for (std::int32_t f = 0; f < shell.GetNumberOfFaces(); ++f)
          {
            const vtkIdType entry = at.PolyhedronFaces + f;
            arrays.Locations[entry] = static_cast<Id>(entry);
            arrays.FaceOffsets[entry] =
              static_cast<Id>(facePoints - arrays.FaceConnectivity.data());
            shell.ForEachPoint(f,
              [&](std::int32_t id) { *facePoints++ = static_cast<Id>(this->Piece.GetPoint(id)); });
            if (provide)
            {
              arrays.CellFaces[at.Faces + f] =
                static_cast<Index>(this->Piece.GetFaceNumber(shell.GetFace(f)));
            }
          }
        }
        else if (shape.Type != VTK_EMPTY_CELL && this->Mesh.Dimension == 2)
        {
          if (!ring.Make(faces.data(), directions.data(), count))
          {
            localExceptions.push_back({ i, VTK_EMPTY_CELL, 0 });
            return;
          }
          for (const std::int32_t id : ring.GetPoints())
          {
            *ids++ = static_cast<Id>(this->Piece.GetPoint(id));
          }
        }
        else if (shape.Size.Faces > 0 && shape.Type != VTK_EMPTY_CELL)
        {
          if (PrimitiveMatcher::Guess(faces.data(), count) != shape.Type)
          {
            hasChanged = true;
            return;
          }
          if (!(this->Mesh.HasSides ? matcher.Match(shape.Type, faces.data(), directions.data())
                                    : matcher.Match(shape.Type, faces.data())))
          {
            shell.Load(cell, faces.data());
            localExceptions.push_back(
              { i, VTK_POLYHEDRON, static_cast<vtkIdType>(shell.GetPoints().size()) });
            return;
          }
          for (vtkIdType node = 0; node < shape.Size.Points; ++node)
          {
            ids[node] = static_cast<Id>(this->Piece.GetPoint(matcher.GetNodes()[node]));
          }
          for (std::int32_t f = 0; provide && f < cell.Size; ++f)
          {
            arrays.CellFaces[at.Faces + f] =
              static_cast<Index>(this->Piece.GetFaceNumber(cell[matcher.GetFace(f)]));
          }
        }
        else if (shape.Type != VTK_EMPTY_CELL)
        {
          const IdList& face = faces[0];
          for (std::int32_t j = 0; j < std::min<vtkIdType>(face.Size, shape.Size.Points); ++j)
          {
            ids[j] = static_cast<Id>(this->Piece.GetPoint(face[j]));
          }
        }
      };

      for (vtkIdType block = first; block < last; ++block)
      {
        this->ForBlock(block, true, lists,
          [&](vtkIdType i, const IdList& cell, const Shape& shape)
          {
            if (!at.HasRoom(shape.Size, this->Blocks[block + 1]))
            {
              hasChanged = true;
              return;
            }
            fill(i, cell, shape);
            at += shape.Size;
          });
      }
      const std::lock_guard<std::mutex> lock(mutex);
      open.insert(open.end(), localOpen.begin(), localOpen.end());
      exceptions.insert(exceptions.end(), localExceptions.begin(), localExceptions.end());
    });

  std::sort(open.begin(), open.end());
  this->OpenCells = std::move(open);
  std::sort(exceptions.begin(), exceptions.end(),
    [](const Exception& a, const Exception& b) { return a.Item < b.Item; });
  this->Exceptions = std::move(exceptions);
  if (hasChanged)
  {
    this->Error = MeshHasChanged;
  }
  return finished && !hasChanged;
}

//------------------------------------------------------------------------------
template <typename Id>
void GridBuilder::FillCloud(Arrays<Id>& arrays)
{
  const vtkIdType size = this->Piece.GetNumberOfItems();
  ParallelFor(size, BlockSize,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        arrays.Types[i] = VTK_VERTEX;
        arrays.Offsets[i] = static_cast<Id>(i);
        arrays.Connectivity[i] = static_cast<Id>(i);
      }
    });
}

//------------------------------------------------------------------------------
template <typename Id>
void GridBuilder::TurnSecondUses(Arrays<Id>& arrays) const
{
  IdSet faces(this->Mesh.Faces.GetCount());
  auto next = this->OpenCells.begin();
  this->Mesh.Cells.ForEachInOrder(
    [&](vtkIdType cell, const IdList& list)
    {
      if (next != this->OpenCells.end() && (*next)[0] == cell)
      {
        for (std::int32_t f = 0; f < list.Size; ++f)
        {
          faces.Add(list[f]);
        }
        ++next;
      }
    });
  std::vector<bool> reversed(static_cast<std::size_t>(faces.Number()), false);
  next = this->OpenCells.begin();
  this->Mesh.Cells.ForEachInOrder(
    [&](vtkIdType cell, const IdList& list)
    {
      const bool isOpen = next != this->OpenCells.end() && (*next)[0] == cell;
      vtkIdType entry = isOpen ? arrays.LocationOffsets[(*next)[1]] : 0;
      for (std::int32_t f = 0; f < list.Size; ++f)
      {
        const std::int32_t face = list[f];
        if (!faces.Contains(face) || this->Mesh.Faces.GetSize(face) == 0)
        {
          continue;
        }
        const auto number = static_cast<std::size_t>(faces.GetNumber(face));
        if (isOpen && entry < arrays.LocationOffsets[(*next)[1] + 1])
        {
          if (reversed[number])
          {
            Id* points = arrays.FaceConnectivity.data();
            std::reverse(
              points + arrays.FaceOffsets[entry] + 1, points + arrays.FaceOffsets[entry + 1]);
          }
          ++entry;
        }
        reversed[number] = !reversed[number];
      }
      next += isOpen;
    });
}

//------------------------------------------------------------------------------
template <typename Id>
bool GridBuilder::FillAs(const Progress& progress)
{
  // Storing the known faces is only worthwhile if finding them is more expensive.
  constexpr vtkIdType MaxUses = vtkIdType(1) << 30; // of FacetTable
  const bool provide = this->Total.PolyhedronFaces > 0 && this->Total.Faces <= MaxUses;
  Arrays<Id> arrays(this->Piece.GetNumberOfItems(), this->Total, provide);
  if (this->Piece.IsCloud())
  {
    this->FillCloud(arrays);
  }
  else if (!this->FillCells(arrays, progress))
  {
    return false;
  }
  if (this->Exceptions.empty())
  {
    if (!this->OpenCells.empty())
    {
      this->TurnSecondUses(arrays);
      Tally open;
      for (const auto& cell : this->OpenCells)
      {
        if (cell[1] < this->Piece.GetNumberOfOwnedItems()) // the owner of a ghost warns about it
        {
          open.Add(cell[0]);
        }
      }
      this->Messages.Add(
        open, "cell", "cells", "not closed (an edge has one face or more than two)");
    }
    arrays.MoveTo(this->Grid);
    if (provide)
    {
      MeshTopology::Provide(this->Grid, std::move(arrays.CellFaces),
        static_cast<Index>(this->Piece.GetNumberOfFaces()));
    }
  }
  return true;
}

}

//------------------------------------------------------------------------------
bool BuildGrid(FaceMesh& mesh, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress)
{
  return GridBuilder(mesh, request, grid, warnings, error).Build(progress);
}
}
