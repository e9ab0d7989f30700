// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PLYCells.h"

#include "Base/Parallel.h"
#include "Mesh/CellShape.h"

#include <algorithm>
#include <mutex>
#include <numeric>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
unsigned char GetType(PLYRole role, vtkIdType size)
{
  return role == PLYRole::Edges && size > 2 ? static_cast<unsigned char>(VTK_POLY_LINE)
                                            : GetPolygonType(size);
}

//------------------------------------------------------------------------------
// Appends the triangles of a strip, whose parts -1 separates; orientation alternates. Those with a
// repeated vertex, which connect parts of a strip, are left out.
void AppendTriangles(const std::int32_t* ids, vtkIdType size, std::vector<std::int32_t>& triangles)
{
  vtkIdType begin = 0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (ids[i] < 0)
    {
      begin = i + 1;
    }
    else if (i >= begin + 2)
    {
      const bool isOdd = ((i - begin) & 1) != 0;
      const std::int32_t a = ids[i - 2], b = ids[isOdd ? i : i - 1], c = ids[isOdd ? i - 1 : i];
      if (a != b && b != c && c != a)
      {
        triangles.insert(triangles.end(), { a, b, c });
      }
    }
  }
}
}

//------------------------------------------------------------------------------
bool PLYCells::ReadStrips(PLYPart& part, const Progress& progress)
{
  Buffer<std::int32_t> strips(part.Sizes.Total);
  if (!this->Pass(
        part, [](vtkIdType, vtkIdType, const std::int32_t*) {}, nullptr, strips.data(), progress))
  {
    return false;
  }
  part.Ids.reserve(static_cast<std::size_t>(3 * part.Sizes.Total)); // at most
  for (vtkIdType row = 0; row < part.Rows->GetCount(); ++row)
  {
    AppendTriangles(strips.data() + part.Sizes.GetOffset(row), part.Sizes.GetSize(row), part.Ids);
  }
  part.IsInMemory = true;
  part.Sizes = ListSizes();
  part.Sizes.Common = 3;
  return true;
}

//------------------------------------------------------------------------------
bool PLYCells::ReadEdges(PLYPart& part, const Progress& progress)
{
  part.Ids.resize(static_cast<std::size_t>(2 * part.Rows->GetCount()));
  ListSizes sizes;
  sizes.Common = 1;
  bool good = true;
  for (int end = 0; end < 2 && good; ++end)
  {
    good = part.Rows->ReadIds(
      part.Ends[end], this->GetExpected(part), sizes, nullptr,
      [&](vtkIdType first, vtkIdType count, const std::int32_t* ids)
      {
        for (vtkIdType i = 0; i < count; ++i)
        {
          part.Ids[static_cast<std::size_t>(2 * (first + i) + end)] = ids[i];
        }
      },
      nullptr, progress);
  }
  part.IsInMemory = true;
  part.Sizes.Common = 2;
  return good;
}

//------------------------------------------------------------------------------
// Determines the lists of a part, and counts those with fewer than three vertices.
bool PLYCells::Measure(PLYPart& part, bool keepsEmpty, const Progress& progress)
{
  const vtkIdType rows = part.Rows->GetCount();
  part.FirstCell = this->NumberOfCells;
  if (rows == 0)
  {
    return true;
  }
  const bool hasEnds = part.List < 0;
  const bool isStrips = part.Role == PLYRole::Strips;
  if (hasEnds ? !this->ReadEdges(part, progress)
              : !part.Rows->ReadSizes(part.List, part.Sizes, progress.Part(0, 0.3)) ||
        (isStrips && !this->ReadStrips(part, progress.Part(0.3, 1))))
  {
    return false;
  }
  part.NumberOfLists = isStrips ? static_cast<vtkIdType>(part.Ids.size()) / 3 : rows;
  part.Sizes.Total = part.IsInMemory ? static_cast<vtkIdType>(part.Ids.size()) : part.Sizes.Total;
  Tally empty;
  if (part.Sizes.Common <= 2 && !part.IsInMemory && part.Role != PLYRole::Polyhedra)
  {
    std::mutex mutex;
    ParallelFor(rows, LightGrain,
      [&](vtkIdType begin, vtkIdType end)
      {
        std::int32_t least = part.Sizes.Common >= 0 ? part.Sizes.Common : INT32_MAX;
        for (vtkIdType row = begin; part.Sizes.Common < 0 && row < end; ++row)
        {
          least = std::min(least, part.Sizes.Offsets[row + 1] - part.Sizes.Offsets[row]);
        }
        Tally none, few;
        for (vtkIdType row = begin; least < 3 && row < end; ++row)
        {
          const vtkIdType size = part.Sizes.GetSize(row);
          if (size < 3 && (size == 0 || part.Role == PLYRole::Faces))
          {
            (size == 0 ? none : few).Add(row);
          }
        }
        const std::lock_guard<std::mutex> lock(mutex);
        empty.Merge(none);
        this->Short.Merge(few);
      });
  }
  this->Empty.Merge(empty);
  part.NumberOfCells = part.NumberOfLists - (keepsEmpty ? 0 : empty.Count);
  if (part.NumberOfCells < part.NumberOfLists)
  {
    // Cells without vertices are left out, and later cells move up.
    part.Items = Buffer<std::int32_t>(rows);
    auto cell = static_cast<std::int32_t>(part.FirstCell);
    for (vtkIdType row = 0; row < rows; ++row)
    {
      part.Items[row] = part.Sizes.GetSize(row) > 0 ? cell++ : -1;
    }
  }
  this->NumberOfCells += part.NumberOfCells;
  return true;
}

//------------------------------------------------------------------------------
ListIds PLYCells::GetExpected(const PLYPart& part) const
{
  return { part.Role == PLYRole::Faces ? "a vertex of a face"
      : part.Role == PLYRole::Edges    ? "a vertex of an edge"
      : part.Role == PLYRole::Strips   ? "a vertex of a strip"
                                       : "a face of a cell",
    this->Limit, part.Role == PLYRole::Strips && part.HasSignedIds() };
}

//------------------------------------------------------------------------------
// Passes all lists of a part; see TableRows::ReadIds.
bool PLYCells::Pass(const PLYPart& part, TableRows::TakeIds take, const TableRows::Needs* needs,
  std::int32_t* all, const Progress& progress) const
{
  if (part.IsInMemory)
  {
    if (all)
    {
      std::copy(part.Ids.begin(), part.Ids.end(), all);
    }
    take(0, part.NumberOfLists, part.Ids.data());
    return progress.Report(1);
  }
  return part.Rows->GetCount() == 0 ||
    part.Rows->ReadIds(part.List, this->GetExpected(part), part.Sizes, all, take, needs, progress);
}

//------------------------------------------------------------------------------
// Allocates the cells of a piece, and sets their types and sizes.
void PLYCells::Allocate(const std::vector<PLYPart*>& parts, const CellMeshPiece& piece)
{
  const vtkIdType cells = piece.GetNumberOfCells();
  // Most files have faces only, most of them of one size.
  if (parts.size() == 1 && parts[0]->Sizes.Common > 0)
  {
    const std::int32_t size = parts[0]->Sizes.Common;
    this->Mesh = CellMesh(piece.GetNumberOfPoints(), cells, GetType(parts[0]->Role, size), size);
    return;
  }
  // The offsets of the only lists are those of the cells.
  const bool takesOffsets =
    parts.size() == 1 && piece.IsWhole() && parts[0]->Sizes.Offsets.size() == cells + 1;
  this->Mesh.NumberOfPoints = piece.GetNumberOfPoints();
  this->Mesh.NumberOfCells = cells;
  this->Mesh.Types = Buffer<unsigned char>(cells);
  Buffer<std::int32_t> sizes(takesOffsets ? 0 : cells + 1);
  std::int32_t* const offsets = takesOffsets ? parts[0]->Sizes.Offsets.data() : sizes.data();
  offsets[0] = 0;
  for (const PLYPart* part : parts)
  {
    ParallelFor(part->NumberOfLists, LightGrain,
      [&](vtkIdType begin, vtkIdType end)
      {
        unsigned char* const types = this->Mesh.Types.data();
        for (vtkIdType list = begin; takesOffsets && list < end; ++list)
        {
          types[list] = GetType(part->Role, offsets[list + 1] - offsets[list]);
        }
        for (vtkIdType list = begin; !takesOffsets && list < end; ++list)
        {
          const vtkIdType cell = part->GetCell(list);
          const vtkIdType index = cell < 0 ? -1 : piece.FindCell(cell);
          if (index >= 0)
          {
            const vtkIdType size = part->Sizes.GetSize(list);
            types[index] = GetType(part->Role, size);
            offsets[index + 1] = static_cast<std::int32_t>(size);
          }
        }
      });
  }
  if (!takesOffsets)
  {
    std::partial_sum(offsets, offsets + cells + 1, offsets);
    this->Mesh.Offsets = std::move(sizes);
  }
  this->Mesh.Connectivity = Buffer<std::int32_t>(offsets[cells]);
}

//------------------------------------------------------------------------------
// Stores the points of the cells of a part; those of a whole mesh from firstId on.
bool PLYCells::Fill(const PLYPart& part, bool isAlone, const CellMeshPiece& piece,
  vtkIdType& firstId, const Progress& progress)
{
  CellMesh& mesh = this->Mesh;
  std::int32_t* const points = mesh.Connectivity.data();
  if (!piece.IsWhole())
  {
    const auto needs = [&](vtkIdType list, vtkIdType count)
    {
      bool found = false;
      for (const vtkIdType end = list + count; list < end && !found; ++list)
      {
        const vtkIdType cell = part.GetCell(list);
        found = cell >= 0 && piece.FindCell(cell) >= 0;
      }
      return found;
    };
    const TableRows::Needs some = needs;
    return this->Pass(
      part,
      [&](vtkIdType first, vtkIdType count, const std::int32_t* ids)
      {
        for (vtkIdType list = first; list < first + count; ++list)
        {
          const vtkIdType cell = part.GetCell(list), size = part.Sizes.GetSize(list);
          const vtkIdType index = cell < 0 ? -1 : piece.FindCell(cell);
          for (vtkIdType i = 0; index >= 0 && i < size; ++i)
          {
            points[mesh.GetBegin(index) + i] = static_cast<std::int32_t>(piece.FindPoint(ids[i]));
          }
          ids += size;
        }
      },
      &some, nullptr, progress);
  }
  // Counts the cells with a repeated point while they are in the cache.
  const bool counts = isAlone && part.Items.size() == 0;
  std::mutex mutex;
  Tally repeating;
  const bool good = this->Pass(
    part,
    [&](vtkIdType first, vtkIdType count, const std::int32_t* ids)
    {
      Tally local;
      if (counts)
      {
        const ListSizes& sizes = part.Sizes;
        FindRepeatedPoints(ids, sizes.Common < 0 ? sizes.Offsets.data() + first : nullptr,
          sizes.Common, first, count, local);
      }
      if (local.Count > 0)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        repeating.Merge(local);
      }
    },
    nullptr, points + firstId, progress);
  firstId += part.Sizes.Total;
  if (counts)
  {
    mesh.Repeating = repeating;
  }
  return good;
}

//------------------------------------------------------------------------------
bool PLYCells::Read(const std::vector<PLYPart*>& parts, vtkIdType limit, bool keepsEmpty,
  const PieceRequest& request, CellMeshPiece& piece, const Progress& progress)
{
  this->Limit = limit;
  vtkIdType numberOfIds = 0;
  for (PLYPart* part : parts)
  {
    if (!this->Measure(*part, keepsEmpty, progress.Part(0, 0.3)))
    {
      return false;
    }
    numberOfIds += part->Sizes.Total;
  }
  if (std::max(this->NumberOfCells, numberOfIds) > INT32_MAX)
  {
    return parts[0]->Rows->Fail(ErrorKind::Unsupported,
      "fewer than 2147483648 cells and vertices of all cells in total",
      std::to_string(numberOfIds));
  }
  const auto find = [&]
  {
    return std::all_of(parts.begin(), parts.end(),
      [&](const PLYPart* part)
      {
        return this->Pass(
          *part,
          [&](vtkIdType first, vtkIdType count, const std::int32_t* ids)
          {
            for (vtkIdType list = first; list < first + count; ++list)
            {
              const vtkIdType cell = part->GetCell(list), size = part->Sizes.GetSize(list);
              if (cell >= 0)
              {
                piece.Visit(cell, ids, size);
              }
              ids += size;
            }
          },
          nullptr, nullptr, progress.Part(0.3, 0.8));
      });
  };
  if (!piece.Find(limit, this->NumberOfCells, request, find))
  {
    return false;
  }
  this->Allocate(parts, piece);
  const double filling = piece.IsWhole() ? 0.3 : 0.8;
  vtkIdType firstId = 0;
  for (PLYPart* part : parts)
  {
    if (!this->Fill(*part, parts.size() == 1, piece, firstId, progress.Part(filling, 1)))
    {
      return false;
    }
    if (this->Mesh.Types.size() > 0 && this->Mesh.Offsets.size() == 0)
    {
      this->Mesh.Offsets = std::move(part->Sizes.Offsets);
    }
    part->Sizes = ListSizes(); // releases memory
    part->Ids = std::vector<std::int32_t>();
  }
  return !progress.IsStopped();
}
}
