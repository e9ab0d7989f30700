// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/PieceBorders.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camaron
{
namespace
{
constexpr vtkIdType CellChunk = 1 << 14;
constexpr vtkIdType Grain = 1024;

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
bool PieceBorders::Box::Intersects(const Box& other) const
{
  bool result = true;
  for (int i = 0; i < 3; ++i)
  {
    result = result && this->Low[i] <= other.High[i] && other.Low[i] <= this->High[i];
  }
  return result;
}

//------------------------------------------------------------------------------
bool PieceBorders::Box::Contains(const double x[3]) const
{
  return this->Low[0] <= x[0] && x[0] <= this->High[0] && this->Low[1] <= x[1] &&
    x[1] <= this->High[1] && this->Low[2] <= x[2] && x[2] <= this->High[2];
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
void PieceBorders::GetPoint(const MeshView& mesh, vtkIdType id, double x[3]) const
{
  mesh.GetPoint(id, x);
  if (this->HasFloats)
  {
    for (int i = 0; i < 3; ++i)
    {
      x[i] = static_cast<float>(x[i]);
    }
  }
}

//------------------------------------------------------------------------------
PointKey PieceBorders::GetKey(std::size_t piece, vtkIdType point) const
{
  const LinkedPiece& from = this->Pieces[piece];
  double x[3];
  from.Topology->GetMesh().GetPoint(point, x);
  return this->GetKey(this->HasIds ? from.PointIds[point] : 0, x);
}

//------------------------------------------------------------------------------
PointKey PieceBorders::GetKey(std::int64_t id, const double x[3]) const
{
  if (this->HasIds)
  {
    return { { static_cast<std::uint64_t>(id), 0, 0 } };
  }
  PointKey key;
  for (int i = 0; i < 3; ++i)
  {
    key[i] = GetBits(this->HasFloats ? static_cast<float>(x[i]) : x[i]);
  }
  return key;
}

//------------------------------------------------------------------------------
void PieceBorders::FindBoxes(Reducer& reducer)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Box> own;
  for (std::size_t p = 0; p < this->Pieces.size(); ++p)
  {
    const LinkedPiece& piece = this->Pieces[p];
    const MeshView& mesh = piece.Topology->GetMesh();
    const Box empty = { this->Process, static_cast<std::int32_t>(p), piece.Block,
      { infinity, infinity, infinity }, { -infinity, -infinity, -infinity } };
    std::vector<Box> parts((mesh.GetNumberOfCells() + CellChunk - 1) / CellChunk, empty);
    ParallelFor(static_cast<vtkIdType>(parts.size()), 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType part = begin; part < end; ++part)
        {
          const vtkIdType last = std::min(mesh.GetNumberOfCells(), (part + 1) * CellChunk);
          for (vtkIdType cell = part * CellChunk; cell < last; ++cell)
          {
            this->AddToBox(piece, cell, parts[part]);
          }
        }
      });
    Box whole = empty;
    for (const Box& part : parts)
    {
      for (int i = 0; i < 3; ++i)
      {
        whole.Low[i] = std::min(whole.Low[i], part.Low[i]);
        whole.High[i] = std::max(whole.High[i], part.High[i]);
      }
    }
    own.push_back(whole);
  }
  this->Boxes = reducer.GatherItems(own);
}

//------------------------------------------------------------------------------
void PieceBorders::AddToBox(const LinkedPiece& piece, vtkIdType cell, Box& box) const
{
  if (piece.IsCopy(cell) && !this->WithCopies)
  {
    return;
  }
  const MeshView& mesh = piece.Topology->GetMesh();
  const IndexRange points = mesh.GetCellPoints(cell);
  for (vtkIdType i = 0; i < points.Size; ++i)
  {
    double x[3];
    this->GetPoint(mesh, points[i], x);
    for (int axis = 0; axis < 3; ++axis)
    {
      box.Low[axis] = std::min(box.Low[axis], x[axis]);
      box.High[axis] = std::max(box.High[axis], x[axis]);
    }
  }
}

//------------------------------------------------------------------------------
std::vector<unsigned char> PieceBorders::FindNearPoints(std::size_t piece) const
{
  const auto isOwn = [&](const Box& box)
  { return box.Process == this->Process && box.Piece == static_cast<std::int32_t>(piece); };
  const Box& own = *std::find_if(this->Boxes.begin(), this->Boxes.end(), isOwn);
  std::vector<Box> others;
  for (const Box& box : this->Boxes)
  {
    if (!isOwn(box) && box.Block == own.Block && box.Intersects(own))
    {
      others.push_back(box);
    }
  }
  std::vector<unsigned char> isNear;
  if (others.empty())
  {
    return isNear;
  }
  const MeshView& mesh = this->Pieces[piece].Topology->GetMesh();
  isNear.resize(mesh.GetNumberOfPoints());
  ParallelFor(mesh.GetNumberOfPoints(), Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        double x[3];
        this->GetPoint(mesh, point, x);
        // A NaN position identifies nothing, but an id does.
        const bool isNowhere = this->HasIds && std::isnan(x[0] + x[1] + x[2]);
        isNear[point] = isNowhere ||
          std::any_of(
            others.begin(), others.end(), [&](const Box& box) { return box.Contains(x); });
      }
    });
  return isNear;
}
}
