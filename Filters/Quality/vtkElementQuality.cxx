// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkElementQuality.h"

#include "AcceptableRanges.h"
#include "Base/Buffer.h"
#include "Base/Parallel.h"
#include "Base/Units.h"
#include "ControllerReducer.h"
#include "Criteria/CostEstimate.h"
#include "Criteria/Evaluation.h"
#include "DistributedMesh.h"
#include "EvaluatedArrays.h"
#include "Mesh/GhostArrays.h"
#include "MeshInput.h"
#include "MeshOutputs.h"
#include "Ranks/Collective.h"
#include "RequestFailure.h"
#include "WorstCriterion.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace
{
//------------------------------------------------------------------------------
// Undefined values become 0.
vtkSmartPointer<vtkDataArray> ToIntegers(vtkDoubleArray* values)
{
  const auto integers = camaron::MakeLargeArray<vtkIdTypeArray>(values->GetNumberOfValues());
  integers->SetName(values->GetName());
  const double* const from = values->GetPointer(0);
  std::transform(from, from + values->GetNumberOfValues(), integers->GetPointer(0),
    [](double value) { return std::isnan(value) ? 0 : static_cast<vtkIdType>(value); });
  return integers;
}
}

vtkStandardNewMacro(vtkElementQuality);

//------------------------------------------------------------------------------
vtkElementQuality::vtkElementQuality()
  : PresetNames(camaron::MakePresetNames(TickedCriteria()))
  , Known(std::make_unique<camaron::EvaluatedArrays>())
{
  const camaron::Preset* overview = camaron::FindPreset("Overview");
  for (const camaron::Criterion& criterion : camaron::GetCriteria())
  {
    const bool ticked = std::any_of(overview->Rules.begin(), overview->Rules.end(),
      [&](const auto& rule) { return rule.Criterion == std::string_view(criterion.Name); });
    this->Criteria->AddArray(criterion.Name, ticked);
  }
}

//------------------------------------------------------------------------------
vtkElementQuality::~vtkElementQuality() = default;

//------------------------------------------------------------------------------
void vtkElementQuality::SetPreset(const char* name)
{
  const std::string preset = name && name[0] ? name : TickedCriteria();
  if (this->Preset != preset)
  {
    this->Preset = preset;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkElementQuality::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Criteria->GetMTime());
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkElementQuality::GetChosenCriteria()
{
  std::vector<std::string> names;
  if (this->Preset == TickedCriteria())
  {
    for (int i = 0; i < this->Criteria->GetNumberOfArrays(); ++i)
    {
      if (this->Criteria->GetArraySetting(i))
      {
        names.emplace_back(this->Criteria->GetArrayName(i));
      }
    }
  }
  else if (const camaron::Preset* preset = camaron::FindPreset(this->Preset))
  {
    for (const auto& rule : preset->Rules)
    {
      names.emplace_back(rule.Criterion);
    }
  }
  return names;
}

//------------------------------------------------------------------------------
void vtkElementQuality::CountCorners()
{
  vtkDataObject* input =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr;
  vtkMTimeType time = 0;
  for (vtkDataSet* data : vtkCompositeDataSet::GetDataSets<vtkDataSet>(input))
  {
    time = std::max(time, data->GetMTime());
  }
  if (input == this->CountedInput && time == this->CountedTime)
  { // panels ask at every change of a property
    return;
  }
  this->CountedInput = input;
  this->CountedTime = time;
  this->NumberOfCorners = {};
  for (vtkDataSet* data : vtkCompositeDataSet::GetDataSets<vtkDataSet>(input))
  {
    const camaron::GroupCorners corners = camaron::CountCorners(data);
    std::transform(corners.begin(), corners.end(), this->NumberOfCorners.begin(),
      this->NumberOfCorners.begin(), std::plus<double>());
  }
}

//------------------------------------------------------------------------------
double vtkElementQuality::GetEstimatedSeconds()
{
  std::vector<const camaron::Criterion*> criteria;
  for (const std::string& name : this->GetChosenCriteria())
  {
    if (const camaron::Criterion* criterion = camaron::FindCriterion(name))
    {
      criteria.push_back(criterion);
    }
  }
  this->CountCorners();
  int threads = 1;
  camaron::WithThreads([&] { threads = vtkSMPTools::GetEstimatedNumberOfThreads(); });
  return camaron::EstimateSeconds(criteria, this->NumberOfCorners, threads);
}

//------------------------------------------------------------------------------
int vtkElementQuality::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  if (input)
  {
    camaron::MakeOutput(input->GetDataObjectType(), 0, outputVector);
  }
  return input != nullptr;
}

//------------------------------------------------------------------------------
bool vtkElementQuality::NeedsNeighbors()
{
  const auto names = this->GetChosenCriteria();
  return std::any_of(names.begin(), names.end(),
    [](const std::string& name)
    {
      const camaron::Criterion* criterion = camaron::FindCriterion(name);
      return criterion && criterion->Cost == camaron::Cost::Neighbors;
    });
}

//------------------------------------------------------------------------------
int vtkElementQuality::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->NeedsNeighbors())
  {
    RequestGhostCells(inputVector, outputVector);
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkElementQuality::FindCriteria(std::vector<const camaron::Criterion*>& criteria)
{
  if (this->Preset != TickedCriteria() && !camaron::FindPreset(this->Preset))
  {
    vtkErrorMacro("There is no preset named '" << this->Preset << "'.");
    return false;
  }
  for (const std::string& name : this->GetChosenCriteria())
  {
    criteria.push_back(camaron::FindCriterion(name));
    if (!criteria.back())
    {
      vtkErrorMacro("There is no criterion named '" << name << "'.");
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
camaron::EvaluationOptions vtkElementQuality::GetOptions(
  const std::vector<const camaron::Criterion*>& criteria) const
{
  camaron::EvaluationOptions options = this->GetEvaluationOptions();
  options.ChecksStarShape = (camaron::GetNeeds(criteria) & camaron::NeedsStarShape) != 0;
  return options;
}

//------------------------------------------------------------------------------
void vtkElementQuality::Evaluate(const std::vector<camaron::DataSetLeaf>& leaves,
  const camaron::EvaluationOptions& options, const std::vector<const camaron::Criterion*>& criteria,
  int numberOfPieces, ArraysOfCriteria& arrays)
{
  for (const camaron::Criterion* criterion : criteria)
  {
    arrays[criterion->Name]
      .clear(); // also without data sets, so that all processes know the same criteria
  }
  camaron::ControllerReducer reducer;
  camaron::DistributedMesh pieces(leaves, options, numberOfPieces, reducer);
  if (this->GetConnectBlocks())
  {
    pieces.ConnectBlocks();
  }
  const auto goOn = [&] { camaron::CheckAbortOnAllRanks(this, 0, reducer); };
  if (this->NeedsNeighbors())
  {
    goOn();
    pieces.Link();
  }
  pieces.FindFacts(camaron::GetNeeds(criteria), goOn);
  bool isFinished = true;
  camaron::RunCollectively(reducer,
    [&]
    {
      for (std::size_t piece = 0; piece < pieces.GetSize() && isFinished; ++piece)
      {
        const camaron::MeshTopology& topology = pieces.GetTopology(piece);
        std::vector<camaron::CriterionValues> rows;
        for (const camaron::Criterion* criterion : criteria)
        {
          const auto array =
            camaron::MakeLargeArray<vtkDoubleArray>(topology.GetMesh().GetNumberOfCells());
          array->SetName(criterion->Name);
          camaron::SetUnitLabel(array, criterion->UnitLabel(options.Angles).c_str());
          rows.push_back({ criterion, array->GetPointer(0) });
          arrays[criterion->Name].push_back(array);
        }
        isFinished = camaron::Evaluate(topology, pieces.GetOptions(piece), rows,
          [&](double done)
          {
            this->UpdateProgress(
              (static_cast<double>(piece) + done) / static_cast<double>(pieces.GetSize()));
            return !this->CheckAbort();
          });
      }
    });
  camaron::CheckAbortOnAllRanks(this, 1, reducer, isFinished);
}

//------------------------------------------------------------------------------
void vtkElementQuality::AddArrays(const std::vector<camaron::DataSetLeaf>& leaves,
  const std::vector<const camaron::Criterion*>& criteria, const ArraysOfCriteria& arrays,
  const camaron::EvaluationOptions& options)
{
  camaron::ControllerReducer reducer;
  const camaron::AcceptableRanges ranges(
    this->Preset == TickedCriteria() ? camaron::GetDefaultRangesName() : this->Preset, "", reducer);
  const camaron::Criterion* const worst =
    camaron::FindWorstCriterion(criteria, arrays, leaves, ranges, options.Angles, reducer);
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
  {
    vtkCellData* const data = leaves[leaf].Data->GetCellData();
    for (const camaron::Criterion* criterion : criteria)
    {
      vtkDoubleArray* const array = arrays.at(criterion->Name)[leaf];
      data->AddArray(criterion->Kind == camaron::ValueKind::Code ? ToIntegers(array) : array);
      if (this->WriteUndefinedMask)
      {
        data->AddArray(camaron::MakeUndefinedMask(array, leaves[leaf].Data));
      }
    }
    if (worst)
    {
      data->SetActiveScalars(worst->Name);
    }
  }
}

//------------------------------------------------------------------------------
void vtkElementQuality::EvaluateMesh(vtkDataObject* input, vtkDataObject* output,
  const std::vector<const camaron::Criterion*>& criteria, int numberOfPieces)
{
  const camaron::EvaluationOptions options = this->GetOptions(criteria);
  camaron::ControllerReducer reducer;
  camaron::CheckAbortOnAllRanks(this, 0, reducer);
  this->Known->Check(
    camaron::GetMeshes(input, reducer), options, this->GetConnectBlocks(), numberOfPieces, reducer);
  ArraysOfCriteria arrays;
  std::vector<const camaron::Criterion*> missing;
  for (const camaron::Criterion* criterion : criteria)
  {
    if (const auto* known = this->Known->Find(criterion->Name))
    {
      arrays[criterion->Name] = *known;
    }
    else
    {
      missing.push_back(criterion);
    }
  }
  const std::vector<camaron::DataSetLeaf> leaves = camaron::GetOutputLeaves(output);
  for (const camaron::DataSetLeaf& leaf : leaves)
  {
    const vtkSmartPointer<vtkDataSet> mesh =
      camaron::WithoutStrips(camaron::WithGhostBytes(leaf.Data));
    if (mesh != leaf.Data)
    {
      leaf.Data->ShallowCopy(mesh);
    }
  }
  if (!missing.empty())
  {
    this->Evaluate(leaves, options, missing, numberOfPieces, arrays);
  }
  this->AddArrays(leaves, criteria, arrays, options);
  this->Known->Keep(std::move(arrays));
}

//------------------------------------------------------------------------------
int vtkElementQuality::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  std::vector<const camaron::Criterion*> criteria;
  if (!this->FindCriteria(criteria))
  {
    return 0;
  }
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  output->ShallowCopy(input);
  try
  {
    this->EvaluateMesh(input, output, criteria, camaron::GetNumberOfPieces(outputVector));
  }
  catch (...)
  {
    this->Known->Clear();
    return camaron::FailRequest(this, "The mesh cannot be evaluated", outputVector);
  }
  return 1;
}
