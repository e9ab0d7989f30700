// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The measures of Verdict against VTK's own use of it, and where VTK's results are corrected.
#include "CriteriaTesting.h"

#include "vtkIdList.h"
#include "vtkMeshQuality.h"

#include <random>

using namespace camaron;
using namespace camaron::testing;

namespace
{
// A function of VTK, some of which since 9.6 may also be asked for an approximation.
class MeasureOfVTK
{
public:
  MeasureOfVTK(double (*measure)(vtkCell*))
    : Exact(measure)
  {
  }
  MeasureOfVTK(double (*measure)(vtkCell*, bool))
    : WithChoice(measure)
  {
  }
  double operator()(vtkCell* cell) const
  {
    return this->Exact ? this->Exact(cell) : this->WithChoice(cell, false);
  }

private:
  double (*Exact)(vtkCell*) = nullptr;
  double (*WithChoice)(vtkCell*, bool) = nullptr;
};

struct Row
{
  int Type;
  const char* Name;
  MeasureOfVTK OfVTK;
};

const Row Rows[] = {
  { VTK_TRIANGLE, "VerdictArea", vtkMeshQuality::TriangleArea },
  { VTK_QUAD, "VerdictArea", vtkMeshQuality::QuadArea },
  { VTK_TRIANGLE, "VerdictAspectFrobenius", vtkMeshQuality::TriangleAspectFrobenius },
  { VTK_TETRA, "VerdictAspectFrobenius", vtkMeshQuality::TetAspectFrobenius },
  { VTK_TETRA, "VerdictAspectGamma", vtkMeshQuality::TetAspectGamma },
  { VTK_TRIANGLE, "VerdictAspectRatio", vtkMeshQuality::TriangleAspectRatio },
  { VTK_QUAD, "VerdictAspectRatio", vtkMeshQuality::QuadAspectRatio },
  { VTK_TETRA, "VerdictAspectRatio", vtkMeshQuality::TetAspectRatio },
  { VTK_TETRA, "VerdictCollapseRatio", vtkMeshQuality::TetCollapseRatio },
  { VTK_TRIANGLE, "VerdictCondition", vtkMeshQuality::TriangleCondition },
  { VTK_QUAD, "VerdictCondition", vtkMeshQuality::QuadCondition },
  { VTK_TETRA, "VerdictCondition", vtkMeshQuality::TetCondition },
  { VTK_WEDGE, "VerdictCondition", vtkMeshQuality::WedgeCondition },
  { VTK_HEXAHEDRON, "VerdictCondition", vtkMeshQuality::HexCondition },
  { VTK_HEXAHEDRON, "VerdictDiagonal", vtkMeshQuality::HexDiagonal },
  { VTK_HEXAHEDRON, "VerdictDimension", vtkMeshQuality::HexDimension },
  { VTK_TRIANGLE, "VerdictDistortion", vtkMeshQuality::TriangleDistortion },
  { VTK_QUAD, "VerdictDistortion", vtkMeshQuality::QuadDistortion },
  { VTK_TETRA, "VerdictDistortion", vtkMeshQuality::TetDistortion },
  { VTK_WEDGE, "VerdictDistortion", vtkMeshQuality::WedgeDistortion },
  { VTK_HEXAHEDRON, "VerdictDistortion", vtkMeshQuality::HexDistortion },
  { VTK_TRIANGLE, "VerdictEdgeRatio", vtkMeshQuality::TriangleEdgeRatio },
  { VTK_QUAD, "VerdictEdgeRatio", vtkMeshQuality::QuadEdgeRatio },
  { VTK_TETRA, "VerdictEdgeRatio", vtkMeshQuality::TetEdgeRatio },
  { VTK_WEDGE, "VerdictEdgeRatio", vtkMeshQuality::WedgeEdgeRatio },
  { VTK_HEXAHEDRON, "VerdictEdgeRatio", vtkMeshQuality::HexEdgeRatio },
  { VTK_TRIANGLE, "VerdictEquiangleSkew", vtkMeshQuality::TriangleEquiangleSkew },
  { VTK_QUAD, "VerdictEquiangleSkew", vtkMeshQuality::QuadEquiangleSkew },
  { VTK_TETRA, "VerdictEquiangleSkew", vtkMeshQuality::TetEquiangleSkew },
  { VTK_PYRAMID, "VerdictEquiangleSkew", vtkMeshQuality::PyramidEquiangleSkew },
  { VTK_WEDGE, "VerdictEquiangleSkew", vtkMeshQuality::WedgeEquiangleSkew },
  { VTK_HEXAHEDRON, "VerdictEquiangleSkew", vtkMeshQuality::HexEquiangleSkew },
  { VTK_TETRA, "VerdictEquivolumeSkew", vtkMeshQuality::TetEquivolumeSkew },
  { VTK_QUAD, "VerdictJacobian", vtkMeshQuality::QuadJacobian },
  { VTK_TETRA, "VerdictJacobian", vtkMeshQuality::TetJacobian },
  { VTK_PYRAMID, "VerdictJacobian", vtkMeshQuality::PyramidJacobian },
  { VTK_WEDGE, "VerdictJacobian", vtkMeshQuality::WedgeJacobian },
  { VTK_HEXAHEDRON, "VerdictJacobian", vtkMeshQuality::HexJacobian },
  { VTK_TRIANGLE, "VerdictMaxAngle", vtkMeshQuality::TriangleMaxAngle },
  { VTK_QUAD, "VerdictMaxAngle", vtkMeshQuality::QuadMaxAngle },
  { VTK_QUAD, "VerdictMaxAspectFrobenius", vtkMeshQuality::QuadMaxAspectFrobenius },
  { VTK_WEDGE, "VerdictMaxAspectFrobenius", vtkMeshQuality::WedgeMaxAspectFrobenius },
  { VTK_HEXAHEDRON, "VerdictMaxAspectFrobenius", vtkMeshQuality::HexMaxAspectFrobenius },
  { VTK_QUAD, "VerdictMaxEdgeRatio", vtkMeshQuality::QuadMaxEdgeRatio },
  { VTK_HEXAHEDRON, "VerdictMaxEdgeRatio", vtkMeshQuality::HexMaxEdgeRatio },
  { VTK_WEDGE, "VerdictMaxStretch", vtkMeshQuality::WedgeMaxStretch },
  { VTK_WEDGE, "VerdictMeanAspectFrobenius", vtkMeshQuality::WedgeMeanAspectFrobenius },
  { VTK_TETRA, "VerdictMeanRatio", vtkMeshQuality::TetMeanRatio },
  { VTK_QUAD, "VerdictMedAspectFrobenius", vtkMeshQuality::QuadMedAspectFrobenius },
  { VTK_HEXAHEDRON, "VerdictMedAspectFrobenius", vtkMeshQuality::HexMedAspectFrobenius },
  { VTK_TRIANGLE, "VerdictMinAngle", vtkMeshQuality::TriangleMinAngle },
  { VTK_QUAD, "VerdictMinAngle", vtkMeshQuality::QuadMinAngle },
  { VTK_TETRA, "VerdictMinAngle", vtkMeshQuality::TetMinAngle },
  { VTK_HEXAHEDRON, "VerdictNodalJacobianRatio", vtkMeshQuality::HexNodalJacobianRatio },
  { VTK_TRIANGLE, "VerdictNormalizedInradius", vtkMeshQuality::TriangleNormalizedInradius },
  { VTK_TETRA, "VerdictNormalizedInradius", vtkMeshQuality::TetNormalizedInradius },
  { VTK_QUAD, "VerdictOddy", vtkMeshQuality::QuadOddy },
  { VTK_HEXAHEDRON, "VerdictOddy", vtkMeshQuality::HexOddy },
  { VTK_TRIANGLE, "VerdictRadiusRatio", vtkMeshQuality::TriangleRadiusRatio },
  { VTK_QUAD, "VerdictRadiusRatio", vtkMeshQuality::QuadRadiusRatio },
  { VTK_TETRA, "VerdictRadiusRatio", vtkMeshQuality::TetRadiusRatio },
  { VTK_TRIANGLE, "VerdictScaledJacobian", vtkMeshQuality::TriangleScaledJacobian },
  { VTK_QUAD, "VerdictScaledJacobian", vtkMeshQuality::QuadScaledJacobian },
  { VTK_TETRA, "VerdictScaledJacobian", vtkMeshQuality::TetScaledJacobian },
  { VTK_PYRAMID, "VerdictScaledJacobian", vtkMeshQuality::PyramidScaledJacobian },
  { VTK_WEDGE, "VerdictScaledJacobian", vtkMeshQuality::WedgeScaledJacobian },
  { VTK_HEXAHEDRON, "VerdictScaledJacobian", vtkMeshQuality::HexScaledJacobian },
  { VTK_TRIANGLE, "VerdictShape", vtkMeshQuality::TriangleShape },
  { VTK_QUAD, "VerdictShape", vtkMeshQuality::QuadShape },
  { VTK_TETRA, "VerdictShape", vtkMeshQuality::TetShape },
  { VTK_PYRAMID, "VerdictShape", vtkMeshQuality::PyramidShape },
  { VTK_WEDGE, "VerdictShape", vtkMeshQuality::WedgeShape },
  { VTK_HEXAHEDRON, "VerdictShape", vtkMeshQuality::HexShape },
  { VTK_QUAD, "VerdictShear", vtkMeshQuality::QuadShear },
  { VTK_HEXAHEDRON, "VerdictShear", vtkMeshQuality::HexShear },
  { VTK_QUAD, "VerdictSkew", vtkMeshQuality::QuadSkew },
  { VTK_HEXAHEDRON, "VerdictSkew", vtkMeshQuality::HexSkew },
  { VTK_TETRA, "VerdictSquishIndex", vtkMeshQuality::TetSquishIndex },
  { VTK_QUAD, "VerdictStretch", vtkMeshQuality::QuadStretch },
  { VTK_HEXAHEDRON, "VerdictStretch", vtkMeshQuality::HexStretch },
  { VTK_QUAD, "VerdictTaper", vtkMeshQuality::QuadTaper },
  { VTK_HEXAHEDRON, "VerdictTaper", vtkMeshQuality::HexTaper },
  { VTK_TETRA, "VerdictVolume", vtkMeshQuality::TetVolume },
  { VTK_PYRAMID, "VerdictVolume", vtkMeshQuality::PyramidVolume },
  { VTK_WEDGE, "VerdictVolume", vtkMeshQuality::WedgeVolume },
  { VTK_HEXAHEDRON, "VerdictVolume", vtkMeshQuality::HexVolume },
  { VTK_QUAD, "VerdictWarpage", vtkMeshQuality::QuadWarpage },
};

double EvaluateOne(vtkDataSet* mesh, const char* name, const EvaluationOptions& options = {})
{
  double value = 0;
  const std::vector<CriterionValues> rows = { { FindCriterion(name), &value } };
  EXPECT_NE(rows[0].Criterion, nullptr) << name;
  EXPECT_TRUE(Evaluate(MeshTopology(mesh), options, rows, [](double) { return true; }));
  return value;
}

Grid MakeCell(int type)
{
  const Points square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  switch (type)
  {
    case VTK_TRIANGLE:
      return MakeGrid(square, { { VTK_TRIANGLE, { 0, 1, 2 } } });
    case VTK_QUAD:
      return MakeGrid(square, { { VTK_QUAD, { 0, 1, 2, 3 } } });
    default:
      return MakeStandardCell(type);
  }
}

//------------------------------------------------------------------------------
// Some versions of VTK pass a wedge to Verdict in VTK's order, that is inverted.
Grid AsVerdictWants(vtkUnstructuredGrid* grid)
{
  if (grid->GetCellType(0) != VTK_WEDGE ||
    vtkMeshQuality::WedgeVolume(MakeStandardCell(VTK_WEDGE)->GetCell(0)) > 0)
  {
    return grid;
  }
  Grid turned = MakeGrid({}, { { VTK_WEDGE, { 0, 2, 1, 3, 5, 4 } } });
  turned->SetPoints(grid->GetPoints());
  return turned;
}
}

//------------------------------------------------------------------------------
// If this fails, our numbers are not those that people know from VTK.
TEST(Verdict, EqualsMeshQuality)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-0.15, 0.15);
  for (int round = 0; round < 20; ++round)
  {
    for (const Row& row : Rows)
    {
      const Grid grid = MakeCell(row.Type);
      for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
      {
        double x[3];
        grid->GetPoint(i, x);
        const bool isFlat = row.Type == VTK_TRIANGLE || row.Type == VTK_QUAD;
        grid->GetPoints()->SetPoint(
          i, x[0] + noise(random), x[1] + noise(random), x[2] + (isFlat ? 0 : noise(random)));
      }
      const double expected = row.OfVTK(AsVerdictWants(grid)->GetCell(0));
      EXPECT_NEAR(EvaluateOne(grid, row.Name), expected, 1e-9 * std::max(1.0, std::abs(expected)))
        << row.Name << " of type " << row.Type;
    }
  }
}

//------------------------------------------------------------------------------
// VTK's means are those of all cells that a process has; here, of all there are.
TEST(Verdict, SizesEqualMeshQuality)
{
  const Row rows[] = {
    { VTK_TRIANGLE, "VerdictRelativeSizeSquared", vtkMeshQuality::TriangleRelativeSizeSquared },
    { VTK_TRIANGLE, "VerdictShapeAndSize", vtkMeshQuality::TriangleShapeAndSize },
    { VTK_QUAD, "VerdictRelativeSizeSquared", vtkMeshQuality::QuadRelativeSizeSquared },
    { VTK_QUAD, "VerdictShapeAndSize", vtkMeshQuality::QuadShapeAndSize },
    { VTK_QUAD, "VerdictShearAndSize", vtkMeshQuality::QuadShearAndSize },
    { VTK_TETRA, "VerdictRelativeSizeSquared", vtkMeshQuality::TetRelativeSizeSquared },
    { VTK_TETRA, "VerdictShapeAndSize", vtkMeshQuality::TetShapeAndSize },
    { VTK_HEXAHEDRON, "VerdictRelativeSizeSquared", vtkMeshQuality::HexRelativeSizeSquared },
    { VTK_HEXAHEDRON, "VerdictShapeAndSize", vtkMeshQuality::HexShapeAndSize },
    { VTK_HEXAHEDRON, "VerdictShearAndSize", vtkMeshQuality::HexShearAndSize },
  };
  std::mt19937 random(4);
  std::uniform_real_distribution<double> noise(-0.15, 0.15), size(0.5, 2);
  const Grid mesh = Grid::New();
  mesh->SetPoints(MakePoints({}));
  for (const int type : { VTK_TRIANGLE, VTK_QUAD, VTK_TETRA, VTK_HEXAHEDRON })
  {
    for (int copy = 0; copy < 6; ++copy)
    {
      const Grid cell = MakeCell(type);
      const double scale = size(random);
      const bool isFlat = type == VTK_TRIANGLE || type == VTK_QUAD;
      vtkNew<vtkIdList> ids;
      for (vtkIdType i = 0; i < cell->GetCell(0)->GetNumberOfPoints(); ++i)
      {
        double x[3];
        cell->GetPoint(cell->GetCell(0)->GetPointId(i), x);
        ids->InsertNextId(mesh->GetPoints()->InsertNextPoint(scale * (x[0] + noise(random)),
          scale * (x[1] + noise(random)), isFlat ? 0 : scale * (x[2] + noise(random))));
      }
      mesh->InsertNextCell(type, ids);
    }
  }
  vtkNew<vtkMeshQuality> quality;
  quality->SetInputData(mesh);
  quality->SetTriangleQualityMeasureToRelativeSizeSquared();
  quality->SetQuadQualityMeasureToRelativeSizeSquared();
  quality->SetTetQualityMeasureToRelativeSizeSquared();
  quality->SetHexQualityMeasureToRelativeSizeSquared();
  quality->Update(); // leaves the means where the functions look for them
  std::vector<double> values(mesh->GetNumberOfCells());
  int compared = 0;
  for (const Row& row : rows)
  {
    ASSERT_TRUE(Evaluate(MeshTopology(mesh), {}, { { FindCriterion(row.Name), values.data() } },
      [](double) { return true; }));
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      if (mesh->GetCellType(cell) == row.Type)
      {
        EXPECT_NEAR(values[cell], row.OfVTK(mesh->GetCell(cell)), 1e-9) << row.Name;
        EXPECT_GT(values[cell], 0);
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 60);
}

//------------------------------------------------------------------------------
TEST(Verdict, PitfallsAreMended)
{
  // Verdict says 1e30 for a hexahedron with a collapsed edge, which is not good.
  const Grid hexahedron = MakeStandardCell(VTK_HEXAHEDRON);
  double x[3];
  hexahedron->GetPoint(0, x);
  hexahedron->GetPoints()->SetPoint(1, x);
  EXPECT_LE(EvaluateOne(hexahedron, "VerdictScaledJacobian"), 0);
  // Verdict passes over the corners of a collapsed edge of a wedge, and does not see that a wedge
  // is inverted.
  Grid wedge = MakeStandardCell(VTK_WEDGE);
  wedge->GetPoint(0, x);
  wedge->GetPoints()->SetPoint(1, x);
  EXPECT_EQ(EvaluateOne(wedge, "VerdictScaledJacobian"), 0);
  wedge = MakeStandardCell(VTK_WEDGE);
  for (vtkIdType point = 0; point < wedge->GetNumberOfPoints(); ++point)
  {
    wedge->GetPoint(point, x);
    wedge->GetPoints()->SetPoint(point, x[0], x[1], -x[2]);
  }
  EXPECT_LT(EvaluateOne(wedge, "VerdictVolume"), 0);
  EXPECT_LT(EvaluateOne(wedge, "VerdictScaledJacobian"), 0);
  for (const char* name :
    { "VerdictCondition", "VerdictMaxAspectFrobenius", "VerdictMeanAspectFrobenius" })
  {
    EXPECT_EQ(EvaluateOne(wedge, name), std::numeric_limits<double>::infinity()) << name;
  }
  // A flat tetrahedron is infinitely bad.
  const Grid flat = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
  EXPECT_EQ(EvaluateOne(flat, "VerdictAspectRatio"), std::numeric_limits<double>::infinity());
  // Verdict's condition of an inverted tetrahedron is below 0, which is not less than 4 in the good
  // sense.
  const Grid inverted = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { VTK_TETRA, { 0, 2, 1, 3 } } });
  EXPECT_LT(
    EvaluateOne(inverted, "VerdictCondition"), FindCriterion("VerdictCondition")->Acceptable[0]);
  // Cells without such a measure are undefined, not -1.
  EXPECT_EQ(GetNullReason(EvaluateOne(flat, "VerdictMaxAngle")), NullReason::NotApplicable);
  // Of a quadrilateral with a collapsed edge Verdict's smallest angle is 360, and its skew below
  // that of a square.
  const Grid collapsed = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { VTK_QUAD, { 0, 1, 2, 3 } } });
  for (const char* name : { "VerdictMinAngle", "VerdictMaxAngle", "VerdictEquiangleSkew" })
  {
    EXPECT_EQ(GetNullReason(EvaluateOne(collapsed, name)), NullReason::Degenerate) << name;
  }
  // Whichever edge is collapsed: Verdict sees a triangle where the last two corners are one.
  for (vtkIdType corner = 0; corner < 4; ++corner)
  {
    const Grid quadrilateral = MakeCell(VTK_QUAD);
    quadrilateral->GetPoint((corner + 1) % 4, x);
    quadrilateral->GetPoints()->SetPoint(corner, x);
    for (const char* name : { "VerdictScaledJacobian", "VerdictShear", "VerdictShearAndSize" })
    {
      EXPECT_EQ(EvaluateOne(quadrilateral, name), 0) << name << " at corner " << corner;
    }
  }
  // One that crosses itself may lack a principal axis, of which Verdict makes the best skew.
  const Grid crossed = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } }, { { VTK_QUAD, { 0, 1, 2, 3 } } });
  EXPECT_EQ(EvaluateOne(crossed, "VerdictSkew"), std::numeric_limits<double>::infinity());
  // A tetrahedron is one whatever its VTK type.
  const Grid healthy = MakeStandardCell(VTK_TETRA);
  EXPECT_NEAR(
    EvaluateOne(ToPolyhedra(healthy), "VerdictShape"), EvaluateOne(healthy, "VerdictShape"), 1e-12);
  // Angles come in the unit that was asked for.
  EvaluationOptions radians;
  radians.Angles = AngleUnit::Radians;
  const Grid square = MakeCell(VTK_QUAD);
  EXPECT_NEAR(EvaluateOne(square, "VerdictMaxAngle"), 90, 1e-9);
  EXPECT_NEAR(EvaluateOne(square, "VerdictMaxAngle", radians), std::acos(0.0), 1e-12);
}

//------------------------------------------------------------------------------
// If this fails, voxels have values of their own in measures that depend on the order of the nodes.
TEST(Verdict, VoxelsAreHexahedra)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 2, 0, 0 }, { 0, 3, 0 }, { 2, 3, 0 }, { 0, 0, 5 },
                               { 2, 0, 5 }, { 0, 3, 5 }, { 2, 3, 5 } },
    { { VTK_VOXEL, { 0, 1, 2, 3, 4, 5, 6, 7 } }, { VTK_HEXAHEDRON, { 0, 1, 3, 2, 4, 5, 7, 6 } } });
  auto values = EvaluateAll(grid);
  EXPECT_EQ(values["VerdictEdgeRatio"][0], 1.5);
  for (const auto& criterion : values)
  {
    if (criterion.first.compare(0, 7, "Verdict") == 0 && !std::isnan(criterion.second[1]))
    {
      EXPECT_EQ(criterion.second[0], criterion.second[1]) << criterion.first;
    }
  }
}

//------------------------------------------------------------------------------
namespace
{
// Regular cells of edge length 1.
Grid MakeRegularCell(int type)
{
  const double height = std::sqrt(3.0) / 2;
  const Points triangle = { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, height, 0 } };
  switch (type)
  {
    case VTK_TRIANGLE:
      return MakeGrid(triangle, { { VTK_TRIANGLE, { 0, 1, 2 } } });
    case VTK_TETRA:
      return MakeGrid(
        { triangle[0], triangle[1], triangle[2], { 0.5, height / 3, std::sqrt(2.0 / 3) } },
        { { VTK_TETRA, { 0, 1, 2, 3 } } });
    default:
      return MakeCell(type); // the unit square and cube
  }
}
}

//------------------------------------------------------------------------------
// If this fails, a perfect cell is called bad: the registry and VTK mean opposite things by a
// measure.
TEST(Verdict, IdealIsThatOfRegularCells)
{
  const std::pair<int, unsigned> shapes[] = { { VTK_TRIANGLE, Triangles },
    { VTK_QUAD, Quadrilaterals }, { VTK_TETRA, Tetrahedra }, { VTK_HEXAHEDRON, Hexahedra } };
  for (const Criterion& criterion : GetCriteria())
  {
    for (const auto& shape : shapes)
    {
      const bool isVerdict = std::string_view(criterion.Name).substr(0, 7) == "Verdict";
      if (isVerdict && (criterion.AppliesTo & shape.second) && std::isfinite(criterion.Ideal))
      {
        EXPECT_NEAR(
          EvaluateOne(MakeRegularCell(shape.first), criterion.Name), criterion.Ideal, 1e-6)
          << criterion.Name << " of type " << shape.first;
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, Verdict takes small cells for collapsed ones, and large values for infinite: the
// same cell in other units has the same quality, and sizes in these units.
TEST(Verdict, AnySize)
{
  const auto getDimension = [](const Criterion& criterion, bool isPolygon)
  {
    return criterion.Unit == Unit::Length ? 1
      : criterion.Unit == Unit::Area      ? 2
      : criterion.Unit == Unit::Volume    ? (isPolygon ? 2 : 3)
                                          : 0;
  };
  std::vector<Grid> cells;
  for (const int type : { VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID })
  {
    cells.push_back(MakeStandardCell(type));
  }
  cells.push_back(MakePolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.2, 0.7, 0 } }));
  cells.push_back(MakePolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 1.2, 0.7, 0 }, { 0, 1, 0.1 } }));
  for (const Grid& cell : cells)
  {
    const bool isPolygon = cell->GetCell(0)->GetCellDimension() == 2;
    const Values unit = EvaluateAll(cell);
    for (const double size : { 1e-30, 1e-10, 1e8, 1e30 })
    {
      const Values scaled = EvaluateAll(Transform(
        cell, [=](const Point& p) { return Point{ size * p[0], size * p[1], size * p[2] }; }));
      for (const Criterion& criterion : GetCriteria())
      {
        if (std::string(criterion.Name).rfind("Verdict", 0) == 0)
        {
          const double unitSize = std::pow(size, getDimension(criterion, isPolygon));
          ExpectSame(unit.at(criterion.Name)[0], scaled.at(criterion.Name)[0] / unitSize, 1e-9,
            criterion.Name + (" of size " + std::to_string(std::log10(size))));
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// What the documentation says of our criteria and Verdict's. If this fails, it is wrong.
TEST(Verdict, AgreesWithOurCriteria)
{
  struct Pair
  {
    int Type;
    const char* Ours;
    const char* Verdicts;
    double (*Expected)(double);
  };
  const auto same = [](double x) { return x; };
  const auto inverse = [](double x) { return 1 / x; };
  const auto complement = [](double x) { return 1 - x; };
  const Pair pairs[] = {
    { VTK_TRIANGLE, "Area", "VerdictArea", same },
    { VTK_QUAD, "Area", "VerdictArea", same },
    { VTK_TETRA, "Volume", "VerdictVolume", same },
    { VTK_PYRAMID, "Volume", "VerdictVolume", same },
    { VTK_WEDGE, "Volume", "VerdictVolume", same },
    { VTK_HEXAHEDRON, "Volume", "VerdictVolume", same },
    { VTK_TRIANGLE, "EdgeRatio", "VerdictEdgeRatio", same },
    { VTK_QUAD, "EdgeRatio", "VerdictEdgeRatio", same },
    { VTK_TETRA, "EdgeRatio", "VerdictEdgeRatio", same },
    { VTK_WEDGE, "EdgeLengthRatio", "VerdictEdgeRatio", inverse },
    { VTK_TRIANGLE, "MinInteriorAngle", "VerdictMinAngle", same },
    { VTK_QUAD, "MinInteriorAngle", "VerdictMinAngle", same },
    { VTK_TRIANGLE, "MaxInteriorAngle", "VerdictMaxAngle", same },
    { VTK_QUAD, "MaxInteriorAngle", "VerdictMaxAngle", same },
    { VTK_TRIANGLE, "EquiangleSkewness", "VerdictEquiangleSkew", same },
    { VTK_QUAD, "EquiangleSkewness", "VerdictEquiangleSkew", same },
    { VTK_PYRAMID, "EquiangleSkewness", "VerdictEquiangleSkew", same },
    { VTK_WEDGE, "EquiangleSkewness", "VerdictEquiangleSkew", same },
    { VTK_HEXAHEDRON, "EquiangleSkewness", "VerdictEquiangleSkew", same },
    { VTK_TRIANGLE, "TriangleRadiusRatio", "VerdictRadiusRatio", inverse },
    { VTK_TRIANGLE, "TriangleRadiusRatio", "VerdictNormalizedInradius", same },
    { VTK_TRIANGLE, "BhatiaLawrence", "VerdictShape", same },
    { VTK_TRIANGLE, "BhatiaLawrence", "VerdictAspectFrobenius", inverse },
    { VTK_TRIANGLE, "BhatiaLawrence", "VerdictCondition", inverse },
    { VTK_TETRA, "TetRadiusRatio", "VerdictRadiusRatio", inverse },
    { VTK_TETRA, "TetMeanRatio", "VerdictShape", same },
    { VTK_TETRA, "TetQualityFoam", "VerdictEquivolumeSkew", complement },
    { VTK_TETRA, "VolumeEdgeRatio", "VerdictAspectGamma",
      [](double gamma) { return 1 / (6 * std::sqrt(2.0) * gamma); } },
    { VTK_HEXAHEDRON, "CornerScaledJacobian", "VerdictScaledJacobian", same },
  };
  std::mt19937 random(4);
  std::uniform_real_distribution<double> noise(-0.15, 0.15);
  for (const Pair& pair : pairs)
  {
    for (int round = 0; round < 20; ++round)
    {
      const Grid grid = MakeCell(pair.Type);
      const bool isFlat = pair.Type == VTK_TRIANGLE || pair.Type == VTK_QUAD;
      for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
      {
        double x[3];
        grid->GetPoint(i, x);
        grid->GetPoints()->SetPoint(
          i, x[0] + noise(random), x[1] + noise(random), x[2] + (isFlat ? 0 : noise(random)));
      }
      const double ours = EvaluateOne(grid, pair.Ours);
      EXPECT_NEAR(ours, pair.Expected(EvaluateOne(grid, pair.Verdicts)), 1e-9 * std::abs(ours))
        << pair.Ours << " of type " << pair.Type;
    }
  }
  // VTK has no function for this one.
  const Grid tetrahedron = MakeCell(VTK_TETRA);
  EXPECT_NEAR(EvaluateOne(tetrahedron, "VerdictInradius"),
    3 * EvaluateOne(tetrahedron, "Volume") / EvaluateOne(tetrahedron, "SurfaceArea"), 1e-12);
}
