// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCoarseInspectionMesh.h"

#include "InspectionArrays.h"
#include "InspectionMesh.h"

#include "Drawing/CoarseMesh.h"
#include "Mesh/MeshTopology.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutlineSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTypeUInt64Array.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <exception>

using namespace camaron;

vtkStandardNewMacro(vtkCoarseInspectionMesh);

namespace
{
//------------------------------------------------------------------------------
void MakeOutline(const std::array<double, 6>& bounds, vtkUnstructuredGrid* output)
{
  vtkNew<vtkOutlineSource> box;
  box->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  box->SetBounds(bounds.data());
  vtkNew<vtkAppendFilter> lines;
  lines->SetInputConnection(box->GetOutputPort());
  lines->Update();
  output->CopyStructure(lines->GetOutput());
}

//------------------------------------------------------------------------------
// Copies all arrays of the elements that represent others.
void CopyArrays(
  vtkDataSetAttributes* from, const std::vector<vtkIdType>& ids, vtkDataSetAttributes* to)
{
  vtkNew<vtkIdList> sources;
  sources->SetNumberOfIds(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), sources->begin());
  to->CopyAllOn();
  to->CopyAllocate(from, sources->GetNumberOfIds());
  to->CopyData(from, sources);
}
}

//------------------------------------------------------------------------------
int vtkCoarseInspectionMesh::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
int vtkCoarseInspectionMesh::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  auto* output = vtkUnstructuredGrid::GetData(outputVector);
  output->GetFieldData()->PassData(input->GetFieldData());
  if (input->GetNumberOfCells() == 0)
  {
    return 1;
  }
  CoarseBoxes boxes;
  boxes.Bounds = GetCellBounds(input);
  if (this->OutlineOnly)
  {
    MakeOutline(boxes.Bounds, output);
    return 1;
  }
  if (this->WholeBounds[0] <= this->WholeBounds[1])
  {
    std::copy_n(this->WholeBounds, 6, boxes.Bounds.begin());
  }
  // The resolution of ParaView for surfaces; the interior needs less.
  boxes.OfOutside = static_cast<int>(150 * this->Resolution) + 10;
  boxes.OfInside = static_cast<int>(40 * this->Resolution) + 10;
  const CellsToDraw cells = GetCellsToDraw(input);
  CoarseMesh coarse;
  try
  {
    coarse = MakeCoarseMesh(MeshTopology(input), cells, boxes);
  }
  catch (const std::exception& error)
  {
    vtkWarningMacro("The full mesh is drawn while the camera moves: " << error.what());
    output->ShallowCopy(input);
    return 1;
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  points->SetNumberOfPoints(static_cast<vtkIdType>(coarse.Points.size()));
  for (std::size_t i = 0; i < coarse.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), input->GetPoint(coarse.Points[i]));
  }
  output->SetPoints(points);
  output->Allocate(static_cast<vtkIdType>(coarse.Cells.size()));
  constexpr int types[] = { VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_TETRA };
  for (const std::array<std::uint32_t, 4>& cell : coarse.Cells)
  {
    vtkIdType corners[4];
    int size = 0;
    for (; size < 4 && cell[size] != CoarseMesh::NoPoint; ++size)
    {
      corners[size] = cell[size];
    }
    output->InsertNextCell(types[size - 1], size, corners);
  }
  CopyArrays(input->GetPointData(), coarse.Points, output->GetPointData());
  CopyArrays(input->GetCellData(), coarse.Origins, output->GetCellData());
  output->GetCellData()->RemoveArray(OuterFacetsName);
  if (cells.OuterFacets)
  {
    vtkNew<vtkTypeUInt64Array> outer;
    outer->SetName(OuterFacetsName);
    outer->SetNumberOfValues(static_cast<vtkIdType>(coarse.OuterFacets.size()));
    std::copy(coarse.OuterFacets.begin(), coarse.OuterFacets.end(), outer->GetPointer(0));
    output->GetCellData()->AddArray(outer);
  }
  return 1;
}
