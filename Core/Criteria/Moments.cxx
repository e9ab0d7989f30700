// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Criteria of stretching, from the second moments of the points and of the face vectors of a cell.
#include "Criteria/Moments.h"
#include "Criteria/CriterionRows.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Clamps a value that is between 0 and 1 except for roundoff.
double LimitToOne(double value)
{
  return std::min(1.0, std::max(0.0, value));
}
}

//------------------------------------------------------------------------------
double PrincipalAspectRatio(const CellGeometry& cell)
{
  const int size = cell.GetNumberOfPoints();
  if (cell.IsZeroLength(cell.GetDiameter()))
  {
    return Null(NullReason::Degenerate);
  }
  Vector mean;
  for (int i = 0; i < size; ++i)
  {
    mean += cell.GetPoint(i);
  }
  mean = (1.0 / size) * mean;
  const bool isPolygon = (cell.GetShapes() & Polygons) != 0;
  const Vector normal =
    isPolygon && !cell.IsZeroArea(cell.GetPolygonArea()) ? Unit(cell.GetFaceVector(0)) : Vector();
  Moments moments;
  for (int i = 0; i < size; ++i)
  {
    const Vector offset = cell.GetPoint(i) - mean;
    moments.Add(offset - Dot(offset, normal) * normal);
  }
  double values[3];
  moments.GetEigenvalues(values);
  const double smallest = std::max(0.0, values[isPolygon ? 1 : 2]);
  const double ratio = std::sqrt(smallest / values[0]);
  return cell.IsZeroLength(ratio * cell.GetDiameter()) ? 0 : ratio;
}

//------------------------------------------------------------------------------
double CellIsotropy(const CellGeometry& cell)
{
  Moments moments;
  if (cell.GetShapes() & Polygons)
  {
    if (cell.IsZeroArea(cell.GetPolygonArea()))
    {
      return cell.IsZeroLength(cell.GetDiameter()) ? Null(NullReason::Degenerate) : 0;
    }
    const Vector normal = Unit(cell.GetFaceVector(0));
    const FaceRing ring(cell, 0);
    for (int i = 0; i < ring.GetSize(); ++i)
    {
      moments.Add(Cross(ring.GetEnd(i) - ring.GetBegin(i), normal));
    }
    return LimitToOne(4 * moments.Scaled(1 / moments.GetTrace()).GetSumOfMinors());
  }
  for (int f = 0; f < cell.GetTopology().GetNumberOfFaces(); ++f)
  {
    moments.Add(cell.GetFaceVector(f));
  }
  const double trace = moments.GetTrace();
  return cell.IsZeroArea(std::sqrt(trace))
    ? Null(NullReason::Degenerate)
    : LimitToOne(27 * moments.Scaled(1 / trace).GetDeterminant());
}

//------------------------------------------------------------------------------
std::vector<Criterion> MomentCriteria()
{
  return {
    CriterionRow("PrincipalAspectRatio", "Principal aspect ratio",
      "Shortest divided by longest principal axis of the vertices (square root of the ratio of the "
      "eigenvalues of their second moments; for a polygon, in its plane).")
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Needs(NeedsFaces)
      .Cells<PrincipalAspectRatio>()
      .Formula("√(λmin/λmax) of Σ (pᵢ − p̄)(pᵢ − p̄)ᵀ with p̄ the mean of the vertices; for a "
               "polygon, in its plane")
      .Degenerate("0 for a flat cell or a collinear polygon, NaN (degenerate) for a cell collapsed "
                  "to a point.")
      .Agreement("None of the compared programs reports it."),
    CriterionRow("CellIsotropy", "Cell isotropy",
      "27 det T / (tr T)^3 with T the sum of the outer products of the face vectors with "
      "themselves; 1 for the cube and all regular polyhedra, 0 for a flat cell. For a polygon, 4 "
      "det T / (tr T)^2 in its plane, with the edge normals scaled by edge length.")
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Needs(NeedsFaces)
      .Cells<CellIsotropy>()
      .Formula("27 det T / (tr T)³ with T = Σ S_f S_fᵀ over all faces; for a polygon 4 det T / (tr "
               "T)² in its plane, with edges as faces")
      .Degenerate("0 for a flat cell or a collinear polygon, NaN (degenerate) if no face has an "
                  "area or all points of a polygon coincide. Open cells have a value; inverted "
                  "cells have the same value.")
      .Agreement("OpenFOAM's cell determinant uses the same matrix of the interior faces, but "
                 "divided by their mean area: see `CellDeterminant`."),
  };
}
}
