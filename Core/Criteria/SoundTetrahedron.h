// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::SoundTetrahedron
 * @brief A VTK_TETRA in which nothing is collapsed, flat, huge or not a number.
 *
 * Has those members of CellGeometry that need the points only, with the same values to the last bit: a criterion
 * that is a template of its cell is evaluated here many times faster. Makes no topology.
 */
#ifndef camaron_SoundTetrahedron_h
#define camaron_SoundTetrahedron_h

#include "Criteria/CellGeometry.h"

#include <algorithm> // for extremes
#include <cmath>     // for roots

namespace camaron
{
class SoundTetrahedron
{
public:
  /// False if the cell is something else, or so close to it that CellGeometry has to tell.
  bool Load(const MeshView& mesh, vtkIdType cell, const EvaluationOptions& options)
  {
    if (mesh.GetCellType(cell) != VTK_TETRA)
    {
      return false;
    }
    const IndexRange ids = mesh.GetCellPoints(cell);
    const Vector origin = GetPlace(mesh, ids[0]);
    for (int i = 1; i < 4; ++i)
    {
      this->Points[i] = GetPlace(mesh, ids[i]) - origin;
    }
    const Vector &a = this->Points[1], &b = this->Points[2], &c = this->Points[3];
    this->Volume = Dot(a, Cross(b, c)) / 6;
    // In the order of the edges of CellTopology.
    this->SquaredLengths[0] = Norm2(a);
    this->SquaredLengths[1] = Norm2(c - a);
    this->SquaredLengths[2] = Norm2(c);
    this->SquaredLengths[3] = Norm2(b - a);
    this->SquaredLengths[4] = Norm2(c - b);
    this->SquaredLengths[5] = Norm2(b);
    // Of two numbers at a time, so that nothing branches on which is smaller.
    const double* square = this->SquaredLengths;
    this->MinSquaredLength = std::min(std::min(std::min(square[0], square[1]), std::min(square[2], square[3])),
      std::min(square[4], square[5]));
    this->MaxSquaredLength = std::max(std::max(std::max(square[0], square[1]), std::max(square[2], square[3])),
      std::max(square[4], square[5]));
    // A volume well above zero leaves no room for an edge or a face that is zero.
    const double diameter = std::sqrt(this->MaxSquaredLength);
    const double largest = std::abs(origin.X) + std::abs(origin.Y) + std::abs(origin.Z) + diameter;
    const double zero =
      GetZeroLength(options, diameter, GetAbsoluteTolerance(largest, mesh.HasFloatPoints()));
    constexpr double margin = 2;
    return std::abs(this->Volume) > margin * zero * diameter * diameter && diameter > SmallestSize &&
      diameter < LargestSize;
  }

  const Vector& GetPoint(int point) const { return this->Points[point]; }
  double GetVolume() const { return this->Volume; }
  double GetDiameter() const { return this->GetMaxEdgeLength(); }
  int GetNumberOfEdges() const { return 6; }
  double GetMinEdgeLength() const { return std::sqrt(this->MinSquaredLength); }
  double GetMaxEdgeLength() const { return std::sqrt(this->MaxSquaredLength); }
  double GetSumOfSquaredLengths() const
  {
    const double* square = this->SquaredLengths;
    return square[0] + square[1] + square[2] + square[3] + square[4] + square[5];
  }
  double GetTotalEdgeLength() const
  {
    double sum = 0;
    for (const double square : this->SquaredLengths)
    {
      sum += std::sqrt(square);
    }
    return sum;
  }
  double GetSurfaceArea() const
  {
    const Vector* p = this->Points;
    const auto getArea = [](const Vector& a, const Vector& b, const Vector& c)
    { return Norm(0.5 * Cross(b - a, c - a)); };
    return getArea(p[0], p[1], p[3]) + getArea(p[1], p[2], p[3]) + getArea(p[2], p[0], p[3]) +
      getArea(p[0], p[2], p[1]);
  }

  ///@{
  /// Nothing is.
  bool IsZeroLength(double) const { return false; }
  bool IsZeroArea(double) const { return false; }
  bool IsZeroVolume(double) const { return false; }
  ///@}

private:
  static constexpr double SmallestSize = 1e-20, LargestSize = 1e20; // products of ten lengths are numbers

  static Vector GetPlace(const MeshView& mesh, vtkIdType point)
  {
    double x[3];
    mesh.GetPoint(point, x);
    return { x[0], x[1], x[2] };
  }

  Vector Points[4]; // the first one stays the origin
  double SquaredLengths[6];
  double MinSquaredLength = 0, MaxSquaredLength = 0;
  double Volume = 0;
};
}

#endif
