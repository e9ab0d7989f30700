// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkMeshInspectionMapper that changes VTK's shaders and sets their uniforms.
#include "InspectionArrays.h"
#include "InspectionTables.h"
#include "MeshMatrices.h"
#include "Shaders.h"
#include "vtkMeshInspectionMapper.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkHardwareSelector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLTexture.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>

#include "OpenGL.h"

using namespace camaron;

namespace
{
//------------------------------------------------------------------------------
// The position of the eye in the coordinates of the tables (w is 1), or the direction to it (w is
// 0).
std::array<double, 4> GetEye(
  vtkRenderer* renderer, vtkActor* actor, const std::array<double, 3>& middle)
{
  const MeshMatrices matrices(renderer, actor, middle);
  vtkMatrix4x4* toTables = matrices.ToView;
  toTables->Invert();
  const bool isParallel = renderer->GetActiveCamera()->GetParallelProjection();
  const double inView[4] = { 0, 0, isParallel ? 1.0 : 0.0, isParallel ? 0.0 : 1.0 };
  std::array<double, 4> eye;
  toTables->MultiplyPoint(inView, eye.data());
  return eye;
}

//------------------------------------------------------------------------------
// The height or depth as the distance from a plane: a x + b y + c z + d.
std::array<double, 4> GetPlane(const InspectionStyle& style, vtkMatrix4x4* toView)
{
  std::array<double, 4> plane = { { 0, 0, 0, 0 } };
  if (style.ColorBy == Coloring::Depth)
  {
    for (int i = 0; i < 4; ++i)
    {
      plane[i] = -toView->GetElement(2, i);
    }
    return plane;
  }
  std::copy(style.HeightDirection.begin(), style.HeightDirection.end(), plane.begin());
  if (vtkMath::Normalize(plane.data()) == 0.0)
  {
    plane[2] = 1;
  }
  return plane;
}

//------------------------------------------------------------------------------
// The smallest and the largest distance of the corners of a box.
std::array<double, 2> GetRange(const std::array<double, 4>& plane, const double bounds[6])
{
  std::array<double, 2> range = { { plane[3], plane[3] } };
  for (int i = 0; i < 3; ++i)
  {
    const double low = plane[i] * bounds[2 * i];
    const double high = plane[i] * bounds[2 * i + 1];
    range[0] += std::min(low, high);
    range[1] += std::max(low, high);
  }
  return range;
}

//------------------------------------------------------------------------------
// Height or depth as a fraction of a range: coefficients (a, b, c, d) for which a x + b y + c z + d
// is 0 at its low end and 1 at its high end, for points relative to @a middle. Without a custom
// range, the ends are those of @a bounds. @a toView: from coordinates of the mesh to those of the
// camera, which looks along -z.
std::array<double, 4> GetDistanceRamp(const InspectionStyle& style, const double bounds[6],
  const std::array<double, 3>& middle, vtkMatrix4x4* toView)
{
  std::array<double, 4> plane = GetPlane(style, toView);
  std::array<double, 2> range = style.CustomColorRange ? style.ColorRange : GetRange(plane, bounds);
  if (!style.CustomColorRange && style.ColorBy == Coloring::Depth)
  {
    range[0] = std::max(range[0], 0.0); // nothing is visible behind the eye
  }
  for (int i = 0; i < 3; ++i)
  {
    plane[3] += plane[i] * middle[i];
  }
  const double width = range[1] > range[0] ? range[1] - range[0] : 1.0;
  plane[3] -= range[0];
  for (double& coefficient : plane)
  {
    coefficient /= width;
  }
  return plane;
}

//------------------------------------------------------------------------------
// Draws the point that Cap.glsl finds on the line of sight instead of the point on the face.
void PutOnCap(std::string& fragment)
{
  const auto replace = [&](const char* place, const char* code)
  { vtkShaderProgram::Substitute(fragment, std::string("//VTK::") + place, code); };
  replace("PositionVC::Dec", "");
  replace("PositionVC::Impl",
    "bool isHit = findHit();\n"
    "  vec4 vertexVC = MCVCMatrix * vec4(hitPlace, 1.0);\n"
    "  vec4 hitDC = MCDCMatrix * vec4(hitPlace, 1.0);\n"
    "  findInputs(vec4(hitPlace, 1.0));\n"
    "  findLines();\n");
  replace("Depth::Impl",
    "if (!isHit || abs(hitDC.z) > hitDC.w) { discard; }\n"
    "  gl_FragDepth = 0.5 * hitDC.z / hitDC.w + 0.5;\n");
  replace("Normal::Dec", "");
  replace("Normal::Impl",
    "vec3 normalVCVSOutput = normalize(normalMatrix * hitNormal);\n"
    "  vec3 coatNormalVCVSOutput = normalVCVSOutput;\n");
}
}

//------------------------------------------------------------------------------
bool vtkMeshInspectionMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  const bool base = this->Superclass::GetNeedToRebuildShaders(helper, renderer, actor);
  InspectionTables& self = *this->Internal;
  const bool isPicking = renderer->GetSelector() != nullptr;
  const bool isPoints = &helper == &this->Primitives[PrimitivePoints];
  self.Code = GetRenderModeCode(self.GetStyleOfPicture(this, this->DrawsPoints(helper)),
    this->PrimitiveInfo[&helper].LastLightComplexity > 0);
  self.Code.Defines += self.Colors.GetDefine();
  if (!self.Values.IsEmpty())
  {
    self.Code.Defines +=
      self.HasCellValues ? "#define HAS_CELL_VALUES\n" : "#define HAS_POINT_VALUES\n";
  }
  self.Code.Defines += self.Style.MovesCells() ? "#define HAS_CENTROIDS\n" : "";
  self.Code.Defines += self.Style.What == Figure::PointNormals ? "#define HAS_POINT_NORMALS\n" : "";
  self.Code.Defines += self.Style.What == Figure::Isosurfaces ? "#define IS_ISOSURFACE\n" : "";
  // Points are picked only where they are drawn.
  const bool arePoints = isPoints || (this->PointPicking && self.Style.Points);
  self.Code.Defines += arePoints ? "#define ARE_POINTS\n" : "";
  self.Code.Defines += isPoints || this->PointPicking ? "#define ARE_NODES\n" : "";
  self.Code.Defines += isPicking ? "#define IS_PICKING\n" : "";
  const std::string key = self.Code.Defines + self.Code.ColorCalls + self.Code.NormalCalls;
  const bool isNew = key != self.ShaderKeys[&helper];
  self.ShaderKeys[&helper] = key;
  return base || isNew;
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::GetShaderTemplate(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::GetShaderTemplate(shaders, renderer, actor);
  const InspectionTables& self = *this->Internal;
  const bool isCap = self.Style.What == Figure::Cap;
  std::string vertex = self.Style.DrawsNormals() ? NormalLinesVS : isCap ? CapVS : FacesVS;
  vtkShaderProgram::Substitute(vertex, "//Camaron::Defines", self.Code.Defines);
  vtkShaderProgram::Substitute(vertex, "//Camaron::Place", PlaceGLSL);
  vtkShaderProgram::Substitute(vertex, "//Camaron::Inputs", InputsGLSL);
  vtkShaderProgram::Substitute(vertex, "//Camaron::Shape", InShapeGLSL);
  shaders[vtkShader::Vertex]->SetSource(vertex);
  shaders[vtkShader::Geometry]->SetSource("");

  std::string fragment = shaders[vtkShader::Fragment]->GetSource();
  std::string declarations = "flat in uint cellOfFace;\n"
                             "flat in uint cellMarks;\n"
                             "flat in int isCutFace;\n" +
    self.Code.Declarations;
  // Modes refer to uniforms of material and camera, which VTK declares last.
  vtkShaderProgram::Substitute(
    fragment, "//VTK::System::Dec", "//VTK::System::Dec\n" + self.Code.Defines);
  vtkShaderProgram::Substitute(fragment, "//VTK::Edges::Dec", "//VTK::Edges::Dec\n" + declarations);
  vtkShaderProgram::Substitute(fragment, "//VTK::UniformFlow::Impl",
    "//VTK::UniformFlow::Impl\n"
    "#ifdef HAS_ISOLINES\n"
    "  findLevelRate();\n"
    "#endif\n");
  vtkShaderProgram::Substitute(
    fragment, "//VTK::Edges::Impl", self.Code.ColorCalls + "//VTK::Edges::Impl\n");
  vtkShaderProgram::Substitute(
    fragment, "//VTK::PBR::Impl", self.Code.NormalCalls + "//VTK::PBR::Impl\n");
  if (isCap)
  {
    PutOnCap(fragment);
  }
  shaders[vtkShader::Fragment]->SetSource(fragment);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::ReplaceShaderTCoord(
  std::map<vtkShader::Type, vtkShader*>, vtkRenderer*, vtkActor*)
{
  // The only texture coordinates are those of colors, which the shaders compute themselves.
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::ReplaceShaderPicking(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  const char* id = nullptr;
  if (selector)
  {
    vtkCellData* data = this->Internal->Grid->GetCellData();
    switch (selector->GetCurrentPass())
    {
      case vtkHardwareSelector::POINT_ID_LOW24:
        id = "pickedPoint";
        break;
      case vtkHardwareSelector::POINT_ID_HIGH24:
        id = "pickedPoint >> 24";
        break;
      case vtkHardwareSelector::CELL_ID_LOW24:
        id = "cellOfFace";
        break;
      case vtkHardwareSelector::CELL_ID_HIGH24:
        id = "cellOfFace >> 24";
        break;
      case vtkHardwareSelector::PROCESS_PASS:
        id = selector->GetUseProcessIdFromData() && data->HasArray(ProcessIdsName)
          ? "pickedOwner.x + 1u" // 0 means nothing
          : nullptr;
        break;
      case vtkHardwareSelector::COMPOSITE_INDEX_PASS:
        id = data->HasArray(BlockIdsName) ? "pickedOwner.y" : nullptr;
        break;
      default:
        break;
    }
  }
  if (!id)
  {
    this->Superclass::ReplaceShaderPicking(shaders, renderer, actor);
    return;
  }
  std::string fragment = shaders[vtkShader::Fragment]->GetSource();
  vtkShaderProgram::Substitute(fragment, "//VTK::Picking::Dec", PickingGLSL);
  vtkShaderProgram::Substitute(
    fragment, "//VTK::Picking::Impl", std::string("  gl_FragData[0] = colorOfId(") + id + ");\n");
  shaders[vtkShader::Fragment]->SetSource(fragment);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(helper, renderer, actor);
  InspectionTables& self = *this->Internal;
  vtkShaderProgram* program = helper.Program;
  const InspectionMesh& mesh = *self.Mesh;
  self.Attach(program, "triangleTable", mesh.Triangles);
  self.Attach(program, "faceTable", mesh.Faces);
  self.Attach(program, "pointTable", mesh.Points);
  self.Attach(program, "markTable", mesh.Marks);
  self.Attach(program, "visibleTable", self.IsListed ? self.Visible.GetTable() : mesh.Marks);
  self.Attach(program, "cornerTable", self.Isosurface.GetTable());
  self.Attach(program, "cutTable", self.Cut.GetTable());
  self.Attach(program, "tetrahedronTable", mesh.Tetrahedra);
  self.Attach(program, "cellOfTetrahedronTable", mesh.CellsOfTetrahedra);
  self.Attach(program, "firstNegativeTable", mesh.FirstNegatives);
  self.Attach(program, "negativeBoxTable", mesh.NegativeBoxes);
  self.Attach(program, "centroidTable", mesh.Centroids);
  self.Attach(program, "ownerTable", mesh.Owners);
  self.Attach(program, "colorTable", self.Colors.GetTable());
  self.Attach(program, "normalTable", self.Normals.GetTable());
  self.Attach(program, "valueTable", self.Values.GetTable());
  self.Attach(program, "levelTable", self.Levels.GetTable());
  self.Attach(program, "leafTable", mesh.Leaves);
  self.Attach(program, "lookTable", self.Looks);
  program->SetUniformi("isListed", self.IsListed ? 1 : 0);
  program->SetUniformi("numberOfNodes", static_cast<int>(self.Mesh->GetNumberOfNodes()));
  program->SetUniformf("shrinkFactor", static_cast<float>(self.Style.ShrinkFactor));
  program->SetUniformf("explodeFactor", static_cast<float>(self.Style.ExplodeFactor));
  program->SetUniform3f("explodeCenter", self.Style.GetExplodeCenter(mesh.GetMiddle()).data());
  if (this->InternalColorTexture && program->IsUniformUsed("colortexture"))
  {
    program->SetUniformi("colortexture", this->InternalColorTexture->GetTextureUnit());
  }
  int viewport[4];
  glGetIntegerv(GL_VIEWPORT, viewport);
  const InspectionStyle style = self.GetStyleOfPicture(this, this->DrawsPoints(helper));
  const bool hasBounds = style.Bounds[0] <= style.Bounds[1];
  vtkNew<vtkMatrix4x4> toView;
  vtkMatrix4x4::Multiply4x4(
    renderer->GetActiveCamera()->GetModelViewTransformMatrix(), actor->GetMatrix(), toView);
  const std::array<double, 4> distance = GetDistanceRamp(
    style, hasBounds ? style.Bounds.data() : this->GetBounds(), mesh.GetMiddle(), toView);
  const std::array<double, 4> eye = GetEye(renderer, actor, mesh.GetMiddle());
  const RenderContext context{ style, actor->GetProperty(), distance, viewport, mesh.GetMiddle(),
    eye, self.Values.GetOrigin(), self.Levels.GetOrigin() };
  for (const RenderMode& mode : GetRenderModes())
  {
    if (mode.IsOn(style))
    {
      mode.SetUniforms(program, context);
    }
  }
}

//------------------------------------------------------------------------------
// Coordinates in the tables are relative to the middle of the mesh; the matrices add it in double
// precision.
void vtkMeshInspectionMapper::SetCameraShaderParameters(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetCameraShaderParameters(helper, renderer, actor);
  const MeshMatrices matrices(renderer, actor, this->Internal->Mesh->GetMiddle());
  // GLSL stores matrices by columns.
  matrices.ToView->Transpose();
  matrices.ToDisplay->Transpose();
  helper.Program->SetUniformMatrix("MCDCMatrix", matrices.ToDisplay);
  if (helper.Program->IsUniformUsed("MCVCMatrix"))
  {
    helper.Program->SetUniformMatrix("MCVCMatrix", matrices.ToView);
  }
}
