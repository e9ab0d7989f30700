// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GatheredPieces.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <cmath>
#include <cstring>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The global ids of points or cells; empty if there are none.
std::vector<vtkIdType> GetGlobalIds(vtkDataSetAttributes* data)
{
  vtkDataArray* const ids = data->GetGlobalIds();
  std::vector<vtkIdType> values(static_cast<std::size_t>(ids ? ids->GetNumberOfTuples() : 0));
  if (auto* const exact = vtkIdTypeArray::SafeDownCast(ids))
  {
    std::copy_n(exact->GetPointer(0), values.size(), values.begin());
    return values;
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<vtkIdType>(ids->GetTuple1(static_cast<vtkIdType>(i)));
  }
  return values;
}
}

//------------------------------------------------------------------------------
GatheredPieces::GatheredPieces(const std::vector<MeshPart>& parts)
{
  for (const MeshPart& part : parts)
  {
    this->Pieces.push_back({ part.Mesh, part.Block, MeshView(part.Mesh),
      part.Mesh->GetCellGhostArray(), this->NumberOfPoints, this->NumberOfCells });
    this->NumberOfPoints += this->Pieces.back().View.GetNumberOfPoints();
    this->NumberOfCells += this->Pieces.back().View.GetNumberOfCells();
  }
  this->OrderCells();
  this->DropPoints();
  this->NumberPoints();
}

//------------------------------------------------------------------------------
bool GatheredPieces::IsUnchanged() const
{
  const auto isWhole = [](const std::vector<vtkIdType>& ids, vtkIdType size)
  { return static_cast<vtkIdType>(ids.size()) == size && std::is_sorted(ids.begin(), ids.end()); };
  return isWhole(this->OldCells, this->NumberOfCells) &&
    isWhole(this->OldPoints, this->NumberOfPoints);
}

//------------------------------------------------------------------------------
void GatheredPieces::OrderCells()
{
  bool haveIds = true;
  for (const Piece& piece : this->Pieces)
  {
    haveIds = haveIds && piece.Mesh->GetCellData()->GetGlobalIds();
    for (vtkIdType cell = 0; cell < piece.View.GetNumberOfCells(); ++cell)
    {
      if (!piece.IsLeftOut(cell))
      {
        this->OldCells.push_back(piece.FirstCell + cell);
      }
    }
  }
  if (!haveIds)
  {
    return;
  }
  std::vector<vtkIdType> global;
  for (const Piece& piece : this->Pieces)
  {
    const std::vector<vtkIdType> ids = GetGlobalIds(piece.Mesh->GetCellData());
    global.insert(global.end(), ids.begin(), ids.end());
  }
  std::stable_sort(this->OldCells.begin(), this->OldCells.end(),
    [&global](vtkIdType a, vtkIdType b) { return global[a] < global[b]; });
}

//------------------------------------------------------------------------------
// Drops points that only dropped cells use.
void GatheredPieces::DropPoints()
{
  this->NewPoints.assign(static_cast<std::size_t>(this->NumberOfPoints), 0);
  for (const vtkIdType mark : { -1, 0 })
  {
    for (const Piece& piece : this->Pieces)
    {
      for (vtkIdType cell = 0; piece.Ghosts && cell < piece.View.GetNumberOfCells(); ++cell)
      {
        if (piece.IsLeftOut(cell) == (mark < 0))
        {
          const IndexRange points = piece.View.GetCellPoints(cell);
          for (vtkIdType i = 0; i < points.Size; ++i)
          {
            this->NewPoints[piece.FirstPoint + points[i]] = mark;
          }
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void GatheredPieces::NumberPoints()
{
  const auto haveIds = [](Iterator begin, Iterator end)
  {
    return std::all_of(
      begin, end, [](const Piece& piece) { return piece.Mesh->GetPointData()->GetGlobalIds(); });
  };
  Iterator begin = this->Pieces.begin();
  const bool isOneNumbering = haveIds(begin, this->Pieces.end());
  while (begin != this->Pieces.end())
  {
    const Iterator end = isOneNumbering
      ? this->Pieces.cend()
      : std::find_if(begin, this->Pieces.cend(),
          [begin](const Piece& piece) { return piece.Block != begin->Block; });
    if (haveIds(begin, end))
    {
      this->NumberPointsById(begin, end);
    }
    else
    {
      this->NumberPointsByPlace(begin, end);
    }
    begin = end;
  }
}

//------------------------------------------------------------------------------
void GatheredPieces::NumberPointsById(Iterator begin, Iterator end)
{
  const vtkIdType firstPoint = begin->FirstPoint;
  std::vector<vtkIdType> ids;
  for (Iterator piece = begin; piece != end; ++piece)
  {
    const std::vector<vtkIdType> own = GetGlobalIds(piece->Mesh->GetPointData());
    ids.insert(ids.end(), own.begin(), own.end());
  }
  const auto getId = [&ids, firstPoint](vtkIdType point) { return ids[point - firstPoint]; };
  std::vector<vtkIdType> sorted;
  for (vtkIdType point = firstPoint; point < firstPoint + static_cast<vtkIdType>(ids.size());
    ++point)
  {
    if (this->NewPoints[point] >= 0)
    {
      sorted.push_back(point);
    }
  }
  std::stable_sort(sorted.begin(), sorted.end(),
    [&getId](vtkIdType a, vtkIdType b) { return getId(a) < getId(b); });

  // Points are the same only if their positions are, too: blocks of different meshes may use the
  // same ids. With more positions than this for one id, the ids are meaningless.
  constexpr std::size_t MaxPlaces = 64;
  std::vector<vtkIdType>& kept = this->OldPoints;
  std::size_t first = kept.size(); // of the kept points with the current id
  for (const vtkIdType point : sorted)
  {
    if (first < kept.size() && getId(kept[first]) != getId(point))
    {
      first = kept.size();
    }
    std::size_t twin = kept.size() - first < MaxPlaces ? first : kept.size();
    while (twin < kept.size() && !this->HaveSamePlace(kept[twin], point))
    {
      ++twin;
    }
    this->NewPoints[point] = static_cast<vtkIdType>(twin);
    if (twin == kept.size())
    {
      kept.push_back(point);
    }
  }
}

//------------------------------------------------------------------------------
void GatheredPieces::NumberPointsByPlace(Iterator begin, Iterator end)
{
  // First the twin of each point, then its number.
  const vtkIdType firstPoint = begin->FirstPoint;
  const vtkIdType lastPoint = end == this->Pieces.end() ? this->NumberOfPoints : end->FirstPoint;
  for (vtkIdType point = firstPoint; point < lastPoint; ++point)
  {
    this->NewPoints[point] = this->NewPoints[point] < 0 ? -1 : point;
  }
  const std::vector<vtkIdType> border = this->FindBorderPoints(begin, end);
  const vtkIdType* const last = border.data() + border.size();
  for (const vtkIdType* run = border.data(); run != last;)
  {
    const vtkIdType* next = run + 1;
    while (next != last && this->HaveSamePlace(*run, *next))
    {
      ++next;
    }
    this->MergeTwins(run, next);
    run = next;
  }
  for (vtkIdType point = firstPoint; point < lastPoint; ++point)
  {
    vtkIdType& newId = this->NewPoints[point];
    if (newId == point)
    {
      newId = static_cast<vtkIdType>(this->OldPoints.size());
      this->OldPoints.push_back(point);
    }
    else if (newId >= 0)
    {
      newId = this->NewPoints[newId]; // the twin is an earlier point
    }
  }
}

//------------------------------------------------------------------------------
// Points that may also exist in other pieces, sorted by position.
std::vector<vtkIdType> GatheredPieces::FindBorderPoints(Iterator begin, Iterator end) const
{
  std::vector<vtkBoundingBox> boxes;
  for (Iterator piece = begin; piece != end; ++piece)
  {
    boxes.emplace_back(piece->Mesh->GetBounds());
  }
  std::vector<vtkIdType> points;
  for (std::size_t p = 0; p < boxes.size(); ++p)
  {
    std::vector<vtkBoundingBox> neighbors;
    for (std::size_t other = 0; other < boxes.size(); ++other)
    {
      if (other != p && boxes[other].Intersects(boxes[p]))
      {
        neighbors.push_back(boxes[other]);
      }
    }
    const Piece& piece = *(begin + static_cast<std::ptrdiff_t>(p));
    for (vtkIdType i = 0; !neighbors.empty() && i < piece.View.GetNumberOfPoints(); ++i)
    {
      double x[3];
      piece.View.GetPoint(i, x);
      if (this->NewPoints[piece.FirstPoint + i] >= 0 && !std::isnan(x[0] + x[1] + x[2]) &&
        std::any_of(neighbors.begin(), neighbors.end(),
          [&x](const vtkBoundingBox& box) { return box.ContainsPoint(x) != 0; }))
      {
        points.push_back(piece.FirstPoint + i);
      }
    }
  }
  vtkSMPTools::Sort(points.begin(), points.end(),
    [this](vtkIdType a, vtkIdType b)
    {
      const auto x = this->GetPlace(a), y = this->GetPlace(b);
      return x != y ? x < y : a < b;
    });
  return points;
}

//------------------------------------------------------------------------------
// Merges points at one position, in the order of the pieces, unless two are of the same piece.
void GatheredPieces::MergeTwins(const vtkIdType* begin, const vtkIdType* end)
{
  const auto areOfOnePiece = [this](vtkIdType a, vtkIdType b)
  { return &this->FindPiece(a, &Piece::FirstPoint) == &this->FindPiece(b, &Piece::FirstPoint); };
  if (areOfOnePiece(*begin, *(end - 1)))
  {
    return;
  }
  if (std::adjacent_find(begin, end, areOfOnePiece) != end)
  {
    ++this->NumberOfUnclearPlaces;
    return;
  }
  for (const vtkIdType* point = begin + 1; point != end; ++point)
  {
    this->NewPoints[*point] = *begin;
    ++this->NumberOfTwins;
  }
}

//------------------------------------------------------------------------------
bool GatheredPieces::HaveSamePlace(vtkIdType a, vtkIdType b) const
{
  const auto x = this->GetPlace(a), y = this->GetPlace(b);
  return x == y || std::memcmp(x.data(), y.data(), sizeof(x)) == 0; // the latter for NaN
}
}
