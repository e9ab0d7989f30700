// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkQualityRegions.h"

#include "AcceptableRanges.h"
#include "ControllerReducer.h"
#include "Grouping.h"
#include "MeshOutputs.h"
#include "PropertyValues.h"
#include "QualityRegions.h"
#include "RequestFailure.h"
#include "TableRows.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkQualityRegions);

namespace
{
//------------------------------------------------------------------------------
void AddColumnsOfRegions(vtkTable* table, bool withVolumes)
{
  camaron::AddColumns<camaron::IntegerColumn>(table, { "Rank", "Count" });
  camaron::AddColumns<vtkDoubleArray>(table, { "WorstValue" });
  camaron::AddColumns<camaron::IntegerColumn>(table, { "WorstId" });
  camaron::AddColumns<vtkStringArray>(table, { "IdSpace" });
  camaron::AddColumns<vtkDoubleArray>(table, { "X", "Y", "Z", "Size" });
  if (withVolumes)
  {
    camaron::AddColumns<vtkDoubleArray>(table, { "Volume" });
  }
  camaron::AddColumns<vtkStringArray>(table, { "Block" });
}

//------------------------------------------------------------------------------
void AddRows(vtkTable* table, const camaron::QualityRegions& regions, const std::string& idSpace,
  const camaron::BlockNames& blockNames)
{
  std::int64_t rank = 0;
  for (const camaron::QualityRegion& region : regions.Largest)
  {
    camaron::TableRow row;
    row.Add(++rank, region.Count, region.WorstValue, static_cast<std::int64_t>(region.WorstId),
      idSpace, region.Center, region.Size);
    if (regions.HaveVolumes)
    {
      row.Add(region.Volume);
    }
    row.Add(camaron::FindBlockName(blockNames, region.BlockNumber));
    row.AppendTo(table);
  }
}
}

//------------------------------------------------------------------------------
vtkQualityRegions::vtkQualityRegions()
  : PresetNames(camaron::MakePresetNames(camaron::GetDefaultRangesName()))
{
  this->Adjacency = "Vertex";
}

//------------------------------------------------------------------------------
int vtkQualityRegions::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkQualityRegions::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkTable* table = vtkTable::GetData(outputVector);
  camaron::SelectionInputs inputs;
  inputs.Mesh = vtkDataObject::GetData(inputVector[0]);
  try
  {
    camaron::CheckNumber("Number Of Regions", this->NumberOfRegions, 0);
    camaron::ControllerReducer reducer;
    const camaron::ElementBlocks blocks(inputs.Mesh, reducer);
    const camaron::SelectionTask task(
      *this, inputs, blocks, camaron::GetNumberOfPieces(outputVector), reducer);
    camaron::RegionFinder finder(task, this->IncludeUndefined);
    camaron::CheckAbortOnAllRanks(this, 0.2, reducer);
    const camaron::QualityRegions regions = finder.Find(this->NumberOfRegions);
    camaron::CheckAbortOnAllRanks(this, 0.9, reducer);
    const auto blockNames = camaron::GetBlockNames(blocks, reducer);
    AddColumnsOfRegions(table, regions.HaveVolumes);
    if (reducer.GetProcess() == 0)
    {
      AddRows(table, regions, blocks.GetIdSpace(), blockNames);
      vtkNew<camaron::IntegerColumn> total;
      total->SetName("NumberOfRegions");
      total->InsertNextValue(regions.Total);
      table->GetFieldData()->AddArray(total);
    }
  }
  catch (...)
  {
    return camaron::FailRequest(this, "The regions cannot be found", outputVector);
  }
  return 1;
}
