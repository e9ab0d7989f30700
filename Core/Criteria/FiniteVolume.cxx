// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What finite volumes ask of a cell and its neighbors, as OpenFOAM's checkMesh and Fluent define
// it.
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
enum class End
{
  Smallest,
  Largest
};

//------------------------------------------------------------------------------
// The smallest or largest of what facets have, or why there is none. A neighbor in another piece,
// of which nothing is known, might be beyond all others.
class Extreme
{
public:
  explicit Extreme(End end)
    : Sign(end == End::Largest ? 1 : -1)
  {
  }
  void Add(double value)
  {
    if (!std::isnan(value))
    {
      this->Value =
        this->IsEmpty ? value : std::max(this->Sign * value, this->Sign * this->Value) * this->Sign;
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
  double Sign;
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
// The smallest or largest measure(facet) of the facets on some Sides.
template <typename Measure>
double ExtremeOfFacets(const CellNeighborhood& cell, End end, unsigned sides, Measure&& measure)
{
  Extreme extreme(end);
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
template <End end>
double NonOrthogonality(const CellNeighborhood& cell)
{
  const double lean =
    ExtremeOfFacets(cell, end, Inner, [&](const Facet& facet) { return GetLean(cell, facet); });
  return std::isnan(lean) ? lean : cell.GetGeometry().ToAngleUnit(GetAngleOfLean(lean));
}

//------------------------------------------------------------------------------
template <End end>
double BoundaryNonOrthogonality(const CellNeighborhood& cell)
{
  const double angle = ExtremeOfFacets(cell, end, AtBoundary,
    [&](const Facet& facet) { return GetBoundaryNonOrthogonality(cell, facet); });
  return std::isnan(angle) ? angle : cell.GetGeometry().ToAngleUnit(angle);
}

//------------------------------------------------------------------------------
template <End end>
double FaceSkewness(const CellNeighborhood& cell)
{
  return ExtremeOfFacets(cell, end, Inner | AtBoundary,
    [&](const Facet& facet) { return GetFaceSkewness(cell, facet); });
}

//------------------------------------------------------------------------------
template <End end>
double FaceWeight(const CellNeighborhood& cell)
{
  return ExtremeOfFacets(
    cell, end, Inner, [&](const Facet& facet) { return GetFaceWeight(cell, facet); });
}

//------------------------------------------------------------------------------
template <End end>
double VolumeRatio(const CellNeighborhood& cell)
{
  if (std::isnan(cell.GetSize()))
  {
    return cell.GetSize();
  }
  return ExtremeOfFacets(
    cell, end, Inner, [&](const Facet& facet) { return GetVolumeRatio(cell, facet); });
}

//------------------------------------------------------------------------------
double CellVolumeRatio(const CellNeighborhood& cell)
{
  const double ratio = VolumeRatio<End::Smallest>(cell);
  return std::isnan(ratio) ? ratio : ratio > 0 ? 1 / ratio : Infinity;
}

//------------------------------------------------------------------------------
double OrthogonalQuality(const CellNeighborhood& cell)
{
  Extreme extreme(End::Smallest);
  for (const Facet& facet : cell.GetFacets())
  {
    // A vector of no length makes the quality 0.
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
  // clang-format off
  return {
    { "MaxNonOrthogonality", "Maximum non-orthogonality",
      "Maximum angle between the normal of a face and the line from the centroid of the cell to "
      "that of the neighbor; above 90, the centroids are on the wrong sides.",
      PolygonsAndPolyhedra, Unit::Angle, { 0, 180 }, 0, Better::Smaller,
      { -Infinity, 70 }, "OpenFOAM checkMesh; maxNonOrtho of snappyHexMesh is 65", Cited, Polyhedra, Real,
      Cost::Neighbors, NeedsCentroid, CAMARON_NEIGHBORS(NonOrthogonality<End::Largest>),
      { "∠(d, S) with d = N − P, from the centroid P of the cell to that of the neighbor N; the "
        "maximum over the interior faces",
        "NaN (no neighbor) for a cell without neighbors. Collapsed faces, coincident centroids and "
        "neighbors with nonfinite coordinates are skipped; NaN (degenerate) if nothing remains.",
        "Same as checkMesh for planar convex faces, to the digits it prints. Fluent reports the "
        "cosine: see `OrthogonalQuality`.",
        "finite volume schemes need correctors, or diverge" } },
    { "MinNonOrthogonality", "Minimum non-orthogonality",
      "Minimum angle between the normal of a face and the line from the centroid of the cell to "
      "that of the neighbor: the value of the best face.",
      PolygonsAndPolyhedra, Unit::Angle, { 0, 180 }, 0, Better::Smaller,
      { -Infinity, Infinity }, NoRange, Cited, NoShapes, Real,
      Cost::Neighbors, NeedsCentroid, CAMARON_NEIGHBORS(NonOrthogonality<End::Smallest>),
      { "as `MaxNonOrthogonality`, the minimum over the interior faces", "As `MaxNonOrthogonality`.",
        "None of the compared programs reports it per cell." } },
    { "MaxBoundaryNonOrthogonality", "Maximum non-orthogonality at the boundary",
      "Maximum angle between the normal of a boundary face and the line from the centroid of the "
      "cell to the center of that face.",
      PolygonsAndPolyhedra, Unit::Angle, { 0, 180 }, 0, Better::Smaller,
      { -Infinity, Infinity }, NoRange, Cited, NoShapes, Real,
      Cost::Neighbors, NeedsCentroid, CAMARON_NEIGHBORS(BoundaryNonOrthogonality<End::Largest>),
      { "∠(c_f − P, S); the maximum over the boundary faces",
        "90 for a flat tetrahedron, 180 for an inverted cell. NaN (no neighbor) for a cell without "
        "boundary faces, NaN (degenerate) if all of them are collapsed.",
        "checkMesh ignores boundary faces." } },
    { "MinBoundaryNonOrthogonality", "Minimum non-orthogonality at the boundary",
      "Minimum angle between the normal of a boundary face and the line from the centroid of the "
      "cell to the center of that face: the value of the best face.",
      PolygonsAndPolyhedra, Unit::Angle, { 0, 180 }, 0, Better::Smaller,
      { -Infinity, Infinity }, NoRange, Cited, NoShapes, Real,
      Cost::Neighbors, NeedsCentroid, CAMARON_NEIGHBORS(BoundaryNonOrthogonality<End::Smallest>),
      { "as `MaxBoundaryNonOrthogonality`, the minimum over the boundary faces",
        "NaN as for `MaxBoundaryNonOrthogonality`.", "None of the compared programs reports it per "
                                                  "cell." } },
    { "MaxFaceSkewness", "Maximum face skewness",
      "Maximum distance between the center of a face and the point where the line to the "
      "neighbor's centroid crosses the face, relative to the size of the face in that direction; "
      "at the boundary, the cell is mirrored.",
      PolygonsAndPolyhedra, Unit::None, { 0, Infinity }, 0, Better::Smaller,
      { -Infinity, 4 }, "OpenFOAM checkMesh; meshQualityDict allows 20 at the boundary", Cited, Polyhedra, Real,
      Cost::Neighbors, NeedsCentroid, CAMARON_NEIGHBORS(FaceSkewness<End::Largest>),
      { "|s|/δ with s = w − (S · w)/(S · d) d, w = c_f − P, δ = max(0.2 |d|, max |ŝ · (p − c_f)| "
        "over the points of the face); at the boundary d = n (n · w) and 0.4 instead of 0.2; the "
        "maximum over the faces",
        "Infinite if d lies in the plane of the face, as for a flat cell. Collapsed faces are "
        "skipped; NaN (degenerate) if all are collapsed. Inverted cells have the same value.",
        "Same as checkMesh for planar convex faces, to the digits it prints. Fluent, Gmsh and "
        "Verdict define skewness differently.",
        "finite volume schemes interpolate to the wrong point of the face" } },
    { "MinFaceSkewness", "Minimum face skewness",
      "Minimum skewness, as in `MaxFaceSkewness`, of the faces of the cell: the value of the best "
      "face.",
      PolygonsAndPolyhedra, Unit::None, { 0, Infinity }, 0, Better::Smaller,
      { -Infinity, Infinity }, NoRange, Cited, NoShapes, Real,
      Cost::Neighbors, NeedsCentroid, CAMARON_NEIGHBORS(FaceSkewness<End::Smallest>),
      { "as `MaxFaceSkewness`, the minimum over the faces",
        "Infinite if d lies in the plane of every face; else as `MaxFaceSkewness`.",
        "None of the compared programs reports it per cell." } },
    { "MinFaceWeight", "Minimum face weight",
      "The smaller of the distances of a face from the two centroids, along its normal, divided by "
      "their sum; the minimum over the interior faces.",
      PolygonsAndPolyhedra, Unit::None, { 0, 0.5 }, 0.5, Better::Bigger,
      { 0.05, Infinity }, "OpenFOAM's minFaceWeight", Cited, Polyhedra, Real,
      Cost::Neighbors, NeedsCentroid, CAMARON_NEIGHBORS(FaceWeight<End::Smallest>),
      { "min(a, b)/(a + b) with a = |S · (c_f − P)|, b = |S · (N − c_f)|; the minimum over the "
        "interior faces",
        "As `MaxNonOrthogonality`; 0 if a centroid lies in the plane of the face.",
        "Same as checkMesh's \"face interpolation weight\" for planar convex faces, to the digits "
        "it prints.",
        "finite volume schemes interpolate almost from one side" } },
    { "MaxFaceWeight", "Maximum face weight",
      "Maximum weight, as in `MinFaceWeight`, of the interior faces of the cell: the value of the "
      "best face.",
      PolygonsAndPolyhedra, Unit::None, { 0, 0.5 }, 0.5, Better::Bigger,
      { -Infinity, Infinity }, NoRange, Cited, NoShapes, Real,
      Cost::Neighbors, NeedsCentroid, CAMARON_NEIGHBORS(FaceWeight<End::Largest>),
      { "as `MinFaceWeight`, the maximum over the interior faces",
        "NaN as for `MinFaceWeight`; 0 if a centroid lies in the plane of every interior face.",
        "None of the compared programs reports it per cell." } },
    { "MinVolumeRatio", "Minimum volume ratio",
      "Ratio of the smaller to the larger of the volumes (areas) of the cell and a neighbor; the "
      "worst neighbor counts.",
      PolygonsAndPolyhedra, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { 0.01, Infinity }, "OpenFOAM's minVolRatio", Cited, Polyhedra, Real,
      Cost::Neighbors, NeedsCentroid, CAMARON_NEIGHBORS(VolumeRatio<End::Smallest>),
      { "min(V_P, V_N) / max(V_P, V_N); the minimum over the neighbors",
        "0 if either cell is flat or inverted; NaN (no neighbor) without neighbors, NaN (invalid "
        "topology) for an open cell.",
        "Same as checkMesh's \"face volume ratio\", to the digits it prints.",
        "abrupt changes of size: finite volume gradients lose accuracy" } },
    { "MaxVolumeRatio", "Maximum volume ratio",
      "Ratio of the smaller to the larger of the volumes (areas) of the cell and a neighbor; the "
      "best neighbor counts.",
      PolygonsAndPolyhedra, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { -Infinity, Infinity }, NoRange, Cited, NoShapes, Real,
      Cost::Neighbors, NeedsCentroid, CAMARON_NEIGHBORS(VolumeRatio<End::Largest>),
      { "min(V_P, V_N) / max(V_P, V_N); the maximum over the neighbors",
        "NaN as for `MinVolumeRatio`; 0 if the cell or all its neighbors are flat or inverted.",
        "None of the compared programs reports it per cell." } },
    { "CellVolumeRatio", "Size growth",
      "Ratio of the larger to the smaller of the volumes (areas) of the cell and a neighbor; the "
      "worst neighbor counts.",
      PolygonsAndPolyhedra, Unit::None, { 1, Infinity }, 1, Better::Smaller,
      { -Infinity, 2 }, "common practice for transitions; 1.2 in layers", Hint, SimplePolyhedra, Real,
      Cost::Neighbors, NeedsCentroid, CAMARON_NEIGHBORS(CellVolumeRatio),
      { "1 / MinVolumeRatio",
        "Infinite if the cell or a neighbor is flat or inverted; NaN as for `MinVolumeRatio`.",
        "Growth rates of Fluent and other programs are defined for layers, often by lengths.",
        "abrupt changes of size; intended where cells are refined by halving" } },
    { "OrthogonalQuality", "Orthogonal quality",
      "Minimum cosine of the angles between the normal of a face and the lines from the centroid "
      "of the cell to the center of the face and to the neighbor's centroid, as in Fluent.",
      PolygonsAndPolyhedra, Unit::None, { -1, 1 }, 1, Better::Bigger,
      { 0.1, Infinity }, "Fluent practice; 0.01 at least", Hint, Polyhedra, Real,
      Cost::Neighbors, NeedsCentroid, CAMARON_NEIGHBORS(OrthogonalQuality),
      { "min over the faces of n · ŵ and, for interior faces, n · d̂, with w = c_f − P and d = N − "
        "P",
        "0 if a face is collapsed or a centroid lies on a face, −1 for an inverted cell.",
        "Fluent's definition for polyhedra and hexahedra; for tetrahedra, wedges and pyramids, "
        "Fluent includes 1 minus the skewness in the minimum.",
        "finite volume diffusive fluxes lose accuracy" } },
    { "CellDeterminant", "Cell determinant",
      "OpenFOAM's determinant of the interior faces, relative to their mean area; 1 for a cube or "
      "square within a grid (8 in some releases of OpenFOAM), 0 for a cell without interior faces.",
      PolygonsAndPolyhedra, Unit::None, { 0, Infinity }, None, Better::Bigger,
      { 0.001, Infinity }, CheckMesh, Hint, Polyhedra, Real,
      Cost::Neighbors, NeedsCentroid, CAMARON_NEIGHBORS(CellDeterminant),
      { "det Σ (S/ā)(S/ā)ᵀ / 8 over the interior faces, with ā their mean area; for a polygon the "
        "same in its plane, with edges as faces, and 4 instead of 8",
        "0 for a flat cell and for a cell without interior faces.",
        "checkMesh of OpenFOAM v1912 prints the same minimum; releases that do not divide by 8 "
        "give a cube 8, although their dictionaries document 1.",
        "least-squares gradients of finite volumes are badly conditioned; intended in boundary "
        "layers" } },
  };
  // clang-format on
}
}
