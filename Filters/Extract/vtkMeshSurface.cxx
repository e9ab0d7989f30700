// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshSurface.h"

#include "AcceptableRanges.h"
#include "ControllerReducer.h"
#include "DistributedMesh.h"
#include "Drawing/PolygonTriangles.h"
#include "Mesh/BoundarySurface.h"
#include "MeshInput.h"
#include "MeshOutputs.h"
#include "RequestFailure.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedShortArray.h"

#include <vector>

vtkStandardNewMacro(vtkMeshSurface);

namespace
{
void AddShapes(vtkDataSet* mesh, vtkPolyData* surface)
{
  const std::vector<std::uint16_t> shapes = camaron::FindCellShapes(mesh);
  auto* cells = vtkArrayDownCast<vtkIdTypeArray>(
    surface->GetCellData()->GetAbstractArray("vtkOriginalCellIds"));
  vtkNew<vtkUnsignedShortArray> ofFaces;
  ofFaces->SetName(camaron::GetCellShapesName());
  ofFaces->SetNumberOfValues(surface->GetNumberOfCells());
  for (vtkIdType face = 0; face < surface->GetNumberOfCells(); ++face)
  {
    ofFaces->SetValue(face, shapes[cells->GetValue(face)]);
  }
  surface->GetCellData()->AddArray(ofFaces);
}
}

//------------------------------------------------------------------------------
int vtkMeshSurface::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshSurface::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  camaron::MakePolyDataOutputs(inputVector, outputVector);
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  try
  {
    camaron::ControllerReducer reducer;
    std::vector<camaron::DataSetLeaf> leaves = camaron::GetMeshes(input, reducer);
    for (camaron::DataSetLeaf& leaf : leaves)
    {
      leaf.Data = this->Triangulate ? camaron::WithoutStrips(leaf.Data) : leaf.Data;
    }
    camaron::DistributedMesh pieces(leaves, {}, camaron::GetNumberOfPieces(outputVector), reducer);
    camaron::CheckAbortOnAllRanks(this, 0.3, reducer);
    pieces.Link();
    camaron::CheckAbortOnAllRanks(this, 0.6, reducer);
    const std::vector<vtkPolyData*> surfaces = camaron::MakePolyDataLeaves(input, output);
    for (std::size_t piece = 0; piece < pieces.GetSize(); ++piece)
    {
      const camaron::PieceLinks* links = pieces.GetOptions(piece).Links;
      camaron::MakeBoundarySurface(
        pieces.GetMesh(piece), surfaces[piece], links ? &links->Faces : nullptr);
      if (this->PassThroughShapes)
      {
        AddShapes(leaves[piece].Data, surfaces[piece]);
      }
      if (this->Triangulate)
      {
        camaron::CutIntoTriangles(surfaces[piece]);
      }
      if (!this->PassThroughIds)
      {
        surfaces[piece]->GetCellData()->RemoveArray("vtkOriginalCellIds");
        surfaces[piece]->GetPointData()->RemoveArray("vtkOriginalPointIds");
      }
    }
    camaron::CheckAbortOnAllRanks(this, 1, reducer);
  }
  catch (...)
  {
    return camaron::FailRequest(this, "The surface of the mesh cannot be extracted", outputVector);
  }
  return 1;
}
