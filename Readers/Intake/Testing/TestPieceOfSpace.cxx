// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The division of the points of a mesh among processes.
#include "Intake/Pieces/PieceOfSpace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <vector>

using namespace camaron;

namespace
{
using PointList = std::vector<std::array<double, 3>>;

//------------------------------------------------------------------------------
/// The piece of every point, after checking that it has exactly one, and what is before it.
std::vector<int> Divide(const PointList& points, int pieces)
{
  const auto size = static_cast<vtkIdType>(points.size());
  std::vector<int> pieceOf(points.size(), -1), numberBefore(points.size(), 0);
  for (int piece = 0; piece < pieces; ++piece)
  {
    PieceOfSpace space;
    space.Start(size, size, { piece, pieces, 0 });
    for (vtkIdType i = 0; i < size; ++i)
    {
      space.Add(i, i);
    }
    EXPECT_TRUE(space.Find(
      [&](const PieceOfSpace::Visit& visit)
      {
        for (vtkIdType i = 0; i < size; ++i)
        {
          visit(i, points[static_cast<std::size_t>(i)].data());
        }
        return true;
      }));
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const auto id = static_cast<vtkIdType>(i);
      EXPECT_FALSE(space.Has(id) && space.IsBefore(id));
      if (space.Has(id))
      {
        EXPECT_EQ(pieceOf[i], -1);
        pieceOf[i] = piece;
      }
      numberBefore[i] += space.IsBefore(id);
    }
    EXPECT_EQ(space.Has(-1), piece == 0);
    EXPECT_EQ(space.IsBefore(size), piece > 0);
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_EQ(numberBefore[i], pieces - 1 - pieceOf[i]) << "later pieces know that it is before";
  }
  return pieceOf;
}

//------------------------------------------------------------------------------
PointList MakeRandomPoints(std::size_t size)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform;
  PointList points(size);
  for (auto& point : points)
  {
    std::generate(point.begin(), point.end(), [&] { return uniform(random); });
  }
  return points;
}

//------------------------------------------------------------------------------
std::vector<int> CountSizes(const std::vector<int>& pieceOf, int pieces)
{
  std::vector<int> sizes(static_cast<std::size_t>(pieces));
  for (const int piece : pieceOf)
  {
    ++sizes.at(static_cast<std::size_t>(piece));
  }
  return sizes;
}
}

//------------------------------------------------------------------------------
// If this fails, some processes wait for one that has more to do.
TEST(PieceOfSpace, PiecesHaveTheSameSize)
{
  PointList stuck(1000);
  PointList odd = MakeRandomPoints(1000);
  odd[3][1] = std::numeric_limits<double>::quiet_NaN();
  odd[4][2] = -std::numeric_limits<double>::infinity();
  for (const PointList& points : { MakeRandomPoints(1000), stuck, odd })
  {
    for (const int pieces : { 2, 3, 8 })
    {
      for (const int size : CountSizes(Divide(points, pieces), pieces))
      {
        EXPECT_NEAR(size, 1000 / pieces, 1);
      }
    }
  }
  const PointList many = MakeRandomPoints(500000); // of which a sample is used
  for (const int size : CountSizes(Divide(many, 5), 5))
  {
    EXPECT_NEAR(size, 100000, 3000);
  }
}

//------------------------------------------------------------------------------
// If this fails, points are lost where there are few.
TEST(PieceOfSpace, ThereMayBeMorePiecesThanPoints)
{
  for (const std::size_t size : { 0, 1, 2, 5 })
  {
    Divide(MakeRandomPoints(size), 7);
  }
}

//------------------------------------------------------------------------------
// If this fails, a piece of a mesh in random order touches all others, and has as many ghosts.
TEST(PieceOfSpace, PiecesAreCompact)
{
  const PointList points = MakeRandomPoints(20000);
  constexpr int Pieces = 8;
  const std::vector<int> pieceOf = Divide(points, Pieces);
  for (int piece = 0; piece < Pieces; ++piece)
  {
    double volume = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      double low = 1, high = 0;
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        if (pieceOf[i] == piece)
        {
          low = std::min(low, points[i][axis]);
          high = std::max(high, points[i][axis]);
        }
      }
      volume *= high - low;
    }
    EXPECT_NEAR(volume, 1.0 / Pieces, 0.01);
  }
}
