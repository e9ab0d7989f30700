// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIdLabels.h"

#include "DigitTexture.h"
#include "InspectionMesh.h"
#include "LabelChoice.h"
#include "MeshMatrices.h"
#include "VisiblePixels.h"
#include "VisibleTriangles.h"
#include "vtkMeshInspectionMapper.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTexture.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

#include "OpenGL.h"

using namespace camaron;

namespace
{
/// Distance of labels in front of the mesh, in depth from 0 to 1: more than that of anything else
/// drawn directly in front of it.
constexpr double DepthBefore = 1e-4;
/// Distance of digits in front of their outlines.
constexpr double DepthBetween = 1e-5;

//------------------------------------------------------------------------------
// Draws polygons in clip coordinates, from -1 to 1, independent of the camera.
class ScreenMapper : public vtkOpenGLPolyDataMapper
{
public:
  static ScreenMapper* New();
  vtkTypeMacro(ScreenMapper, vtkOpenGLPolyDataMapper);

  /// Called to release graphics memory, with the context current.
  std::function<void()> OnRelease;

  // The base class calls this again after making the context current. If the window calls it, the
  // context is already current.
  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Superclass::ReleaseGraphicsResources(window);
    if (this->OnRelease)
    {
      this->OnRelease();
    }
  }

protected:
  void SetCameraShaderParameters(
    vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor) override
  {
    this->Superclass::SetCameraShaderParameters(helper, renderer, actor);
    vtkNew<vtkMatrix4x4> identity;
    helper.Program->SetUniformMatrix("MCDCMatrix", identity);
  }
};
vtkStandardNewMacro(ScreenMapper);

//------------------------------------------------------------------------------
// Adds an array to the field data that describes the labels.
template <typename Array>
vtkSmartPointer<Array> AddRows(vtkPolyData* to, const char* name, int size, std::size_t rows)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(size);
  array->SetNumberOfTuples(static_cast<vtkIdType>(rows));
  to->GetFieldData()->AddArray(array);
  return array;
}

//------------------------------------------------------------------------------
void Describe(vtkPolyData* written, const std::vector<IdLabel>& labels, const DigitSize& digits)
{
  const auto kinds = AddRows<vtkIntArray>(written, "LabelKinds", 1, labels.size());
  const auto ids = AddRows<vtkIdTypeArray>(written, "LabelIds", 1, labels.size());
  const auto places = AddRows<vtkDoubleArray>(written, "LabelPlaces", 3, labels.size());
  const auto pixels = AddRows<vtkIntArray>(written, "LabelPixels", 4, labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    const IdLabel& label = labels[i];
    const auto row = static_cast<vtkIdType>(i);
    kinds->SetValue(row, static_cast<int>(label.Kind));
    ids->SetValue(row, label.Id);
    places->SetTypedTuple(row, label.At.data());
    const int width = digits.Width * static_cast<int>(std::to_string(label.Id).size());
    const int rectangle[4] = { label.Left, label.Bottom, width, digits.Height };
    pixels->SetTypedTuple(row, rectangle);
  }
}
}

//==============================================================================
class vtkIdLabels::Internals
{
public:
  LabelStyle Labels;
  InspectionStyle Style;
  bool HasPieces = true;
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkMeshInspectionMapper> MeshMapper;
  vtkSmartPointer<vtkActor> MeshActor;
  vtkSmartPointer<vtkUnstructuredGrid> Grid;

  VisibleTriangles Visible;
  VisiblePixels Pixels;
  LabelMesh Mesh;
  DigitTexture Digits;
  vtkNew<ScreenMapper> Mapper;

  void Release();
  bool IsMeshDrawn() const
  {
    return (this->Style.Faces || this->Style.Edges || this->Style.Points) && this->Grid &&
      this->Grid->GetNumberOfCells() > 0 && !this->MeshMapper->IsOnProcessor();
  }
  double GetMargin(const vtkBoundingBox& mesh) const;
  std::vector<IdLabel> Choose(vtkRenderer* renderer, const int size[2]);
  std::vector<std::uint32_t> GetEntries(bool isListed, std::size_t numberOfTriangles) const;
  void Write(const std::vector<IdLabel>& labels, const int size[2]);
};

//------------------------------------------------------------------------------
void vtkIdLabels::Internals::Release()
{
  this->Visible.Release();
  this->Pixels.Release();
  this->Mesh.Release();
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> vtkIdLabels::Internals::GetEntries(
  bool isListed, std::size_t numberOfTriangles) const
{
  std::vector<std::uint32_t> entries(numberOfTriangles);
  if (isListed)
  {
    this->Visible.GetTable().Download(entries.data(), entries.size());
    return entries;
  }
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    entries[i] = static_cast<std::uint32_t>(i << 1);
  }
  return entries;
}

//------------------------------------------------------------------------------
// How far labels can extend beyond the mesh, in its unit, at the position farthest from the camera.
double vtkIdLabels::Internals::GetMargin(const vtkBoundingBox& mesh) const
{
  constexpr int longest = 20; // digits
  const DigitSize& digits = this->Digits.GetSize();
  const double pixels = longest * digits.Width + 2 * (digits.Height + 2 * digits.Margin);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  double half = camera->GetParallelScale(); // half the height of the view
  if (!camera->GetParallelProjection())
  {
    double middle[3];
    mesh.GetCenter(middle);
    const double distance =
      std::sqrt(vtkMath::Distance2BetweenPoints(middle, camera->GetPosition())) +
      mesh.GetDiagonalLength() / 2;
    half = distance * std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle() / 2));
  }
  return 2 * half * pixels / std::max(this->Renderer->GetSize()[1], 1);
}

//------------------------------------------------------------------------------
// For the frame that is being drawn.
std::vector<IdLabel> vtkIdLabels::Internals::Choose(vtkRenderer* renderer, const int size[2])
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const std::shared_ptr<InspectionMesh> mesh = this->MeshMapper->GetMesh();
  InspectionStyle style = this->Style.GetVisible();
  style.BordersAreOpen = this->MeshActor->GetProperty()->GetOpacity() >= 1 &&
    !this->MeshMapper->HasTranslucentPolygonalGeometry();
  const bool hidesOthers = this->Style.Faces && style.BordersAreOpen;
  if (this->Style.DrawsPointsOnly())
  {
    style.FacesToDraw = DrawnFaces::Complete;
  }
  const bool isListed = !style.IsWholeSurface();
  window->GetShaderCache()->ReleaseCurrentShader();
  mesh->SetGrid(this->Grid);
  mesh->Update();
  mesh->NeedFaces(isListed);
  mesh->NeedPoints();
  mesh->NeedMarks();
  if (style.MovesCells())
  {
    mesh->NeedCentroids();
  }
  if (isListed)
  {
    this->Visible.Update(*mesh, style);
  }
  glUseProgram(0);
  window->GetState()->ResetGLActiveTexture();
  const std::size_t numberOfTriangles =
    isListed ? this->Visible.GetNumberOfTriangles() : mesh->GetNumberOfOuterTriangles();
  if (numberOfTriangles == 0)
  {
    return {};
  }
  this->Mesh.Update(*mesh, style, this->HasPieces);
  const MeshMatrices matrices(renderer, this->MeshActor, mesh->GetMiddle());
  this->Pixels.Draw(window,
    { *mesh, isListed ? &this->Visible.GetTable() : nullptr, numberOfTriangles, style,
      this->MeshActor->GetProperty(), matrices.ToDisplay, size[0], size[1] });
  std::vector<std::uint32_t> entries;
  if (!hidesOthers)
  {
    entries = this->GetEntries(isListed, numberOfTriangles);
  }
  const LabelChoice::Picture picture = { this->Pixels, matrices.ToView, matrices.ToDisplay,
    renderer->GetActiveCamera()->GetParallelProjection() != 0, size[0], size[1],
    this->Digits.GetSize(), hidesOthers ? nullptr : &entries };
  return LabelChoice(this->Mesh, this->Labels, picture).Choose();
}

//------------------------------------------------------------------------------
// One quadrilateral per digit, and one for its outline behind it.
void vtkIdLabels::Internals::Write(const std::vector<IdLabel>& labels, const int size[2])
{
  const DigitSize& digits = this->Digits.GetSize();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  vtkNew<vtkCellArray> cells;
  for (const bool isRim : { true, false })
  {
    for (const IdLabel& label : labels)
    {
      const std::string text = std::to_string(label.Id);
      const double depth = 2 * label.Depth - 1 - (isRim ? DepthBefore : DepthBefore + DepthBetween);
      for (std::size_t i = 0; i < text.size(); ++i)
      {
        const double left = label.Left + static_cast<double>(i) * digits.Width - digits.Margin;
        const double bottom = label.Bottom - digits.Margin;
        const double x[2] = { left, left + digits.Width + 2 * digits.Margin };
        const double y[2] = { bottom, bottom + digits.Height + 2 * digits.Margin };
        const std::array<float, 4> place = this->Digits.GetPlace(text[i], label.Kind, isRim);
        vtkIdType corners[4];
        for (int corner = 0; corner < 4; ++corner)
        {
          const int right = corner == 1 || corner == 2, up = corner / 2;
          corners[corner] = points->InsertNextPoint(2 * x[right] / size[0] - 1,
            2 * y[up] / size[1] - 1, std::max(depth, -1 + DepthBetween * (isRim ? 2 : 1)));
          coordinates->InsertNextTuple2(place[2 * right], place[2 * up + 1]);
        }
        cells->InsertNextCell(4, corners);
      }
    }
  }
  vtkNew<vtkPolyData> written;
  written->SetPoints(points);
  written->SetPolys(cells);
  written->GetPointData()->SetTCoords(coordinates);
  Describe(written, labels, digits);
  this->Mapper->SetInputData(written);
}

//==============================================================================
vtkStandardNewMacro(vtkIdLabels);

//------------------------------------------------------------------------------
vtkIdLabels::vtkIdLabels()
  : Internal(std::make_unique<Internals>())
{
  vtkNew<vtkPolyData> nothing;
  this->Internal->Mapper->SetInputData(nothing);
  this->Internal->Mapper->OnRelease = [this] { this->Internal->Release(); };
  this->Internal->Mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  this->Internal->Mapper->ScalarVisibilityOff();
  this->SetMapper(this->Internal->Mapper);
  this->SetTexture(this->Internal->Digits.GetTexture());
  this->GetProperty()->LightingOff();
  this->GetProperty()->SetColor(1, 1, 1);
  this->ForceOpaqueOn(); // the outlines are blended with what is already drawn
  this->PickableOff();
  this->VisibilityOff();
}

//------------------------------------------------------------------------------
vtkIdLabels::~vtkIdLabels()
{
  this->Internal->Mapper->ReleaseGraphicsResources(nullptr);
  this->Internal->Mapper->OnRelease = nullptr;
}

//------------------------------------------------------------------------------
void vtkIdLabels::SetMesh(vtkMeshInspectionMapper* mapper, vtkActor* actor)
{
  this->Internal->MeshMapper = mapper;
  this->Internal->MeshActor = actor;
}

//------------------------------------------------------------------------------
void vtkIdLabels::Show(const LabelStyle& labels, const InspectionStyle& style, vtkDataObject* grid)
{
  this->Internal->Labels = labels;
  this->Internal->Style = style;
  this->Internal->Grid = vtkUnstructuredGrid::SafeDownCast(grid);
}

//------------------------------------------------------------------------------
void vtkIdLabels::SetHasPieces(bool has)
{
  this->Internal->HasPieces = has;
}

//------------------------------------------------------------------------------
void vtkIdLabels::SetRenderer(vtkRenderer* renderer)
{
  this->Internal->Renderer = renderer;
}

//------------------------------------------------------------------------------
bool vtkIdLabels::GetUseBounds()
{
  vtkRenderer* renderer = this->Internal->Renderer;
  return renderer && renderer->GetRenderWindow() &&
    renderer->GetRenderWindow()->CheckInRenderStatus();
}

//------------------------------------------------------------------------------
double* vtkIdLabels::GetBounds()
{
  const double* mesh = this->GetUseBounds() ? this->Internal->MeshActor->GetBounds() : nullptr;
  if (!mesh || !vtkMath::AreBoundsInitialized(mesh))
  {
    return nullptr;
  }
  vtkBoundingBox box(mesh);
  box.Inflate(this->Internal->GetMargin(box));
  box.GetBounds(this->Bounds);
  return this->Bounds;
}

//------------------------------------------------------------------------------
int vtkIdLabels::RenderOpaqueGeometry(vtkViewport* viewport)
{
  Internals& self = *this->Internal;
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  if (!renderer || renderer->GetSelector())
  {
    return 0;
  }
  std::vector<IdLabel> labels;
  int area[4];
  glGetIntegerv(GL_VIEWPORT, area);
  try
  {
    // Large screenshots are rendered in tiles, each of which shows a part of the view.
    vtkRenderWindow* window = renderer->GetRenderWindow();
    if (!self.Digits.Update(self.Labels, window->GetDPI() * window->GetTileScale()[1]))
    {
      vtkErrorMacro("VTK cannot render text for labels.");
      return 0;
    }
    if (self.IsMeshDrawn())
    {
      labels = self.Choose(renderer, area + 2);
    }
  }
  catch (const std::length_error&)
  {
    // The mapper reports that the mesh does not fit into graphics memory.
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
  }
  self.Write(labels, area + 2);
  return this->Superclass::RenderOpaqueGeometry(viewport);
}
