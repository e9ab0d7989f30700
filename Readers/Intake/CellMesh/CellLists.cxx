// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/CellMesh/CellLists.h"

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
unsigned char GetType(const CellLists::Part& part, vtkIdType size)
{
  return part.AreLines && size > 2 ? static_cast<unsigned char>(VTK_POLY_LINE)
                                   : GetPolygonType(size);
}

//------------------------------------------------------------------------------
// Counts lists with fewer than three ids.
void CountFew(CellLists::Part& part)
{
  const ListSizes& sizes = part.Sizes;
  std::mutex mutex;
  ParallelFor(part.NumberOfLists, LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::int32_t least = sizes.Common >= 0 ? sizes.Common : INT32_MAX;
      for (vtkIdType list = begin; sizes.Common < 0 && list < end; ++list)
      {
        least = std::min(least, sizes.Offsets[list + 1] - sizes.Offsets[list]);
      }
      Tally few[3];
      for (vtkIdType list = begin; least < 3 && list < end; ++list)
      {
        const vtkIdType size = sizes.GetSize(list);
        if (size < 3)
        {
          few[size].Add(list);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      for (int size = 0; size < 3; ++size)
      {
        part.Few[size].Merge(few[size]);
      }
    });
}

//------------------------------------------------------------------------------
// Passes all lists of a part; see TableRows::ReadIds.
bool Pass(const CellLists::Part& part, TableRows::TakeIds take, const TableRows::Needs* needs,
  std::int32_t* all, const Progress& progress)
{
  if (part.Load)
  {
    if (all)
    {
      std::copy(part.Ids.begin(), part.Ids.end(), all);
    }
    take(0, part.NumberOfLists, part.Ids.data());
    return progress.Report(1);
  }
  return part.Rows->GetCount() == 0 ||
    part.Rows->ReadIds(part.List, part.Expected, part.Sizes, all, take, needs, progress);
}
}

//------------------------------------------------------------------------------
// Determines the lists of a part and their cells.
bool CellLists::Measure(Part& part, bool keepsEmpty, const Progress& progress)
{
  const vtkIdType rows = part.Rows->GetCount();
  part.FirstCell = this->NumberOfCells;
  if (rows == 0)
  {
    return true;
  }
  if (!(part.Load ? part.Load(part, progress)
                  : part.Rows->ReadSizes(part.List, part.Sizes, progress)))
  {
    return false;
  }
  part.NumberOfLists = rows;
  if (part.Load)
  {
    part.Sizes.Total = static_cast<vtkIdType>(part.Ids.size());
    part.NumberOfLists = part.Sizes.Total / part.Sizes.Common;
  }
  else if (part.Sizes.Common <= 2)
  {
    CountFew(part);
  }
  part.NumberOfCells = part.NumberOfLists - (keepsEmpty ? 0 : part.Few[0].Count);
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
// Allocates the cells of a piece, and sets their types and sizes.
void CellLists::Allocate(const std::vector<Part*>& parts, const CellMeshPiece& piece)
{
  const vtkIdType cells = piece.GetNumberOfCells();
  // Most files have faces only, most of them of one size.
  if (parts.size() == 1 && parts[0]->Sizes.Common > 0)
  {
    const std::int32_t size = parts[0]->Sizes.Common;
    this->Mesh = CellMesh(piece.GetNumberOfPoints(), cells, GetType(*parts[0], size), size);
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
  for (const Part* part : parts)
  {
    ParallelFor(part->NumberOfLists, LightGrain,
      [&](vtkIdType begin, vtkIdType end)
      {
        unsigned char* const types = this->Mesh.Types.data();
        for (vtkIdType list = begin; takesOffsets && list < end; ++list)
        {
          types[list] = GetType(*part, offsets[list + 1] - offsets[list]);
        }
        for (vtkIdType list = begin; !takesOffsets && list < end; ++list)
        {
          const vtkIdType cell = part->GetCell(list);
          const vtkIdType index = cell < 0 ? -1 : piece.FindCell(cell);
          if (index >= 0)
          {
            const vtkIdType size = part->Sizes.GetSize(list);
            types[index] = GetType(*part, size);
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
bool CellLists::Fill(const Part& part, bool isAlone, const CellMeshPiece& piece, vtkIdType& firstId,
  const Progress& progress)
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
    return Pass(
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
  const bool good = Pass(
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
bool CellLists::Read(const std::vector<Part*>& parts, vtkIdType limit, bool keepsEmpty,
  const PieceRequest& request, CellMeshPiece& piece, const Progress& progress)
{
  vtkIdType numberOfIds = 0;
  for (Part* part : parts)
  {
    part->Expected.Limit = limit;
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
      [&](const Part* part)
      {
        return Pass(
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
  for (Part* part : parts)
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
