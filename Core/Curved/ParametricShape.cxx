// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curved/ParametricShape.h"

#include "Curved/LinearEquations.h"
#include "Mesh/CellShape.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <set>
#include <tuple>

namespace camaron
{
namespace
{
using Domain = ParametricShape::Domain;
using Factor = BernsteinSpace::Factor;

constexpr double Tiny = 1e-12; // rounding of weights
const double IdealPyramidHeight = std::sqrt(0.5);
const double IdealTriangleHeight = std::sqrt(0.75);

// The last coordinate of a pyramid is q, with two vertices: the apex and the base.
constexpr int Apex = 4, Base = 5;

//------------------------------------------------------------------------------
struct TypeRow
{
  int Type;
  Domain Form;
  CellDegrees Degrees; // 0 where these vary
};

// clang-format off
constexpr TypeRow TypeRows[] = {
  { VTK_TRIANGLE, Domain::Triangle, { 1, 1, 1 } },
  { VTK_QUAD, Domain::Quadrilateral, { 1, 1, 1 } },
  { VTK_TETRA, Domain::Tetrahedron, { 1, 1, 1 } },
  { VTK_HEXAHEDRON, Domain::Hexahedron, { 1, 1, 1 } },
  { VTK_WEDGE, Domain::Wedge, { 1, 1, 1 } },
  { VTK_PYRAMID, Domain::Pyramid, { 1, 1, 1 } },
  { VTK_QUADRATIC_TRIANGLE, Domain::Triangle, { 2, 2, 2 } },
  { VTK_BIQUADRATIC_TRIANGLE, Domain::Triangle, { 3, 3, 3 } },
  { VTK_QUADRATIC_QUAD, Domain::Quadrilateral, { 2, 2, 2 } },
  { VTK_BIQUADRATIC_QUAD, Domain::Quadrilateral, { 2, 2, 2 } },
  { VTK_QUADRATIC_LINEAR_QUAD, Domain::Quadrilateral, { 2, 1, 1 } },
  { VTK_QUADRATIC_TETRA, Domain::Tetrahedron, { 2, 2, 2 } },
  { VTK_QUADRATIC_HEXAHEDRON, Domain::Hexahedron, { 2, 2, 2 } },
  { VTK_TRIQUADRATIC_HEXAHEDRON, Domain::Hexahedron, { 2, 2, 2 } },
  { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, Domain::Hexahedron, { 2, 2, 2 } },
  { VTK_QUADRATIC_PYRAMID, Domain::Pyramid, { 2, 2, 2 } },
  { VTK_TRIQUADRATIC_PYRAMID, Domain::Pyramid, { 3, 3, 3 } },
  { VTK_QUADRATIC_WEDGE, Domain::Wedge, { 2, 2, 2 } },
  { VTK_QUADRATIC_LINEAR_WEDGE, Domain::Wedge, { 2, 2, 1 } },
  { VTK_BIQUADRATIC_QUADRATIC_WEDGE, Domain::Wedge, { 2, 2, 2 } },
  { VTK_LAGRANGE_TRIANGLE, Domain::Triangle, {} },
  { VTK_BEZIER_TRIANGLE, Domain::Triangle, {} },
  { VTK_LAGRANGE_QUADRILATERAL, Domain::Quadrilateral, {} },
  { VTK_BEZIER_QUADRILATERAL, Domain::Quadrilateral, {} },
  { VTK_LAGRANGE_TETRAHEDRON, Domain::Tetrahedron, {} },
  { VTK_BEZIER_TETRAHEDRON, Domain::Tetrahedron, {} },
  { VTK_LAGRANGE_HEXAHEDRON, Domain::Hexahedron, {} },
  { VTK_BEZIER_HEXAHEDRON, Domain::Hexahedron, {} },
  { VTK_LAGRANGE_WEDGE, Domain::Wedge, {} },
  { VTK_BEZIER_WEDGE, Domain::Wedge, {} },
};
// clang-format on

//------------------------------------------------------------------------------
const TypeRow* FindRow(unsigned char type)
{
  const auto found = std::find_if(std::begin(TypeRows), std::end(TypeRows),
    [type](const TypeRow& row) { return row.Type == type; });
  return found == std::end(TypeRows) ? nullptr : found;
}

//------------------------------------------------------------------------------
std::vector<Factor> GetFactors(Domain form, const CellDegrees& degrees)
{
  switch (form)
  {
    case Domain::Triangle:
      return { { 2, degrees[0] } };
    case Domain::Quadrilateral:
      return { { 1, degrees[0] }, { 1, degrees[1] } };
    case Domain::Tetrahedron:
      return { { 3, degrees[0] } };
    case Domain::Wedge:
      return { { 2, degrees[0] }, { 1, degrees[2] } };
    default:
      return { { 1, degrees[0] }, { 1, degrees[1] }, { 1, degrees[2] } };
  }
}

//------------------------------------------------------------------------------
// The degrees of the map of a cell; false if they are too large, or do not fit its nodes.
bool FindDegrees(
  const TypeRow& row, int numberOfNodes, const CellDegrees& given, CellDegrees& degrees)
{
  degrees = row.Degrees;
  if (degrees[0] > 0)
  {
    return true;
  }
  constexpr int Triangle7 = 7, Tetrahedron15 = 15, Wedge21 = 21; // have centers, too
  const bool isSimplex = row.Form == Domain::Triangle || row.Form == Domain::Tetrahedron;
  const bool isGiven = given[0] > 0 && !isSimplex;
  for (int degree = 1; degree <= ParametricShape::MaxDegree; ++degree)
  {
    degrees = isGiven ? given : CellDegrees{ degree, degree, degree };
    if (*std::max_element(degrees.begin(), degrees.end()) <= ParametricShape::MaxDegree &&
      BernsteinSpace(GetFactors(row.Form, degrees)).GetSize() == numberOfNodes)
    {
      return true;
    }
  }
  degrees = row.Form == Domain::Triangle ? CellDegrees{ 3, 3, 3 }
    : row.Form == Domain::Tetrahedron    ? CellDegrees{ 4, 4, 4 }
                                         : CellDegrees{ 3, 3, 2 };
  return numberOfNodes ==
    (row.Form == Domain::Triangle         ? Triangle7
        : row.Form == Domain::Tetrahedron ? Tetrahedron15
        : row.Form == Domain::Wedge       ? Wedge21
                                          : 0);
}

//------------------------------------------------------------------------------
// VTK's parametric coordinates.
std::array<double, 3> GetParametric(
  unsigned char type, Domain form, const BernsteinSpace::Barycentric& at)
{
  switch (form)
  {
    case Domain::Triangle:
    case Domain::Tetrahedron:
      return { at[1], at[2], form == Domain::Triangle ? 0 : at[3] };
    case Domain::Wedge:
      return { at[1], at[2], at[4] };
    case Domain::Pyramid:
      if (type == VTK_TRIQUADRATIC_PYRAMID) // does not collapse, and is half as high
      {
        return { 0.5 + (at[1] - 0.5) * at[Base], 0.5 + (at[3] - 0.5) * at[Base],
          0.5 + at[Apex] / 2 };
      }
      return { at[1], at[3], at[Apex] };
    default:
      return { at[1], at[3], form == Domain::Hexahedron ? at[5] : 0 };
  }
}

//------------------------------------------------------------------------------
// Bedrosian's functions of the nodes of a quadratic pyramid, for x and y from -1 to 1.
std::vector<double> InterpolatePyramid(double x, double y, double q)
{
  constexpr int Corners[4][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
  constexpr int Middles[4][2] = { { 0, -1 }, { 1, 0 }, { 0, 1 }, { -1, 0 } };
  std::vector<double> weights;
  for (const auto& sign : Corners)
  {
    weights.push_back(
      q * (1 + sign[0] * x) * (1 + sign[1] * y) * (-1 + q * sign[0] * x + q * sign[1] * y) / 4);
  }
  weights.push_back((1 - q) * (1 - 2 * q));
  for (const auto& sign : Middles)
  {
    weights.push_back(q * q *
      (sign[0] == 0 ? (1 - x * x) * (1 + sign[1] * y) : (1 - y * y) * (1 + sign[0] * x)) / 2);
  }
  for (const auto& sign : Corners)
  {
    weights.push_back(q * (1 - q) * (1 + sign[0] * x) * (1 + sign[1] * y));
  }
  return weights;
}

//------------------------------------------------------------------------------
// A grid of one cell, whose functions VTK evaluates.
vtkSmartPointer<vtkUnstructuredGrid> MakeCell(
  unsigned char type, int numberOfNodes, const CellDegrees& degrees)
{
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  std::vector<vtkIdType> ids;
  for (vtkIdType node = 0; node < numberOfNodes; ++node)
  {
    ids.push_back(points->InsertNextPoint(static_cast<double>(node), 0, 0));
  }
  grid->SetPoints(points);
  grid->InsertNextCell(type, numberOfNodes, ids.data());
  if (degrees[0] > 0)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName("Degrees");
    array->SetNumberOfComponents(3);
    array->InsertNextTuple3(degrees[0], degrees[1], degrees[2]);
    grid->GetCellData()->SetHigherOrderDegrees(array);
  }
  return grid;
}

//------------------------------------------------------------------------------
// The place of a corner of the domain in the ideal cell.
Vector GetIdealPlace(Domain form, const BernsteinSpace::Barycentric& at)
{
  switch (form)
  {
    case Domain::Triangle:
      return { at[1] + at[2] / 2, IdealTriangleHeight * at[2], 0 };
    case Domain::Tetrahedron:
      return { at[1] + (at[2] + at[3]) / 2, IdealTriangleHeight * (at[2] + at[3] / 3),
        std::sqrt(2.0 / 3) * at[3] };
    case Domain::Wedge:
      return { at[1] + at[2] / 2, IdealTriangleHeight * at[2], at[4] };
    case Domain::Pyramid:
      return { (at[1] - 0.5) * at[Base], (at[3] - 0.5) * at[Base], IdealPyramidHeight * at[Apex] };
    default:
      return { at[1], at[3], form == Domain::Hexahedron ? at[5] : 0 };
  }
}

//------------------------------------------------------------------------------
// Volume by VTK's faces, whose nodes turn outward.
double GetVolumeByFaces(const CellShape& shape, const std::vector<Vector>& corners)
{
  double volume = 0;
  for (int f = 0; f < shape.NumberOfFaces; ++f)
  {
    const Vector& first = corners[shape.FacePoints[shape.FaceOffsets[f]]];
    for (int i = shape.FaceOffsets[f] + 2; i < shape.FaceOffsets[f + 1]; ++i)
    {
      volume += Dot(first, Cross(corners[shape.FacePoints[i - 1]], corners[shape.FacePoints[i]]));
    }
  }
  return volume;
}

//------------------------------------------------------------------------------
// The vertices of each factor in the list of all vertices.
std::vector<std::pair<int, int>> GetVertexRanges(const BernsteinSpace& space)
{
  std::vector<std::pair<int, int>> ranges;
  int first = 0;
  for (const Factor& factor : space.GetFactors())
  {
    ranges.emplace_back(first, first + factor.Dimension);
    first += factor.GetNumberOfVertices();
  }
  return ranges;
}
}

//------------------------------------------------------------------------------
bool ParametricShape::Exists(unsigned char type, int numberOfNodes, const CellDegrees& given)
{
  const TypeRow* const row = FindRow(type);
  CellDegrees degrees;
  return row && FindDegrees(*row, numberOfNodes, given, degrees);
}

//------------------------------------------------------------------------------
const ParametricShape* ParametricShape::Find(
  unsigned char type, int numberOfNodes, const CellDegrees& degrees)
{
  static std::mutex mutex;
  static std::map<std::tuple<unsigned char, int, CellDegrees>, std::unique_ptr<ParametricShape>>
    shapes;
  const std::lock_guard<std::mutex> lock(mutex);
  const auto key = std::make_tuple(type, numberOfNodes, degrees);
  const auto found = shapes.find(key);
  return (
    found != shapes.end() ? found : shapes.emplace(key, Make(type, numberOfNodes, degrees)).first)
    ->second.get();
}

//------------------------------------------------------------------------------
std::unique_ptr<ParametricShape> ParametricShape::Make(
  unsigned char type, int numberOfNodes, const CellDegrees& given)
{
  const TypeRow* const row = FindRow(type);
  CellDegrees degrees;
  if (!row || !FindDegrees(*row, numberOfNodes, given, degrees))
  {
    return nullptr;
  }
  auto shape = std::make_unique<ParametricShape>();
  shape->Form = row->Form;
  shape->NumberOfNodes = numberOfNodes;
  shape->NumberOfCorners = GetCellShape(type).NumberOfCorners;
  shape->Positions = BernsteinSpace(GetFactors(row->Form, degrees));
  shape->AddControls(type, row->Degrees[0] == 0 ? given : CellDegrees());
  shape->AddStraightControls();
  shape->SetUp();
  shape->AddIntegral();
  shape->AddIdeal(type);
  shape->AddSamples();
  shape->AddEdges();
  shape->AddFaces();
  return shape;
}

//------------------------------------------------------------------------------
std::unique_ptr<ParametricShape> ParametricShape::MakeFacet(const BernsteinSpace& positions)
{
  auto shape = std::make_unique<ParametricShape>();
  shape->Positions = positions;
  shape->Form = positions.GetFactors().size() == 2 ? Domain::Quadrilateral
    : positions.GetFactors()[0].Dimension == 2     ? Domain::Triangle
                                                   : Domain::Line;
  shape->SetUp();
  return shape;
}

//------------------------------------------------------------------------------
std::vector<std::pair<int, double>> ParametricShape::GetWeights(
  const std::vector<std::pair<int, double>>& corners) const
{
  BernsteinSpace::Barycentric at = {};
  const bool isPyramid = this->Form == Domain::Pyramid;
  for (const auto& [corner, weight] : corners)
  {
    const auto found =
      std::find(this->CornerOfControl.begin(), this->CornerOfControl.end(), corner);
    const BernsteinSpace::Barycentric of =
      this->Positions.GetLatticePoint(static_cast<int>(found - this->CornerOfControl.begin()));
    for (std::size_t i = 0; i < of.size(); ++i)
    {
      at[i] += weight * of[i] * (isPyramid && i < Apex ? of[Base] : 1);
    }
  }
  for (int i = 0; isPyramid && i < Apex; ++i)
  {
    at[i] = at[Base] > 0 ? at[i] / at[Base] : 0.5;
  }
  std::map<int, double> weights;
  for (int control = 0; control < this->Positions.GetSize(); ++control)
  {
    const double value = this->Positions.Evaluate(control, at);
    const Row& row = this->Controls[control];
    for (std::size_t i = 0; i < row.Places.size(); ++i)
    {
      weights[row.Places[i]] += value * row.Weights[i];
    }
  }
  std::vector<std::pair<int, double>> nodes;
  std::copy_if(weights.begin(), weights.end(), std::back_inserter(nodes),
    [](const auto& node) { return std::abs(node.second) > Tiny; });
  return nodes;
}

//------------------------------------------------------------------------------
void ParametricShape::SetUp()
{
  this->AddDerivatives();
  if (this->Dimension > 1)
  {
    this->CrossProduct = BernsteinProduct(
      this->Derivatives[this->Dimension - 2].Space, this->Derivatives[this->Dimension - 1].Space);
  }
  if (this->Dimension > 2)
  {
    this->TripleProduct = BernsteinProduct(this->Derivatives[0].Space, this->CrossProduct.Space);
  }
}

//------------------------------------------------------------------------------
// Control points such that the polynomial has the same values as VTK's on a lattice.
void ParametricShape::AddControls(unsigned char type, const CellDegrees& degrees)
{
  const auto cell = MakeCell(type, this->NumberOfNodes, degrees);
  const int size = this->Positions.GetSize();
  DenseMatrix polynomials, values;
  for (int i = 0; i < size; ++i)
  {
    const BernsteinSpace::Barycentric at = this->Positions.GetLatticePoint(i);
    std::vector<double>& row = polynomials.emplace_back();
    for (int j = 0; j < size; ++j)
    {
      row.push_back(this->Positions.Evaluate(j, at));
    }
    if (type == VTK_QUADRATIC_PYRAMID)
    {
      values.push_back(InterpolatePyramid(2 * at[1] - 1, 2 * at[3] - 1, at[Base]));
      continue;
    }
    const std::array<double, 3> place = GetParametric(type, this->Form, at);
    values.emplace_back(this->NumberOfNodes);
    cell->GetCell(0)->InterpolateFunctions(place.data(), values.back().data());
  }
  for (const std::vector<double>& weights :
    SolveEquations(std::move(polynomials), std::move(values)))
  {
    Row& row = this->Controls.emplace_back();
    for (int node = 0; node < this->NumberOfNodes; ++node)
    {
      if (std::abs(weights[node]) > Tiny)
      {
        row.Places.push_back(node);
        row.Weights.push_back(weights[node]);
      }
    }
  }
}

//------------------------------------------------------------------------------
// Corners belong to one node each, an apex to several corners of the domain.
void ParametricShape::AddStraightControls()
{
  this->CornerOfControl.assign(this->Controls.size(), -1);
  for (const int corner : this->Positions.GetCorners())
  {
    this->CornerOfControl[corner] = this->Controls[corner].Places[0];
  }
  for (int control = 0; control < this->Positions.GetSize(); ++control)
  {
    const BernsteinSpace::Barycentric at = this->Positions.GetLatticePoint(control);
    std::map<int, double> weights;
    for (const int corner : this->Positions.GetCorners())
    {
      double weight = 1;
      for (int vertex = 0; vertex < this->Positions.GetNumberOfVertices(); ++vertex)
      {
        weight *= this->Positions.GetIndex(corner)[vertex] > 0 ? at[vertex] : 1;
      }
      weights[this->CornerOfControl[corner]] += weight;
    }
    Row& row = this->StraightControls.emplace_back();
    for (const auto& [corner, weight] : weights)
    {
      if (weight > 0)
      {
        row.Places.push_back(corner);
        row.Weights.push_back(weight);
      }
    }
  }
}

//------------------------------------------------------------------------------
void ParametricShape::AddDerivatives()
{
  const auto ranges = GetVertexRanges(this->Positions);
  for (std::size_t f = 0; f < ranges.size(); ++f)
  {
    const auto [first, last] = ranges[f];
    const int degree = this->Positions.GetFactors()[f].Degree;
    const bool isPyramid = this->Form == Domain::Pyramid;
    const bool isAlongAxis = isPyramid && f == 2;
    for (int to = first + 1; to <= last; ++to)
    {
      std::vector<Factor> factors = this->Positions.GetFactors();
      --factors[f].Degree;
      if (isPyramid && !isAlongAxis)
      {
        --factors[2].Degree;
      }
      Derivative derivative;
      derivative.Space = BernsteinSpace(factors);
      for (int i = 0; i < derivative.Space.GetSize(); ++i)
      {
        BernsteinSpace::Index index = derivative.Space.GetIndex(i);
        double factor = degree;
        if (isPyramid && !isAlongAxis)
        {
          // q times the polynomial with these coefficients is the derivative, which is 0 at the
          // apex.
          ++index[Base];
          factor *= static_cast<double>(this->Positions.GetFactors()[2].Degree) / index[Base];
        }
        BernsteinSpace::Index from = index;
        ++index[to];
        ++from[first];
        derivative.Terms.push_back({ this->Positions.Find(index), this->Positions.Find(from),
          isAlongAxis ? -factor : factor });
      }
      this->Derivatives.push_back(std::move(derivative));
    }
  }
  this->Dimension = static_cast<int>(this->Derivatives.size());
}

//------------------------------------------------------------------------------
void ParametricShape::AddIntegral()
{
  const BernsteinSpace& space = this->GetJacobianSpace();
  constexpr double Sixth = 1.0 / 6, Third = 1.0 / 3;
  this->Measure = this->Form == Domain::Tetrahedron                 ? Sixth
    : this->Form == Domain::Triangle || this->Form == Domain::Wedge ? 0.5
    : this->Form == Domain::Pyramid                                 ? Third
                                                                    : 1;
  this->Integral = this->GetIntegral(space);
}

//------------------------------------------------------------------------------
// Weights of the coefficients of polynomials in the parametric domain.
std::vector<double> ParametricShape::GetIntegral(const BernsteinSpace& space) const
{
  std::vector<double> integral(space.GetSize(), this->Measure / space.GetSize());
  if (this->Form == Domain::Pyramid)
  {
    // The integrals of q² times the polynomials of q.
    const int degree = space.GetFactors()[2].Degree;
    const int others = space.GetSize() / (degree + 1);
    for (int i = 0; i < space.GetSize(); ++i)
    {
      const int k = space.GetIndex(i)[Base];
      integral[i] = static_cast<double>((k + 1) * (k + 2)) /
        ((degree + 1) * (degree + 2) * (degree + 3)) / others;
    }
  }
  return integral;
}

//------------------------------------------------------------------------------
const std::vector<BernsteinProduct::Term>& ParametricShape::GetMoments() const
{
  std::call_once(this->HasMoments,
    [this]
    {
      BernsteinProduct product(this->Positions, this->GetJacobianSpace());
      const std::vector<double> integral = this->GetIntegral(product.Space);
      for (BernsteinProduct::Term& term : product.Terms)
      {
        term.Weight *= integral[term.C];
      }
      this->Moments = std::move(product.Terms);
    });
  return this->Moments;
}

//------------------------------------------------------------------------------
void ParametricShape::AddIdeal(unsigned char type)
{
  std::vector<Vector> corners(this->NumberOfCorners);
  for (const int corner : this->Positions.GetCorners())
  {
    corners[this->CornerOfControl[corner]] =
      GetIdealPlace(this->Form, this->Positions.GetLatticePoint(corner));
  }
  if (this->Dimension == 3)
  {
    this->Sign = GetVolumeByFaces(GetCellShape(type), corners) < 0 ? -1 : 1;
  }
  // Derivatives of the ideal cell by the same coordinates.
  std::array<Vector, 3> columns = { Vector{ 1, 0, 0 }, Vector{ 0, 1, 0 }, Vector{ 0, 0, 1 } };
  const auto place = [&](int vertex)
  {
    BernsteinSpace::Barycentric at = {};
    at[vertex] = 1;
    return GetIdealPlace(this->Form, at);
  };
  switch (this->Form)
  {
    case Domain::Tetrahedron:
      columns = { place(1), place(2), place(3) };
      break;
    case Domain::Triangle:
    case Domain::Wedge:
      columns[0] = place(1);
      columns[1] = place(2);
      break;
    case Domain::Pyramid:
      columns[2].Z = IdealPyramidHeight;
      break;
    default:
      break;
  }
  // The columns of the inverse of this upper triangular matrix.
  const double z = 1 / columns[2].Z, y = 1 / columns[1].Y;
  this->IdealInverse[0] = { 1, 0, 0 };
  this->IdealInverse[1] = { -columns[1].X * y, y, 0 };
  const double second = -columns[2].Y * y * z;
  this->IdealInverse[2] = { -columns[2].X * z - columns[1].X * second, second, z };
}

//------------------------------------------------------------------------------
void ParametricShape::AddSamples()
{
  for (int i = 0; i < this->Positions.GetSize(); ++i)
  {
    const BernsteinSpace::Barycentric at = this->Positions.GetLatticePoint(i);
    Sample& sample = this->Samples.emplace_back();
    for (int d = 0; d < this->Dimension; ++d)
    {
      std::vector<double>& weights = sample.Weights[d];
      weights.assign(this->Positions.GetSize(), 0);
      const Derivative& derivative = this->Derivatives[d];
      for (int j = 0; j < derivative.Space.GetSize(); ++j)
      {
        const double value = derivative.Space.Evaluate(j, at) * derivative.Terms[j].Factor;
        weights[derivative.Terms[j].Plus] += value;
        weights[derivative.Terms[j].Minus] -= value;
      }
    }
    if (this->Form == Domain::Pyramid)
    {
      // The derivative toward the apex in a space that is not collapsed.
      for (int control = 0; control < this->Positions.GetSize(); ++control)
      {
        sample.Weights[2][control] +=
          (at[1] - 0.5) * sample.Weights[0][control] + (at[3] - 0.5) * sample.Weights[1][control];
      }
    }
  }
}

//------------------------------------------------------------------------------
// Along each factor of the domain, from all corners.
void ParametricShape::AddEdges()
{
  std::set<std::pair<int, int>> known;
  for (const BernsteinSpace::Direction& direction : this->Positions.GetDirections())
  {
    int begin = 0;
    for (const int end : direction.Ends)
    {
      const std::vector<int> line(
        direction.Members.begin() + begin, direction.Members.begin() + end);
      begin = end;
      const int corners[2] = { this->CornerOfControl[line.front()],
        this->CornerOfControl[line.back()] };
      if (corners[0] >= 0 && corners[1] >= 0 && corners[0] != corners[1] &&
        known.insert(std::minmax(corners[0], corners[1])).second)
      {
        this->Edges.push_back(line);
      }
    }
  }
}

//------------------------------------------------------------------------------
// Where the barycentric coordinate of a vertex is zero, unless all of that is the apex.
void ParametricShape::AddFaces()
{
  const auto ranges = GetVertexRanges(this->Positions);
  for (int vertex = 0; this->Dimension == 3 && vertex < this->Positions.GetNumberOfVertices();
    ++vertex)
  {
    if (this->Form == Domain::Pyramid && vertex == Base)
    {
      continue;
    }
    const int f = this->Positions.GetFactor(vertex);
    std::vector<Factor> factors = this->Positions.GetFactors();
    --factors[f].Dimension;
    if (factors[f].Dimension == 0)
    {
      factors.erase(factors.begin() + f);
    }
    const BernsteinSpace space(factors);
    Face face;
    for (int i = 0; i < space.GetSize(); ++i)
    {
      BernsteinSpace::Index index = {};
      int from = 0;
      for (int v = 0; v < this->Positions.GetNumberOfVertices(); ++v)
      {
        if (this->Positions.GetFactor(v) != f || this->Positions.GetFactors()[f].Dimension > 1)
        {
          index[v] = v == vertex ? static_cast<signed char>(0) : space.GetIndex(i)[from++];
        }
      }
      if (this->Positions.GetFactors()[f].Dimension == 1)
      {
        const int other = ranges[f].first + ranges[f].second - vertex;
        index[other] = static_cast<signed char>(this->Positions.GetFactors()[f].Degree);
      }
      face.Controls.push_back(this->Positions.Find(index));
    }
    this->FaceShapes.push_back(MakeFacet(space));
    face.Shape = this->FaceShapes.back().get();
    this->Faces.push_back(std::move(face));
  }
}
}
