// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ParametricShape
 * @brief How the nodes of a type of cells map its parametric domain to space.
 *
 * The map is a polynomial, given by its control points. Those of a type follow from the functions
 * with which VTK interpolates between its nodes, whatever their order is in a version of VTK. Only
 * for VTK_QUADRATIC_PYRAMID, whose nodes determine no map, are they those of Bedrosian (Int. J.
 * Numer. Meth. Eng. 35 (1992), 95-108), as in finite element programs.
 *
 * A pyramid is a collapsed hexahedron: the third coordinate q is 0 at the apex, and derivatives by
 * the first two are divided by q, so that its Jacobian determinant is a polynomial as well.
 */
#ifndef camaron_ParametricShape_h
#define camaron_ParametricShape_h

#include "Base/Vector.h"
#include "Curved/BernsteinSpace.h"

#include <array>   // for directions
#include <cstddef> // for indices
#include <memory>  // for the shapes of facets
#include <mutex>   // for what is made on first use
#include <utility> // for weights
#include <vector>  // for tables

namespace camaron
{
/// Degrees of the map of a cell along its parametric coordinates.
using CellDegrees = std::array<int, 3>;

class ParametricShape
{
public:
  /// The greatest degree of cells with a map.
  static constexpr int MaxDegree = 4;

  enum class Domain
  {
    Line,
    Triangle,
    Quadrilateral,
    Tetrahedron,
    Hexahedron,
    Wedge,
    Pyramid,
    None
  };

  /// The shape of a type of cells with so many nodes; @a degrees are those of the attribute
  /// HigherOrderDegrees, 0 without. nullptr if there is none: polygons, polyhedra, cells of greater
  /// degree, parametric cells. Thread-safe; keep the result.
  static const ParametricShape* Find(
    unsigned char type, int numberOfNodes, const CellDegrees& degrees);
  /// Whether there is one.
  static bool Exists(unsigned char type, int numberOfNodes, const CellDegrees& degrees);

  /// Nodes, and their weights, at the point of the parametric domain that is a combination of
  /// corners; of a pyramid, of one that is not collapsed.
  std::vector<std::pair<int, double>> GetWeights(
    const std::vector<std::pair<int, double>>& corners) const;

  /// A line or surface with control points of its own.
  static std::unique_ptr<ParametricShape> MakeFacet(const BernsteinSpace& positions);

  /// A linear combination.
  struct Row
  {
    std::vector<int> Places;
    std::vector<double> Weights;
    Vector Combine(const Vector* points) const
    {
      Vector sum;
      for (std::size_t i = 0; i < this->Places.size(); ++i)
      {
        sum += this->Weights[i] * points[this->Places[i]];
      }
      return sum;
    }
  };

  /// A derivative in the direction of a parametric coordinate: the differences of control points.
  struct Derivative
  {
    struct Term
    {
      int Plus, Minus;
      double Factor;
    };
    BernsteinSpace Space;
    std::vector<Term> Terms; ///< of each coefficient
  };

  /// A point where the map is sampled, by control points.
  struct Sample
  {
    std::array<std::vector<double>, 3> Weights; ///< of derivatives
  };

  Domain Form = Domain::None;
  int Dimension = 0, NumberOfNodes = 0, NumberOfCorners = 0;
  BernsteinSpace Positions;
  std::vector<Row> Controls; ///< from nodes; one node with weight 1 where these are the same
  /// From corners: those of a cell with straight edges and bilinear faces.
  std::vector<Row> StraightControls;
  std::vector<Derivative> Derivatives; ///< one per dimension
  /// Of the last two derivatives, and of the first one and that product. The Jacobian determinant
  /// is a coefficient of the last one's space; for surfaces and lines, there is only the former or
  /// none.
  BernsteinProduct CrossProduct, TripleProduct;
  const BernsteinSpace& GetJacobianSpace() const
  {
    return this->Dimension == 3 ? this->TripleProduct.Space
      : this->Dimension == 2    ? this->CrossProduct.Space
                                : this->Derivatives[0].Space;
  }
  std::vector<double> Integral; ///< weights of the coefficients of the determinant
  /// The integral of position times determinant: each term is the weight of a control point A and a
  /// coefficient B of the determinant. Made on first use; thread-safe.
  const std::vector<BernsteinProduct::Term>& GetMoments() const;
  double Measure = 1; ///< of the parametric domain
  /// -1 if the determinant is negative in a cell whose faces are oriented outward by VTK's order.
  double Sign = 1;
  /// Inverse of the derivatives of the ideal cell: K = J W.
  std::array<Vector, 3> IdealInverse;
  std::vector<Sample> Samples; ///< the points of a regular lattice

  std::vector<std::vector<int>> Edges; ///< control points of each
  struct Face
  {
    std::vector<int> Controls;
    const ParametricShape* Shape;
  };
  std::vector<Face> Faces; ///< of 3D cells

private:
  static std::unique_ptr<ParametricShape> Make(
    unsigned char type, int numberOfNodes, const CellDegrees& degrees);
  void SetUp();
  void AddControls(unsigned char type, const CellDegrees& degrees);
  void AddStraightControls();
  void AddDerivatives();
  void AddIntegral();
  std::vector<double> GetIntegral(const BernsteinSpace& space) const;
  void AddIdeal(unsigned char type);
  void AddSamples();
  void AddEdges();
  void AddFaces();

  std::vector<int> CornerOfControl; ///< the number of a corner, or -1
  std::vector<std::unique_ptr<ParametricShape>> FaceShapes;
  mutable std::once_flag HasMoments;
  mutable std::vector<BernsteinProduct::Term> Moments;
};
}

#endif
