// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshInspectionRepresentation.h"

#include "InspectionArrays.h"
#include "InspectionBlocks.h"
#include "InspectionMesh.h"
#include "MeshInspectionInternals.h"
#include "ShapeConversion.h"
#include "vtkHalfSpaces.h"
#include "vtkInspectionMesh.h"
#include "vtkJoinedInspectionMesh.h"

#include "ControllerReducer.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkLineSource.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPVRenderViewDataDeliveryManager.h"
#include "vtkPolyData.h"
#include "vtkRenderPass.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace camaron;

vtkStandardNewMacro(vtkMeshInspectionRepresentation);

namespace
{
//------------------------------------------------------------------------------
// The bounds of all parts that are not empty; 1, -1 if there are none.
std::array<double, 6> JoinBounds(const std::vector<std::array<double, 6>>& parts)
{
  vtkBoundingBox box;
  for (const std::array<double, 6>& part : parts)
  {
    if (part[0] <= part[1])
    {
      box.AddBounds(part.data());
    }
  }
  std::array<double, 6> bounds = { { 1, -1, 1, -1, 1, -1 } };
  if (box.IsValid())
  {
    box.GetBounds(bounds.data());
  }
  return bounds;
}

//------------------------------------------------------------------------------
// A line across the bounds of the cells of @a mesh; nothing if it has no cells.
vtkSmartPointer<vtkPolyData> MakeBox(vtkUnstructuredGrid* mesh)
{
  const std::array<double, 6> bounds = GetCellBounds(mesh);
  if (bounds[0] > bounds[1])
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  vtkNew<vtkLineSource> diagonal;
  diagonal->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  diagonal->SetPoint1(bounds[0], bounds[2], bounds[4]);
  diagonal->SetPoint2(bounds[1], bounds[3], bounds[5]);
  diagonal->Update();
  return diagonal->GetOutput();
}

//------------------------------------------------------------------------------
// The blocks of @a meshes with such lines in place of the meshes.
vtkSmartPointer<vtkDataObject> MakeBoxes(vtkDataObject* meshes)
{
  auto* blocks = vtkCompositeDataSet::SafeDownCast(meshes);
  if (!blocks)
  {
    return MakeBox(vtkUnstructuredGrid::SafeDownCast(meshes));
  }
  auto boxes = vtk::TakeSmartPointer(blocks->NewInstance());
  boxes->CopyStructure(blocks);
  boxes->GetFieldData()->ShallowCopy(blocks->GetFieldData());
  const auto leaves = vtk::TakeSmartPointer(blocks->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    if (auto* mesh = vtkUnstructuredGrid::SafeDownCast(leaves->GetCurrentDataObject()))
    {
      boxes->SetDataSet(leaves, MakeBox(mesh));
    }
  }
  return boxes;
}

//------------------------------------------------------------------------------
// Whether processes exchange cells, which they do to draw translucent objects.
bool IsRedistributed(vtkPVRenderView* view)
{
  return view && ControllerReducer().GetNumberOfProcesses() > 1 && view->GetUseOrderedCompositing();
}
}

//------------------------------------------------------------------------------
bool vtkMeshInspectionRepresentation::Internals::Delivered::Update(
  vtkUnstructuredGrid* mesh, vtkDataObjectTree* samples)
{
  if (this->TimeOfMesh != mesh->GetMTime())
  {
    this->TimeOfMesh = mesh->GetMTime();
    this->Blocks = vtkSmartPointer<vtkUnstructuredGrid>::New();
    this->Blocks->ShallowCopy(mesh);
  }
  const bool areOld = this->AreAttributesOld || this->TimeOfSamples != samples->GetMTime();
  this->TimeOfSamples = samples->GetMTime();
  this->AreAttributesOld = false;
  return areOld;
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::Internals::CopyColoring(vtkMapper* from, vtkMapper* to)
{
  to->SetLookupTable(from->GetLookupTable());
  to->SetUseLookupTableScalarRange(from->GetUseLookupTableScalarRange());
  to->SetColorMode(from->GetColorMode());
  to->SetInterpolateScalarsBeforeMapping(from->GetInterpolateScalarsBeforeMapping());
  to->SetScalarVisibility(from->GetScalarVisibility());
  to->SelectColorArray(from->GetArrayName());
  to->SetScalarMode(from->GetScalarMode());
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::Internals::ShowWires(
  const InspectionStyle& style, const Drawn& drawn, vtkActor* ofMesh)
{
  const bool isOn = ofMesh->GetVisibility() && (style.Faces || style.Edges);
  vtkPolyData* cells = this->Wires.Update(isOn ? drawn.Mesh : nullptr, style);
  this->WireActor->SetVisibility(cells->GetNumberOfCells() > 0);
  if (cells->GetNumberOfCells() > 0)
  {
    CopyColoring(drawn.Mapper, this->WireMapper);
    this->WireMapper->SetInputData(cells);
    this->WireActor->SetPickable(ofMesh->GetPickable());
    FollowActor(this->WireActor, ofMesh);
  }
}

//------------------------------------------------------------------------------
std::size_t vtkMeshInspectionRepresentation::Internals::CountTriangles(vtkMapper* ofMesh) const
{
  const bool isListAnew = this->CutMoves == WithView && this->Style.CutsCells();
  std::size_t number =
    static_cast<vtkMeshInspectionMapper*>(ofMesh)->GetNumberOfTriangles(isListAnew);
  for (const Companion* other : { &this->Lines, &this->Isosurfaces, &this->Cap, &this->Shell })
  {
    number += other->Actor->GetVisibility() ? other->Mapper->GetNumberOfTriangles(isListAnew) : 0;
  }
  return number;
}

//------------------------------------------------------------------------------
// Computes the shape in the coordinates of the mesh. A shape that is attached to the view is fixed
// as the camera sees it in the first frame after the property was set, and then moves through the
// mesh with the camera. @a renderer: null as long as its camera may be outdated.
void vtkMeshInspectionRepresentation::Internals::UpdateShape(
  vtkMeshInspectionRepresentation* self, vtkActor* actor, vtkRenderer* renderer)
{
  if (this->Style.Cut == CutBy::Nothing || !this->CutFunction)
  {
    this->HasFixedView = false;
    return;
  }
  if (!renderer && this->CutMoves == WithView && this->HasFixedView)
  {
    return; // the next frame starts with the new camera
  }
  const std::string error = ConvertShape(this->CutFunction, this->Style.Shape);
  // Neither the default shape of an empty mesh, which has no bounds, nor a list without planes is
  // an error.
  const bool isEmpty = this->Style.Bounds[0] > this->Style.Bounds[1];
  auto* planes = vtkHalfSpaces::SafeDownCast(this->CutFunction);
  const bool isUnfinished = planes && planes->GetNumberOfNumbers() == 0;
  if (!error.empty() && error != this->LastShapeError && !isEmpty && !isUnfinished)
  {
    vtkErrorWithObjectMacro(self, << error);
  }
  this->LastShapeError = error;
  if (this->CutMoves == WithMesh)
  {
    this->HasFixedView = false;
    return;
  }
  if (!renderer)
  {
    return;
  }
  vtkNew<vtkMatrix4x4> toView;
  vtkMatrix4x4::Multiply4x4(
    renderer->GetActiveCamera()->GetModelViewTransformMatrix(), actor->GetMatrix(), toView);
  if (!this->HasFixedView)
  {
    this->FixedView->DeepCopy(toView);
    this->FixedView->Invert();
    this->HasFixedView = true;
  }
  vtkNew<vtkMatrix4x4> toShape;
  vtkMatrix4x4::Multiply4x4(this->FixedView, toView, toShape);
  this->Style.Shape = TransformShape(this->Style.Shape, toShape);
}

//==============================================================================
vtkMeshInspectionRepresentation::vtkMeshInspectionRepresentation()
  : Internal(std::make_unique<Internals>(
      [this] { return this->GetVisibility() && this->IsTooMuchToMove(this->Internal->Mesh); }))
{
  // Replace the surface filter and its mapper by those for the mesh.
  this->GeometryFilter->Delete();
  this->GeometryFilter = vtkInspectionMesh::New();
  this->MultiBlockMaker->Delete();
  this->MultiBlockMaker = vtkJoinedInspectionMesh::New();
  this->Mapper->Delete();
  auto* mapper = vtkMeshInspectionMapper::New();
  this->Mapper = mapper;
  this->BackfaceMapper->Delete();
  auto* backfaceMapper = vtkMeshInspectionMapper::New();
  this->BackfaceMapper = backfaceMapper;
  // The same for the coarse mesh.
  this->LODMapper->Delete();
  auto* coarseMapper = vtkMeshInspectionMapper::New();
  this->LODMapper = coarseMapper;
  this->LODBackfaceMapper->Delete();
  auto* coarseBackfaceMapper = vtkMeshInspectionMapper::New();
  this->LODBackfaceMapper = coarseBackfaceMapper;
  this->SetupDefaults();
  backfaceMapper->ShareMesh(mapper);
  coarseBackfaceMapper->ShareMesh(coarseMapper);

  Internals& self = *this->Internal;
  self.Isosurfaces.Initialize(mapper, coarseMapper, this->Property);
  self.Cap.Initialize(mapper, coarseMapper, this->Property);

  self.WireActor->SetMapper(self.WireMapper);
  self.WireActor->SetProperty(this->Property);
  self.WireActor->VisibilityOff();
  self.WireMapper->SetPointIdArrayName(PointIdsName);
  self.WireMapper->SetCellIdArrayName(CellIdsName);
  self.WireMapper->SetProcessIdArrayName(ProcessIdsName);
  self.WireMapper->SetCompositeIdArrayName(BlockIdsName);

  self.Shell.Initialize(mapper, coarseMapper, self.ShellProperty);
  self.Shell.HasOneColor();
  self.Shell.Actor->PickableOff();
  self.ShellProperty->SetColor(0.75, 0.85, 1.0);
  self.ShellProperty->SetSpecular(0.6);
  self.ShellProperty->SetSpecularPower(60);

  self.Lines.Initialize(mapper, coarseMapper, self.LineProperty);
  self.Lines.HasOneColor();
  self.Lines.Actor->PickableOff();
  self.LineProperty->LightingOff();

  self.IdLabels->SetMesh(mapper, this->Actor);
}

//------------------------------------------------------------------------------
vtkMeshInspectionRepresentation::~vtkMeshInspectionRepresentation() = default;

//------------------------------------------------------------------------------
bool vtkMeshInspectionRepresentation::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (renderView)
  {
    for (vtkActor* actor : this->Internal->GetActors())
    {
      renderView->GetRenderer()->AddActor(actor);
    }
    for (vtkActor* actor : this->Internal->GetPickableActors())
    {
      renderView->RegisterPropForHardwareSelection(this, actor);
    }
  }
  const bool isAdded = this->Superclass::AddToView(view);
  if (renderView)
  {
    // After the mesh, because the smooth edges of digits are blended with it.
    renderView->GetRenderer()->AddActor(this->Internal->IdLabels);
    this->Internal->IdLabels->SetRenderer(renderView->GetRenderer());
    // After the camera has arrived from the client.
    constexpr float last = -1;
    this->Internal->StartTag = renderView->GetRenderer()->AddObserver(
      vtkCommand::StartEvent, this, &vtkMeshInspectionRepresentation::FollowCamera, last);
  }
  return isAdded;
}

//------------------------------------------------------------------------------
bool vtkMeshInspectionRepresentation::RemoveFromView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (renderView)
  {
    renderView->GetRenderer()->RemoveObserver(this->Internal->StartTag);
    this->Internal->DemandForCoarse.Forget();
    renderView->GetRenderer()->RemoveActor(this->Internal->IdLabels);
    this->Internal->IdLabels->SetRenderer(nullptr);
    for (vtkActor* actor : this->Internal->GetActors())
    {
      renderView->GetRenderer()->RemoveActor(actor);
    }
    for (vtkActor* actor : this->Internal->GetPickableActors())
    {
      renderView->UnRegisterPropForHardwareSelection(this, actor);
    }
  }
  return this->Superclass::RemoveFromView(view);
}

//------------------------------------------------------------------------------
bool vtkMeshInspectionRepresentation::NeedsOrderedCompositing()
{
  return this->Internal->GlassShell || this->Superclass::NeedsOrderedCompositing();
}

//------------------------------------------------------------------------------
// ParaView reads ranges and block names from this object: the blocks before they are joined.
vtkDataObject* vtkMeshInspectionRepresentation::GetRenderedDataObject(int)
{
  return this->GeometryFilter->GetNumberOfInputConnections(0) > 0
    ? this->GeometryFilter->GetOutputDataObject(0)
    : nullptr;
}

//------------------------------------------------------------------------------
// Colors by height and depth need the bounds of all pieces. The exchange is safe, because every
// process with a piece calls this.
int vtkMeshInspectionRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int result = this->Superclass::RequestData(request, inputVector, outputVector);
  this->Internal->Boxes = MakeBoxes(this->GeometryFilter->GetOutputDataObject(0));
  std::vector<std::array<double, 6>> ofGrids;
  for (vtkPointSet* box : vtkCompositeDataSet::GetDataSets<vtkPointSet>(this->Internal->Boxes))
  {
    ofGrids.emplace_back();
    box->GetBounds(ofGrids.back().data());
  }
  this->Internal->Style.Bounds =
    JoinBounds(ControllerReducer().GatherItems(std::vector{ JoinBounds(ofGrids) }));
  return result;
}

//------------------------------------------------------------------------------
// A hidden representation gets no render requests, so hide its actors at once.
void vtkMeshInspectionRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  if (!visible)
  {
    for (vtkActor* actor : this->Internal->GetActors())
    {
      actor->VisibilityOff();
    }
    this->Internal->IdLabels->VisibilityOff();
  }
}

//------------------------------------------------------------------------------
int vtkMeshInspectionRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (request == vtkPVView::REQUEST_UPDATE_LOD())
  {
    vtkDataObject* whole = vtkPVView::GetPiece(inInfo, this);
    const bool isMade = whole && this->Internal->TimeOfCoarse == whole->GetMTime();
    if (this->GetVisibility() && this->Internal->DemandForCoarse.IsDue(isMade))
    {
      this->MakeCoarseMesh(inInfo);
    }
    return this->GetVisibility() ? 1 : 0;
  }
  const bool areBlocksChanged = this->BlockAttrChanged; // the base class resets it
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->Internal->DemandForCoarse.Update(vtkPVRenderView::SafeDownCast(this->GetView()));
    this->UpdateReach();
    // Cells stay whole: those at the border between two processes go to one of them.
    vtkPVRenderView::SetRedistributionModeToUniquelyAssignBoundaryCells(inInfo, this);
    this->GiveSamples(inInfo, false);
    vtkNew<vtkCompositeDataDisplayAttributes> attributes;
    this->PopulateBlockAttributes(attributes, this->Internal->Boxes);
    vtkGeometryRepresentation::GetBounds(
      this->Internal->Boxes, this->VisibleDataBounds, attributes);
    vtkPVRenderView::SetGeometryBounds(
      inInfo, this, this->VisibleDataBounds, this->Actor->GetMatrix());
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    Internals& self = *this->Internal;
    self.Whole.AreAttributesOld = self.Whole.AreAttributesOld || areBlocksChanged;
    self.Coarse.AreAttributesOld = self.Coarse.AreAttributesOld || areBlocksChanged;
    const bool isCoarse = this->DrawsCoarseMesh(inInfo);
    static_cast<vtkPVLODActor*>(this->Actor)->SetEnableLOD(isCoarse);
    self.IsCoarse = isCoarse;
    self.Mesh = this->UpdateMesh(inInfo, isCoarse);
    this->UpdateStyles(nullptr);
  }
  return 1;
}

//------------------------------------------------------------------------------
// A shape attached to the view follows the camera of the frame, which servers know only when they
// start to render.
void vtkMeshInspectionRepresentation::FollowCamera(vtkObject* renderer, unsigned long, void*)
{
  Internals& self = *this->Internal;
  if (this->GetVisibility() && self.Mesh && self.CutMoves == WithView &&
    self.Style.Cut != CutBy::Nothing)
  {
    this->UpdateStyles(vtkRenderer::SafeDownCast(renderer));
  }
}

//------------------------------------------------------------------------------
// After this request, and before rendering, the view reads the bounds of what it shows.
void vtkMeshInspectionRepresentation::UpdateReach()
{
  const double length = this->Internal->GetNormalLength(nullptr);
  for (vtkMapper* mapper : std::initializer_list<vtkMapper*>{
         this->Mapper, this->BackfaceMapper, this->LODMapper, this->LODBackfaceMapper })
  {
    static_cast<vtkMeshInspectionMapper*>(mapper)->SetReach(
      this->Internal->Style.ExplodeFactor, length);
  }
}

//------------------------------------------------------------------------------
// The blocks are delivered as one grid. All processes have the same samples, so those of one
// process are sufficient.
void vtkMeshInspectionRepresentation::GiveSamples(vtkInformation* inInfo, bool withCoarseMesh)
{
  vtkDataObject* samples = this->MultiBlockMaker->GetOutputDataObject(Internals::PortOfSamples);
  if (withCoarseMesh)
  {
    vtkPVView::SetPieceLOD(inInfo, this, samples, 0, Internals::PortOfSamples);
  }
  else
  {
    vtkPVView::SetPiece(inInfo, this, samples, 0, Internals::PortOfSamples);
  }
  auto* view = vtkPVRenderView::SafeDownCast(this->GetView());
  auto* manager =
    vtkPVRenderViewDataDeliveryManager::SafeDownCast(view ? view->GetDeliveryManager() : nullptr);
  if (manager)
  {
    manager->SetDeliverToClientAndRenderingProcesses(
      this, true, /*gather*/ false, withCoarseMesh, Internals::PortOfSamples);
  }
}

//------------------------------------------------------------------------------
// Passes the coarse mesh to the view, which delivers it to where it is drawn.
void vtkMeshInspectionRepresentation::MakeCoarseMesh(vtkInformation* inInfo)
{
  vtkDataObject* whole = vtkPVView::GetPiece(inInfo, this);
  if (!whole || this->SuppressLOD)
  {
    return;
  }
  vtkCoarseInspectionMesh* coarse = this->Internal->MakeCoarse;
  coarse->SetInputDataObject(whole);
  coarse->SetWholeBounds(this->Internal->Style.Bounds.data());
  coarse->SetOutlineOnly(inInfo->Has(vtkPVRenderView::USE_OUTLINE_FOR_LOD()) != 0);
  if (inInfo->Has(vtkPVRenderView::LOD_RESOLUTION()))
  {
    coarse->SetResolution(inInfo->Get(vtkPVRenderView::LOD_RESOLUTION()));
  }
  coarse->Update();
  this->Internal->TimeOfCoarse = whole->GetMTime();
  vtkPVView::SetPieceLOD(inInfo, this, coarse->GetOutputDataObject(0));
  this->GiveSamples(inInfo, true);
}

//------------------------------------------------------------------------------
// ParaView compares its threshold with the size of the whole mesh. A single process instead counts
// the triangles that are drawn, as Surface does. Several processes may draw different parts, but
// must decide alike.
bool vtkMeshInspectionRepresentation::DrawsCoarseMesh(vtkInformation* inInfo)
{
  if (this->SuppressLOD || !inInfo->Has(vtkPVRenderView::USE_LOD()) ||
    !vtkPVView::GetDeliveredPieceLOD(inInfo, this))
  {
    return false;
  }
  return this->IsTooMuchToMove(vtkPVView::GetDeliveredPiece(inInfo, this));
}

//------------------------------------------------------------------------------
// @a whole: the mesh, if it has been delivered to this process, else null.
bool vtkMeshInspectionRepresentation::IsTooMuchToMove(vtkDataObject* whole)
{
  const bool isAlone = ControllerReducer().GetNumberOfProcesses() == 1;
  auto* view = vtkPVRenderView::SafeDownCast(this->GetView());
  if (!isAlone || !view || !whole || whole->GetNumberOfElements(vtkDataObject::CELL) == 0)
  {
    return true;
  }
  constexpr double megabytesOfTriangle =
    40.0 / 1024 / 1024; // three ids, an offset and half a point
  return megabytesOfTriangle * static_cast<double>(this->Internal->CountTriangles(this->Mapper)) >=
    view->GetLODRenderingThreshold();
}

//------------------------------------------------------------------------------
// Updates the looks of blocks here, because they may change without new data.
vtkUnstructuredGrid* vtkMeshInspectionRepresentation::UpdateMesh(
  vtkInformation* inInfo, bool isCoarse)
{
  Internals::Delivered& self = isCoarse ? this->Internal->Coarse : this->Internal->Whole;
  const auto get = [&](int port)
  {
    return isCoarse ? vtkPVView::GetDeliveredPieceLOD(inInfo, this, port)
                    : vtkPVView::GetDeliveredPiece(inInfo, this, port);
  };
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(get(0));
  auto* samples = vtkDataObjectTree::SafeDownCast(get(Internals::PortOfSamples));
  vtkMapper* mapper = isCoarse ? this->LODMapper : this->Mapper;
  if (mesh && samples)
  {
    if (self.Update(mesh, samples))
    {
      this->PopulateBlockAttributes(self.Attributes, samples);
    }
    double missing[3];
    this->Property->GetDiffuseColor(missing);
    if (this->Internal->ColorMissingArraysWithNanColor)
    {
      mapper->GetLookupTable()->GetColor(vtkMath::Nan(), missing);
    }
    mesh = self.Blocks;
    SetLooks(mesh, samples, self.Attributes, mapper, missing);
  }
  if (!isCoarse)
  {
    CurvedMesh& curved = this->Internal->Curved;
    const InspectionStyle& style = this->Internal->Style;
    const int level = style.OnProcessor ? 0 : style.SubdivisionLevel; // VTK's filters divide it
    mesh = curved.Update(mesh, level, this->Internal->GetExtent(mesh));
    static_cast<vtkMeshInspectionMapper*>(mapper)->GetMesh()->SetSubdividedFacets(
      curved.GetFacets());
    const std::string warning = curved.GetNewWarning();
    if (!warning.empty())
    {
      vtkWarningMacro(<< warning);
    }
  }
  mapper->SetInputDataObject(mesh);
  (isCoarse ? this->LODBackfaceMapper : this->BackfaceMapper)->SetInputDataObject(mesh);
  return mesh;
}

//------------------------------------------------------------------------------
// Which faces and points of curved cells are drawn. Hidden cells and pieces have other boundaries
// than the mesh.
SubdividedFacets::Extent vtkMeshInspectionRepresentation::Internals::GetExtent(
  vtkUnstructuredGrid* mesh) const
{
  using Extent = SubdividedFacets::Extent;
  const bool isInside = this->DrawIsosurfaces || (this->CutFunction && this->Style.CutsExactly());
  const bool isWhole = this->Style.IsWholeSurface() && mesh && !mesh->GetCellGhostArray() &&
    !mesh->GetCellData()->GetArray(OuterFacetsName) &&
    !mesh->GetFieldData()->GetArray(HiddenLeavesName);
  return isInside ? Extent::Cells : isWhole ? Extent::Boundary : Extent::Faces;
}

//------------------------------------------------------------------------------
// Length of the lines; 0 if none are drawn. @a mesh: used if the bounds of all pieces are unknown;
// may be null.
double vtkMeshInspectionRepresentation::Internals::GetNormalLength(vtkUnstructuredGrid* mesh) const
{
  vtkBoundingBox box(this->Style.Bounds.data());
  if (!box.IsValid() && mesh)
  {
    box.SetBounds(GetCellBounds(mesh).data());
  }
  return this->NormalsOf != 0 && box.IsValid() ? this->NormalLength * box.GetDiagonalLength() : 0;
}

//------------------------------------------------------------------------------
// The same for all pieces if the bounds of all pieces are known. @a mesh: used otherwise; may be
// null.
ConvexShape vtkMeshInspectionRepresentation::Internals::GetExactShape(
  vtkUnstructuredGrid* mesh) const
{
  const InspectionStyle& style = this->Style;
  std::array<double, 6> bounds = style.Bounds;
  if (bounds[0] > bounds[1] && mesh)
  {
    bounds = GetCellBounds(mesh);
  }
  const vtkBoundingBox box(bounds.data());
  const double size = box.IsValid() ? box.GetDiagonalLength() * (1 + style.ExplodeFactor) : 0;
  if (style.ExplodeFactor != 0)
  {
    bounds = { { 1, -1, 1, -1, 1, -1 } }; // cells move beyond the bounds
  }
  return MakeExactShape(style.Shape, style.KeepInside, size, bounds);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::UpdateStyles(vtkRenderer* ofPicture)
{
  Internals& self = *this->Internal;
  const bool isCoarse = self.IsCoarse;
  vtkUnstructuredGrid* mesh = self.Mesh;
  const Internals::Drawn drawn{ mesh, isCoarse ? this->LODMapper : this->Mapper, isCoarse };
  auto* view = vtkPVRenderView::SafeDownCast(this->GetView());
  vtkRenderer* renderer = view ? view->GetRenderer() : nullptr;
  self.UpdateShape(this, this->Actor, ofPicture);
  InspectionStyle style = self.Style;
  if (!self.CutFunction || !self.LastShapeError.empty())
  {
    style.Cut = CutBy::Nothing;
  }
  if (renderer && renderer->GetPass() && renderer->GetPass()->IsA("vtkOSPRayPass"))
  {
    // Ray tracers do not run the shaders.
    if (!self.WarnedOfRayTracing)
    {
      vtkWarningMacro(
        "Mesh Inspection is ray traced as an ordinary surface: without glass, isolines, normals, "
        "interior faces and emphasis.");
    }
    self.WarnedOfRayTracing = true;
    style.OnProcessor = true;
  }
  style.NormalLength = self.GetNormalLength(mesh);
  if (style.CutsExactly())
  {
    style.ExactShape = self.GetExactShape(mesh);
  }
  for (vtkMapper* mapper :
    { drawn.Mapper, isCoarse ? this->LODBackfaceMapper : this->BackfaceMapper })
  {
    static_cast<vtkMeshInspectionMapper*>(mapper)->SetStyle(style);
  }

  self.ShowWires(style, drawn, this->Actor);

  const bool isVisible = this->GetVisibility();
  InspectionStyle lines = style.GetVisible();
  lines.What = self.NormalsOf == 1 ? Figure::FaceNormals : Figure::PointNormals;
  self.LineProperty->SetLineWidth(this->Property->GetLineWidth());
  self.Lines.Show(isVisible && self.NormalsOf != 0, lines, drawn, this->Actor);

  InspectionStyle surfaces = style;
  surfaces.What = Figure::Isosurfaces;
  surfaces.Faces = true;
  surfaces.Edges = surfaces.Points = surfaces.Isolines = false;
  surfaces.ShrinkFactor = 1;
  surfaces.ExplodeFactor = 0;
  self.Isosurfaces.Show(isVisible && self.DrawIsosurfaces, surfaces, drawn, this->Actor, true);

  // The cells of a coarse mesh are not those that ids belong to.
  const bool hasIds = !self.Ids.IsEmpty() && isVisible && !isCoarse;
  self.IdLabels->SetVisibility(hasIds);
  if (hasIds)
  {
    self.IdLabels->Show(self.Ids, style, mesh);
    self.IdLabels->SetHasPieces(!IsRedistributed(view));
  }

  const bool hasCap = style.CutsExactly() && (style.Faces || style.Edges);
  style.What = Figure::Cap;
  self.Cap.Show(isVisible && hasCap, style, drawn, this->Actor, true);

  InspectionStyle glass;
  glass.Glass = true;
  glass.Edges = false;
  glass.GlassStrength = style.GlassStrength;
  self.Shell.Show(isVisible && self.GlassShell, glass, drawn, this->Actor);
}
