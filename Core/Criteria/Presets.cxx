// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/Criterion.h"

#include <limits>

namespace camaron
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Positive = std::numeric_limits<double>::min();
constexpr bool Hint = true;

//------------------------------------------------------------------------------
// With the acceptable ranges of the table of criteria.
std::vector<Preset::Rule> AsInTable(const std::vector<const char*>& names)
{
  std::vector<Preset::Rule> rules;
  for (const char* name : names)
  {
    const Criterion& criterion = *FindCriterion(name);
    rules.push_back(
      { name, { criterion.Acceptable[0], criterion.Acceptable[1] }, criterion.AcceptableIsHint });
  }
  return rules;
}
}

//------------------------------------------------------------------------------
const std::vector<Preset>& GetPresets()
{
  // clang-format off
  static const std::vector<Preset> presets = {
    { "Overview", "Shape at a glance, for any polygon or polyhedron; ranges as in the table of criteria.",
      { { "EdgeLengthRatio", { 1.0 / 3, Infinity }, Hint },
        { "EquiangleSkewness", { -Infinity, 0.9 }, Hint },
        { "IsoperimetricQuotient", { -Infinity, Infinity } } } },
    { "General", "What a report shows unless asked otherwise; ranges as in the table of criteria.",
      AsInTable({ "Area", "Perimeter", "SurfaceArea", "Volume", "VertexCount", "EdgeCount", "FaceCount",
        "MinEdgeLength", "MaxEdgeLength", "MeanEdgeLength", "Diameter", "MinInteriorAngle",
        "MaxInteriorAngle", "MinFaceAngle", "MaxFaceAngle", "MinDihedralAngle", "MaxDihedralAngle",
        "MinSolidAngle", "MaxSolidAngle", "EquiangleSkewness", "MaxNeighborNormalAngle",
        "EdgeLengthRatio", "IsoperimetricQuotient", "CellAspectRatio", "TriangleRadiusRatio",
        "BhatiaLawrence", "TetRadiusEdgeRatio", "TetRadiusRatio", "TetMeanRatio", "MinFaceFlatness",
        "MinTetMeanRatio", "CellStatus", "MaxNonOrthogonality", "MaxFaceSkewness", "MinVolumeRatio",
        "OrthogonalQuality" }) },
    { "FEM tetrahedra", "Finite elements on tetrahedra; ranges of the Verdict manual, rev. A, for "
      "tetrahedra; TetGen's default bound of the radius-edge ratio; 165 degrees are common practice.",
      { { "Volume", { Positive, Infinity } },
        { "MinDihedralAngle", { 40, Infinity } },
        { "MaxDihedralAngle", { -Infinity, 165 }, Hint },
        { "TetRadiusEdgeRatio", { -Infinity, 2 } },
        { "TetRadiusRatio", { 1.0 / 3, Infinity } },
        { "TetMeanRatio", { 0.3, Infinity } },
        { "EdgeLengthRatio", { 1.0 / 3, Infinity } } } },
    { "FEM hexahedra", "Finite elements on hexahedra; ranges of the Verdict manual, rev. A, for "
      "hexahedra (scaled Jacobian) and their quadrilaterals (angles, edges).",
      { { "Volume", { Positive, Infinity } },
        { "MinFaceAngle", { 45, Infinity } },
        { "MaxFaceAngle", { -Infinity, 135 } },
        { "EdgeLengthRatio", { 1 / 1.3, Infinity } },
        { "EquiangleSkewness", { -Infinity, 0.5 } },
        { "CornerScaledJacobian", { 0.5, Infinity } } } },
    { "Finite volume", "Finite volumes on any polyhedra; limits of OpenFOAM's checkMesh (non-orthogonality "
      "from 70 degrees, skewness, aspect ratio, flatness, openness) and of its meshQualityDict (the others).",
      { { "Volume", { Positive, Infinity } },
        { "MaxNonOrthogonality", { -Infinity, 70 } },
        { "MaxFaceSkewness", { -Infinity, 4 } },
        { "CellAspectRatio", { -Infinity, 1000 } },
        { "MinFacePyramidVolume", { Positive, Infinity } },
        { "MinFaceWeight", { 0.05, Infinity } },
        { "MinVolumeRatio", { 0.01, Infinity } },
        { "MinFaceFlatness", { 0.8, Infinity } },
        { "MaxFaceConcavity", { -Infinity, 80 } },
        { "MinTetQuality", { 1e-15, Infinity } },
        { "CellDeterminant", { 0.001, Infinity } },
        { "Openness", { -Infinity, 1e-6 } } } },
    { "Surface", "Polygonal surfaces; ranges of the Verdict manual, rev. A, for triangles, and that of the largest angle for "
      "quadrilaterals.",
      { { "Area", { Positive, Infinity } },
        { "MinInteriorAngle", { 30, Infinity }, Hint },
        { "MaxInteriorAngle", { -Infinity, 135 }, Hint },
        { "EdgeLengthRatio", { 1 / 1.3, Infinity } },
        { "TriangleRadiusRatio", { 1.0 / 3, Infinity } },
        { "MaxNeighborNormalAngle", { -Infinity, Infinity } } } },
    { "VEM", "Virtual elements on any polygons and polyhedra: what the shape-regularity assumptions bound; "
      "no agreed limits.",
      { { "EdgeLengthRatio", { -Infinity, Infinity } },
        { "IsoperimetricQuotient", { -Infinity, Infinity } },
        { "EquiangleSkewness", { -Infinity, 0.9 }, Hint },
        { "MaxDihedralAngle", { -Infinity, 180 }, Hint },
        { "KernelRatio", { Positive, Infinity } },
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
