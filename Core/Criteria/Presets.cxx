// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/Criterion.h"

#include "Criteria/CriterionRows.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// With the acceptable ranges of the table of criteria.
std::vector<Preset::Rule> AsInTable(const std::vector<const char*>& names)
{
  std::vector<Preset::Rule> rules;
  for (const char* name : names)
  {
    const Criterion& criterion = *FindCriterion(name);
    rules.push_back({ name, { criterion.Acceptable[0], criterion.Acceptable[1] },
      criterion.AcceptableIsHint, criterion.AcceptableFor });
  }
  return rules;
}
}

//------------------------------------------------------------------------------
const std::vector<Preset>& GetPresets()
{
  // clang-format off
  static const std::vector<Preset> presets = {
    { "Overview", "Shape of any polygon or polyhedron at a glance, with the default ranges.",
      AsInTable({ "EdgeLengthRatio", "EquiangleSkewness", "IsoperimetricQuotient" }) },
    { "General", "The criteria of reports by default, with the default ranges.",
      AsInTable({ "Area", "Perimeter", "SurfaceArea", "Volume", "VertexCount", "EdgeCount", "FaceCount",
        "MinEdgeLength", "MaxEdgeLength", "MeanEdgeLength", "Diameter", "MinInteriorAngle",
        "MaxInteriorAngle", "MinFaceAngle", "MaxFaceAngle", "MinDihedralAngle", "MaxDihedralAngle",
        "MinSolidAngle", "MaxSolidAngle", "EquiangleSkewness", "MaxNeighborNormalAngle",
        "EdgeLengthRatio", "IsoperimetricQuotient", "CellAspectRatio", "TriangleRadiusRatio",
        "BhatiaLawrence", "TetRadiusEdgeRatio", "TetRadiusRatio", "TetMeanRatio", "MinFaceFlatness",
        "MinTetMeanRatio", "CornerScaledJacobian", "CellStatus", "IsValid", "MaxNonOrthogonality", "MaxFaceSkewness", "MinVolumeRatio",
        "OrthogonalQuality" }) },
    { "FEM tetrahedra", "Finite elements on tetrahedra; ranges of the Verdict manual, rev. A, for "
      "tetrahedra; TetGen's default limit of the radius-edge ratio and target of the maximum "
      "dihedral angle.",
      { { "Volume", { Positive, Infinity }, Cited, Polyhedra },
        { "MinDihedralAngle", { 40, Infinity }, Cited, Tetrahedra },
        { "MaxDihedralAngle", { -Infinity, 165 }, Cited, Tetrahedra },
        { "TetRadiusEdgeRatio", { -Infinity, 2 }, Cited, Tetrahedra },
        { "TetRadiusRatio", { 1.0 / 3, Infinity }, Cited, Tetrahedra },
        { "TetMeanRatio", { 0.3, Infinity }, Cited, Tetrahedra },
        { "EdgeLengthRatio", { 1.0 / 3, Infinity }, Cited, Tetrahedra } } },
    { "FEM hexahedra", "Finite elements on hexahedra; ranges of the Verdict manual, rev. A, for "
      "hexahedra (scaled Jacobian) and, as hints, for their quadrilaterals (angles, edges).",
      { { "Volume", { Positive, Infinity }, Cited, Polyhedra },
        { "MinFaceAngle", { 45, Infinity }, Hint, Hexahedra },
        { "MaxFaceAngle", { -Infinity, 135 }, Hint, Hexahedra },
        { "EdgeLengthRatio", { 1 / 1.3, Infinity }, Hint, Hexahedra },
        { "EquiangleSkewness", { -Infinity, 0.5 }, Hint, Hexahedra },
        { "CornerScaledJacobian", { 0.5, Infinity }, Cited, Hexahedra } } },
    { "FEM second order", "Finite elements of second order: folded cells, and midside nodes beyond "
      "the limits at which Altair OptiStruct warns.",
      { { "JacobianRatio", { Positive, Infinity }, Cited, SimplePolygons | SimplePolyhedra },
        { "MinInverseConditionNumber", { Positive, Infinity }, Cited,
          SimplePolygons | SimplePolyhedra },
        { "MidsideNodeOffsetAlongEdge", { -Infinity, 0.2 }, Cited,
          SimplePolygons | SimplePolyhedra },
        { "MidsideNodeOffsetFromEdge", { -Infinity, 0.3 }, Cited,
          SimplePolygons | SimplePolyhedra } } },
    { "Finite volume", "Finite volumes on 3D cells of any shape; limits of OpenFOAM's checkMesh "
      "(non-orthogonality from 70 degrees, skewness, aspect ratio, flatness, openness) and of its "
      "meshQualityDict (the others). Aspect ratio, determinant and MinTetQuality are hints, "
      "because flat cells in boundary layers and tiny edges of Voronoi cells violate them.",
      { { "Volume", { Positive, Infinity }, Cited, Polyhedra },
        { "MaxNonOrthogonality", { -Infinity, 70 }, Cited, Polyhedra },
        { "MaxFaceSkewness", { -Infinity, 4 }, Cited, Polyhedra },
        { "CellAspectRatio", { -Infinity, 1000 }, Hint, Polyhedra },
        { "MinFacePyramidVolume", { Positive, Infinity }, Cited, Polyhedra },
        { "MinFaceWeight", { 0.05, Infinity }, Cited, Polyhedra },
        { "MinVolumeRatio", { 0.01, Infinity }, Cited, Polyhedra },
        { "MinFaceFlatness", { 0.8, Infinity }, Cited, Polyhedra },
        { "MaxFaceConcavity", { -Infinity, 80 }, Cited, Polyhedra },
        { "MinTetQuality", { 1e-15, Infinity }, Hint, Polyhedra },
        { "CellDeterminant", { 0.001, Infinity }, Hint, Polyhedra },
        { "Openness", { -Infinity, 1e-6 }, Cited, Polyhedra } } },
    { "Surface", "Surfaces of triangles and quadrilaterals; ranges of the Verdict manual, rev. A, "
      "for triangles, and that of the maximum angle for quadrilaterals. Ranges that stretched "
      "triangles violate on purpose are hints.",
      { { "Area", { Positive, Infinity }, Cited, Polygons },
        { "MinInteriorAngle", { 30, Infinity }, Hint, SimplePolygons },
        { "MaxInteriorAngle", { -Infinity, 135 }, Cited, SimplePolygons },
        { "EdgeLengthRatio", { 1 / 1.3, Infinity }, Hint, SimplePolygons },
        { "TriangleRadiusRatio", { 1.0 / 3, Infinity }, Hint, Triangles },
        { "MaxNeighborNormalAngle", { -Infinity, Infinity } } } },
    { "VEM", "Virtual elements on any polygons and polyhedra: measures that the shape-regularity "
      "assumptions limit; there are no agreed limits.",
      { { "EdgeLengthRatio", { -Infinity, Infinity } },
        { "IsoperimetricQuotient", { -Infinity, Infinity } },
        { "EquiangleSkewness", { -Infinity, Infinity } },
        { "MaxDihedralAngle", { -Infinity, Infinity } },
        { "KernelRatio", { Positive, Infinity }, Cited, PolygonsAndPolyhedra },
        { "ShapeRegularity", { -Infinity, Infinity } },
        { "VemQuality", { -Infinity, Infinity } },
        { "PolyhedronQuality", { -Infinity, Infinity } } } },
  };
  // clang-format on
  return presets;
}

//------------------------------------------------------------------------------
const Preset* FindPreset(std::string_view name)
{
  for (const Preset& preset : GetPresets())
  {
    if (name == preset.Name)
    {
      return &preset;
    }
  }
  return nullptr;
}
}
