// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elements/CurvedEdges.h"

#include "Curved/CurveIntegrals.h"
#include "Curved/ParametricShape.h"
#include "Mesh/CellShape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool MayBeCurved(const MeshView& mesh, vtkIdType cell)
{
  const CellShape& shape = GetCellShape(mesh.GetCellType(cell));
  return shape.IsHigherOrder && shape.Dimension > 1;
}

//------------------------------------------------------------------------------
bool IsBefore(const Vector& a, const Vector& b)
{
  return std::tie(a.X, a.Y, a.Z) < std::tie(b.X, b.Y, b.Z);
}

//------------------------------------------------------------------------------
// The control points of the edges of a cell.
class EdgeCurve
{
public:
  EdgeCurve(const MeshView& mesh, const ParametricShape& shape)
    : Mesh(mesh)
    , Shape(shape)
  {
  }

  /// Control points relative to the end that comes first in space, so that the direction in a cell
  /// does not matter. False if the edge is straight.
  bool Load(const IndexRange& nodes, const std::vector<int>& edge)
  {
    this->Ends = { nodes[this->Shape.Controls[edge.front()].Places[0]],
      nodes[this->Shape.Controls[edge.back()].Places[0]] };
    const Vector ends[2] = { this->Mesh.GetPoint(this->Ends[0]),
      this->Mesh.GetPoint(this->Ends[1]) };
    const Vector& origin = IsBefore(ends[1], ends[0]) ? ends[1] : ends[0];
    this->Controls.clear();
    double largest = 0;
    for (const int control : edge)
    {
      const ParametricShape::Row& row = this->Shape.Controls[control];
      Vector sum;
      for (std::size_t i = 0; i < row.Places.size(); ++i)
      {
        sum += row.Weights[i] * (this->Mesh.GetPoint(nodes[row.Places[i]]) - origin);
      }
      this->Controls.push_back(sum);
      largest = std::max(largest, GetLargestComponent(sum));
    }
    if (IsBefore(ends[1], ends[0]))
    {
      std::reverse(this->Controls.begin(), this->Controls.end());
    }
    this->Exponent = GetUnitExponent(largest);
    constexpr double Rounding = 1e-12, MeshRounding = 8 * std::numeric_limits<double>::epsilon();
    const double tolerance = Rounding * largest + MeshRounding * GetLargestComponent(origin);
    const std::size_t degree = this->Controls.size() - 1;
    bool isStraight = true;
    for (std::size_t i = 0; i <= degree; ++i)
    {
      const Vector straight =
        (static_cast<double>(i) / static_cast<double>(degree)) * this->Controls[degree];
      isStraight &= GetLargestComponent(this->Controls[i] - straight) <= tolerance;
    }
    return !isStraight;
  }
  const std::array<vtkIdType, 2>& GetEnds() const { return this->Ends; }

  double GetLength()
  {
    const auto degree = static_cast<int>(this->Controls.size()) - 1;
    for (int i = 0; i < degree; ++i)
    {
      const Vector tangent = degree * (this->Controls[i + 1] - this->Controls[i]);
      this->Controls[i] = TimesPowerOfTwo(tangent, -this->Exponent);
    }
    const BernsteinSpace space({ { 1, degree - 1 } });
    return std::ldexp(IntegrateMagnitude(space, this->Controls.data()), this->Exponent);
  }

private:
  const MeshView& Mesh;
  const ParametricShape& Shape;
  std::array<vtkIdType, 2> Ends;
  std::vector<Vector> Controls;
  int Exponent = 0;
};
}

//------------------------------------------------------------------------------
bool MayHaveCurvedEdges(const MeshView& mesh)
{
  vtkIdType cell = 0;
  while (cell < mesh.GetNumberOfCells() && !MayBeCurved(mesh, cell))
  {
    ++cell;
  }
  return cell < mesh.GetNumberOfCells();
}

//------------------------------------------------------------------------------
void MeasureCurvedEdges(const MeshView& mesh, const EdgeFinder& finder, double* lengths)
{
  std::vector<bool> areKnown;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    if (!MayBeCurved(mesh, cell) || mesh.IsRational(cell))
    {
      continue;
    }
    const IndexRange nodes = mesh.GetCellPoints(cell);
    const ParametricShape* const shape = ParametricShape::Find(
      mesh.GetCellType(cell), static_cast<int>(nodes.Size), mesh.GetDegrees(cell));
    if (!shape)
    {
      continue;
    }
    EdgeCurve curve(mesh, *shape);
    for (const std::vector<int>& edge : shape->Edges)
    {
      const bool isCurved = curve.Load(nodes, edge);
      const auto [a, b] = curve.GetEnds();
      if (a == b) // a collapsed edge
      {
        continue;
      }
      const auto place = static_cast<std::size_t>(finder.Find(a, b));
      areKnown.resize(std::max(areKnown.size(), place + 1));
      if (isCurved && !areKnown[place])
      {
        lengths[place] = curve.GetLength();
      }
      areKnown[place] = true;
    }
  }
}
}
