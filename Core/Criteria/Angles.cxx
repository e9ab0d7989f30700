// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/CriterionRows.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
AngleRange OverFaces(const CellGeometry& cell)
{
  AngleRange range;
  for (int f = 0; f < cell.GetTopology().GetNumberOfFaces(); ++f)
  {
    range.Add(cell.GetFaceAngles(f));
  }
  return range;
}

//------------------------------------------------------------------------------
double InUserUnit(const CellGeometry& cell, double radian)
{
  return std::isnan(radian) ? radian : cell.ToAngleUnit(radian);
}
}

//------------------------------------------------------------------------------
double MinFaceAngle(const CellGeometry& cell)
{
  return InUserUnit(cell, OverFaces(cell).GetMin());
}

//------------------------------------------------------------------------------
double MaxFaceAngle(const CellGeometry& cell)
{
  return InUserUnit(cell, OverFaces(cell).GetMax());
}

//------------------------------------------------------------------------------
double MinDihedralAngle(const CellGeometry& cell)
{
  return InUserUnit(cell, cell.GetMinDihedralAngle());
}

//------------------------------------------------------------------------------
double MaxDihedralAngle(const CellGeometry& cell)
{
  return InUserUnit(cell, cell.GetMaxDihedralAngle());
}

//------------------------------------------------------------------------------
double MinSolidAngle(const CellGeometry& cell)
{
  return cell.GetMinSolidAngle();
}

//------------------------------------------------------------------------------
double MaxSolidAngle(const CellGeometry& cell)
{
  return cell.GetMaxSolidAngle();
}

//------------------------------------------------------------------------------
double EquiangleSkewness(const CellGeometry& cell)
{
  // Faces with the same number of corners share their ideal angle and so their extremes.
  constexpr int manyCorners = 12;
  AngleRange ranges[manyCorners];
  double worst = Null(NullReason::Degenerate);
  const auto add = [&](const AngleRange& angles, int size)
  {
    if (!angles.IsEmpty())
    {
      const double ideal = Pi * (size - 2) / size;
      const double skewness =
        std::max((angles.GetMax() - ideal) / (Pi - ideal), (ideal - angles.GetMin()) / ideal);
      worst = std::isnan(worst) ? skewness : std::max(worst, skewness);
    }
  };
  for (int f = 0; f < cell.GetTopology().GetNumberOfFaces(); ++f)
  {
    const int size = cell.GetTopology().GetFaceSize(f);
    size < manyCorners ? ranges[size].Add(cell.GetFaceAngles(f)) : add(cell.GetFaceAngles(f), size);
  }
  for (int size = 3; size < manyCorners; ++size)
  {
    add(ranges[size], size);
  }
  return worst;
}

//------------------------------------------------------------------------------
std::vector<Criterion> AngleCriteria()
{
  // clang-format off
  return {
    { "MinInteriorAngle", "Smallest interior angle",
      "Smallest interior angle of the polygon; ideal is 180 (k - 2) / k for k corners.",
      Polygons, Unit::Angle, { 0, 360 }, None, Better::Bigger,
      { 30, Infinity }, "Verdict manual, rev. A, for triangles; 45 for quadrilaterals", Hint, Real,
      Cost::Faces, NeedsFaces | NeedsCorners, CAMARON_CELLS(MinFaceAngle) },
    { "MaxInteriorAngle", "Largest interior angle",
      "Largest interior angle of the polygon, above 180 at a reflex corner.",
      Polygons, Unit::Angle, { 0, 360 }, None, Better::Smaller,
      { -Infinity, 135 }, "Verdict manual, rev. A, for quadrilaterals; 90 for triangles", Hint, Real,
      Cost::Faces, NeedsFaces | NeedsCorners, CAMARON_CELLS(MaxFaceAngle) },
    { "MinFaceAngle", "Smallest face angle", "Smallest interior angle of all faces of the cell.",
      Polyhedra, Unit::Angle, { 0, 360 }, None, Better::Bigger,
      { 30, Infinity }, "Verdict manual, rev. A, for triangles; 45 for quadrilaterals", Hint, Real,
      Cost::Faces, NeedsFaces | NeedsCorners, CAMARON_CELLS(MinFaceAngle) },
    { "MaxFaceAngle", "Largest face angle",
      "Largest interior angle of all faces of the cell, above 180 at a reflex corner.",
      Polyhedra, Unit::Angle, { 0, 360 }, None, Better::Smaller,
      { -Infinity, 135 }, "Verdict manual, rev. A, for quadrilaterals; 90 for triangles", Hint, Real,
      Cost::Faces, NeedsFaces | NeedsCorners, CAMARON_CELLS(MaxFaceAngle) },
    { "MinDihedralAngle", "Smallest dihedral angle",
      "Smallest interior angle between two faces of the cell at their common edge; regular tetrahedron "
      "70.53, hexahedron 90.",
      Polyhedra, Unit::Angle, { 0, 360 }, None, Better::Bigger,
      { 20, Infinity }, "common practice; 40 for tetrahedra in the Verdict manual", Hint, Real,
      Cost::Edges, NeedsDihedral, CAMARON_CELLS(MinDihedralAngle) },
    { "MaxDihedralAngle", "Largest dihedral angle",
      "Largest interior angle between two faces of the cell at their common edge; above 180 the cell is "
      "not convex.",
      Polyhedra, Unit::Angle, { 0, 360 }, None, Better::Smaller,
      { -Infinity, 165 }, "common practice", Hint, Real,
      Cost::Edges, NeedsDihedral, CAMARON_CELLS(MaxDihedralAngle) },
    { "MinSolidAngle", "Smallest solid angle",
      "Smallest solid angle of the cell at one of its vertices; cube 1.5708, regular tetrahedron 0.5513.",
      Polyhedra, Unit::SolidAngle, { 0, 4 * Pi }, None, Better::Bigger,
      { 0.1, Infinity }, "common practice for tetrahedra", Hint, Real,
      Cost::Edges, NeedsSolidAngle, CAMARON_CELLS(MinSolidAngle) },
    { "MaxSolidAngle", "Largest solid angle",
      "Largest solid angle of the cell at one of its vertices; a full sphere is 12.566.",
      Polyhedra, Unit::SolidAngle, { 0, 4 * Pi }, None, Better::Smaller,
      { -Infinity, Infinity }, NoRange, Cited, Real,
      Cost::Edges, NeedsSolidAngle, CAMARON_CELLS(MaxSolidAngle) },
    { "EquiangleSkewness", "Equiangle skewness",
      "Largest relative deviation of an interior angle from that of the regular polygon, over all faces; "
      "above 1 at reflex corners.",
      PolygonsAndPolyhedra, Unit::None, { 0, Infinity }, 0, Better::Smaller,
      { -Infinity, 0.9 }, "common finite-volume practice", Hint, Real,
      Cost::Faces, NeedsFaces | NeedsCorners, CAMARON_CELLS(EquiangleSkewness) },
  };
  // clang-format on
}
}
