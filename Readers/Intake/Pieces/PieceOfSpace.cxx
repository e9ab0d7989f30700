// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Pieces/PieceOfSpace.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camaron
{
namespace
{
// Pieces differ by about 1 / sqrt(SamplesPerPiece) in size; few pieces can have more samples.
constexpr vtkIdType SamplesPerPiece = 1024, MinSamples = vtkIdType(1) << 13;
}

//------------------------------------------------------------------------------
PieceOfSpace::Sample PieceOfSpace::MakeSample(vtkIdType point, const double* x)
{
  const auto makeFinite = [](double value)
  {
    const auto single = static_cast<float>(value);
    return std::isfinite(single) ? single : 0;
  };
  return { { makeFinite(x[0]), makeFinite(x[1]), makeFinite(x[2]) },
    static_cast<std::int32_t>(point) };
}

//------------------------------------------------------------------------------
// The cuts on the way from the root of the tree to the piece.
void PieceOfSpace::FindBox(std::vector<Sample>& samples)
{
  int piece = this->Piece, pieces = this->NumberOfPieces;
  this->Box.clear();
  auto begin = samples.begin(), end = samples.end();
  while (pieces > 1 && begin != end)
  {
    float longest = -1;
    Cut cut;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto ends = std::minmax_element(
        begin, end, [axis](const Sample& a, const Sample& b) { return a.X[axis] < b.X[axis]; });
      const float length = ends.second->X[axis] - ends.first->X[axis];
      if (length > longest)
      {
        longest = length;
        cut.Axis = axis;
      }
    }
    const int below = pieces / 2;
    const auto middle = begin + (end - begin) * below / pieces;
    std::nth_element(begin, middle, end,
      [&cut](const Sample& a, const Sample& b) { return IsBelow(a, b, cut.Axis); });
    cut.At = *middle;
    cut.IsAbove = piece >= below;
    this->Box.push_back(cut);
    (cut.IsAbove ? begin : end) = middle;
    piece -= cut.IsAbove ? below : 0;
    pieces = cut.IsAbove ? pieces - below : below;
  }
  if (pieces > 1 && piece > 0)
  {
    // There are fewer elements than pieces; the first of the remaining pieces gets what is left.
    this->Box.push_back({ { { std::numeric_limits<float>::infinity(), 0, 0 }, 0 }, 0, true });
  }
}

//------------------------------------------------------------------------------
void PieceOfSpace::Start(
  vtkIdType numberOfPoints, vtkIdType numberOfElements, const PieceRequest& request)
{
  this->Piece = request.Piece;
  this->NumberOfPieces = request.NumberOfPieces;
  this->IsFirst = request.Piece == 0;
  this->NumberOfElements = numberOfElements;
  const vtkIdType wanted = std::max(MinSamples, SamplesPerPiece * request.NumberOfPieces);
  this->Range = std::max<vtkIdType>(1, numberOfElements / wanted);
  this->Firsts.assign(
    static_cast<std::size_t>((numberOfElements + this->Range - 1) / this->Range), -1);
  this->Own = IdSet(numberOfPoints);
}

//------------------------------------------------------------------------------
bool PieceOfSpace::FindSamples(const ForEachPoint& forEach, std::vector<Sample>& samples) const
{
  IdSet wanted(this->Own.GetLimit());
  for (const std::int32_t first : this->Firsts)
  {
    wanted.Add(first);
  }
  std::vector<Sample> found(static_cast<std::size_t>(wanted.Number()));
  if (!forEach(
        [&](vtkIdType point, const double* x)
        {
          if (wanted.Contains(point))
          {
            found[static_cast<std::size_t>(wanted.GetNumber(point))] = MakeSample(point, x);
          }
        }))
  {
    return false;
  }
  for (const std::int32_t first : this->Firsts)
  {
    if (this->IsPoint(first))
    {
      samples.push_back(found[static_cast<std::size_t>(wanted.GetNumber(first))]);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool PieceOfSpace::Find(const ForEachPoint& forEach)
{
  std::vector<Sample> samples;
  if (!this->FindSamples(forEach, samples))
  {
    return false;
  }
  this->FindBox(samples);
  this->Own = IdSet(this->Own.GetLimit());
  this->Before = IdSet(this->Own.GetLimit());
  return forEach(
    [&](vtkIdType point, const double* x)
    {
      const Sample place = MakeSample(point, x);
      for (const Cut& cut : this->Box)
      {
        const bool isBelow = IsBelow(place, cut.At, cut.Axis);
        if (isBelow == cut.IsAbove)
        {
          if (isBelow)
          {
            this->Before.Add(point);
          }
          return;
        }
      }
      this->Own.Add(point);
    });
}
}
