// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TouchingPolygons.h
 * @brief Random polygons that touch themselves in every way without crossing, and know their area.
 *
 * Squares of a grid are glued together along some of their common edges, so that they form a tree;
 * the polygon is the walk around it. Where squares are side by side but not glued it runs along
 * their edge twice, around a hole it comes back to where it left, and squares that meet in a corner
 * share that one. Cracks and spikes are added.
 */
#ifndef TouchingPolygons_h
#define TouchingPolygons_h

#include "Base/Vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace camaron
{
namespace testing
{
class TouchingPolygons
{
public:
  explicit TouchingPolygons(unsigned seed)
    : Random(seed)
  {
  }

  struct Polygon
  {
    std::vector<Vector> Corners; ///< in the plane, counter-clockwise
    double Area = 0;
  };

  /// @a jitter: how far corners of the grid are moved, 0 to 0.3. With 0, corners between two in a
  /// line are left out at random.
  Polygon Make(int numberOfSquares, double jitter, bool hasSpikes)
  {
    this->Nodes.clear();
    this->Glued.clear();
    this->GrowTree(numberOfSquares);
    const std::vector<Node> walk = this->Walk();
    Polygon polygon;
    for (std::size_t i = 0; i < walk.size(); ++i)
    {
      const Node &before = walk[(i + walk.size() - 1) % walk.size()],
                 &after = walk[(i + 1) % walk.size()];
      const Node& node = walk[i];
      const bool isStraight = node.first - before.first == after.first - node.first &&
        node.second - before.second == after.second - node.second;
      if (jitter == 0 && isStraight && this->Draw(2) == 0)
      {
        continue;
      }
      polygon.Corners.push_back(this->Place(node, jitter));
      if (hasSpikes && this->Draw(12) == 0)
      {
        this->AddSpike(walk, node, jitter, polygon.Corners);
      }
      if (hasSpikes && this->Draw(12) == 0)
      {
        polygon.Corners.push_back(polygon.Corners.back()); // a corner after itself
      }
    }
    polygon.Area = this->SumSquares(jitter);
    return polygon;
  }

  int Draw(int end) { return static_cast<int>(this->Random() % static_cast<unsigned>(end)); }
  double DrawReal() { return std::uniform_real_distribution<double>(-1, 1)(this->Random); }

private:
  using Node = std::pair<int, int>;   // of the grid; a square has the number of its lower left one
  using Edge = std::pair<Node, Node>; // as one of its squares runs along it

  static Node Step(const Node& node, int side)
  {
    constexpr int x[] = { 1, 0, -1, 0 }, y[] = { 0, 1, 0, -1 };
    return { node.first + x[side], node.second + y[side] };
  }
  /// The square on the other side of one of the four edges, which start at the lower one and run
  /// counter-clockwise.
  static Node GetNeighbor(const Node& square, int edge) { return Step(square, (edge + 3) % 4); }
  static Node GetCorner(const Node& square, int corner)
  {
    return { square.first + (corner == 1 || corner == 2), square.second + (corner >= 2) };
  }

  void GrowTree(int numberOfSquares)
  {
    std::vector<Node> squares = { { 0, 0 } };
    this->Glued[squares[0]] = {};
    while (static_cast<int>(squares.size()) < numberOfSquares)
    {
      const Node square = squares[this->Draw(static_cast<int>(squares.size()))];
      const int edge = this->Draw(4);
      const Node neighbor = GetNeighbor(square, edge);
      if (this->Glued.count(neighbor) == 0)
      {
        squares.push_back(neighbor);
        this->Glued[square][edge] = true;
        this->Glued[neighbor][(edge + 2) % 4] = true;
      }
    }
  }

  std::vector<Node> Walk() const
  {
    Node square = this->Glued.begin()->first; // nothing is to the left of it
    int edge = 3;
    const Node first = square;
    std::vector<Node> walk;
    do
    {
      walk.push_back(GetCorner(square, edge));
      edge = (edge + 1) % 4;
      while (this->Glued.at(square)[edge])
      {
        square = GetNeighbor(square, edge);
        edge = (edge + 3) % 4; // the next one after that between the two
      }
    } while (square != first || edge != 3);
    return walk;
  }

  Vector Place(const Node& node, double jitter)
  {
    auto found = this->Nodes.find(node);
    if (found == this->Nodes.end())
    {
      const Vector place = { node.first + jitter * this->DrawReal(),
        node.second + jitter * this->DrawReal(), 0 };
      found = this->Nodes.emplace(node, place).first;
    }
    return found->second;
  }

  /// To and fro within the one square that is full, or the one that is empty, around a corner.
  void AddSpike(
    const std::vector<Node>& walk, const Node& node, double jitter, std::vector<Vector>& corners)
  {
    const Node square = { node.first - this->Draw(2), node.second - this->Draw(2) };
    int full = 0;
    for (int i = 0; i < 4; ++i)
    {
      full += static_cast<int>(this->Glued.count({ node.first - (i & 1), node.second - (i >> 1) }));
    }
    const bool isFull = this->Glued.count(square) > 0;
    if (isFull ? full == 1 : full == 3 && std::count(walk.begin(), walk.end(), node) == 1)
    {
      const Vector corner = this->Place(node, jitter);
      const double x = square.first + 0.5 - node.first, y = square.second + 0.5 - node.second;
      const double length = 0.125 * (1 + this->Draw(3));
      const Vector tip = corner + length * Vector{ x, y, 0 };
      corners.push_back(tip);
      if (this->Draw(2) == 0)
      {
        corners.push_back(tip + (0.25 * length) * Vector{ x, -y, 0 }); // bent
        corners.push_back(tip);
      }
      corners.push_back(corner);
    }
  }

  double SumSquares(double jitter)
  {
    double sum = 0;
    for (const auto& square : this->Glued)
    {
      const Vector a = this->Place(GetCorner(square.first, 0), jitter),
                   b = this->Place(GetCorner(square.first, 1), jitter),
                   c = this->Place(GetCorner(square.first, 2), jitter),
                   d = this->Place(GetCorner(square.first, 3), jitter);
      sum += 0.5 * Cross(c - a, d - b).Z;
    }
    return sum;
  }

  std::mt19937 Random;
  std::map<Node, Vector> Nodes;
  std::map<Node, std::array<bool, 4>> Glued; ///< to the neighbors beyond the four edges
};
}
}

#endif
