// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Measures of the Verdict library, as copied into VTK, as criteria. They are evaluated for all
// cells of matching shapes, including general polygons and polyhedra, from their vertices.
#include "Cell/Shapes.h"
#include "Criteria/CriterionRows.h"
#include "Mesh/CellShape.h"
#include "Ranks/MeshFacts.h"

#include "vtk_verdict.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

namespace camaron
{
namespace
{
constexpr double VerdictInfinity = 1e30;
constexpr double RadianPerDegree = 0.017453292519943295;
constexpr int NumberOfShapes = 6;
constexpr unsigned ShapesInOrder[NumberOfShapes] = { Triangles, Quadrilaterals, Tetrahedra,
  Pyramids, Wedges, Hexahedra };

using Function = double (*)(int, const double[][3]);
using SizeFunction = double (*)(int, const double[][3], double);

constexpr Function SizesOfShapes[NumberOfShapes] = { verdict::tri_area, verdict::quad_area,
  verdict::tet_volume, nullptr, nullptr, verdict::hex_volume };
constexpr MeanSizes::Kind SizeKinds[NumberOfShapes] = { MeanSizes::TriangleArea,
  MeanSizes::QuadrilateralArea, MeanSizes::TetrahedronVolume, MeanSizes::NumberOfKinds,
  MeanSizes::NumberOfKinds, MeanSizes::HexahedronVolume };

//------------------------------------------------------------------------------
// Unlike for hexahedra, Verdict does not detect inverted corners of a wedge.
template <Function OfWedge>
double OfUprightWedge(int size, const double corners[][3])
{
  return verdict::wedge_jacobian(size, corners) < 0 ? VerdictInfinity : OfWedge(size, corners);
}

//------------------------------------------------------------------------------
// For a quadrilateral without a principal axis, Verdict returns the best value.
double SkewOfQuadrilateral(int size, const double corners[][3])
{
  return verdict::quad_taper(size, corners) >= VerdictInfinity ? VerdictInfinity
                                                               : verdict::quad_skew(size, corners);
}

//------------------------------------------------------------------------------
// A measure of Verdict. The acceptable range is that of the most lenient shape.
struct Measure
{
  const char* Name;
  const char* Label;
  const char* Description;
  enum camaron::Unit Unit; // there is a function of that name, too
  double Range[2];
  double Ideal;
  camaron::Better Better;
  double Acceptable[2];
  Function Functions[NumberOfShapes]; // of the shapes in this order; nullptr where there is none
  CriterionNotes Notes;
  SizeFunction SizeFunctions[NumberOfShapes] = {}; // or of a cell and the mean size of its shape
};

/// Those that the manual does not have.
constexpr std::string_view YoungerThanManual[] = { "VerdictEquiangleSkew", "VerdictEquivolumeSkew",
  "VerdictMeanRatio", "VerdictNodalJacobianRatio", "VerdictNormalizedInradius",
  "VerdictSquishIndex" };

using namespace verdict;

constexpr Measure Measures[] = {
  // clang-format off
    { "VerdictArea", "Verdict area", "Area of a triangle or quadrilateral.",
      Unit::Area, { -Infinity, Infinity }, None, Better::Neither, { -Infinity, Infinity },
      { tri_area, quad_area },
      { "triangle ½|a × b|; quadrilateral ¼ Σ of the signed areas |eᵢ × eᵢ₊₁| at the corners",
        "0 for a collapsed polygon.",
        "VTK's Mesh Quality and Cell Quality. Same as `Area`." } },
    { "VerdictAspectFrobenius", "Verdict aspect Frobenius",
      "Frobenius norm of the Jacobian relative to the regular simplex.",
      Unit::None, { 1, Infinity }, 1, Better::Smaller, { -Infinity, 1.3 },
      { tri_aspect_frobenius, nullptr, tet_aspect_frobenius },
      { "(a² + b² + c²)/(4√3 A) of a triangle; Frobenius norm of the Jacobian, weighted to be 1 "
        "for the regular tetrahedron",
        "Infinite for a flat cell.",
        "VTK's Mesh Quality and Cell Quality. For a triangle, the reciprocal of "
        "`BhatiaLawrence`." } },
    { "VerdictAspectGamma", "Verdict aspect gamma",
      "Cube of the root mean square edge length, relative to the volume.",
      Unit::None, { 1, Infinity }, 1, Better::Smaller, { -Infinity, 3 },
      { nullptr, nullptr, tet_aspect_gamma },
      { "(Σ lᵢ²/6)^(3/2) √2 / (12 V)",
        "Infinite for a flat tetrahedron.",
        "VTK's Mesh Quality and Cell Quality. `VolumeEdgeRatio` is 1/(6√2) times its "
        "reciprocal." } },
    { "VerdictAspectRatio", "Verdict aspect ratio",
      "Longest edge relative to the inradius (to the area for quadrilaterals).",
      Unit::None, { 1, Infinity }, 1, Better::Smaller, { -Infinity, 3 },
      { tri_aspect_ratio, quad_aspect_ratio, tet_aspect_ratio },
      { "triangle max l · L/(4√3 A); quadrilateral max l · L/(4A); tetrahedron max l/(2√6 r)",
        "Infinite for a flat triangle or tetrahedron; a self-intersecting or collapsed "
        "quadrilateral may have an inconspicuous value.",
        "VTK's Mesh Quality and Cell Quality. The aspect ratio of the original Camarón is "
        "`EdgeLengthRatio`, that of OpenFOAM `CellAspectRatio`." } },
    { "VerdictCollapseRatio", "Verdict collapse ratio",
      "Minimum height above a face relative to the longest edge of that face; depends on the order "
      "of the vertices.",
      Unit::None, { -Infinity, Infinity }, None, Better::Bigger, { 0.1, Infinity },
      { nullptr, nullptr, tet_collapse_ratio },
      { "min over the vertices of the height above the opposite face / longest edge; for two of "
        "the faces, the edge belongs to another face",
        "0 for a flat tetrahedron, negative for an inverted one.",
        "VTK's Mesh Quality and Cell Quality. The result depends on the order of the vertices." } },
    { "VerdictCondition", "Verdict condition",
      "Maximum condition number of the Jacobian at a corner.",
      Unit::None, { -Infinity, Infinity }, 1, Better::Smaller, { 0, 4 },
      { tri_condition, quad_condition, tet_condition, nullptr, OfUprightWedge<wedge_condition>,
        hex_condition },
      { "‖J‖ ‖J⁻¹‖ / dimension with Frobenius norms, weighted to be 1 for the regular simplex; the "
        "maximum over the corners",
        "Infinite for a flat cell; negative for an inverted tetrahedron, infinite for an inverted "
        "wedge or hexahedron.",
        "VTK's Mesh Quality and Cell Quality, except that there, inverted wedges have the values "
        "of their mirror images. For a triangle, the reciprocal of `BhatiaLawrence`." } },
    { "VerdictDiagonal", "Verdict diagonal", "Shortest divided by longest diagonal.",
      Unit::None, { 0, 1 }, 1, Better::Bigger, { 0.65, Infinity },
      { nullptr, nullptr, nullptr, nullptr, nullptr, hex_diagonal },
      { "min of the four diagonals / max of them",
        "Evaluates the remaining diagonals: 1 for a flat cube.",
        "VTK's Mesh Quality and Cell Quality. `EdgeDiameterRatio` is defined for any "
        "polyhedron." } },
    { "VerdictDimension", "Verdict dimension",
      "Volume divided by twice the gradient of volume, for stable time steps.",
      Unit::Length, { 0, Infinity }, None, Better::Neither, { -Infinity, Infinity },
      { nullptr, nullptr, nullptr, nullptr, nullptr, hex_dimension },
      { "V / √(2 Σ |∂V/∂pᵢ|²) over the corners",
        "0 for a flat hexahedron, NaN (degenerate) for a collinear one.",
        "VTK's Mesh Quality and Cell Quality." } },
    { "VerdictDistortion", "Verdict distortion",
      "Minimum Jacobian determinant relative to the area or volume.",
      Unit::None, { -Infinity, Infinity }, 1, Better::Bigger, { 0.5, Infinity },
      { tri_distortion, quad_distortion, tet_distortion, nullptr, wedge_distortion,
        hex_distortion },
      { "min |J| at the integration points / V × volume of the reference cell",
        "1 for every triangle and tetrahedron, even flat ones; 0 for a flat hexahedron; negative "
        "for a self-intersecting quadrilateral.",
        "VTK's Mesh Quality and Cell Quality, except for wedges: see `VerdictVolume`." } },
    { "VerdictEdgeRatio", "Verdict edge ratio",
      "Longest divided by shortest edge; for hexahedra only some edges, depending on the order of "
      "the vertices.",
      Unit::None, { 1, Infinity }, 1, Better::Smaller, { -Infinity, 3 },
      { tri_edge_ratio, quad_edge_ratio, tet_edge_ratio, nullptr, wedge_edge_ratio,
        hex_edge_ratio },
      { "max lᵢ / min lᵢ; for a hexahedron, the maximum over the first six edges only",
        "Infinite if an edge is collapsed.",
        "VTK's Mesh Quality and Cell Quality. Same as `EdgeRatio`, except for hexahedra, where "
        "Verdict searches only six edges for the longest." } },
    { "VerdictEquiangleSkew", "Verdict equiangle skew",
      "Maximum relative deviation of an angle from that of the regular shape.",
      Unit::None, { 0, Infinity }, 0, Better::Smaller, { -Infinity, 0.7 },
      { tri_equiangle_skew, quad_equiangle_skew, tet_equiangle_skew, pyramid_equiangle_skew,
        wedge_equiangle_skew, hex_equiangle_skew },
      { "max((θmax − θₑ)/(180° − θₑ), (θₑ − θmin)/θₑ), the maximum over the faces; for a "
        "tetrahedron, also over its dihedral angles with θₑ = 70.53°",
        "1 for a flat triangle or tetrahedron, above 1 for a reflex corner; NaN (degenerate) for a "
        "quadrilateral with a collapsed edge. For other cells, the value depends on which edge is "
        "collapsed.",
        "VTK's Mesh Quality and Cell Quality, which return −1 for a quadrilateral with a collapsed "
        "edge. Same as `EquiangleSkewness` for cells without collapsed edges and self-intersecting "
        "faces, except for tetrahedra." } },
    { "VerdictEquivolumeSkew", "Verdict equivolume skew",
      "Relative deviation of the volume from that of the regular tetrahedron with the same "
      "circumsphere.",
      Unit::None, { 0, Infinity }, 0, Better::Smaller, { -Infinity, 0.7 },
      { nullptr, nullptr, tet_equivolume_skew },
      { "1 − V / (8√3/27 · R³)",
        "Infinite for a flat tetrahedron; an inverted tetrahedron has the value of its mirror "
        "image.",
        "VTK's Mesh Quality and Cell Quality. 1 minus `TetQualityFoam`." } },
    { "VerdictInradius", "Verdict inradius", "Radius of the inscribed ball.",
      Unit::Length, { -Infinity, Infinity }, None, Better::Neither, { -Infinity, Infinity },
      { nullptr, nullptr, tet_inradius },
      { "r = 3V / surface area",
        "0 for a flat tetrahedron, NaN (degenerate) for a collinear one, negative for an inverted "
        "one.",
        "VTK's Mesh Quality and Cell Quality." } },
    { "VerdictJacobian", "Verdict Jacobian", "Minimum determinant of the Jacobian.",
      Unit::Volume, { -Infinity, Infinity }, None, Better::Bigger, { Positive, Infinity },
      { nullptr, quad_jacobian, tet_jacobian, pyramid_jacobian, wedge_jacobian, hex_jacobian },
      { "min det J over the corners (and the center of a hexahedron)",
        "0 for a flat cell, negative for an inverted one. For a tetrahedron, six times the volume.",
        "VTK's Mesh Quality and Cell Quality, except for the sign of wedges: see "
        "`VerdictVolume`." } },
    { "VerdictMaxAngle", "Verdict maximum angle", "Maximum interior angle.",
      Unit::Angle, { 0, 360 }, None, Better::Smaller, { -Infinity, 135 },
      { tri_maximum_angle, quad_maximum_angle },
      { "max θᵢ over the corners",
        "180 for a collinear triangle, 0 for a triangle with two coincident points. A reflex "
        "corner of a quadrilateral counts as above 180; NaN (degenerate) for a quadrilateral with "
        "a collapsed edge.",
        "VTK's Mesh Quality and Cell Quality. Same as `MaxInteriorAngle` for valid cells." } },
    { "VerdictMaxAspectFrobenius", "Verdict maximum aspect Frobenius",
      "Maximum aspect Frobenius at a corner.",
      Unit::None, { 1, Infinity }, 1, Better::Smaller, { -Infinity, 3 },
      { nullptr, quad_max_aspect_frobenius, nullptr, nullptr,
        OfUprightWedge<wedge_max_aspect_frobenius>, hex_max_aspect_frobenius },
      { "maximum of the aspect Frobenius numbers at the corners",
        "Infinite for a collapsed edge, a flat or inverted cell.",
        "VTK's Mesh Quality and Cell Quality, except that there, inverted wedges have the values "
        "of their mirror images." } },
    { "VerdictMaxEdgeRatio", "Verdict maximum edge ratio", "Maximum ratio of the principal axes.",
      Unit::None, { 1, Infinity }, 1, Better::Smaller, { -Infinity, 1.3 },
      { nullptr, quad_max_edge_ratio, nullptr, nullptr, nullptr, hex_max_edge_ratio },
      { "max |Xᵢ| / |Xⱼ| of the principal axes X",
        "Infinite if a principal axis vanishes.",
        "VTK's Mesh Quality and Cell Quality." } },
    { "VerdictMaxStretch", "Verdict maximum stretch",
      "Maximum stretch of the quadrilateral faces: shortest edge relative to the longest diagonal.",
      Unit::None, { 0, Infinity }, 1, Better::Neither, { -Infinity, Infinity },
      { nullptr, nullptr, nullptr, nullptr, wedge_max_stretch },
      { "√2 min l / max diagonal of a quadrilateral face; the maximum of the three",
        "0 if all three faces have a collapsed edge, infinite for a collinear wedge.",
        "VTK's Mesh Quality and Cell Quality." } },
    { "VerdictMeanAspectFrobenius", "Verdict mean aspect Frobenius",
      "Mean aspect Frobenius at the corners.",
      Unit::None, { 1, Infinity }, 1, Better::Smaller, { -Infinity, Infinity },
      { nullptr, nullptr, nullptr, nullptr, OfUprightWedge<wedge_mean_aspect_frobenius> },
      { "mean of the aspect Frobenius numbers at the six corners / 1.16477",
        "Infinite for a collapsed edge, a flat or inverted cell.",
        "VTK's Mesh Quality and Cell Quality, except that there, inverted wedges have the values "
        "of their mirror images." } },
    { "VerdictMeanRatio", "Verdict mean ratio", "Mean ratio of the tetrahedron.",
      Unit::None, { -1, 1 }, 1, Better::Bigger, { 0.3, Infinity },
      { nullptr, nullptr, tet_mean_ratio },
      { "12 (3|V|)^⅔ / Σ lᵢ² with the sign of V",
        "0 for a flat tetrahedron, negative for an inverted one.",
        "VTK's Mesh Quality and Cell Quality. Same as `TetMeanRatio`; newer VTK raises it to the "
        "power 3/2." } },
    { "VerdictMedAspectFrobenius", "Verdict mean aspect Frobenius of corners",
      "Mean aspect Frobenius at the corners.",
      Unit::None, { 1, Infinity }, 1, Better::Smaller, { -Infinity, 3 },
      { nullptr, quad_med_aspect_frobenius, nullptr, nullptr, nullptr, hex_med_aspect_frobenius },
      { "mean of the aspect Frobenius numbers at the corners",
        "Infinite for a collapsed edge, a flat or inverted cell.",
        "VTK's Mesh Quality and Cell Quality. Verdict abbreviates the mean as med." } },
    { "VerdictMinAngle", "Verdict minimum angle",
      "Minimum interior angle of a polygon; for a tetrahedron, minimum dihedral angle, which "
      "depends on the order of its vertices.",
      Unit::Angle, { 0, 360 }, None, Better::Bigger, { 30, Infinity },
      { tri_minimum_angle, quad_minimum_angle, tet_minimum_angle },
      { "min θᵢ over the corners; for a tetrahedron, the minimum of the six angles between "
        "normals, some of which are dihedral angles and others their supplements, depending on the "
        "order of the vertices",
        "0 for a flat cell, NaN (degenerate) for a quadrilateral with a collapsed edge, where "
        "Verdict returns 360.",
        "VTK's Mesh Quality and Cell Quality. Same as `MinInteriorAngle` for valid polygons; for "
        "the minimum dihedral angle of tetrahedra use `MinDihedralAngle`." } },
    { "VerdictNodalJacobianRatio", "Verdict nodal Jacobian ratio",
      "Minimum divided by maximum Jacobian determinant at the vertices.",
      Unit::None, { -Infinity, 1 }, 1, Better::Bigger, { Positive, Infinity },
      { nullptr, nullptr, nullptr, nullptr, nullptr, hex_nodal_jacobian_ratio },
      { "min det J / max det J over the corners",
        "0 for a flat or inverted hexahedron.",
        "VTK's Mesh Quality and Cell Quality." } },
    { "VerdictNormalizedInradius", "Verdict normalized inradius",
      "Minimum inradius of the subtriangles or subtetrahedra relative to the regular shape.",
      Unit::None, { -Infinity, 1 }, 1, Better::Bigger, { 0.15, Infinity },
      { tri_normalized_inradius, nullptr, tet_normalized_inradius },
      { "2r/R of a triangle; for a tetrahedron, the minimum inradius of the twelve tetrahedra "
        "between its vertices, the midpoints of its edges and its center, divided by R and "
        "weighted to be 1 for the regular one",
        "0 for a flat cell, NaN (degenerate) for a triangle with two coincident points. An "
        "inverted tetrahedron has a different value than its mirror image.",
        "VTK's Mesh Quality and Cell Quality. Same as `TriangleRadiusRatio` for a triangle." } },
    { "VerdictOddy", "Verdict Oddy",
      "Maximum deviation of the metric tensor from the isotropic one.",
      Unit::None, { 0, Infinity }, 0, Better::Smaller, { -Infinity, 0.5 },
      { nullptr, quad_oddy, nullptr, nullptr, nullptr, hex_oddy },
      { "quadrilateral ((g₁₁ − g₂₂)² + 4g₁₂²)/(2 det g) with the metric g = JᵀJ at a corner; "
        "hexahedron likewise in three dimensions; the maximum over the corners",
        "Infinite for a collapsed edge, a flat or inverted cell.",
        "VTK's Mesh Quality and Cell Quality." } },
    { "VerdictRadiusRatio", "Verdict radius ratio",
      "Circumradius divided by the inradius, relative to the regular shape.",
      Unit::None, { 0, Infinity }, 1, Better::Smaller, { -Infinity, 3 },
      { tri_radius_ratio, quad_radius_ratio, tet_radius_ratio },
      { "R/(2r) of a triangle, R/(3r) of a tetrahedron, h √(Σ lᵢ²) / (2√2 min |eᵢ × eᵢ₊₁|) of a "
        "quadrilateral",
        "Infinite for a flat cell; below 1 for some warped quadrilaterals.",
        "VTK's Mesh Quality and Cell Quality. Reciprocal of `TriangleRadiusRatio` or "
        "`TetRadiusRatio`." } },
    { "VerdictRelativeSizeSquared", "Verdict relative size squared",
      "Square of the size compared with the mean of all cells of the same shape in all blocks and "
      "on all ranks: the smaller divided by the larger.",
      Unit::None, { 0, 1 }, 1, Better::Bigger, { 0.25, Infinity },
      {},
      { "min(x/x̄, x̄/x)² with x the area or volume and x̄ its mean over the cells of the shape, "
        "except ghosts",
        "0 for a flat or inverted cell; NaN (degenerate) if the mean is not positive.",
        "VTK's Mesh Quality on one rank; on several ranks, it uses the mean of the cells of each "
        "rank, including ghosts." },
      { tri_relative_size_squared, quad_relative_size_squared, tet_relative_size_squared, nullptr,
        nullptr, hex_relative_size_squared } },
    { "VerdictScaledJacobian", "Verdict scaled Jacobian",
      "Minimum Jacobian determinant at a corner, divided by the lengths of the edges there.",
      Unit::None, { -1.5, 1.5 }, 1, Better::Bigger, { 0.3, Infinity },
      { tri_scaled_jacobian, quad_scaled_jacobian, tet_scaled_jacobian, pyramid_scaled_jacobian,
        wedge_scaled_jacobian, hex_scaled_jacobian },
      { "min over the corners of det J / product of the lengths of its columns; for simplices "
        "weighted to be 1 for the regular one",
        "0 for a flat cell or a collapsed edge (where Verdict returns 10³⁰ for a hexahedron, skips "
        "the corners of a wedge, and treats a quadrilateral whose last two vertices coincide as a "
        "triangle), negative for an inverted cell, but 0 for a pyramid.",
        "VTK's Mesh Quality and Cell Quality, except for the sign of wedges: see `VerdictVolume`. "
        "Same as `CornerScaledJacobian` for most hexahedra." } },
    { "VerdictShape", "Verdict shape",
      "Reciprocal of the worst condition number or aspect Frobenius.",
      Unit::None, { 0, 1 }, 1, Better::Bigger, { 0.25, Infinity },
      { tri_shape, quad_shape, tet_shape, pyramid_shape, wedge_shape, hex_shape },
      { "1 / the worst condition number or aspect Frobenius; for a pyramid s cos α min(d/h, h/d) "
        "with s the shape of the base, d the distance of the apex from the plane at the first "
        "vertex through the center of the base, α the angle there between the normal and the apex, "
        "h the longest edge / √2",
        "0 for a flat, collapsed or inverted cell (10⁻³⁰ for a triangle).",
        "VTK's Mesh Quality and Cell Quality. Same as `BhatiaLawrence` for a triangle and "
        "`TetMeanRatio` for a tetrahedron. VTK returns 0 for a valid wedge: see `VerdictVolume`. "
        "For a pyramid with a warped base, the result depends on the order of the vertices." } },
    { "VerdictShapeAndSize", "Verdict shape and size",
      "Product of Verdict's shape and relative size squared.",
      Unit::None, { 0, 1 }, 1, Better::Bigger, { 0.2, Infinity },
      {},
      { "`VerdictShape` × `VerdictRelativeSizeSquared`",
        "0 for a flat or inverted cell; NaN (degenerate) if the mean size is not positive.",
        "As `VerdictRelativeSizeSquared`." },
      { tri_shape_and_size, quad_shape_and_size, tet_shape_and_size, nullptr, nullptr,
        hex_shape_and_size } },
    { "VerdictShear", "Verdict shear",
      "Minimum scaled Jacobian, but at least 0, as a measure of skew.",
      Unit::None, { 0, 1 }, 1, Better::Bigger, { 0.3, Infinity },
      { nullptr, quad_shear, nullptr, nullptr, nullptr, hex_shear },
      { "max(0, the minimum scaled Jacobian of the corners)",
        "0 for a flat or inverted cell and for a quadrilateral with a collapsed edge.",
        "VTK's Mesh Quality and Cell Quality, which treat a quadrilateral whose last two vertices "
        "coincide as a triangle." } },
    { "VerdictShearAndSize", "Verdict shear and size",
      "Product of Verdict's shear and relative size squared.",
      Unit::None, { 0, 1 }, 1, Better::Bigger, { 0.2, Infinity },
      {},
      { "`VerdictShear` × `VerdictRelativeSizeSquared`",
        "0 for a flat or inverted cell; NaN (degenerate) if the mean size is not positive.",
        "As `VerdictRelativeSizeSquared`." },
      { nullptr, quad_shear_and_size, nullptr, nullptr, nullptr, hex_shear_and_size } },
    { "VerdictSkew", "Verdict skew", "Maximum cosine of the angles between the principal axes.",
      Unit::None, { 0, Infinity }, 0, Better::Smaller, { -Infinity, 0.5 },
      { nullptr, SkewOfQuadrilateral, nullptr, nullptr, nullptr, hex_skew },
      { "max |X̂ᵢ · X̂ⱼ| of the principal axes X",
        "Infinite if a principal axis vanishes.",
        "VTK's Mesh Quality and Cell Quality. The manual prints 0.5 to 1 as acceptable, although a "
        "rectangle has 0." } },
    { "VerdictSquishIndex", "Verdict squish index",
      "Maximum over the faces of 1 minus the sine of the angle between the face and the line to "
      "its center.",
      Unit::None, { 0, 2 }, 0, Better::Smaller, { -Infinity, 0.3 },
      { nullptr, nullptr, tet_squish_index },
      { "max over the faces of 1 − n · ŵ",
        "1 for a flat tetrahedron (0 for a collinear one), above 1 for an inverted one.",
        "VTK's Mesh Quality and Cell Quality. 1 minus the part n · ŵ of `OrthogonalQuality`." } },
    { "VerdictStretch", "Verdict stretch", "Shortest edge relative to the longest diagonal.",
      Unit::None, { 0, Infinity }, 1, Better::Bigger, { 0.25, Infinity },
      { nullptr, quad_stretch, nullptr, nullptr, nullptr, hex_stretch },
      { "√2 (quadrilateral) or √3 (hexahedron) × min l / max diagonal",
        "0 if an edge is collapsed.",
        "VTK's Mesh Quality and Cell Quality. `EdgeDiameterRatio` is defined for any cell." } },
    { "VerdictTaper", "Verdict taper",
      "Maximum ratio of the cross derivative to the principal axes.",
      Unit::None, { 0, Infinity }, 0, Better::Smaller, { -Infinity, 0.7 },
      { nullptr, quad_taper, nullptr, nullptr, nullptr, hex_taper },
      { "max |X_ij| / min(|Xᵢ|, |Xⱼ|) of the cross derivatives and principal axes",
        "Infinite if a principal axis vanishes.",
        "VTK's Mesh Quality and Cell Quality." } },
    { "VerdictVolume", "Verdict volume", "Volume as the sum of tetrahedra at the corners.",
      Unit::Volume, { -Infinity, Infinity }, None, Better::Neither, { Positive, Infinity },
      { nullptr, nullptr, tet_volume, pyramid_volume, wedge_volume, hex_volume },
      { "sum of the signed volumes of corner tetrahedra",
        "0 for a flat cell, negative for an inverted one.",
        "VTK's Mesh Quality and Cell Quality, except for the sign of wedges, because these assume "
        "Verdict's order of vertices instead of VTK's. Same as `Volume`." } },
    { "VerdictWarpage", "Verdict warpage",
      "Cube of the minimum cosine of the angle between normals at opposite corners; 1 is planar.",
      Unit::None, { -1, 1 }, 1, Better::Bigger, { 0.3, Infinity },
      { nullptr, quad_warpage },
      { "min(n₀ · n₂, n₁ · n₃)³ with unit normals at the corners",
        "10⁻³⁰ if a corner has no normal, −1 for a self-intersecting quadrilateral.",
        "VTK's Mesh Quality and Cell Quality. Verdict's manual defines 1 minus this value, with 0 "
        "as the best; VTK's code does not subtract. `MaxWarpage` and `MinFaceFlatness` are defined "
        "for any polygon." } },
  // clang-format on
};
constexpr std::size_t NumberOfMeasures = sizeof(Measures) / sizeof(Measures[0]);

//------------------------------------------------------------------------------
// Coordinates of the corners in Verdict's order, in which a wedge is an extrusion.
int GetCorners(const CellGeometry& cell, double corners[MaxSimpleNodes][3])
{
  Vector points[MaxSimpleNodes];
  const int size = cell.GetSimpleCorners(points);
  for (int i = 0; i < size; ++i)
  {
    corners[i][0] = points[i].X, corners[i][1] = points[i].Y, corners[i][2] = points[i].Z;
  }
  return size;
}

//------------------------------------------------------------------------------
// Place of the shape of a cell in the order above; NumberOfShapes for any other.
int FindShape(const CellGeometry& cell)
{
  int index = 0;
  while (index < NumberOfShapes && !(cell.GetShapes() & ShapesInOrder[index]))
  {
    ++index;
  }
  return index;
}

//------------------------------------------------------------------------------
void Scale(double corners[MaxSimpleNodes][3], int size, int exponent)
{
  const double factor = std::ldexp(1.0, exponent);
  for (int i = 0; i < size; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      corners[i][k] *= factor;
    }
  }
}

//------------------------------------------------------------------------------
double ReadInfinity(double value)
{
  return std::abs(value) >= VerdictInfinity ? std::copysign(Infinity, value) : value;
}

//------------------------------------------------------------------------------
// Evaluates a cell scaled to edges near 1, because Verdict treats sizes below absolute limits, such
// as 1e-30, as zero.
double EvaluateScaled(const Measure& measure, Function function, const CellGeometry& cell, int size,
  double corners[MaxSimpleNodes][3])
{
  const int exponent = std::ilogb(cell.GetMaxEdgeLength());
  Scale(corners, size, -exponent);
  return std::ldexp(ReadInfinity(function(size, corners)), cell.GetPower(measure.Unit) * exponent);
}

//------------------------------------------------------------------------------
double Evaluate(const Measure& measure, const CellGeometry& cell)
{
  const int index = FindShape(cell);
  if (cell.IsZeroLength(cell.GetMaxEdgeLength()))
  {
    return Null(NullReason::Degenerate);
  }
  const Function function = measure.Functions[index];
  const bool isOfAngles = function == quad_minimum_angle || function == quad_maximum_angle ||
    function == quad_equiangle_skew;
  if (isOfAngles && cell.IsZeroLength(cell.GetMinEdgeLength()))
  {
    return Null(NullReason::Degenerate); // without angles, Verdict returns 360 for the minimum and
                                         // 0 for the maximum
  }
  // Verdict skips the corners there, or treats a quadrilateral whose last two vertices coincide as
  // a triangle.
  const bool isOfEdges = function == wedge_scaled_jacobian || function == quad_scaled_jacobian ||
    function == quad_shear || measure.SizeFunctions[index] == quad_shear_and_size;
  if (isOfEdges && cell.IsZeroLength(cell.GetMinEdgeLength()))
  {
    return 0;
  }
  double corners[MaxSimpleNodes][3] = {};
  const int size = GetCorners(cell, corners);
  double value = 0;
  if (function)
  {
    value = EvaluateScaled(measure, function, cell, size, corners);
  }
  else
  {
    // Scaled by a power of two so that the mean is near 1: Verdict computes roots with 11 digits of
    // 1/3, and treats sizes below 1e-30 as zero.
    const double mean = cell.GetOptions().Means->Of[SizeKinds[index]];
    if (!(mean > 0))
    {
      return Null(NullReason::Degenerate);
    }
    const int dimension = cell.GetPower(Unit::Volume);
    const int exponent = std::ilogb(mean) / dimension;
    Scale(corners, size, cell.GetLengthExponent() - exponent);
    value = ReadInfinity(
      measure.SizeFunctions[index](size, corners, std::ldexp(mean, -dimension * exponent)));
  }
  if (std::isnan(value))
  {
    return Null(NullReason::Degenerate);
  }
  if (std::isinf(value))
  {
    // For a bounded measure that should be large, this is Verdict's value for a collapsed cell.
    value = measure.Better == Better::Bigger ? std::max(0.0, measure.Range[0])
                                             : std::copysign(Infinity, value);
  }
  return measure.Unit == Unit::Angle ? cell.ToAngleUnit(RadianPerDegree * value) : value;
}

//------------------------------------------------------------------------------
template <std::size_t Index>
double EvaluateMeasure(const CellGeometry& cell)
{
  return Evaluate(Measures[Index], cell);
}

//------------------------------------------------------------------------------
CriterionRow MakeRow(const Measure& measure)
{
  unsigned shapes = 0, meanSizes = 0;
  for (int i = 0; i < NumberOfShapes; ++i)
  {
    shapes |= measure.Functions[i] || measure.SizeFunctions[i] ? ShapesInOrder[i] : 0u;
    meanSizes = measure.SizeFunctions[i] ? NeedsMeanSizes : meanSizes;
  }
  const bool hasRange =
    std::isfinite(measure.Acceptable[0]) || std::isfinite(measure.Acceptable[1]);
  const auto* const end = std::end(YoungerThanManual);
  const bool isOfManual = std::find(YoungerThanManual, end, measure.Name) == end;
  const char* const source =
    isOfManual ? "Verdict manual, rev. A, for the most lenient shape" : "common practice";
  // For pyramids and wedges, the manual only limits the sign.
  const bool isOfSign = measure.Acceptable[0] == Positive;
  const unsigned shapesOfRange = isOfManual && !isOfSign ? shapes & ~(Pyramids | Wedges) : shapes;
  CriterionRow row(measure.Name, measure.Label, measure.Description);
  row.Shapes(shapes)
    .Unit(measure.Unit)
    .Range(measure.Range[0], measure.Range[1])
    .Ideal(measure.Ideal, measure.Better)
    .Cost(Cost::Edges)
    .Needs(NeedsEdges | NeedsFaces | NeedsVolume | meanSizes)
    .Formula(measure.Notes.Formula)
    .Degenerate(measure.Notes.Degenerate)
    .Agreement(measure.Notes.Agreement);
  if (hasRange)
  {
    row.Acceptable(measure.Acceptable[0], measure.Acceptable[1], source, Hint, shapesOfRange);
  }
  return row;
}

//------------------------------------------------------------------------------
template <std::size_t... Indices>
std::vector<Criterion> MakeCriteria(std::index_sequence<Indices...>)
{
  return { MakeRow(Measures[Indices]).template Cells<EvaluateMeasure<Indices>>()... };
}
}

//------------------------------------------------------------------------------
bool GetVerdictSize(const CellGeometry& cell, MeanSizes::Kind& kind, double& size)
{
  const int index = FindShape(cell);
  if (index == NumberOfShapes || !SizesOfShapes[index])
  {
    return false;
  }
  double corners[MaxSimpleNodes][3] = {};
  const int numberOfCorners = GetCorners(cell, corners);
  kind = SizeKinds[index];
  const double diameter = cell.GetDiameter();
  const int exponent = diameter > 0 && std::isfinite(diameter) ? std::ilogb(diameter) : 0;
  Scale(corners, numberOfCorners, -exponent);
  size = std::ldexp(
    SizesOfShapes[index](numberOfCorners, corners), exponent * cell.GetPower(Unit::Volume));
  return true;
}

//------------------------------------------------------------------------------
std::vector<Criterion> VerdictCriteria()
{
  return MakeCriteria(std::make_index_sequence<NumberOfMeasures>());
}
}
