// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkElementOverlay.h"

#include "ControllerReducer.h"

#include "vtkActor.h"
#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMergeBlocks.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPVRenderView.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include "OpenGL.h"

#include <cstdint>

vtkStandardNewMacro(vtkElementOverlay);

namespace
{
// Draws in front of everything that was drawn before.
class OverlayMapper : public vtkOpenGLPolyDataMapper
{
public:
  static OverlayMapper* New();
  vtkTypeMacro(OverlayMapper, vtkOpenGLPolyDataMapper);

  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    vtkOpenGLState* state = window->GetState();
    const vtkOpenGLState::ScopedglEnableDisable restoring(state, GL_DEPTH_TEST);
    state->vtkglDisable(GL_DEPTH_TEST);
    this->Superclass::RenderPiece(renderer, actor);
  }
};
vtkStandardNewMacro(OverlayMapper);

//------------------------------------------------------------------------------
// The same cells with no arrays but that of ghosts: a surface would copy each of the others face by
// face, which takes longer than anything else here.
vtkSmartPointer<vtkDataSet> WithoutArrays(vtkDataSet* cells)
{
  const auto bare = vtkSmartPointer<vtkDataSet>::Take(cells->NewInstance());
  bare->ShallowCopy(cells);
  for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* const arrays = bare->GetAttributes(type);
    vtkSmartPointer<vtkDataArray> ghosts = arrays->GetArray(vtkDataSetAttributes::GhostArrayName());
    arrays->Initialize();
    if (ghosts)
    {
      arrays->AddArray(ghosts);
    }
  }
  return bare;
}
}

//------------------------------------------------------------------------------
vtkElementOverlay::vtkElementOverlay()
{
  constexpr double edgeOpacity = 0.4, lineWidth = 1.5;
  vtkNew<OverlayMapper> mapper;
  mapper->ScalarVisibilityOff();
  this->Actor->SetMapper(mapper);
  this->Actor->PickableOff();
  vtkProperty* look = this->Actor->GetProperty();
  look->LightingOff();
  look->SetLineWidth(lineWidth);
  look->SetEdgeOpacity(edgeOpacity);
  this->SetColor(1, 0, 1);
}

//------------------------------------------------------------------------------
vtkElementOverlay::~vtkElementOverlay() = default;

//------------------------------------------------------------------------------
void vtkElementOverlay::SetVisibility(bool isVisible)
{
  this->Superclass::SetVisibility(isVisible);
  this->Actor->SetVisibility(isVisible);
}

//------------------------------------------------------------------------------
void vtkElementOverlay::SetColor(double red, double green, double blue)
{
  this->Actor->GetProperty()->SetColor(red, green, blue);
  this->Actor->GetProperty()->SetEdgeColor(red, green, blue);
}

//------------------------------------------------------------------------------
int vtkElementOverlay::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // only data servers have the mesh
  return 1;
}

//------------------------------------------------------------------------------
int vtkElementOverlay::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (inputVector[0]->GetNumberOfInformationObjects() == 1)
  {
    this->Blocks->SetInputConnection(this->GetInternalOutputPort());
  }
  else
  {
    vtkNew<vtkUnstructuredGrid> empty;
    this->Blocks->SetInputDataObject(empty);
  }
  this->Blocks->Modified();
  this->Blocks->Update();
  auto* const found = vtkDataSet::SafeDownCast(this->Blocks->GetOutputDataObject(0));
  std::int64_t cells = found->GetNumberOfCells();
  camaron::ControllerReducer().Sum(&cells, 1);
  this->Drawn->Initialize();
  if (cells <= this->MostCells)
  {
    constexpr std::int64_t few = 1000; // whose curved faces are divided in no time
    this->Surface->SetNonlinearSubdivisionLevel(cells <= few ? 3 : 1);
    this->Surface->SetInputDataObject(WithoutArrays(found));
    this->Surface->Update();
    this->Drawn->CopyStructure(this->Surface->GetOutput()); // colors need no arrays
    this->Surface->SetInputDataObject(nullptr);
  }
  this->Drawn->Modified();
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkElementOverlay::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0; // it is hidden
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    vtkPVView::SetPiece(inInfo, this, this->Drawn);
    vtkPVRenderView::SetDeliverToAllProcesses(inInfo, this, true);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    vtkAlgorithmOutput* elements = vtkPVRenderView::GetPieceProducer(inInfo, this);
    vtkDataObject* data = elements->GetProducer()->GetOutputDataObject(0);
    const bool isSurface = vtkPolyData::SafeDownCast(data) != nullptr;
    this->Actor->SetVisibility(isSurface);
    if (isSurface)
    {
      this->Actor->GetMapper()->SetInputConnection(elements);
      // Many elements are a haze, which is denser where more of them are.
      constexpr vtkIdType manyFaces = 40000;
      constexpr double opacity = 0.15, opacityOfMany = 0.03;
      const bool isMany = data->GetNumberOfElements(vtkDataObject::CELL) > manyFaces;
      this->Actor->GetProperty()->SetOpacity(isMany ? opacityOfMany : opacity);
      this->Actor->GetProperty()->SetEdgeVisibility(!isMany);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkElementOverlay::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetNonCompositedRenderer()->AddActor(this->Actor);
  return this->Superclass::AddToView(view);
}

//------------------------------------------------------------------------------
bool vtkElementOverlay::RemoveFromView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetNonCompositedRenderer()->RemoveActor(this->Actor);
  return this->Superclass::RemoveFromView(view);
}
