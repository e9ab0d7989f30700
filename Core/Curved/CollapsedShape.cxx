// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curved/CollapsedShape.h"

#include "Curved/LinearEquations.h"
#include "Mesh/CellShape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

namespace camaron
{
namespace
{
using MixedNodes = std::vector<std::pair<int, double>>;

constexpr double SmallWeight = 1e-12; // rounding

//------------------------------------------------------------------------------
// The types of cells that may remain, with their numbers of nodes, the largest first.
std::vector<std::pair<unsigned char, int>> GetRemainingTypes(
  ParametricShape::Domain remaining, int degree)
{
  const int i = degree + 1, j = degree + 2, k = degree + 3;
  switch (remaining)
  {
    case ParametricShape::Domain::Triangle:
      return { { VTK_LAGRANGE_TRIANGLE, i * j / 2 } };
    case ParametricShape::Domain::Tetrahedron:
      return { { VTK_LAGRANGE_TETRAHEDRON, i * j * k / 6 } };
    case ParametricShape::Domain::Wedge:
      return { { VTK_LAGRANGE_WEDGE, i * i * j / 2 }, { VTK_QUADRATIC_WEDGE, 15 } };
    case ParametricShape::Domain::Pyramid:
      return { { VTK_QUADRATIC_PYRAMID, 13 } };
    default:
      return {};
  }
}

//------------------------------------------------------------------------------
ParametricShape::Row MakeRow(const MixedNodes& nodes)
{
  ParametricShape::Row row;
  for (const auto& [node, weight] : nodes)
  {
    row.Places.push_back(node);
    row.Weights.push_back(weight);
  }
  return row;
}
}

//------------------------------------------------------------------------------
const CollapsedShape* CollapsedShape::Find(
  const ParametricShape& shape, ParametricShape::Domain remaining, const Corners& corners)
{
  static std::mutex mutex;
  static std::map<std::tuple<const ParametricShape*, ParametricShape::Domain, Corners>,
    std::unique_ptr<CollapsedShape>>
    shapes;
  const std::lock_guard<std::mutex> lock(mutex);
  const auto key = std::make_tuple(&shape, remaining, corners);
  const auto found = shapes.find(key);
  return (
    found != shapes.end() ? found : shapes.emplace(key, Make(shape, remaining, corners)).first)
    ->second.get();
}

//------------------------------------------------------------------------------
std::unique_ptr<CollapsedShape> CollapsedShape::Make(
  const ParametricShape& shape, ParametricShape::Domain remaining, const Corners& corners)
{
  int degree = 0;
  for (const BernsteinSpace::Factor& factor : shape.Positions.GetFactors())
  {
    degree = std::max(degree, factor.Degree);
  }
  for (const auto& [type, numberOfNodes] : GetRemainingTypes(remaining, degree))
  {
    auto made = std::make_unique<CollapsedShape>();
    made->Type = type;
    made->Remaining = ParametricShape::Find(type, numberOfNodes, {});
    made->InOrder = corners;
    for (int i = 0; remaining == ParametricShape::Domain::Wedge && i < shape.NumberOfCorners; ++i)
    {
      // Lagrange wedges have the order of quadratic ones.
      made->InOrder[i] =
        static_cast<signed char>(GetExtrusionOrder(VTK_QUADRATIC_WEDGE)[corners[i]]);
    }
    if (made->SetUp(shape))
    {
      return made;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
// The nodes of what remains are such that both maps are the same: at the nodes of the cell, and
// everywhere on the lattice if these determine all polynomials of its degree.
bool CollapsedShape::SetUp(const ParametricShape& shape)
{
  const auto size = static_cast<std::size_t>(this->Remaining->NumberOfNodes);
  const auto numberOfNodes = static_cast<std::size_t>(shape.NumberOfNodes);
  const bool isComplete = shape.NumberOfNodes == shape.Positions.GetSize();
  DenseMatrix squares(size, std::vector<double>(size));
  DenseMatrix products(size, std::vector<double>(numberOfNodes));
  for (const ParametricShape::Row& place : shape.StraightControls)
  {
    MixedNodes mixed, remaining;
    for (std::size_t i = 0; i < place.Places.size(); ++i)
    {
      mixed.emplace_back(place.Places[i], place.Weights[i]);
      remaining.emplace_back(this->InOrder[place.Places[i]], place.Weights[i]);
    }
    mixed = shape.GetWeights(mixed);
    remaining = this->Remaining->GetWeights(remaining);
    if (!isComplete && mixed.size() != 1)
    {
      continue;
    }
    for (const auto& [node, weight] : remaining)
    {
      for (const auto& [other, factor] : remaining)
      {
        squares[node][other] += weight * factor;
      }
      for (const auto& [given, factor] : mixed)
      {
        products[node][given] += weight * factor;
      }
    }
    this->Given.push_back(MakeRow(mixed));
    this->Expected.push_back(MakeRow(remaining));
  }
  for (const std::vector<double>& weights : SolveEquations(std::move(squares), std::move(products)))
  {
    ParametricShape::Row& row = this->Nodes.emplace_back();
    for (std::size_t node = 0; node < numberOfNodes; ++node)
    {
      if (std::abs(weights[node]) > SmallWeight)
      {
        row.Places.push_back(static_cast<int>(node));
        row.Weights.push_back(weights[node]);
      }
    }
  }
  if (this->Nodes.size() != size)
  {
    return false;
  }
  // Where nodes of the cell coincide with one that remains, the first of them is it.
  for (std::size_t i = this->Given.size(); i-- > 0;)
  {
    if (this->Given[i].Places.size() == 1 && this->Expected[i].Places.size() == 1)
    {
      this->Nodes[this->Expected[i].Places[0]] = this->Given[i];
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool CollapsedShape::Convert(
  const std::vector<Vector>& nodes, double tolerance, std::vector<Vector>& remaining) const
{
  remaining.clear();
  for (const ParametricShape::Row& row : this->Nodes)
  {
    remaining.push_back(row.Combine(nodes.data()));
  }
  for (std::size_t i = 0; i < this->Given.size(); ++i)
  {
    const Vector difference =
      this->Given[i].Combine(nodes.data()) - this->Expected[i].Combine(remaining.data());
    if (!(GetLargestComponent(difference) <= tolerance))
    {
      return false;
    }
  }
  return true;
}
}
