// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/PieceBorders.h"

#include "Base/Parallel.h"
#include "Ranks/EqualKeys.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
std::uint64_t GetBits(double value)
{
  value += 0.0; // -0 becomes 0
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}
}

//------------------------------------------------------------------------------
PieceBorders::PieceBorders(
  const std::vector<LinkedPiece>& pieces, Reducer& reducer, bool withCopies)
  : Pieces(pieces)
  , Process(reducer.GetProcess())
  , WithCopies(withCopies)
{
  this->FindWhatPointsHave(reducer);
  this->FindBoxes(reducer);
}

//------------------------------------------------------------------------------
// Global ids can only be used if all pieces have them.
void PieceBorders::FindWhatPointsHave(Reducer& reducer)
{
  std::int64_t lacks[2] = { 0, 0 };
  for (const LinkedPiece& piece : this->Pieces)
  {
    if (piece.Topology->GetMesh().GetNumberOfCells() > 0)
    {
      lacks[0] = lacks[0] || !piece.PointIds;
      lacks[1] = lacks[1] || piece.Topology->GetMesh().HasFloatPoints();
    }
  }
  reducer.Max(lacks, 2);
  this->HasIds = !lacks[0];
  this->HasFloats = lacks[1] != 0;
}

//------------------------------------------------------------------------------
Vector PieceBorders::GetPoint(const MeshView& mesh, vtkIdType id) const
{
  const Vector x = mesh.GetPoint(id);
  return this->HasFloats
    ? Vector{ static_cast<float>(x.X), static_cast<float>(x.Y), static_cast<float>(x.Z) }
    : x;
}

//------------------------------------------------------------------------------
PointKey PieceBorders::GetKey(std::size_t piece, vtkIdType point) const
{
  const LinkedPiece& from = this->Pieces[piece];
  return this->GetKey(
    this->HasIds ? from.PointIds[point] : 0, from.Topology->GetMesh().GetPoint(point));
}

//------------------------------------------------------------------------------
PointKey PieceBorders::GetKey(std::int64_t id, const Vector& x) const
{
  if (this->HasIds)
  {
    return { { static_cast<std::uint64_t>(id), 0, 0 } };
  }
  const auto getBits = [this](double value)
  { return GetBits(this->HasFloats ? static_cast<float>(value) : value); };
  return { { getBits(x.X), getBits(x.Y), getBits(x.Z) } };
}

//------------------------------------------------------------------------------
void PieceBorders::FindBoxes(Reducer& reducer)
{
  std::vector<PieceBox> own;
  for (std::size_t p = 0; p < this->Pieces.size(); ++p)
  {
    const LinkedPiece& piece = this->Pieces[p];
    const MeshView& mesh = piece.Topology->GetMesh();
    std::vector<Bounds> parts((mesh.GetNumberOfCells() + MediumGrain - 1) / MediumGrain);
    ParallelForEach(static_cast<vtkIdType>(parts.size()), 1,
      [&](vtkIdType part)
      {
        const vtkIdType last = std::min(mesh.GetNumberOfCells(), (part + 1) * MediumGrain);
        for (vtkIdType cell = part * MediumGrain; cell < last; ++cell)
        {
          if (piece.IsCopy(cell) && !this->WithCopies)
          {
            continue;
          }
          for (const vtkIdType point : mesh.GetCellPoints(cell))
          {
            parts[part].Add(this->GetPoint(mesh, point));
          }
        }
      });
    own.push_back({ this->Process, static_cast<std::int32_t>(p), piece.Block, {} });
    for (const Bounds& part : parts)
    {
      own.back().Box.Add(part);
    }
  }
  this->Boxes = reducer.GatherItems(own);
}

//------------------------------------------------------------------------------
std::vector<unsigned char> PieceBorders::FindNearPoints(std::size_t piece) const
{
  const PieceBox& own =
    *std::find_if(this->Boxes.begin(), this->Boxes.end(), [&](const PieceBox& box)
      { return box.Process == this->Process && box.Piece == static_cast<std::int32_t>(piece); });
  std::vector<Bounds> others;
  for (const PieceBox& box : this->Boxes)
  {
    if (box.IsBeside(own) && box.Box.Meets(own.Box))
    {
      others.push_back(box.Box);
    }
  }
  std::vector<unsigned char> isNear;
  if (others.empty())
  {
    return isNear;
  }
  const MeshView& mesh = this->Pieces[piece].Topology->GetMesh();
  isNear.resize(mesh.GetNumberOfPoints());
  ParallelForEach(mesh.GetNumberOfPoints(), HeavyGrain,
    [&](vtkIdType point)
    {
      const Vector x = this->GetPoint(mesh, point);
      // A NaN position identifies nothing, but an id does.
      const bool isNowhere = this->HasIds && std::isnan(x.X + x.Y + x.Z);
      isNear[point] = isNowhere ||
        std::any_of(
          others.begin(), others.end(), [&](const Bounds& box) { return box.Contains(x); });
    });
  return isNear;
}

namespace
{
// A point of a piece that another piece may have, too.
struct CandidatePoint
{
  PointKey Key;
  std::int32_t Block;
  PieceAt Piece;
  vtkIdType Point;

  auto GetKey() const { return std::make_tuple(this->Block, this->Key); }
  std::uint64_t GetHash() const { return Hash(this->Key); }
};

//------------------------------------------------------------------------------
// The points of own cells that are near other pieces.
std::vector<CandidatePoint> FindCandidates(
  const std::vector<LinkedPiece>& pieces, const PieceBorders& borders, int process)
{
  constexpr unsigned char isUsed = 2;
  std::vector<CandidatePoint> candidates;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    std::vector<unsigned char> marks = borders.FindNearPoints(p);
    if (marks.empty())
    {
      continue;
    }
    const MeshView& mesh = pieces[p].Topology->GetMesh();
    for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
    {
      for (const vtkIdType point : mesh.GetCellPoints(cell))
      {
        marks[point] |= pieces[p].IsCopy(cell) ? 0 : isUsed;
      }
    }
    for (vtkIdType point = 0; point < mesh.GetNumberOfPoints(); ++point)
    {
      if (marks[point] == (isUsed | 1))
      {
        candidates.push_back({ borders.GetKey(p, point), pieces[p].Block,
          { process, static_cast<std::int32_t>(p) }, point });
      }
    }
  }
  return candidates;
}
}

//------------------------------------------------------------------------------
std::vector<std::vector<SharedPoint>> FindSharedPoints(
  const std::vector<LinkedPiece>& pieces, const PieceBorders& borders, Reducer& reducer)
{
  std::vector<std::vector<SharedPoint>> shared(pieces.size());
  ForEachEqual(FindCandidates(pieces, borders, reducer.GetProcess()), reducer,
    [&](const std::vector<CandidatePoint>& group)
    {
      for (const CandidatePoint& own : group)
      {
        for (const CandidatePoint& other : group)
        {
          if (own.Piece.Process == reducer.GetProcess() && !(other.Piece == own.Piece))
          {
            shared[own.Piece.Piece].push_back({ own.Point, other.Piece });
          }
        }
      }
    });
  for (std::vector<SharedPoint>& points : shared)
  {
    const auto order = [](const SharedPoint& s) { return std::tie(s.Point, s.Other); };
    std::sort(points.begin(), points.end(),
      [&](const SharedPoint& a, const SharedPoint& b) { return order(a) < order(b); });
    points.erase(
      std::unique(points.begin(), points.end(),
        [&](const SharedPoint& a, const SharedPoint& b) { return order(a) == order(b); }),
      points.end());
  }
  return shared;
}
}
