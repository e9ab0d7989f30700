// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Finite-volume criteria of a cell and its neighbors, as defined by OpenFOAM's checkMesh and
// Fluent.
#include "Cell/FacetMeasures.h"
#include "Criteria/CriterionRows.h"
#include "Criteria/Moments.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
using Facet = CellNeighborhood::Facet;
using Side = CellNeighborhood::Side;

//------------------------------------------------------------------------------
// The minimum or maximum of the values of facets, or why there is none. If a neighbor in another
// piece is unknown, it might be more extreme, so the result is undefined.
template <auto Choose>
class Extreme
{
public:
  void Add(double value)
  {
    if (!std::isnan(value))
    {
      this->Value = this->IsEmpty ? value : Choose(value, this->Value);
      this->IsEmpty = false;
    }
    else
    {
      this->Reason = NullReason::Degenerate;
    }
  }
  void AddMissing() { this->IsMissing = true; }
  void AddNonManifold()
  {
    this->Reason =
      this->Reason == NullReason::NoNeighbor ? NullReason::InvalidTopology : this->Reason;
  }
  double Get() const
  {
    return this->IsMissing ? Null(NullReason::MissingGhosts)
      : this->IsEmpty      ? Null(this->Reason)
                           : this->Value;
  }

private:
  double Value = 0;
  bool IsEmpty = true;
  bool IsMissing = false;
  NullReason Reason = NullReason::NoNeighbor;
};

//------------------------------------------------------------------------------
enum Sides : unsigned
{
  Inner = 1u, ///< facets with a cell on the other side
  AtBoundary = 2u
};

//------------------------------------------------------------------------------
// The minimum or maximum of measure(facet) over the facets on some Sides.
template <auto Choose, typename Measure>
double ExtremeOfFacets(const CellNeighborhood& cell, unsigned sides, Measure&& measure)
{
  Extreme<Choose> extreme;
  for (const Facet& facet : cell.GetFacets())
  {
    if ((facet.Other == Side::Cell && (sides & Inner)) ||
      (facet.Other == Side::Boundary && (sides & AtBoundary)))
    {
      extreme.Add(measure(facet));
    }
    else if (facet.Other == Side::Missing)
    {
      extreme.AddMissing();
    }
    else if (facet.Other == Side::NonManifold && (sides & Inner))
    {
      extreme.AddNonManifold();
    }
  }
  return extreme.Get();
}

//------------------------------------------------------------------------------
template <auto Choose>
double NonOrthogonality(const CellNeighborhood& cell)
{
  const double lean =
    ExtremeOfFacets<Choose>(cell, Inner, [&](const Facet& facet) { return GetLean(cell, facet); });
  return cell.GetGeometry().ToAngleUnit(GetAngleOfLean(lean));
}

//------------------------------------------------------------------------------
template <auto Choose>
double BoundaryNonOrthogonality(const CellNeighborhood& cell)
{
  return cell.GetGeometry().ToAngleUnit(ExtremeOfFacets<Choose>(cell, AtBoundary,
    [&](const Facet& facet) { return GetBoundaryNonOrthogonality(cell, facet); }));
}

//------------------------------------------------------------------------------
template <auto Choose>
double FaceSkewness(const CellNeighborhood& cell)
{
  return ExtremeOfFacets<Choose>(
    cell, Inner | AtBoundary, [&](const Facet& facet) { return GetFaceSkewness(cell, facet); });
}

//------------------------------------------------------------------------------
template <auto Choose>
double FaceWeight(const CellNeighborhood& cell)
{
  return ExtremeOfFacets<Choose>(
    cell, Inner, [&](const Facet& facet) { return GetFaceWeight(cell, facet); });
}

//------------------------------------------------------------------------------
template <auto Choose>
double VolumeRatio(const CellNeighborhood& cell)
{
  if (std::isnan(cell.GetSize()))
  {
    return cell.GetSize();
  }
  return ExtremeOfFacets<Choose>(
    cell, Inner, [&](const Facet& facet) { return GetVolumeRatio(cell, facet); });
}

//------------------------------------------------------------------------------
double CellVolumeRatio(const CellNeighborhood& cell)
{
  const double ratio = VolumeRatio<GetSmaller>(cell);
  return std::isnan(ratio) ? ratio : ratio > 0 ? 1 / ratio : Infinity;
}

//------------------------------------------------------------------------------
double OrthogonalQuality(const CellNeighborhood& cell)
{
  Extreme<GetSmaller> extreme;
  for (const Facet& facet : cell.GetFacets())
  {
    // A vector without length makes the quality 0.
    const auto getCosine = [&](double product, double length)
    {
      const bool isZero = facet.IsZero || cell.GetGeometry().IsZeroLength(length);
      return isZero ? 0 : product / (facet.Size * length);
    };
    extreme.Add(getCosine(facet.AreaByWay, facet.WayLength));
    if (facet.Other == Side::Cell)
    {
      extreme.Add(getCosine(facet.AreaByLine, facet.LineLength));
    }
    else if (facet.Other == Side::Missing)
    {
      extreme.AddMissing();
    }
  }
  return extreme.Get();
}

//------------------------------------------------------------------------------
double CellDeterminant(const CellNeighborhood& cell)
{
  double mean = 0;
  int count = 0;
  for (const Facet& facet : cell.GetFacets())
  {
    if (facet.Other == Side::Missing)
    {
      return Null(NullReason::MissingGhosts);
    }
    if (facet.Other == Side::Cell)
    {
      mean += facet.Size;
      ++count;
    }
  }
  const CellGeometry& geometry = cell.GetGeometry();
  const bool isPolygon = (geometry.GetShapes() & Polygons) != 0;
  if (count == 0 ||
    (isPolygon ? geometry.IsZeroLength(mean / count) : geometry.IsZeroArea(mean / count)))
  {
    return 0;
  }
  mean /= count;
  Moments moments;
  for (const Facet& facet : cell.GetFacets())
  {
    if (facet.Other == Side::Cell)
    {
      moments.Add({ facet.Area.X / mean, facet.Area.Y / mean, facet.Area.Z / mean });
    }
  }
  constexpr double ofSquare = 4, ofCube = 8;
  return isPolygon ? moments.GetSumOfMinors() / ofSquare : moments.GetDeterminant() / ofCube;
}
}

//------------------------------------------------------------------------------
std::vector<Criterion> FiniteVolumeCriteria()
{
  return {
    CriterionRow("MaxNonOrthogonality", "Maximum non-orthogonality",
      "Maximum angle between the normal of a face and the line from the centroid of the cell to "
      "that of the neighbor; above 90, the centroids are on the wrong sides.")
      .Unit(Unit::Angle)
      .Range(0, 180)
      .Ideal(0, Better::Smaller)
      .Acceptable(
        -Infinity, 70, "OpenFOAM checkMesh; maxNonOrtho of snappyHexMesh is 65", Cited, Polyhedra)
      .Neighbors(NonOrthogonality<GetLarger>)
      .Formula("∠(d, S) with d = N − P, from the centroid P of the cell to that of the neighbor N; "
               "the maximum over the interior faces")
      .Degenerate(
        "NaN (no neighbor) for a cell without neighbors. Collapsed faces, coincident centroids and "
        "neighbors with nonfinite coordinates are skipped; NaN (degenerate) if nothing remains.")
      .Agreement("Same as checkMesh for planar convex faces, to the digits it prints. Fluent "
                 "reports the cosine: see `OrthogonalQuality`.")
      .Consequence("finite-volume schemes need correctors, or diverge"),
    CriterionRow("MinNonOrthogonality", "Minimum non-orthogonality",
      "Minimum angle between the normal of a face and the line from the centroid of the cell to "
      "that of the neighbor: the value of the best face.")
      .Unit(Unit::Angle)
      .Range(0, 180)
      .Ideal(0, Better::Smaller)
      .Neighbors(NonOrthogonality<GetSmaller>)
      .Formula("as `MaxNonOrthogonality`, the minimum over the interior faces")
      .Degenerate("As `MaxNonOrthogonality`.")
      .Agreement("None of the compared programs reports it per cell."),
    CriterionRow("MaxBoundaryNonOrthogonality", "Maximum non-orthogonality at the boundary",
      "Maximum angle between the normal of a boundary face and the line from the centroid of the "
      "cell to the center of that face.")
      .Unit(Unit::Angle)
      .Range(0, 180)
      .Ideal(0, Better::Smaller)
      .Neighbors(BoundaryNonOrthogonality<GetLarger>)
      .Formula("∠(c_f − P, S); the maximum over the boundary faces")
      .Degenerate("90 for a flat tetrahedron, above 90 for an inverted cell. NaN (no neighbor) for "
                  "a cell without boundary faces, NaN (degenerate) if all of them are collapsed.")
      .Agreement("checkMesh ignores boundary faces."),
    CriterionRow("MinBoundaryNonOrthogonality", "Minimum non-orthogonality at the boundary",
      "Minimum angle between the normal of a boundary face and the line from the centroid of the "
      "cell to the center of that face: the value of the best face.")
      .Unit(Unit::Angle)
      .Range(0, 180)
      .Ideal(0, Better::Smaller)
      .Neighbors(BoundaryNonOrthogonality<GetSmaller>)
      .Formula("as `MaxBoundaryNonOrthogonality`, the minimum over the boundary faces")
      .Degenerate("NaN as for `MaxBoundaryNonOrthogonality`.")
      .Agreement("None of the compared programs reports it per cell."),
    CriterionRow("MaxFaceSkewness", "Maximum face skewness",
      "Maximum distance between the center of a face and the point where the line to the "
      "neighbor's centroid crosses the face, relative to the size of the face in that direction; "
      "at the boundary, the cell is mirrored.")
      .Range(0, Infinity)
      .Ideal(0, Better::Smaller)
      .Acceptable(-Infinity, 4, "OpenFOAM checkMesh; meshQualityDict allows 20 at the boundary",
        Cited, Polyhedra)
      .Neighbors(FaceSkewness<GetLarger>)
      .Formula("|s|/δ with s = w − (S · w)/(S · d) d, w = c_f − P, δ = max(0.2 |d|, max |ŝ · (p − "
               "c_f)| over the points of the face); at the boundary d = n (n · w) and 0.4 instead "
               "of 0.2; the maximum over the faces")
      .Degenerate(
        "Infinite if d lies in the plane of the face, as for a flat cell. Collapsed faces are "
        "skipped; NaN (degenerate) if all are collapsed. Inverted cells have the same value.")
      .Agreement("Same as checkMesh for planar convex faces, to the digits it prints. Fluent, Gmsh "
                 "and Verdict define skewness differently.")
      .Consequence("finite-volume schemes interpolate to the wrong point of the face"),
    CriterionRow("MinFaceSkewness", "Minimum face skewness",
      "Minimum skewness, as in `MaxFaceSkewness`, of the faces of the cell: the value of the best "
      "face.")
      .Range(0, Infinity)
      .Ideal(0, Better::Smaller)
      .Neighbors(FaceSkewness<GetSmaller>)
      .Formula("as `MaxFaceSkewness`, the minimum over the faces")
      .Degenerate("Infinite if d lies in the plane of every face; else as `MaxFaceSkewness`.")
      .Agreement("None of the compared programs reports it per cell."),
    CriterionRow("MinFaceWeight", "Minimum face weight",
      "The smaller of the distances of a face from the two centroids, along its normal, divided by "
      "their sum; the minimum over the interior faces.")
      .Range(0, 0.5)
      .Ideal(0.5, Better::Bigger)
      .Acceptable(0.05, Infinity, "OpenFOAM's minFaceWeight", Cited, Polyhedra)
      .Neighbors(FaceWeight<GetSmaller>)
      .Formula("min(a, b)/(a + b) with a = |S · (c_f − P)|, b = |S · (N − c_f)|; the minimum over "
               "the interior faces")
      .Degenerate("As `MaxNonOrthogonality`; 0 if a centroid lies in the plane of the face.")
      .Agreement("Same as checkMesh's \"face interpolation weight\" for planar convex faces, to "
                 "the digits it prints.")
      .Consequence("finite-volume schemes interpolate almost from one side"),
    CriterionRow("MaxFaceWeight", "Maximum face weight",
      "Maximum weight, as in `MinFaceWeight`, of the interior faces of the cell: the value of the "
      "best face.")
      .Range(0, 0.5)
      .Ideal(0.5, Better::Bigger)
      .Neighbors(FaceWeight<GetLarger>)
      .Formula("as `MinFaceWeight`, the maximum over the interior faces")
      .Degenerate(
        "NaN as for `MinFaceWeight`; 0 if a centroid lies in the plane of every interior face.")
      .Agreement("None of the compared programs reports it per cell."),
    CriterionRow("MinVolumeRatio", "Minimum volume ratio",
      "Ratio of the smaller to the larger of the volumes (areas) of the cell and a neighbor; the "
      "worst neighbor counts.")
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Acceptable(0.01, Infinity, "OpenFOAM's minVolRatio", Cited, Polyhedra)
      .Neighbors(VolumeRatio<GetSmaller>)
      .Formula("min(V_P, V_N) / max(V_P, V_N); the minimum over the neighbors")
      .Degenerate("0 if either cell is flat or inverted; NaN (no neighbor) without neighbors, NaN "
                  "(invalid topology) for an open cell.")
      .Agreement("Same as checkMesh's \"face volume ratio\", to the digits it prints.")
      .Consequence("abrupt changes of size: finite-volume gradients lose accuracy"),
    CriterionRow("MaxVolumeRatio", "Maximum volume ratio",
      "Ratio of the smaller to the larger of the volumes (areas) of the cell and a neighbor; the "
      "best neighbor counts.")
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Neighbors(VolumeRatio<GetLarger>)
      .Formula("min(V_P, V_N) / max(V_P, V_N); the maximum over the neighbors")
      .Degenerate(
        "NaN as for `MinVolumeRatio`; 0 if the cell or all its neighbors are flat or inverted.")
      .Agreement("None of the compared programs reports it per cell."),
    CriterionRow("CellVolumeRatio", "Size growth",
      "Ratio of the larger to the smaller of the volumes (areas) of the cell and a neighbor; the "
      "worst neighbor counts.")
      .Range(1, Infinity)
      .Ideal(1, Better::Smaller)
      .Acceptable(
        -Infinity, 2, "common practice for transitions; 1.2 in layers", Hint, SimplePolyhedra)
      .Neighbors(CellVolumeRatio)
      .Formula("1 / MinVolumeRatio")
      .Degenerate(
        "Infinite if the cell or a neighbor is flat or inverted; NaN as for `MinVolumeRatio`.")
      .Agreement(
        "Growth rates of Fluent and other programs are defined for layers, often by lengths.")
      .Consequence("abrupt changes of size; intended where cells are refined by halving"),
    CriterionRow("OrthogonalQuality", "Orthogonal quality",
      "Minimum cosine of the angles between the normal of a face and the lines from the centroid "
      "of the cell to the center of the face and to the neighbor's centroid, as in Fluent.")
      .Range(-1, 1)
      .Ideal(1, Better::Bigger)
      .Acceptable(0.1, Infinity, "Fluent practice; 0.01 at least", Hint, Polyhedra)
      .Neighbors(OrthogonalQuality)
      .Formula("min over the faces of n · ŵ and, for interior faces, n · d̂, with w = c_f − P and d "
               "= N − P")
      .Degenerate("0 if a face is collapsed or a centroid lies on a face; negative for an inverted "
                  "cell (−1 at best alignment).")
      .Agreement("Fluent's definition for polyhedra and hexahedra; for tetrahedra, wedges and "
                 "pyramids, Fluent includes 1 minus the skewness in the minimum.")
      .Consequence("finite-volume diffusive fluxes lose accuracy"),
    CriterionRow("CellDeterminant", "Cell determinant",
      "OpenFOAM's determinant of the interior faces, relative to their mean area; 1 for a cube or "
      "square within a grid (8 in some releases of OpenFOAM), 0 for a cell without interior faces.")
      .Range(0, Infinity)
      .Ideal(None, Better::Bigger)
      .Acceptable(0.001, Infinity, CheckMesh, Hint, Polyhedra)
      .Neighbors(CellDeterminant)
      .Formula("det Σ (S/ā)(S/ā)ᵀ / 8 over the interior faces, with ā their mean area; for a "
               "polygon the same in its plane, with edges as faces, and 4 instead of 8")
      .Degenerate("0 for a flat cell and for a cell without interior faces.")
      .Agreement("checkMesh of OpenFOAM v1912 prints the same minimum; releases that do not divide "
                 "by 8 give a cube 8, although their dictionaries document 1.")
      .Consequence("least-squares gradients of finite volumes are badly conditioned; intended in "
                   "boundary layers"),
  };
}
}
