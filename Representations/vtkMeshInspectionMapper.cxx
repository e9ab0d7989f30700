// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshInspectionMapper.h"

#include "CapVS.h"
#include "DistanceRamp.h"
#include "FacesVS.h"
#include "InspectionArrays.h"
#include "InputsGLSL.h"
#include "InspectionTables.h"
#include "MeshMatrices.h"
#include "NormalLinesVS.h"
#include "PickingGLSL.h"
#include "PlaceGLSL.h"
#include "ProcessorDrawing.h"
#include "RenderModes.h"
#include "SelectorPixels.h"

#include "vtkActor.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLTexture.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProgram.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "OpenGL.h"

using namespace camaron;

vtkStandardNewMacro(vtkMeshInspectionMapper);

namespace
{
//------------------------------------------------------------------------------
// Where the eye is in the coordinates of the tables, or in which direction.
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
// What is drawn is not the face, but what Cap.glsl finds before it.
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

//==============================================================================
class vtkMeshInspectionMapper::Internals : public InspectionTables
{
public:
  vtkNew<vtkPolyData> Placeholder;
  RenderModeCode Code;
  std::map<vtkOpenGLHelper*, std::string> ShaderKeys;

  ProcessorDrawing Processor;
  vtkSmartPointer<vtkUnstructuredGrid> RefusedGrid; ///< by the graphics card
  vtkMTimeType RefusedTime = 0;
  bool IsOnProcessor() const
  {
    return this->Style.OnProcessor ||
      (this->Grid && this->Grid == this->RefusedGrid && this->Grid->GetMTime() == this->RefusedTime);
  }
};

//==============================================================================
vtkMeshInspectionMapper::vtkMeshInspectionMapper()
  : Internal(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkMeshInspectionMapper::~vtkMeshInspectionMapper()
{
  // The base class would do it too late for our part.
  this->vtkMeshInspectionMapper::ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::SetStyle(const InspectionStyle& style)
{
  this->Internal->Style = style;
  if (style.DrawsPointsOnly())
  {
    this->Internal->Style.WallsToDraw = Walls::Complete;
  }
  this->SetInputDataObject(0, this->Internal->Grid);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::ShareMesh(vtkMeshInspectionMapper* other)
{
  this->Internal->Mesh = other->Internal->Mesh;
  this->Internal->OwnsMesh = false;
}

//------------------------------------------------------------------------------
std::shared_ptr<InspectionMesh> vtkMeshInspectionMapper::GetMesh() const
{
  return this->Internal->Mesh;
}

//------------------------------------------------------------------------------
std::size_t vtkMeshInspectionMapper::GetNumberOfTriangles(bool changesWithCamera) const
{
  const Internals& self = *this->Internal;
  return changesWithCamera && self.IsListed ? self.Mesh->Triangles.GetNumberOfRows()
                                            : self.NumberOfTriangles;
}

//------------------------------------------------------------------------------
bool vtkMeshInspectionMapper::IsOnProcessor() const
{
  return this->Internal->IsOnProcessor();
}

//------------------------------------------------------------------------------
// The base class sees a vtkPolyData that has nothing but the points of the grid.
void vtkMeshInspectionMapper::SetInputDataObject(int port, vtkDataObject* data)
{
  if (vtkCompositeDataSet::SafeDownCast(data))
  {
    return; // the representation joins blocks
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  Internals& self = *this->Internal;
  if (grid != self.Grid)
  {
    self.Grid = grid;
    this->Modified();
  }
  if (self.Style.OnProcessor)
  {
    // Ray tracers look at the input only.
    vtkPolyData* surface = self.Processor.GetSurface(grid, self.Style);
    if (this->GetInput() != surface)
    {
      this->Superclass::SetInputDataObject(port, surface);
    }
    return;
  }
  const bool isEmpty = !grid || grid->GetNumberOfCells() == 0;
  if (self.Placeholder->GetPoints() != (isEmpty ? nullptr : grid->GetPoints()))
  {
    self.Placeholder->SetPoints(isEmpty ? nullptr : grid->GetPoints());
  }
  if (this->GetInput() != self.Placeholder)
  {
    this->Superclass::SetInputDataObject(port, self.Placeholder);
  }
}

//------------------------------------------------------------------------------
// The producer has run: ParaView delivers data before it draws.
void vtkMeshInspectionMapper::SetInputConnection(int port, vtkAlgorithmOutput* connection)
{
  vtkDataObject* data = connection
    ? connection->GetProducer()->GetOutputDataObject(connection->GetIndex())
    : nullptr;
  if (vtkUnstructuredGrid::SafeDownCast(data) || vtkCompositeDataSet::SafeDownCast(data))
  {
    this->SetInputDataObject(port, data);
  }
  else
  {
    this->Superclass::SetInputConnection(port, connection);
  }
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::ComputeBounds()
{
  vtkUnstructuredGrid* grid = this->Internal->Grid;
  if (grid && grid->GetNumberOfCells() > 0)
  {
    const std::array<double, 6> bounds = GetFiniteBounds(grid);
    std::copy(bounds.begin(), bounds.end(), this->Bounds);
    // Several processes compose no more of the picture than what is within.
    const InspectionStyle& style = this->Internal->Style;
    const double length = style.DrawsNormals() ? style.NormalLength : 0;
    const std::array<double, 3> center = style.GetExplodeCenter(GetMiddleOf(bounds));
    for (int i = 0; i < 3 && bounds[0] <= bounds[1]; ++i)
    {
      const double half = 0.5 * (bounds[2 * i + 1] - bounds[2 * i]);
      this->Bounds[2 * i] -= length + style.ExplodeFactor * (half + center[i]);
      this->Bounds[2 * i + 1] += length + style.ExplodeFactor * (half - center[i]);
    }
  }
  else
  {
    vtkMath::UninitializeBounds(this->Bounds);
  }
}

//------------------------------------------------------------------------------
bool vtkMeshInspectionMapper::HasTranslucentPolygonalGeometry()
{
  vtkUnstructuredGrid* grid = this->Internal->Grid;
  if (this->Internal->Style.Glass)
  {
    return true;
  }
  vtkFloatArray* looks = this->Internal->GetLooks();
  for (vtkIdType i = 0; looks && i < looks->GetNumberOfTuples(); ++i)
  {
    const float opacity = looks->GetTypedComponent(i, 3);
    if (opacity >= 0 && opacity < 1)
    {
      return true;
    }
  }
  int cellFlag = 0;
  vtkAbstractArray* array = grid && this->ScalarVisibility
    ? vtkAbstractMapper::GetAbstractScalars(
        grid, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag)
    : nullptr;
  if (!array)
  {
    return false;
  }
  unsigned char ghostsToSkip = 0;
  vtkUnsignedCharArray* ghosts =
    vtkAbstractMapper::GetGhostArray(grid, this->ScalarMode, ghostsToSkip);
  vtkScalarsToColors* table = this->GetLookupTable();
  table->Build();
  return !table->IsOpaque(array, this->ColorMode, this->ArrayComponent, ghosts, ghostsToSkip);
}

//------------------------------------------------------------------------------
bool vtkMeshInspectionMapper::HasOpaqueGeometry()
{
  return !this->HasTranslucentPolygonalGeometry();
}

//------------------------------------------------------------------------------
bool vtkMeshInspectionMapper::GetNeedToRebuildBufferObjects(vtkRenderer*, vtkActor*)
{
  return true; // each table knows for itself
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  Internals& self = *this->Internal;
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkUnstructuredGrid* grid = self.Grid;
  self.Mesh->SetGrid(grid);
  self.Units = window->GetTextureUnitManager();
  self.NumberOfTriangles = 0;
  window->GetShaderCache()->ReleaseCurrentShader();
  if (!self.VertexArray)
  {
    glGenVertexArrays(1, &self.VertexArray);
  }
  self.Style.BordersAreOpen =
    actor->GetProperty()->GetOpacity() >= 1 && !this->HasTranslucentPolygonalGeometry();
  try
  {
    self.UpdateTables(renderer->GetSelector() != nullptr);
    self.UpdateNormals(actor->GetProperty());
    self.UpdateLooks();
  }
  catch (const std::exception& error)
  {
    self.NumberOfTriangles = 0;
    self.RefusedGrid = grid;
    self.RefusedTime = grid->GetMTime();
    vtkWarningMacro(<< error.what() << " The processor draws the mesh instead.");
  }

  // VTK makes the colours; of points they are either colours or coordinates in a texture.
  int cellFlag = 0;
  vtkUnsignedCharArray* colors = this->MapScalars(grid, 1.0, cellFlag);
  using Kind = InspectionColors::Kind;
  if (this->ColorCoordinates)
  {
    self.Colors.Update(Kind::Coordinates, this->ColorCoordinates);
    if (!this->InternalColorTexture)
    {
      this->InternalColorTexture = vtkOpenGLTexture::New();
      this->InternalColorTexture->RepeatOff();
    }
    this->InternalColorTexture->SetInputData(this->ColorTextureMap);
  }
  else
  {
    const vtkIdType size = colors ? colors->GetNumberOfTuples() : 0;
    const Kind kind = cellFlag == 1 && size == grid->GetNumberOfCells() ? Kind::Cells
      : cellFlag == 0 && size > 0 && size == grid->GetNumberOfPoints()  ? Kind::Points
                                                                        : Kind::None;
    self.Colors.Update(kind, kind == Kind::None ? nullptr : colors);
  }
  this->UpdateValues();
  glUseProgram(0);
  window->GetState()->ResetGLActiveTexture();
}

//------------------------------------------------------------------------------
// The numbers behind the colours, where something is made of them here.
void vtkMeshInspectionMapper::UpdateValues()
{
  Internals& self = *this->Internal;
  const InspectionStyle& style = self.Style;
  int cellFlag = 0;
  vtkDataArray* array = nullptr;
  if (this->ScalarVisibility &&
    (style.ColorBy == Coloring::TwoColors || style.ValuesToEmphasize != Emphasis::Nothing))
  {
    array = vtkArrayDownCast<vtkDataArray>(vtkAbstractMapper::GetAbstractScalars(
      self.Grid, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag));
  }
  self.HasCellValues = cellFlag == 1;
  const vtkIdType size =
    self.HasCellValues ? self.Grid->GetNumberOfCells() : self.Grid->GetNumberOfPoints();
  if (cellFlag > 1 || (array && array->GetNumberOfTuples() != size))
  {
    array = nullptr; // of the whole mesh
  }
  vtkScalarsToColors* table = this->GetLookupTable();
  self.Values.Update(array,
    table->GetVectorMode() == vtkScalarsToColors::COMPONENT ? table->GetVectorComponent()
                                                            : InspectionValues::Magnitude);
}

//------------------------------------------------------------------------------
bool vtkMeshInspectionMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  const bool base = this->Superclass::GetNeedToRebuildShaders(helper, renderer, actor);
  Internals& self = *this->Internal;
  const bool isPicking = renderer->GetSelector() != nullptr;
  const bool isPoints = &helper == &this->Primitives[PrimitivePoints];
  self.Code = GetRenderModeCode(
    self.GetStyleOfPicture(this, this->DrawsPoints(helper)),
    this->PrimitiveInfo[&helper].LastLightComplexity > 0);
  self.Code.Defines += self.Colors.GetDefine();
  if (!self.Values.IsEmpty())
  {
    self.Code.Defines +=
      self.HasCellValues ? "#define HAS_CELL_VALUES\n" : "#define HAS_POINT_VALUES\n";
  }
  self.Code.Defines += self.Style.MovesCells() ? "#define HAS_CENTROIDS\n" : "";
  self.Code.Defines +=
    self.Style.What == Figure::PointNormals ? "#define HAS_POINT_NORMALS\n" : "";
  self.Code.Defines += self.Style.What == Figure::Isosurfaces ? "#define IS_ISOSURFACE\n" : "";
  // Points are picked where they are drawn.
  const bool arePoints = isPoints || (this->PointPicking && self.Style.Points);
  self.Code.Defines += arePoints ? "#define ARE_POINTS\n" : "";
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
  const Internals& self = *this->Internal;
  const bool isCap = self.Style.What == Figure::Cap;
  std::string vertex = self.Style.DrawsNormals() ? NormalLinesVS : isCap ? CapVS : FacesVS;
  vtkShaderProgram::Substitute(vertex, "//Camaron::Defines", self.Code.Defines);
  vtkShaderProgram::Substitute(vertex, "//Camaron::Place", PlaceGLSL);
  vtkShaderProgram::Substitute(vertex, "//Camaron::Inputs", InputsGLSL);
  shaders[vtkShader::Vertex]->SetSource(vertex);
  shaders[vtkShader::Geometry]->SetSource("");

  std::string fragment = shaders[vtkShader::Fragment]->GetSource();
  std::string declarations = "flat in uint cellOfFace;\n"
                             "flat in uint cellMarks;\n"
                             "flat in int isCutFace;\n" +
    self.Code.Declarations;
  // The modes speak of the uniforms of the material and the camera, which VTK declares last.
  vtkShaderProgram::Substitute(
    fragment, "//VTK::System::Dec", "//VTK::System::Dec\n" + self.Code.Defines);
  vtkShaderProgram::Substitute(
    fragment, "//VTK::Edges::Dec", "//VTK::Edges::Dec\n" + declarations);
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
  // There are no texture coordinates but those of colours, which GetShaderTemplate knows.
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
          ? "pickedOwner.x + 1u" // 0 is nothing
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
  vtkShaderProgram::Substitute(fragment, "//VTK::Picking::Impl",
    std::string("  gl_FragData[0] = colorOfId(") + id + ");\n");
  shaders[vtkShader::Fragment]->SetSource(fragment);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(helper, renderer, actor);
  Internals& self = *this->Internal;
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
  self.Attach(program, "centroidTable", mesh.Centroids);
  self.Attach(program, "ownerTable", mesh.Owners);
  self.Attach(program, "colorTable", self.Colors.GetTable());
  self.Attach(program, "normalTable", self.Normals.GetTable());
  self.Attach(program, "valueTable", self.Values.GetTable());
  self.Attach(program, "levelTable", self.Levels.GetTable());
  self.Attach(program, "leafTable", mesh.Leaves);
  self.Attach(program, "lookTable", self.Looks);
  program->SetUniformi("isListed", self.IsListed ? 1 : 0);
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
    eye };
  for (const RenderMode& mode : GetRenderModes())
  {
    if (mode.IsOn(style))
    {
      mode.SetUniforms(program, context);
    }
  }
}

//------------------------------------------------------------------------------
// The tables are relative to the middle of the mesh: the matrices put it back, in double.
void vtkMeshInspectionMapper::SetCameraShaderParameters(
  vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetCameraShaderParameters(helper, renderer, actor);
  const MeshMatrices matrices(renderer, actor, this->Internal->Mesh->GetMiddle());
  // GLSL has its matrices by columns.
  matrices.ToView->Transpose();
  matrices.ToDisplay->Transpose();
  helper.Program->SetUniformMatrix("MCDCMatrix", matrices.ToDisplay);
  if (helper.Program->IsUniformUsed("MCVCMatrix"))
  {
    helper.Program->SetUniformMatrix("MCVCMatrix", matrices.ToView);
  }
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  Internals& self = *this->Internal;
  if (!self.IsOnProcessor())
  {
    this->Superclass::RenderPiece(renderer, actor);
  }
  // The graphics card may just have refused.
  if (self.IsOnProcessor())
  {
    self.Processor.Draw(renderer, actor, this, self.Grid, self.Style);
  }
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  Internals& self = *this->Internal;
  if (self.NumberOfTriangles == 0)
  {
    return;
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  this->DrawingVertices = false;
  this->DrawingSelection = false;
  const InspectionStyle& style = self.Style;
  const std::size_t corners = 3 * self.NumberOfTriangles;
  if (style.DrawsNormals())
  {
    const bool isOfFaces = style.What == Figure::FaceNormals;
    this->Draw(renderer, actor, PrimitiveTris, GL_TRIANGLES, isOfFaces ? 2 * corners : 6 * corners);
    return;
  }
  if (style.What == Figure::Cap)
  {
    // There are no points on it to pick.
    if (!this->PointPicking)
    {
      this->Draw(renderer, actor, PrimitiveTris, GL_TRIANGLES, corners);
    }
    return;
  }
  if (this->PointPicking && (style.Faces || style.Edges))
  {
    state->vtkglPointSize(static_cast<float>(this->GetPointPickingPrimitiveSize(PrimitiveTris)));
    this->Draw(renderer, actor, PrimitiveTris, GL_POINTS, corners);
  }
  else if (style.Faces || style.Edges)
  {
    const std::size_t perCorner = style.DrawsEdgesAlone() ? 6 : 1;
    this->Draw(renderer, actor, PrimitiveTris, GL_TRIANGLES, perCorner * corners);
  }
  if (style.Points && (!renderer->GetSelector() || style.DrawsPointsOnly()))
  {
    state->vtkglPointSize(actor->GetProperty()->GetPointSize());
    this->Draw(renderer, actor, PrimitivePoints, GL_POINTS, corners);
  }
}

//------------------------------------------------------------------------------
// As many vertices as there are; the shaders know which by their numbers.
void vtkMeshInspectionMapper::Draw(vtkRenderer* renderer, vtkActor* actor, int primitive,
  unsigned int mode, std::size_t numberOfVertices)
{
  Internals& self = *this->Internal;
  vtkOpenGLHelper& helper = this->Primitives[primitive];
  this->UpdateShaders(helper, renderer, actor);
  if (helper.Program)
  {
    glBindVertexArray(self.VertexArray);
    glDrawArrays(mode, 0, static_cast<GLsizei>(numberOfVertices));
    glBindVertexArray(0);
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  self.Detach(window->GetState());
}

//------------------------------------------------------------------------------
bool vtkMeshInspectionMapper::DrawingEdges(vtkRenderer*, vtkActor*)
{
  return false; // VTK's; ours are a mode
}

//------------------------------------------------------------------------------
bool vtkMeshInspectionMapper::HaveWideLines(vtkRenderer*, vtkActor*)
{
  return false;
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::UpdateMaximumPointCellIds(vtkRenderer* renderer, vtkActor*)
{
  vtkUnstructuredGrid* grid = this->Internal->Grid;
  vtkHardwareSelector* selector = renderer->GetSelector();
  selector->UpdateMaximumPointId(
    GetLargestId(grid->GetPointData()->GetArray(PointIdsName), grid->GetNumberOfPoints()));
  selector->UpdateMaximumCellId(
    GetLargestId(grid->GetCellData()->GetArray(CellIdsName), grid->GetNumberOfCells()));
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::ProcessSelectorPixelBuffers(
  vtkHardwareSelector* selector, std::vector<unsigned int>& pixelOffsets, vtkProp* prop)
{
  vtkUnstructuredGrid* grid = this->Internal->Grid;
  if (!grid || !this->PopulateSelectionSettings)
  {
    return;
  }
  if (this->Internal->IsOnProcessor())
  {
    this->Internal->Processor.GetMapper()->ProcessSelectorPixelBuffers(selector, pixelOffsets, prop);
    return;
  }
  switch (selector->GetCurrentPass())
  {
    case vtkHardwareSelector::POINT_ID_LOW24:
    case vtkHardwareSelector::POINT_ID_HIGH24:
      MapSelectorPixels(selector, pixelOffsets, vtkHardwareSelector::POINT_ID_LOW24,
        vtkHardwareSelector::POINT_ID_HIGH24, grid->GetPointData()->GetArray(PointIdsName));
      break;
    case vtkHardwareSelector::CELL_ID_LOW24:
    case vtkHardwareSelector::CELL_ID_HIGH24:
      MapSelectorPixels(selector, pixelOffsets, vtkHardwareSelector::CELL_ID_LOW24,
        vtkHardwareSelector::CELL_ID_HIGH24, grid->GetCellData()->GetArray(CellIdsName));
      break;
    default:
      break;
  }
}

//------------------------------------------------------------------------------
// The base class comes back here once it has made the context current; when the window calls, it is already.
void vtkMeshInspectionMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Internal->Processor.GetMapper()->ReleaseGraphicsResources(window);
  this->Internal->Release();
}
