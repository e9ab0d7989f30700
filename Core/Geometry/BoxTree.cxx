// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/BoxTree.h"

#include <algorithm>
#include <numeric>

namespace camaron
{
namespace
{
constexpr std::size_t BoxesPerLeaf = 4;

// Empty and infinite boxes have no center, and come first.
double GetTwiceTheMiddle(const Bounds& box, double Vector::* side)
{
  const double sum = box.Low.*side + box.High.*side;
  return sum == sum ? sum : -Bounds::Infinity;
}
}

//------------------------------------------------------------------------------
void BoxTree::Build(const std::vector<Bounds>& boxes, bool sorts)
{
  this->Nodes.clear();
  this->Order.resize(boxes.size());
  std::iota(this->Order.begin(), this->Order.end(), std::size_t(0));
  if (!boxes.empty())
  {
    this->AddNodes(boxes, 0, boxes.size(), sorts);
  }
}

//------------------------------------------------------------------------------
void BoxTree::Build(const Vector* points, std::size_t size)
{
  std::vector<Bounds> boxes(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    boxes[i].Add(points[i]);
  }
  this->Build(boxes);
}

//------------------------------------------------------------------------------
// Splits the boxes into halves along the longest side of their bounding box.
void BoxTree::AddNodes(
  const std::vector<Bounds>& boxes, std::size_t first, std::size_t last, bool sorts)
{
  const std::size_t node = this->Nodes.size();
  this->Nodes.push_back({ Bounds(), 0, first, last, last - first });
  Bounds around;
  for (std::size_t i = first; i < last; ++i)
  {
    around.Add(boxes[this->Order[i]]);
  }
  if (last - first > BoxesPerLeaf)
  {
    const std::size_t middle = first + (last - first) / 2;
    if (sorts)
    {
      const Vector size = around.High - around.Low;
      const auto side = size.X >= size.Y && size.X >= size.Z ? &Vector::X
        : size.Y >= size.Z                                   ? &Vector::Y
                                                             : &Vector::Z;
      const auto begin = this->Order.begin();
      std::nth_element(begin + first, begin + middle, begin + last,
        [&](std::size_t a, std::size_t b)
        { return GetTwiceTheMiddle(boxes[a], side) < GetTwiceTheMiddle(boxes[b], side); });
    }
    this->AddNodes(boxes, first, middle, sorts);
    this->AddNodes(boxes, middle, last, sorts);
  }
  this->Nodes[node].Box = around;
  this->Nodes[node].Next = this->Nodes.size();
}

//------------------------------------------------------------------------------
void BoxTree::LeaveOut(std::size_t place)
{
  for (std::size_t n = 0;;)
  {
    --this->Nodes[n].Count;
    if (this->Nodes[n].Next == n + 1)
    {
      return;
    }
    const Node& left = this->Nodes[n + 1];
    n = place < left.Last ? n + 1 : left.Next;
  }
}
}
