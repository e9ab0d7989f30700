// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Criteria of the faces of a cell: flatness, warpage, concavity, and whether they close the cell.
#include "Cell/CellDefects.h"
#include "Criteria/CriterionRows.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The minimum or maximum of a measure over the faces with an area.
template <auto Measure, auto Choose>
double ChooseOfRealFaces(const CellGeometry& cell)
{
  double chosen = Null(NullReason::Degenerate);
  for (int f = 0; f < cell.GetTopology().GetNumberOfFaces(); ++f)
  {
    if (!cell.IsZeroArea(cell.GetFaceArea(f)))
    {
      const double value = Measure(cell, f);
      chosen = std::isnan(chosen) ? value : Choose(chosen, value);
    }
  }
  return chosen;
}
}

//------------------------------------------------------------------------------
double MaxWarpage(const CellGeometry& cell)
{
  return ChooseOfRealFaces<GetFaceWarpage, GetLarger>(cell);
}

//------------------------------------------------------------------------------
double MaxFaceConcavity(const CellGeometry& cell)
{
  const double largest = cell.GetMaxFaceAngle();
  return std::isnan(largest) ? largest : cell.ToAngleUnit(std::max(0.0, largest - Pi));
}

//------------------------------------------------------------------------------
double MinFaceConcavity(const CellGeometry& cell)
{
  double smallest = Null(NullReason::Degenerate);
  for (int f = 0; f < cell.GetTopology().GetNumberOfFaces(); ++f)
  {
    const double concavity = GetFaceConcavity(cell, f);
    smallest = std::isnan(smallest) ? concavity : std::min(smallest, concavity);
  }
  return cell.ToAngleUnit(smallest);
}

//------------------------------------------------------------------------------
double Openness(const CellGeometry& cell)
{
  Vector sum, total;
  for (int f = 0; f < cell.GetTopology().GetNumberOfFaces(); ++f)
  {
    const Vector& area = cell.GetFaceVector(f);
    sum += area;
    total += { std::abs(area.X), std::abs(area.Y), std::abs(area.Z) };
  }
  double largest = Null(NullReason::Degenerate);
  const auto add = [&](double part, double whole)
  {
    if (!cell.IsZeroArea(whole))
    {
      const double value = std::abs(part) / whole;
      largest = std::isnan(largest) ? value : std::max(largest, value);
    }
  };
  add(sum.X, total.X);
  add(sum.Y, total.Y);
  add(sum.Z, total.Z);
  return largest;
}

namespace
{
//------------------------------------------------------------------------------
// How far the midpoint of the next edge is beyond an edge, or that of the edge beyond the next one,
// in the plane of a polygon with a normal.
double GetConcavity(const Vector& from, const Vector& via, const Vector& to, const Vector& normal)
{
  const Vector way = 0.5 * (to - from); // from one midpoint to the other
  return std::max(
    Dot(Unit(Cross(via - from, normal)), way), Dot(Unit(Cross(to - via, normal)), -way));
}

//------------------------------------------------------------------------------
// Uses edges instead of faces; ignores edges without length.
double GetPolygonConcavity(const CellGeometry& cell)
{
  if (cell.IsZeroArea(cell.GetPolygonArea()))
  {
    return Null(NullReason::Degenerate);
  }
  const Vector normal = Unit(cell.GetFaceVector(0));
  const int* ring = cell.GetTopology().GetFace(0);
  const int size = cell.GetTopology().GetFaceSize(0);
  // Begin and end of the previous edge with a length, initially the last one before the first
  // point.
  Vector begin, end = cell.GetPoint(ring[0]);
  double largest = -Infinity;
  int edges = 0;
  for (int i = 1; i < 2 * size; ++i)
  {
    const Vector& next = cell.GetPoint(ring[i % size]);
    if (cell.IsZeroLength(Norm(Cross(next - end, normal))))
    {
      continue;
    }
    if (++edges > 1)
    {
      largest = std::max(largest, GetConcavity(begin, end, next, normal));
    }
    begin = end;
    end = next;
  }
  return cell.IsZeroLength(std::abs(largest)) ? 0 : largest / cell.GetDiameter();
}
}

//------------------------------------------------------------------------------
double CellConcavity(const CellGeometry& cell)
{
  if (cell.GetShapes() & Polygons)
  {
    return GetPolygonConcavity(cell);
  }
  if (std::isnan(cell.GetVolume()))
  {
    return cell.GetVolume();
  }
  // An inverted standard cell is evaluated with correct orientation.
  const double sign = cell.GetVolume() < 0 ? -1 : 1;
  double largest = -Infinity;
  for (const CellTopology::Edge& edge : cell.GetTopology().Edges)
  {
    for (const int side : { 0, 1 })
    {
      const int own = edge.Faces[side], other = edge.Faces[1 - side];
      if (other >= 0 && own >= 0 && !cell.IsZeroArea(cell.GetFaceArea(own)))
      {
        const Vector offset = cell.GetFaceCenter(other) - cell.GetFaceCenter(own);
        largest =
          std::max(largest, sign * Dot(cell.GetFaceVector(own), offset) / cell.GetFaceArea(own));
      }
    }
  }
  const double diameter = cell.GetDiameter();
  if (std::isinf(largest) || cell.IsZeroLength(diameter))
  {
    return Null(NullReason::Degenerate);
  }
  return cell.IsZeroLength(std::abs(largest)) ? 0 : largest / diameter;
}

//------------------------------------------------------------------------------
std::vector<Criterion> FaceCriteria()
{
  return {
    CriterionRow("MinFaceFlatness", "Minimum face flatness",
      "Magnitude of the vector area of a face divided by the total area of the triangles about its "
      "center, the minimum over all faces; 1 is planar.")
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Acceptable(0.8, Infinity, CheckMesh, Cited, Polyhedra)
      .Needs(NeedsFaces)
      .Cells<ChooseOfRealFaces<GetFaceFlatness, GetSmaller>>()
      .Formula("min(1, |S| / Σ ±½|(pᵢ − c) × (pᵢ₊₁ − c)|) of a face, signs as for `SurfaceArea`; "
               "the minimum over the faces")
      .Degenerate("1 for triangles; 0 for self-intersecting faces whose triangles cancel. "
                  "Collapsed faces are skipped; NaN (degenerate) if no face has an area.")
      .Agreement("Same as checkMesh's face flatness, except that OpenFOAM treats planar non-convex "
                 "faces as warped.")
      .Consequence("warped faces: their area and flux depend on how they are split"),
    CriterionRow("MaxFaceFlatness", "Maximum face flatness",
      "Flatness, as in `MinFaceFlatness`, of the flattest face.")
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Needs(NeedsFaces)
      .Cells<ChooseOfRealFaces<GetFaceFlatness, GetLarger>>()
      .Formula("as `MinFaceFlatness`, the maximum over the faces")
      .Degenerate("As `MinFaceFlatness`.")
      .Agreement("None of the compared programs reports it per cell."),
    CriterionRow("MaxWarpage", "Maximum warpage",
      "Maximum distance of a vertex from the mean plane of its face, divided by the maximum "
      "distance of a vertex from the center of that face.")
      .Range(0, Infinity)
      .Ideal(0, Better::Smaller)
      .Acceptable(
        -Infinity, 0.1, "planarity limit of VTK's Validate Cells", Hint, PolygonsAndPolyhedra)
      .Needs(NeedsFaces)
      .Cells<MaxWarpage>()
      .Formula("max |n · (pᵢ − c)| / max |pᵢ − c| of a face; the maximum over the faces")
      .Degenerate(
        "0 for triangles. Collapsed faces are skipped; NaN (degenerate) if no face has an area.")
      .Agreement("VTK's Validate Cells (from 9.6) uses this measure to find nonplanar faces. "
                 "Verdict's warpage is a different measure, of the normals at opposite corners.")
      .Consequence("warped faces: area and flux depend on how they are split"),
    CriterionRow(
      "MinWarpage", "Minimum warpage", "Warpage, as in `MaxWarpage`, of the least warped face.")
      .Range(0, Infinity)
      .Ideal(0, Better::Smaller)
      .Needs(NeedsFaces)
      .Cells<ChooseOfRealFaces<GetFaceWarpage, GetSmaller>>()
      .Formula("as `MaxWarpage`, the minimum over the faces")
      .Degenerate("As `MaxWarpage`.")
      .Agreement("None of the compared programs reports it per cell."),
    CriterionRow("MaxFaceConcavity", "Maximum face concavity",
      "How far the maximum interior angle of a face exceeds 180 degrees; 0 for convex faces.")
      .Unit(Unit::Angle)
      .Range(0, 180)
      .Ideal(0, Better::Smaller)
      .Acceptable(
        -Infinity, 80, "OpenFOAM's maxConcave; checkMesh reports from 10", Cited, Polyhedra)
      .Needs(NeedsFaces | NeedsCorners)
      .Cells<MaxFaceConcavity>()
      .Formula(
        "max(0, θmax − 180°) with θmax as for `MaxInteriorAngle`; the maximum over the faces")
      .Degenerate("0 for a collinear triangle. Faces without an angle are skipped; NaN "
                  "(degenerate) if none has one.")
      .Agreement("The angle that OpenFOAM's maxConcave limits.")
      .Consequence("strongly concave faces: their center may be outside"),
    CriterionRow("MinFaceConcavity", "Minimum face concavity",
      "Concavity, as in `MaxFaceConcavity`, of the least concave face; 0 if any face is convex.")
      .Unit(Unit::Angle)
      .Range(0, 180)
      .Ideal(0, Better::Smaller)
      .Needs(NeedsFaces | NeedsCorners)
      .Cells<MinFaceConcavity>()
      .Formula("as `MaxFaceConcavity`, the minimum over the faces")
      .Degenerate("As `MaxFaceConcavity`.")
      .Agreement("None of the compared programs reports it per cell."),
    CriterionRow("CellConcavity", "Cell concavity",
      "Maximum distance of the center of a face outside the plane of an adjacent face (for a "
      "polygon: of the midpoint of an edge beyond an adjacent edge), divided by the diameter; at "
      "most 0 for convex cells.")
      .Range(-Infinity, Infinity)
      .Ideal(None, Better::Smaller)
      .Cost(Cost::Edges)
      .Needs(NeedsEdges | NeedsFaces | NeedsVolume)
      .Cells<CellConcavity>()
      .Formula("max of n_f · (c_g − c_f) / h over the pairs of faces f, g with a common edge; for "
               "a polygon, over the pairs of edges with a common vertex")
      .Degenerate("0 for a flat cell; above 1 if the center of a self-intersecting face is far "
                  "outside. NaN (degenerate) if no face, or the polygon, has an area; NaN (invalid "
                  "topology) for an open cell. Inverted cells have the same value.")
      .Agreement("None of the compared programs reports it; VTK's Validate Cells reports only "
                 "whether a cell is convex."),
    CriterionRow("Openness", "Openness",
      "Maximum over the axes of the absolute sum of a component of the face vectors, divided by "
      "the sum of its absolute values; 0 if the faces close the cell.")
      .Shapes(Polyhedra)
      .Range(0, 1)
      .Ideal(0, Better::Smaller)
      .Acceptable(-Infinity, 1e-6, CheckMesh, Cited, Polyhedra)
      .Cost(Cost::Edges)
      .Needs(NeedsFaces | NeedsVolume)
      .Cells<Openness>()
      .Formula("max over x, y, z of |Σ S_f,i| / Σ |S_f,i|")
      .Degenerate("1 for a cube without one face; NaN (degenerate) if no face has an area. Not "
                  "defined for polygons, which are always closed.")
      .Agreement("Same as checkMesh's \"cell openness\", which it prints for the worst cell.")
      .Consequence("faces do not close the cell: finite-volume schemes are not conservative"),
  };
}
}
