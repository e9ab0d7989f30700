// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshElements.h"

#include "ControllerReducer.h"
#include "DistributedMesh.h"
#include "Elements/MeshElements.h"
#include "MeshInput.h"
#include "MeshOutputs.h"
#include "RequestFailure.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

vtkStandardNewMacro(vtkMeshElements);

namespace
{
//------------------------------------------------------------------------------
void AddRows(vtkDataArraySelection* selection, const std::vector<camaron::ElementArray>& rows)
{
  for (const camaron::ElementArray& row : rows)
  {
    selection->AddArray(row.Name, row.IsDefault);
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> GetTicked(vtkDataArraySelection* selection)
{
  std::vector<std::string> names;
  for (int i = 0; i < selection->GetNumberOfArrays(); ++i)
  {
    if (selection->GetArraySetting(i))
    {
      names.emplace_back(selection->GetArrayName(i));
    }
  }
  return names;
}

//------------------------------------------------------------------------------
void AddUndefinedMasks(vtkPolyData* elements)
{
  vtkCellData* const arrays = elements->GetCellData();
  const int size = arrays->GetNumberOfArrays();
  for (int i = 0; i < size; ++i)
  {
    if (auto* const values = vtkDoubleArray::SafeDownCast(arrays->GetArray(i)))
    {
      arrays->AddArray(camaron::MakeUndefinedMask(values, elements));
    }
  }
}

//------------------------------------------------------------------------------
// The criteria for which pieces of this process have an array.
std::vector<std::string> FindCriteria(const camaron::DistributedMesh& pieces)
{
  std::vector<std::string> names;
  for (const camaron::Criterion& criterion : camaron::GetCriteria())
  {
    for (std::size_t piece = 0; piece < pieces.GetSize(); ++piece)
    {
      vtkDataArray* values = pieces.GetMesh(piece)->GetCellData()->GetArray(criterion.Name);
      if (values && values->GetNumberOfComponents() == 1)
      {
        names.emplace_back(criterion.Name);
      }
    }
  }
  return names;
}

//------------------------------------------------------------------------------
std::vector<std::vector<camaron::ElementKey>> MakeKeys(const std::vector<vtkPolyData*>& pieces)
{
  std::vector<std::vector<camaron::ElementKey>> keys;
  keys.reserve(pieces.size());
  std::transform(pieces.begin(), pieces.end(), std::back_inserter(keys), camaron::MakeKeys);
  return keys;
}

//------------------------------------------------------------------------------
// Collective. Global ids of elements, which are their numbers in the undivided mesh, unless some
// have no keys, or ids of the input are not good for any.
void AddIds(const char* name, const std::vector<vtkPolyData*>& outputs,
  const camaron::DistributedMesh& pieces, std::vector<std::vector<camaron::ElementKey>>&& keys,
  camaron::Reducer& reducer)
{
  std::vector<camaron::KeyedElements> elements(outputs.size());
  std::int64_t lacksKeys = 0;
  for (std::size_t piece = 0; piece < outputs.size(); ++piece)
  {
    vtkUnsignedCharArray* ghosts = outputs[piece]->GetCellGhostArray();
    elements[piece] = { pieces.Get()[piece].Block, std::move(keys[piece]),
      ghosts ? ghosts->GetPointer(0) : nullptr };
    lacksKeys |=
      static_cast<vtkIdType>(elements[piece].Keys.size()) != outputs[piece]->GetNumberOfCells();
  }
  reducer.Max(&lacksKeys, 1);
  if (lacksKeys)
  {
    return;
  }
  const std::vector<std::vector<vtkIdType>> ids = camaron::NumberElements(elements, reducer);
  for (std::size_t piece = 0; piece < ids.size(); ++piece)
  {
    vtkNew<vtkIdTypeArray> array;
    array->SetName(name);
    array->SetNumberOfValues(outputs[piece]->GetNumberOfCells());
    std::copy(ids[piece].begin(), ids[piece].end(), array->GetPointer(0));
    outputs[piece]->GetCellData()->SetGlobalIds(array);
  }
}
}

//------------------------------------------------------------------------------
vtkMeshElements::vtkMeshElements()
{
  this->SetNumberOfOutputPorts(3);
  AddRows(this->FaceArrays, camaron::GetFaceArrays());
  AddRows(this->EdgeArrays, camaron::GetEdgeArrays());
  AddRows(this->VertexArrays, camaron::GetVertexArrays());
}

//------------------------------------------------------------------------------
vtkMTimeType vtkMeshElements::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->FaceArrays->GetMTime(),
    this->EdgeArrays->GetMTime(), this->VertexArrays->GetMTime() });
}

//------------------------------------------------------------------------------
int vtkMeshElements::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  camaron::MakePolyDataOutputs(inputVector, outputVector);
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshElements::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  RequestGhostCells(inputVector, outputVector);
  return 1;
}

//------------------------------------------------------------------------------
void vtkMeshElements::TakeElements(vtkDataObject* input, vtkInformationVector* outputVector)
{
  const camaron::EvaluationOptions common = this->GetEvaluationOptions();
  camaron::ControllerReducer reducer;
  // After an abort the pipeline executes the filter again for each of the other ports.
  camaron::CheckAbortOnAllRanks(this, 0, reducer);
  std::vector<camaron::DataSetLeaf> leaves = camaron::GetMeshes(input, reducer);
  for (camaron::DataSetLeaf& leaf : leaves)
  {
    leaf.Data = camaron::WithoutStrips(leaf.Data);
  }
  camaron::DistributedMesh pieces(
    leaves, common, camaron::GetNumberOfPieces(outputVector), reducer);
  if (this->GetConnectBlocks())
  {
    pieces.ConnectBlocks();
  }
  const bool areComplete = pieces.CanAskOthers();
  const std::vector<unsigned> dimensions = pieces.FindDimensions();
  const std::vector<vtkSmartPointer<vtkDataSet>> meshes = pieces.Complete(
    this->WorstOfCells ? reducer.GatherNames(FindCriteria(pieces)) : std::vector<std::string>());

  std::vector<std::vector<vtkIdType>> points(pieces.GetSize());
  if (this->VertexArrays->ArrayIsEnabled("DuplicatePoint"))
  {
    points = pieces.FindCoincidentPoints(this->MergeTolerance);
  }
  std::vector<std::vector<camaron::Index>> faces(pieces.GetSize());
  if (this->FaceArrays->ArrayIsEnabled("FaceMismatch"))
  {
    faces = pieces.FindMismatchedFaces(meshes, this->MergeTolerance);
  }

  const std::vector<vtkPolyData*> outputs[] = { camaron::MakePolyDataLeaves(
                                                  input, vtkDataObject::GetData(outputVector, 0)),
    camaron::MakePolyDataLeaves(input, vtkDataObject::GetData(outputVector, 1)),
    camaron::MakePolyDataLeaves(input, vtkDataObject::GetData(outputVector, 2)) };
  std::vector<std::vector<camaron::ElementKey>> keys(pieces.GetSize()); // of the faces
  bool isFinished = true;
  for (std::size_t piece = 0; piece < pieces.GetSize(); ++piece)
  {
    const camaron::MeshTopology topology(meshes[piece]);
    camaron::ElementContext context(meshes[piece], topology, pieces.GetOptions(piece),
      this->MergeTolerance,
      { pieces.GetMesh(piece), dimensions[piece], areComplete, &points[piece], &faces[piece] });
    context.SetProgress(
      [&](double done)
      {
        this->UpdateProgress(
          (static_cast<double>(piece) + done) / static_cast<double>(pieces.GetSize()));
        return !this->CheckAbort();
      });
    constexpr double faceTime = 0.6, edgeTime = 0.9; // approximate fractions of the time
    {
      const camaron::ElementContext::Step step(context, 0, faceTime);
      camaron::MakeFaces(context, GetTicked(this->FaceArrays), outputs[0][piece],
        areComplete ? &keys[piece] : nullptr);
    }
    {
      const camaron::ElementContext::Step step(context, faceTime, edgeTime);
      camaron::MakeEdges(context, GetTicked(this->EdgeArrays), outputs[1][piece]);
    }
    const camaron::ElementContext::Step step(context, edgeTime, 1);
    if (camaron::MakeVertices(context, GetTicked(this->VertexArrays), outputs[2][piece]) &&
      this->WorstOfCells)
    {
      camaron::AddWorstOfCells(context, outputs[2][piece]);
    }
    isFinished = context.GoesOn(1);
    if (!isFinished)
    {
      break;
    }
    for (const auto& output : outputs)
    {
      if (this->WriteUndefinedMask)
      {
        AddUndefinedMasks(output[piece]);
      }
    }
  }
  camaron::CheckAbortOnAllRanks(this, 1, reducer, isFinished);
  if (areComplete)
  {
    AddIds("GlobalFaceIds", outputs[0], pieces, std::move(keys), reducer);
    AddIds("GlobalEdgeIds", outputs[1], pieces, MakeKeys(outputs[1]), reducer);
    AddIds("GlobalVertexIds", outputs[2], pieces, MakeKeys(outputs[2]), reducer);
  }
}

//------------------------------------------------------------------------------
int vtkMeshElements::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  try
  {
    this->TakeElements(vtkDataObject::GetData(inputVector[0]), outputVector);
  }
  catch (...)
  {
    return camaron::FailRequest(this, "The elements of the mesh cannot be extracted", outputVector);
  }
  return 1;
}
