// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshInspectionMapper.h"

#include "Base/Parallel.h"
#include "InspectionArrays.h"
#include "InspectionTables.h"
#include "LinearColors.h"

#include "vtkActor.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkMath.h"
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
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "OpenGL.h"

using namespace camaron;

vtkStandardNewMacro(vtkMeshInspectionMapper);

namespace
{
//------------------------------------------------------------------------------
// The largest id in a selection: that in @a ids or, without ids, the last of @a size elements.
vtkIdType GetLargestId(vtkDataArray* ids, vtkIdType size)
{
  const vtkIdType largest = ids && size > 0 ? static_cast<vtkIdType>(ids->GetRange(0)[1]) : 0;
  return largest > size - 1 ? largest : size - 1;
}

//------------------------------------------------------------------------------
// Replaces the numbers that shaders write in the selector's current pass, @a lowPass or @a
// highPass, by the values of @a ids at these numbers. Does nothing without @a ids.
void MapSelectorPixels(vtkHardwareSelector* selector, const std::vector<unsigned int>& pixelOffsets,
  int lowPass, int highPass, vtkDataArray* ids)
{
  const unsigned char* low = selector->GetRawPixelBuffer(lowPass);
  const unsigned char* high = selector->GetRawPixelBuffer(highPass); // null for few elements
  unsigned char* pixels = selector->GetPixelBuffer(selector->GetCurrentPass());
  if (!ids || !low || !pixels)
  {
    return;
  }
  const int firstBit = selector->GetCurrentPass() == highPass ? 24 : 0;
  for (const unsigned int pixel : pixelOffsets)
  {
    const vtkIdType painted = low[pixel] | low[pixel + 1] << 8 | low[pixel + 2] << 16 |
      (high ? static_cast<vtkIdType>(high[pixel]) << 24 : 0);
    if (painted < ids->GetNumberOfTuples())
    {
      const auto id = static_cast<vtkIdType>(ids->GetComponent(painted, 0)) >> firstBit;
      pixels[pixel] = id & 0xff;
      pixels[pixel + 1] = (id >> 8) & 0xff;
      pixels[pixel + 2] = (id >> 16) & 0xff;
    }
  }
}
}

//==============================================================================
vtkMeshInspectionMapper::vtkMeshInspectionMapper()
  : Internal(std::make_unique<InspectionTables>())
{
}

//------------------------------------------------------------------------------
vtkMeshInspectionMapper::~vtkMeshInspectionMapper()
{
  // When the base class calls it, this class no longer exists.
  this->vtkMeshInspectionMapper::ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::SetStyle(const InspectionStyle& style)
{
  this->Internal->Style = style;
  if (style.DrawsPointsOnly())
  {
    this->Internal->Style.FacesToDraw = DrawnFaces::Complete;
  }
  this->SetInputDataObject(0, this->Internal->Grid);
  if (style.OnProcessor)
  {
    // Ray tracers only read the input.
    vtkPolyData* surface = this->Internal->Processor.GetSurface(this->Internal->Grid, style);
    if (this->GetInput() != surface)
    {
      this->Superclass::SetInputDataObject(0, surface);
    }
  }
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::SetReach(double explodeFactor, double normalLength)
{
  this->Internal->Style.ExplodeFactor = explodeFactor;
  this->Internal->Style.NormalLength = normalLength;
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
  const InspectionTables& self = *this->Internal;
  return changesWithCamera && self.IsListed ? self.Mesh->Triangles.GetNumberOfRows()
                                            : self.NumberOfTriangles;
}

//------------------------------------------------------------------------------
bool vtkMeshInspectionMapper::IsOnProcessor() const
{
  return this->Internal->IsOnProcessor();
}

//------------------------------------------------------------------------------
// The base class gets a vtkPolyData that only has the points of the grid.
void vtkMeshInspectionMapper::SetInputDataObject(int port, vtkDataObject* data)
{
  if (vtkCompositeDataSet::SafeDownCast(data))
  {
    return; // the representation has joined the blocks
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  InspectionTables& self = *this->Internal;
  if (grid != self.Grid)
  {
    self.Grid = grid;
    this->Modified();
  }
  if (self.Style.OnProcessor)
  {
    return; // SetStyle makes a surface, of the mesh that the representation passes last
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
// The producer has already executed: ParaView delivers data before it renders.
void vtkMeshInspectionMapper::SetInputConnection(int port, vtkAlgorithmOutput* connection)
{
  vtkDataObject* data =
    connection ? connection->GetProducer()->GetOutputDataObject(connection->GetIndex()) : nullptr;
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
  const std::array<double, 6>& bounds = this->Internal->GetBounds();
  if (bounds[0] > bounds[1])
  {
    vtkMath::UninitializeBounds(this->Bounds);
    return;
  }
  // With several processes, only the part of the image inside the bounds is composited.
  const InspectionStyle& style = this->Internal->Style;
  const std::array<double, 3> center = style.GetExplodeCenter(GetMiddleOf(bounds));
  for (int i = 0; i < 3; ++i)
  {
    const double half = 0.5 * (bounds[2 * i + 1] - bounds[2 * i]);
    const double low = style.NormalLength + style.ExplodeFactor * (half + center[i]);
    const double high = style.NormalLength + style.ExplodeFactor * (half - center[i]);
    this->Bounds[2 * i] = bounds[2 * i] - low;
    this->Bounds[2 * i + 1] = bounds[2 * i + 1] + high;
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
  return true; // each table checks this itself
}

//------------------------------------------------------------------------------
// Colors of cells that VTK's mapper does not make: by all threads, where it would interpolate a
// color for one value after the other, or with a color for cells that are not judged; nullptr if
// VTK has to map them.
vtkUnsignedCharArray* vtkMeshInspectionMapper::MapCells()
{
  InspectionTables& self = *this->Internal;
  int cellFlag = 0;
  auto* array = vtkArrayDownCast<vtkDoubleArray>(vtkAbstractMapper::GetAbstractScalars(
    self.Grid, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag));
  auto* table = vtkDiscretizableColorTransferFunction::SafeDownCast(this->LookupTable);
  if (!this->ScalarVisibility || !array || cellFlag != 1 || !table || table->GetIndexedLookup() ||
    !this->UseLookupTableScalarRange || array->GetLookupTable() ||
    array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != self.Grid->GetNumberOfCells())
  {
    return nullptr;
  }
  vtkDataArray* values = array;
  if (self.Style.IsOn("MarkCellsNotJudged"))
  {
    using Limits = std::numeric_limits<double>;
    const bool isBelow = table->GetUseBelowRangeColor() != 0;
    values = self.ColoredValues.Update(array, self.Grid,
      JudgedValues::Marks{ isBelow ? -Limits::infinity() : Limits::quiet_NaN(),
        isBelow ? table->GetRange()[0] : -Limits::infinity() });
  }
  const bool isLinear =
    !table->GetDiscretize() && !table->GetEnableOpacityMapping() && LinearColors::IsLinear(table);
  if (values == array && !isLinear)
  {
    return nullptr;
  }
  const std::array<vtkMTimeType, 2> times = { { values->GetMTime(), table->GetMTime() } };
  if (times != self.TimesOfCellColors && isLinear)
  {
    vtkNew<vtkUnsignedCharArray> colors;
    constexpr int channels = 4;
    colors->SetNumberOfComponents(channels);
    colors->SetNumberOfTuples(values->GetNumberOfTuples());
    ParallelForEach(values->GetNumberOfTuples(), LightGrain,
      [map = LinearColors(table), value = vtkArrayDownCast<vtkDoubleArray>(values)->GetPointer(0),
        color = colors->GetPointer(0)](vtkIdType cell)
      { map.Map(value[cell], color + channels * cell); });
    self.CellColors = colors;
  }
  else if (times != self.TimesOfCellColors)
  {
    self.CellColors.TakeReference(table->MapScalars(values, this->ColorMode, this->ArrayComponent));
  }
  self.TimesOfCellColors = times;
  return self.CellColors;
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  InspectionTables& self = *this->Internal;
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
    vtkWarningMacro(<< error.what() << " VTK filters draw the mesh instead.");
  }

  // VTK maps the array to colors; for points, to colors or texture coordinates.
  int cellFlag = 1;
  vtkUnsignedCharArray* colors = this->MapCells();
  const bool isMapped = colors != nullptr;
  if (!isMapped)
  {
    colors = this->MapScalars(grid, 1.0, cellFlag);
  }
  using Kind = InspectionColors::Kind;
  if (!isMapped && this->ColorCoordinates)
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
// The values of the array that colors the mesh, or which cells are brushed, if the shaders compute
// colors from them.
void vtkMeshInspectionMapper::UpdateValues()
{
  InspectionTables& self = *this->Internal;
  const InspectionStyle& style = self.Style;
  int cellFlag = 0;
  vtkDataArray* array = nullptr;
  self.ColorLimits = style.HasFacesOfColors()
    ? FindAcceptableRange(vtkColorTransferFunction::SafeDownCast(this->LookupTable))
    : Unlimited;
  if (!style.Brushes.empty())
  {
    array = self.Brushed.Update(style.Brushes, self.Grid);
    cellFlag = 1;
  }
  else if (this->ScalarVisibility &&
    (style.ColorBy == Coloring::TwoColors || style.ValuesToEmphasize != Emphasis::Nothing ||
      self.ColorLimits != Unlimited))
  {
    array = vtkArrayDownCast<vtkDataArray>(vtkAbstractMapper::GetAbstractScalars(self.Grid,
      this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag));
  }
  self.HasCellValues = cellFlag == 1;
  const vtkIdType size =
    self.HasCellValues ? self.Grid->GetNumberOfCells() : self.Grid->GetNumberOfPoints();
  if (cellFlag > 1 || (array && array->GetNumberOfTuples() != size))
  {
    array = nullptr; // one value for the whole mesh
  }
  if (self.HasCellValues && style.Brushes.empty() &&
    (style.ValuesToEmphasize == Emphasis::Unacceptable ||
      (self.ColorLimits != Unlimited && style.IsOn("MarkCellsNotJudged"))))
  {
    array = self.Judged.Update(array, self.Grid);
  }
  vtkScalarsToColors* table = this->GetLookupTable();
  self.Values.Update(array,
    table->GetVectorMode() == vtkScalarsToColors::COMPONENT ? table->GetVectorComponent()
                                                            : InspectionValues::Magnitude);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  InspectionTables& self = *this->Internal;
  if (!self.IsOnProcessor())
  {
    this->Superclass::RenderPiece(renderer, actor);
  }
  // The graphics card may just have failed to draw the mesh.
  if (self.IsOnProcessor())
  {
    self.Processor.Draw(renderer, actor, this, self.Grid, self.Style);
  }
}

//------------------------------------------------------------------------------
void vtkMeshInspectionMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  InspectionTables& self = *this->Internal;
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
    // The cap has no points to pick.
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
// Draws vertices without attributes; the shaders compute them from gl_VertexID.
void vtkMeshInspectionMapper::Draw(vtkRenderer* renderer, vtkActor* actor, int primitive,
  unsigned int mode, std::size_t numberOfVertices)
{
  InspectionTables& self = *this->Internal;
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
  return false; // edges are a render mode, not VTK's
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
    this->Internal->Processor.GetMapper()->ProcessSelectorPixelBuffers(
      selector, pixelOffsets, prop);
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
// The base class calls this again after making the context current. If the window calls it, the
// context is already current.
void vtkMeshInspectionMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Internal->Processor.GetMapper()->ReleaseGraphicsResources(window);
  this->Internal->Release();
}
