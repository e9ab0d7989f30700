// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cell/CellDefects.h"
#include "Criteria/CriterionRows.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace camaron
{
double CellConcavity(const CellGeometry& cell);
double MaxFaceConcavity(const CellGeometry& cell);
double MaxWarpage(const CellGeometry& cell);
double MinPointDistanceRatio(const CellGeometry& cell);
double Openness(const CellGeometry& cell);
double IsStarShaped(const CellGeometry& cell);

namespace
{
constexpr unsigned NeedsAll = NeedsEdges | NeedsFaces | NeedsVolume | NeedsAngles | NeedsCentroid;

constexpr double OpennessLimit = 1e-6;

//------------------------------------------------------------------------------
constexpr unsigned GetInvalidBits()
{
  unsigned bits = 0;
  for (const CellDefect& defect : CellDefects)
  {
    bits |= defect.IsInvalid ? defect.Bit : 0;
  }
  return bits;
}

//------------------------------------------------------------------------------
unsigned Flag(bool isSet, unsigned bit)
{
  return isSet ? bit : 0;
}

//------------------------------------------------------------------------------
bool HasPointTwiceInFace(const CellTopology& topology)
{
  thread_local std::vector<int> points;
  for (int f = 0; f < topology.GetNumberOfFaces(); ++f)
  {
    const int* face = topology.GetFace(f);
    points.assign(face, face + topology.GetFaceSize(f));
    std::sort(points.begin(), points.end());
    if (std::adjacent_find(points.begin(), points.end()) != points.end())
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// Checks all faces; a polygon has one.
unsigned CheckFaces(const CellGeometry& cell)
{
  const CellTopology& topology = cell.GetTopology();
  bool isDegenerate = false;
  for (int f = 0; f < topology.GetNumberOfFaces(); ++f)
  {
    isDegenerate = isDegenerate || cell.IsZeroArea(cell.GetFaceArea(f));
  }
  const double tolerance = cell.ToAngleUnit(cell.GetOptions().ConvexityTolerance * Pi / 180);
  return Flag(isDegenerate, DegenerateFaces) |
    Flag(HasPointTwiceInFace(topology), NoncontiguousEdges) |
    Flag(HasIntersectingEdges(cell), IntersectingEdges | Nonconvex) |
    Flag(MaxWarpage(cell) > cell.GetOptions().PlanarityTolerance, NonPlanarFaces) |
    Flag(MaxFaceConcavity(cell) > tolerance, Nonconvex);
}

//------------------------------------------------------------------------------
double FaceOrientationStatus(const CellGeometry& cell)
{
  enum
  {
    Outward,
    Inward,
    Mixed,
    NotOrientable
  };
  const CellTopology& topology = cell.GetTopology();
  const double volume = cell.GetVolume();
  if (!cell.IsFinite())
  {
    return Null(NullReason::Degenerate);
  }
  if (std::isnan(volume))
  {
    // Every edge has two faces, but they are not consistently oriented.
    const bool isManifold = topology.IsManifold && topology.GetNumberOfFaces() >= 4;
    if (!isManifold || topology.IsClosed)
    {
      return volume;
    }
    CellTopology consistent = topology; // has not been tried if the user trusts the orientation
    consistent.MakeConsistent();
    return consistent.IsClosed ? Mixed : NotOrientable;
  }
  const int reversed = cell.IsOfStandardType() ? 0 : topology.GetNumberOfReversedFaces();
  if (reversed == 0)
  {
    return volume < 0 && !cell.IsZeroVolume(volume) ? Inward : Outward;
  }
  return reversed == topology.GetNumberOfFaces() ? Inward : Mixed;
}

//------------------------------------------------------------------------------
unsigned CheckPolyhedron(const CellGeometry& cell)
{
  const CellTopology& topology = cell.GetTopology();
  unsigned status =
    Flag(cell.GetNumberOfPoints() < 4 || topology.GetNumberOfFaces() < 4, WrongNumberOfPoints) |
    Flag(topology.GetNumberOfFaces() == 0, NotWatertight);
  for (const CellTopology::Edge& edge : topology.Edges)
  {
    status |= Flag(edge.Uses == 1, NotWatertight) | Flag(edge.Uses > 2, NonManifoldEdge);
  }
  const double volume = cell.GetVolume();
  const bool hasVolume = !std::isnan(volume);
  const double tolerance = cell.GetOptions().ConvexityTolerance * Pi / 180;
  status |= Flag(hasVolume && (volume < 0 || cell.IsZeroVolume(volume)), InvertedOrZeroVolume);
  status |= Flag(FaceOrientationStatus(cell) > 0, FacesAreOrientedIncorrectly);
  status |= Flag(Openness(cell) > OpennessLimit, OpenCell);
  // Without a volume, there are no angles to detect edges with several faces, whose ends are
  // non-manifold, too.
  status |= Flag(hasVolume ? GetNullReason(cell.GetMinSolidAngle()) == NullReason::InvalidTopology
                           : (status & NonManifoldEdge) || HasPinchedPoints(topology),
    NonManifoldVertex);
  status |= Flag(cell.GetMaxDihedralAngle() > Pi + tolerance || CellConcavity(cell) > tolerance ||
      (hasVolume && topology.GetNumberOfShells() > 1),
    Nonconvex);
  return status;
}

//------------------------------------------------------------------------------
// Of all cells of simple shapes, so that a hexahedron equals its polyhedron. The Jacobian
// determinant of an affine map is its size.
unsigned CheckMap(const CellGeometry& cell)
{
  const CellMap* const map = cell.GetMap();
  if (!map || (!map->IsCurved() && (cell.GetShapes() & (Triangles | Tetrahedra))))
  {
    return 0;
  }
  const Vector normal = cell.GetNormal();
  if (map->IsSurelyPositive(normal))
  {
    return 0;
  }
  const PolynomialBounds& bounds = map->GetJacobian(normal);
  const bool isFolded = bounds.LeastFound < 0 && bounds.GreatestFound > 0;
  return Flag(isFolded, FoldedMap) |
    Flag(!isFolded && bounds.Least <= 0 && bounds.Greatest > 0, ZeroJacobian);
}

//------------------------------------------------------------------------------
// Whether a point is repeated in a row in a face, or listed twice by a cell of a fixed type.
bool HasRepeatedIds(const CellGeometry& cell)
{
  const bool isCollapsed = (cell.GetShapes() & Polyhedra) && cell.IsOfStandardType() &&
    !cell.HasNodesInOrder() && !cell.IsInDegenerateForm();
  return isCollapsed || cell.HasRepeatedPoints();
}

//------------------------------------------------------------------------------
// The bits of all defects.
unsigned FindStatus(const CellGeometry& cell)
{
  if (!(cell.GetShapes() & PolygonsAndPolyhedra))
  {
    return 0;
  }
  if (!cell.IsFinite())
  {
    return NonFinitePoint;
  }
  unsigned status = CheckFaces(cell) |
    // NaN if all points coincide.
    Flag(cell.GetNumberOfPoints() > 1 && !(MinPointDistanceRatio(cell) > 0), CoincidentPoints) |
    Flag(HasRepeatedIds(cell), CoincidentPoints) |
    Flag(!cell.GetTopology().Edges.empty() && cell.IsZeroLength(cell.GetMinEdgeLength()),
      ZeroLengthEdge) |
    Flag(cell.GetOptions().ChecksStarShape && IsStarShaped(cell) == 0, NotStarShaped) |
    CheckMap(cell);
  if (cell.GetShapes() & Polygons)
  {
    status |= Flag(cell.GetNumberOfPoints() < 3, WrongNumberOfPoints);
  }
  else
  {
    status |= CheckPolyhedron(cell);
    // The faces of a closed convex cell do not intersect; the test is expensive.
    const bool mayIntersect = (status & Nonconvex) || std::isnan(cell.GetVolume());
    status |= Flag(mayIntersect && HasIntersectingFaces(cell), IntersectingFaces);
  }
  return status;
}

//------------------------------------------------------------------------------
unsigned CellStatus(const CellGeometry& cell)
{
  std::optional<unsigned>& status = cell.GetKnownStatus();
  status = status ? *status : FindStatus(cell);
  return *status;
}

//------------------------------------------------------------------------------
double IsConvex(const CellGeometry& cell)
{
  // Faces that are too warped to be represented by a mean plane bend inward between their
  // triangles.
  const bool isPolyhedron = (cell.GetShapes() & Polyhedra) != 0;
  const unsigned bent = isPolyhedron ? NonPlanarFaces : 0u;
  if (isPolyhedron && cell.IsFinite() && std::isnan(cell.GetVolume()))
  {
    return 0; // it has no interior
  }
  return (CellStatus(cell) &
           (Nonconvex | bent | NotWatertight | NonManifoldEdge | NonFinitePoint)) == 0;
}

//------------------------------------------------------------------------------
double IsWatertight(const CellGeometry& cell)
{
  return (CellStatus(cell) & (NotWatertight | NonFinitePoint)) == 0;
}

//------------------------------------------------------------------------------
double IsValid(const CellGeometry& cell)
{
  return (CellStatus(cell) & GetInvalidBits()) == 0;
}
}

//------------------------------------------------------------------------------
std::vector<Criterion> ValidityCriteria()
{
  return {
    CriterionRow("CellStatus", "Cell status",
      "Sum of the defects: 1 too few points, 2 intersecting edges, 4 intersecting faces, 8 face "
      "with a repeated point, 16 not convex, 32 faces not oriented outward, 64 nonplanar faces, "
      "128 degenerate faces, 256 coincident points, 4096 open edge or no face, 8192 edge with more "
      "than two faces, 16384 pinched vertex, 32768 inverted or zero volume, 65536 zero-length "
      "edge, 131072 not star-shaped (only if IsStarShaped is evaluated, too), 262144 nonfinite "
      "coordinates, 524288 face vectors that do not cancel, 1048576 folded (the Jacobian "
      "determinant of the finite element map has both signs), 2097152 zero Jacobian determinant "
      "somewhere, as at a quarter-point node. The first nine are those of VTK 9.6's Validate Cells "
      "(the first six in older versions).")
      .Range(0, 4194303)
      .Ideal(0, Better::Smaller)
      .Kind(ValueKind::Code)
      .Cost(Cost::Edges)
      .Needs(NeedsAll)
      .Cells<CellStatus>()
      .Curved()
      .Formula("sum of bits, each the result of one test of the cell")
      .Degenerate("Every polygon and polyhedron has a value; with nonfinite coordinates, only "
                  "that bit is set. Too few points are those of a polygon, strip or polyhedron; a "
                  "mesh with a hexahedron of six points is refused. The array is of integers, so "
                  "there is no NaN: points and lines, which are not tested, have 0. Faces of an "
                  "open cell that touch in points or edges, for example because points are not "
                  "merged, do not intersect.")
      .Agreement("Bits 1 to 32 are those of VTK's Validate Cells, 64 to 256 those of VTK 9.6. For "
                 "cells with planar faces the results are the same, except that VTK reports cells "
                 "with inward faces as not convex, and the faces of a cell with a non-convex face "
                 "as wrongly oriented; ignores the orientation of the faces of tetrahedra; counts "
                 "repeated ids twice; and misses some intersecting faces. VTK often reports cells "
                 "with warped faces, 64 here, as not convex."),
    CriterionRow("FaceOrientationStatus", "Orientation of faces",
      "0 if all faces point outward, 1 inward, 2 some of both, 3 not orientable.")
      .Shapes(Polyhedra)
      .Range(0, 3)
      .Ideal(0, Better::Smaller)
      .Acceptable(-Infinity, 0, "outward", Hint, Polyhedra)
      .Kind(ValueKind::Integer)
      .Cost(Cost::Edges)
      .Needs(NeedsFaces | NeedsVolume)
      .Cells<FaceOrientationStatus>()
      .Formula("0 outward, 1 inward, 2 mixed, 3 not orientable")
      .Degenerate(
        "NaN (invalid topology) for an open cell, NaN (degenerate) with nonfinite "
        "coordinates. 1 for a standard cell with its vertices in the wrong order, 0 for a "
        "flat one. At a void, outward is into the void.")
      .Agreement("VTK's Validate Cells has one bit for 1 to 3.")
      .Consequence("inward faces, which most programs correct when they read the mesh"),
    CriterionRow("IsConvex", "Convex",
      "1 if no face or edge is concave (within ConvexityTolerance), the faces of a polyhedron are "
      "planar (within PlanarityTolerance) and form a single closed surface; else 0.")
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Kind(ValueKind::Integer)
      .Cost(Cost::Edges)
      .Needs(NeedsAll)
      .Cells<IsConvex>()
      .Formula("1 if CellStatus has none of 16, 4096, 8192 and 262144 and, for a polyhedron, not "
               "64 and Volume is defined")
      .Degenerate(
        "1 for flat cells. Faces that are planar within PlanarityTolerance are represented by "
        "their mean planes. If a face is more warped, the triangles about its center bend inward, "
        "and the cell is not convex: for example, a hexahedron whose top is twisted by a quarter "
        "turn, although the mean planes enclose a box. 0 for open and self-intersecting cells, and "
        "for those with several surfaces, even if these touch in a point.")
      .Agreement("Differs from VTK's vtkPolyhedron::IsConvex, which is unreliable for warped or "
                 "thin cells."),
    CriterionRow("IsWatertight", "Watertight",
      "1 if the cell has faces, and each of its edges at least two of them; else 0.")
      .Shapes(Polyhedra)
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Acceptable(1, Infinity, "closed", Cited, Polyhedra)
      .Kind(ValueKind::Integer)
      .Cost(Cost::Edges)
      .Needs(NeedsAll)
      .Cells<IsWatertight>()
      .Formula("1 if CellStatus has none of 4096 and 262144")
      .Degenerate(
        "1 for flat cells; 0 if an edge has one face only, and for cells without any valid face.")
      .Agreement("None of the compared programs reports it per cell.")
      .Consequence("open cells: no volume, and finite-volume schemes are not conservative"),
    CriterionRow("IsValid", "Valid",
      "1 if CellStatus reports nothing but nonplanar faces, faces not oriented outward, a "
      "nonconvex or a non-star-shaped cell, or a Jacobian determinant that is zero somewhere; else "
      "0.")
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Acceptable(1, Infinity, "valid", Cited, PolygonsAndPolyhedra)
      .Kind(ValueKind::Integer)
      .Cost(Cost::Edges)
      .Needs(NeedsAll)
      .Cells<IsValid>()
      .Curved()
      .Formula("1 if CellStatus has no bits other than 16, 32, 64, 131072 and 2097152")
      .Degenerate("0 for flat, collapsed, inverted and open cells; 1 for a polyhedron whose faces "
                  "all point inward, because reversing them corrects it.")
      .Agreement("None of the compared programs reports it per cell.")
      .Consequence("invalid cells (Cell status shows why): solvers stop or are wrong"),
  };
}
}
