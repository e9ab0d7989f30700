// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellMap
 * @brief The polynomial map of one cell from its parametric domain to space, and what follows from
 * it: guaranteed bounds of its Jacobian determinant, exact sizes, lengths and areas.
 *
 * Linear cells have one as well: that of a quadrilateral is bilinear. A cell of higher order is
 * straight if its nodes are where those of the linear cell with its corners would be.
 *
 * Coordinates are relative to the first node, in units of 2^exponent. Load() reuses all memory.
 */
#ifndef camaron_CellMap_h
#define camaron_CellMap_h

#include "Base/Vector.h"
#include "Curved/BernsteinSpace.h"
#include "Curved/CollapsedShape.h"
#include "Curved/ParametricShape.h"
#include "Mesh/MeshView.h"

#include <optional> // for what is computed on demand
#include <vector>   // for nodes and control points

namespace camaron
{
class CellMap
{
public:
  ///@{
  /// Loads a cell of a mesh, or a linear cell with these nodes. False if it has no map: polygons,
  /// polyhedra, rational cells, and those of degrees greater than ParametricShape::MaxDegree.
  bool Load(const MeshView& mesh, vtkIdType cell, int exponent);
  bool Load(unsigned char type, const Vector* nodes, int numberOfNodes);
  ///@}
  /// The map of a loaded cell of a mesh that lists corners more than once becomes that of what
  /// remains of it; false if its nodes are not those of what remains. See CollapsedShape.
  bool Collapse(ParametricShape::Domain remaining, const CollapsedShape::Corners& corners);
  /// Whether a cell of higher order has a map.
  static bool IsMapped(const MeshView& mesh, vtkIdType cell);

  const ParametricShape& GetShape() const { return *this->Shape; }
  /// How the nodes of that shape follow from those of a collapsed cell; nullptr for others.
  const CollapsedShape* GetCollapsed() const { return this->Collapsed; }
  /// Whether it is not straight.
  bool IsCurved() const { return this->Curved; }

  /**
   * Bounds of the Jacobian determinant, times the measure of the parametric domain, so that they
   * are the volume or area of a cell whose determinant is constant. That of a surface is positive
   * where it has the direction of @a normal, a unit vector.
   */
  const PolynomialBounds& GetJacobian(const Vector& normal) const;

  /// Whether the determinant is positive everywhere by its coefficients, which takes less time;
  /// false does not mean that it is not.
  bool IsSurelyPositive(const Vector& normal) const;

  /// Volume of a 3D cell.
  double GetVolume() const;
  /// The center of the volume of a 3D cell, or of the area of a 2D cell, as seen along @a normal;
  /// nothing if these are zero.
  std::optional<Vector> GetCentroid(const Vector& normal) const;
  /// Area of a 2D cell, or of the faces of a 3D cell.
  double GetArea() const;
  /// Area as a vector of a 2D cell.
  Vector GetVectorArea() const;
  int GetNumberOfEdges() const { return static_cast<int>(this->Shape->Edges.size()); }
  double GetEdgeLength(int edge) const;

  ///@{
  /**
   * Minimum over the points of the regular lattice of the cell's degree: of the inverse condition
   * number, relative to the ideal cell, and of the determinant divided by the greatest product of
   * the lengths of tangents of adjacent edges, which is 1 for the ideal cell. Negative where the
   * determinant is.
   */
  double GetMinInverseCondition(const Vector& normal) const;
  double GetMinScaledJacobian(const Vector& normal) const;
  ///@}

  ///@{
  /// Maximum over the edges of the distance of their middle from that of their ends along the
  /// edge, and from the line between the ends, both relative to the distance of the ends; infinite
  /// if an edge with a middle elsewhere has coincident ends.
  double GetMaxOffsetAlongEdge() const;
  double GetMaxOffsetFromEdge() const;
  ///@}

private:
  bool Choose(unsigned char type, int numberOfNodes, const CellDegrees& degrees);
  void SetControls(double tolerance);
  void ComputeJacobian(const Vector& normal) const;
  void ComputeCross(const ParametricShape& shape, const Vector* controls) const;
  double ComputeArea(const ParametricShape& shape, const Vector* controls) const;
  template <typename Measure>
  double GetLeastSample(Measure&& measure) const;
  template <typename Measure>
  double GetMostOfEdges(Measure&& measure) const;

  const ParametricShape* Shape = nullptr;
  const CollapsedShape* Collapsed = nullptr;
  const ParametricShape* Known = nullptr; ///< of this type, with these nodes and degrees
  unsigned char Type = 0;
  CellDegrees Degrees = {};
  int NumberOfNodes = 0;
  bool Curved = false;
  double Tolerance = 0; ///< below which nodes are at the same place
  mutable bool HasDeterminant = false;
  std::vector<Vector> Nodes, Remaining, Controls;
  mutable std::vector<Vector> Derivatives[3], Cross, FaceControls;
  mutable std::vector<double> Determinant;
  mutable std::optional<PolynomialBounds> Jacobian;
  mutable BoundFinder Finder;
};
}

#endif
