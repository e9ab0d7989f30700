// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curved/CellMap.h"

#include "Curved/CurveIntegrals.h"
#include "Mesh/CellShape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace camaron
{
namespace
{
constexpr double Rounding = 1e-12;                         // of the size of a cell
constexpr double MeshRounding = 8 * 2.220446049250313e-16; // of its coordinates

//------------------------------------------------------------------------------
// A ratio that is zero but for rounding.
double RoundOff(double ratio)
{
  return std::abs(ratio) <= Rounding ? 0 : ratio;
}

//------------------------------------------------------------------------------
void Differentiate(const ParametricShape::Derivative& derivative, const Vector* controls,
  std::vector<Vector>& coefficients)
{
  coefficients.resize(derivative.Terms.size());
  for (std::size_t i = 0; i < derivative.Terms.size(); ++i)
  {
    const ParametricShape::Derivative::Term& term = derivative.Terms[i];
    coefficients[i] = term.Factor * (controls[term.Plus] - controls[term.Minus]);
  }
}
}

//------------------------------------------------------------------------------
bool CellMap::Choose(unsigned char type, int numberOfNodes, const CellDegrees& degrees)
{
  // Most cells are like the one before.
  if (type != this->Type || numberOfNodes != this->NumberOfNodes || degrees != this->Degrees)
  {
    this->Known = ParametricShape::Find(type, numberOfNodes, degrees);
    this->Type = type;
    this->NumberOfNodes = numberOfNodes;
    this->Degrees = degrees;
  }
  this->Shape = this->Known;
  this->Collapsed = nullptr;
  this->Jacobian.reset();
  this->HasDeterminant = false;
  this->Nodes.resize(static_cast<std::size_t>(numberOfNodes));
  return this->Shape != nullptr;
}

//------------------------------------------------------------------------------
bool CellMap::IsMapped(const MeshView& mesh, vtkIdType cell)
{
  return !mesh.IsRational(cell) &&
    ParametricShape::Exists(mesh.GetCellType(cell), static_cast<int>(mesh.GetCellPoints(cell).Size),
      mesh.GetDegrees(cell));
}

//------------------------------------------------------------------------------
bool CellMap::Load(const MeshView& mesh, vtkIdType cell, int exponent)
{
  const IndexRange points = mesh.GetCellPoints(cell);
  if (mesh.IsRational(cell) ||
    !this->Choose(mesh.GetCellType(cell), static_cast<int>(points.Size), mesh.GetDegrees(cell)))
  {
    return false;
  }
  const Vector origin = mesh.GetPoint(points[0]);
  const double largest = GetLargestComponent(origin);
  for (int i = 0; i < this->NumberOfNodes; ++i)
  {
    const Vector offset = mesh.GetPoint(points[i]) - origin;
    this->Nodes[i] = exponent == 0 ? offset : TimesPowerOfTwo(offset, -exponent);
  }
  this->SetControls(MeshRounding * std::ldexp(largest, -exponent));
  return true;
}

//------------------------------------------------------------------------------
bool CellMap::Collapse(ParametricShape::Domain remaining, const CollapsedShape::Corners& corners)
{
  const CollapsedShape* const collapsed = CollapsedShape::Find(*this->Shape, remaining, corners);
  if (!collapsed || !collapsed->Convert(this->Nodes, this->Tolerance, this->Remaining))
  {
    return false;
  }
  this->Shape = &collapsed->GetShape();
  this->Collapsed = collapsed;
  std::swap(this->Nodes, this->Remaining);
  this->SetControls(this->Tolerance);
  return true;
}

//------------------------------------------------------------------------------
bool CellMap::Load(unsigned char type, const Vector* nodes, int numberOfNodes)
{
  if (!this->Choose(type, numberOfNodes, {}))
  {
    return false;
  }
  std::copy_n(nodes, numberOfNodes, this->Nodes.begin());
  this->SetControls(0);
  return true;
}

//------------------------------------------------------------------------------
void CellMap::SetControls(double tolerance)
{
  const auto size = static_cast<std::size_t>(this->Shape->Positions.GetSize());
  this->Controls.resize(size);
  double cellSize = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    this->Controls[i] = this->Shape->Controls[i].Combine(this->Nodes.data());
    cellSize = std::max(cellSize, GetLargestComponent(this->Controls[i]));
  }
  this->Curved = false;
  this->Tolerance = tolerance + Rounding * cellSize;
  const bool isHigherOrder = GetCellShape(this->Type).IsHigherOrder;
  for (std::size_t i = 0; i < size && isHigherOrder && !this->Curved; ++i)
  {
    const Vector straight = this->Shape->StraightControls[i].Combine(this->Nodes.data());
    this->Curved = !(GetLargestComponent(this->Controls[i] - straight) <= this->Tolerance);
  }
}

//------------------------------------------------------------------------------
// The product of the last two derivatives.
void CellMap::ComputeCross(const ParametricShape& shape, const Vector* controls) const
{
  for (int d = 0; d < shape.Dimension; ++d)
  {
    Differentiate(shape.Derivatives[d], controls, this->Derivatives[d]);
  }
  this->Cross.assign(static_cast<std::size_t>(shape.CrossProduct.Space.GetSize()), Vector());
  const std::vector<Vector>&a = this->Derivatives[shape.Dimension - 2],
        &b = this->Derivatives[shape.Dimension - 1];
  for (const BernsteinProduct::Term& term : shape.CrossProduct.Terms)
  {
    this->Cross[term.C] += term.Weight * camaron::Cross(a[term.A], b[term.B]);
  }
}

//------------------------------------------------------------------------------
void CellMap::ComputeJacobian(const Vector& normal) const
{
  if (this->HasDeterminant)
  {
    return;
  }
  this->HasDeterminant = true;
  const ParametricShape& shape = *this->Shape;
  this->ComputeCross(shape, this->Controls.data());
  this->Determinant.assign(static_cast<std::size_t>(shape.GetJacobianSpace().GetSize()), 0);
  if (shape.Dimension == 2)
  {
    for (std::size_t i = 0; i < this->Cross.size(); ++i)
    {
      this->Determinant[i] = Dot(this->Cross[i], normal);
    }
    return;
  }
  for (const BernsteinProduct::Term& term : shape.TripleProduct.Terms)
  {
    this->Determinant[term.C] +=
      shape.Sign * term.Weight * Dot(this->Derivatives[0][term.A], this->Cross[term.B]);
  }
}

//------------------------------------------------------------------------------
bool CellMap::IsSurelyPositive(const Vector& normal) const
{
  this->ComputeJacobian(normal);
  const auto [least, greatest] =
    std::minmax_element(this->Determinant.begin(), this->Determinant.end());
  return *least > BoundFinder::Zero * *greatest;
}

//------------------------------------------------------------------------------
const PolynomialBounds& CellMap::GetJacobian(const Vector& normal) const
{
  if (!this->Jacobian)
  {
    this->ComputeJacobian(normal);
    PolynomialBounds bounds =
      this->Finder.Find(this->Shape->GetJacobianSpace(), this->Determinant.data());
    for (double* bound :
      { &bounds.Least, &bounds.Greatest, &bounds.LeastFound, &bounds.GreatestFound })
    {
      *bound *= this->Shape->Measure;
    }
    this->Jacobian = bounds;
  }
  return *this->Jacobian;
}

//------------------------------------------------------------------------------
double CellMap::GetVolume() const
{
  this->ComputeJacobian({});
  double volume = 0;
  for (std::size_t i = 0; i < this->Determinant.size(); ++i)
  {
    volume += this->Shape->Integral[i] * this->Determinant[i];
  }
  return volume;
}

//------------------------------------------------------------------------------
std::optional<Vector> CellMap::GetCentroid(const Vector& normal) const
{
  this->ComputeJacobian(normal);
  double size = 0;
  for (std::size_t i = 0; i < this->Determinant.size(); ++i)
  {
    size += this->Shape->Integral[i] * this->Determinant[i];
  }
  Vector moment;
  for (const BernsteinProduct::Term& term : this->Shape->GetMoments())
  {
    moment += term.Weight * this->Determinant[term.B] * this->Controls[term.A];
  }
  const Vector centroid = (1 / size) * moment;
  return camaron::IsFinite(centroid) ? std::optional<Vector>(centroid) : std::nullopt;
}

//------------------------------------------------------------------------------
Vector CellMap::GetVectorArea() const
{
  this->ComputeCross(*this->Shape, this->Controls.data());
  Vector area;
  for (std::size_t i = 0; i < this->Cross.size(); ++i)
  {
    area += this->Shape->Integral[i] * this->Cross[i];
  }
  return area;
}

//------------------------------------------------------------------------------
double CellMap::ComputeArea(const ParametricShape& shape, const Vector* controls) const
{
  this->ComputeCross(shape, controls);
  const auto isSmaller = [](const Vector& a, const Vector& b) { return Norm2(a) < Norm2(b); };
  const Vector& largest = *std::max_element(this->Cross.begin(), this->Cross.end(), isSmaller);
  Vector sum;
  bool isPlanar = true;
  for (const Vector& coefficient : this->Cross)
  {
    sum += coefficient;
    isPlanar &= Norm2(camaron::Cross(coefficient, largest)) <=
      Rounding * Rounding * Norm2(largest) * Norm2(largest);
  }
  // In a plane, what is folded over counts negative.
  const double measure = shape.Form == ParametricShape::Domain::Triangle ? 0.5 : 1;
  return isPlanar ? measure * Norm(sum) / static_cast<double>(this->Cross.size())
                  : IntegrateMagnitude(shape.CrossProduct.Space, this->Cross.data());
}

//------------------------------------------------------------------------------
double CellMap::GetArea() const
{
  if (this->Shape->Dimension == 2)
  {
    return this->ComputeArea(*this->Shape, this->Controls.data());
  }
  double area = 0;
  for (const ParametricShape::Face& face : this->Shape->Faces)
  {
    this->FaceControls.clear();
    for (const int control : face.Controls)
    {
      this->FaceControls.push_back(this->Controls[control]);
    }
    area += this->ComputeArea(*face.Shape, this->FaceControls.data());
  }
  return area;
}

//------------------------------------------------------------------------------
double CellMap::GetEdgeLength(int edge) const
{
  const std::vector<int>& controls = this->Shape->Edges[edge];
  const auto degree = static_cast<int>(controls.size()) - 1;
  if (degree == 1)
  {
    return Norm(this->Controls[controls[1]] - this->Controls[controls[0]]);
  }
  static const std::array<BernsteinSpace, ParametricShape::MaxDegree> spaces = []
  {
    std::array<BernsteinSpace, ParametricShape::MaxDegree> made;
    for (int i = 0; i < ParametricShape::MaxDegree; ++i)
    {
      made[i] = BernsteinSpace({ { 1, i } });
    }
    return made;
  }();
  std::vector<Vector>& tangents = this->FaceControls;
  tangents.clear();
  for (int i = 0; i < degree; ++i)
  {
    tangents.push_back(degree * (this->Controls[controls[i + 1]] - this->Controls[controls[i]]));
  }
  return IntegrateMagnitude(spaces[degree - 1], tangents.data());
}

//------------------------------------------------------------------------------
// The least of measure(three tangents along the parametric coordinates of the cell).
template <typename Measure>
double CellMap::GetLeastSample(Measure&& measure) const
{
  double least = HUGE_VAL;
  for (const ParametricShape::Sample& sample : this->Shape->Samples)
  {
    Vector tangents[3];
    for (int d = 0; d < this->Shape->Dimension; ++d)
    {
      for (std::size_t i = 0; i < this->Controls.size(); ++i)
      {
        tangents[d] += sample.Weights[d][i] * this->Controls[i];
      }
    }
    least = std::min(least, measure(tangents));
  }
  return least;
}

//------------------------------------------------------------------------------
double CellMap::GetMinInverseCondition(const Vector& normal) const
{
  return this->GetLeastSample(
    [&](const Vector* tangents)
    {
      Vector columns[3];
      for (int i = 0; i < 3; ++i)
      {
        const Vector& weights = this->Shape->IdealInverse[i];
        columns[i] = weights.X * tangents[0] + weights.Y * tangents[1] + weights.Z * tangents[2];
      }
      const Vector first = camaron::Cross(columns[0], columns[1]);
      if (this->Shape->Dimension == 2)
      {
        const double norm = Norm2(columns[0]) + Norm2(columns[1]);
        return RoundOff(norm > 0 ? 2 * Dot(first, normal) / norm : 0);
      }
      const Vector second = camaron::Cross(columns[1], columns[2]);
      const Vector third = camaron::Cross(columns[2], columns[0]);
      const double norm = std::sqrt((Norm2(columns[0]) + Norm2(columns[1]) + Norm2(columns[2])) *
        (Norm2(first) + Norm2(second) + Norm2(third)));
      return RoundOff(norm > 0 ? 3 * this->Shape->Sign * Dot(first, columns[2]) / norm : 0);
    });
}

//------------------------------------------------------------------------------
// Tangents of the edges of a simplex at a point are those along its coordinates and their
// differences; three of them meet at each corner.
double CellMap::GetMinScaledJacobian(const Vector& normal) const
{
  using Domain = ParametricShape::Domain;
  const double triangle = 2 / std::sqrt(3.0), space = std::sqrt(2.0);
  return this->GetLeastSample(
    [&](const Vector* t)
    {
      const bool isSurface = this->Shape->Dimension == 2;
      const double determinant = isSurface
        ? Dot(camaron::Cross(t[0], t[1]), normal)
        : this->Shape->Sign * Dot(camaron::Cross(t[0], t[1]), t[2]);
      const double a = Norm(t[0]), b = Norm(t[1]), c = isSurface ? 1 : Norm(t[2]);
      double product = a * b * c, factor = 1;
      switch (this->Shape->Form)
      {
        case Domain::Triangle:
        case Domain::Wedge:
        {
          const double third = Norm(t[1] - t[0]);
          product = std::max({ a * b, b * third, a * third }) * c;
          factor = triangle;
          break;
        }
        case Domain::Tetrahedron:
        {
          const double ab = Norm(t[1] - t[0]), ac = Norm(t[2] - t[0]), bc = Norm(t[2] - t[1]);
          product = std::max({ a * b * c, a * ab * ac, b * ab * bc, c * ac * bc });
          factor = space;
          break;
        }
        case Domain::Pyramid:
        {
          product = 0;
          for (const int sign : { -1, 1 })
          {
            const Vector sum = 0.5 * (t[0] + static_cast<double>(sign) * t[1]);
            product = std::max({ product, Norm(t[2] + sum), Norm(t[2] - sum) });
          }
          product *= a * b;
          factor = space;
          break;
        }
        default:
          break;
      }
      const double most = std::max({ a, b, isSurface ? 0 : c });
      const bool isZero = product <= Rounding * (isSurface ? most * most : most * most * most);
      return isZero ? 0 : RoundOff(std::min(factor * determinant / product, 1.0));
    });
}

//------------------------------------------------------------------------------
// The greatest of measure(middle, end, squared distance of the ends), relative to the first end.
template <typename Measure>
double CellMap::GetMostOfEdges(Measure&& measure) const
{
  double most = 0;
  for (const std::vector<int>& edge : this->Shape->Edges)
  {
    const auto degree = static_cast<int>(edge.size()) - 1;
    const Vector& begin = this->Controls[edge[0]];
    Vector middle;
    double weight = std::ldexp(1.0, -degree); // times a binomial coefficient
    for (int i = 0; i <= degree; ++i)
    {
      middle += weight * (this->Controls[edge[i]] - begin);
      weight *= static_cast<double>(degree - i) / (i + 1);
    }
    const Vector end = this->Controls[edge[degree]] - begin;
    const double length = Norm2(end);
    most = std::max(most,
      length > 0            ? measure(middle, end, length)
        : Norm2(middle) > 0 ? HUGE_VAL
                            : 0);
  }
  return most;
}

//------------------------------------------------------------------------------
double CellMap::GetMaxOffsetAlongEdge() const
{
  return this->GetMostOfEdges([](const Vector& middle, const Vector& end, double length)
    { return std::abs(Dot(middle, end) / length - 0.5); });
}

//------------------------------------------------------------------------------
double CellMap::GetMaxOffsetFromEdge() const
{
  return this->GetMostOfEdges([](const Vector& middle, const Vector& end, double length)
    { return Norm(middle - (Dot(middle, end) / length) * end) / std::sqrt(length); });
}
}
