// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkElementQuality.h"

#include "Criteria/CostEstimate.h"
#include "Criteria/Evaluation.h"
#include "MeshInput.h"
#include "Parallel.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArraySelection.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <exception>

vtkStandardNewMacro(vtkElementQuality);

namespace
{
constexpr vtkIdType Grain = 65536;

//------------------------------------------------------------------------------
// Length of the lists of points of all cells.
double CountCorners(vtkDataSet* data)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return static_cast<double>(grid->GetCells()->GetNumberOfConnectivityIds());
  }
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    return static_cast<double>(surface->GetPolys()->GetNumberOfConnectivityIds() +
      surface->GetStrips()->GetNumberOfConnectivityIds());
  }
  constexpr double ofBox = 8;
  return ofBox * static_cast<double>(data->GetNumberOfCells());
}

//------------------------------------------------------------------------------
// Why each value is null, read from the values.
vtkSmartPointer<vtkUnsignedCharArray> MakeNullMask(
  vtkDoubleArray* values, const camaron::MeshView& mesh)
{
  auto mask = vtkSmartPointer<vtkUnsignedCharArray>::New();
  mask->SetName((std::string(values->GetName()) + "_Null").c_str());
  mask->SetNumberOfValues(values->GetNumberOfValues());
  const double* from = values->GetPointer(0);
  unsigned char* to = mask->GetPointer(0);
  camaron::ParallelFor(values->GetNumberOfValues(), Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        camaron::NullReason reason = camaron::GetNullReason(from[cell]);
        if (reason == camaron::NullReason::Value &&
          camaron::GetCellShape(mesh.GetCellType(cell)).IsHigherOrder)
        {
          reason = camaron::NullReason::HigherOrder;
        }
        to[cell] = static_cast<unsigned char>(reason);
      }
    });
  return mask;
}
}

//------------------------------------------------------------------------------
vtkElementQuality::vtkElementQuality()
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
void vtkElementQuality::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Criteria:\n";
  this->Criteria->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Preset: " << this->Preset << '\n';
  os << indent << "AngleUnits: " << (this->AngleUnits == DEGREES ? "degrees" : "radians") << '\n';
  os << indent << "WriteNullMask: " << this->WriteNullMask << '\n';
  os << indent << "TrustFaceOrientation: " << this->TrustFaceOrientation << '\n';
  os << indent << "DegeneracyTolerance: " << this->DegeneracyTolerance << '\n';
  os << indent << "ConvexityTolerance: " << this->ConvexityTolerance << '\n';
  os << indent << "PlanarityTolerance: " << this->PlanarityTolerance << '\n';
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkElementQuality::GetCriteria()
{
  return this->Criteria;
}

//------------------------------------------------------------------------------
void vtkElementQuality::ClearCriteria()
{
  this->Criteria->DisableAllArrays();
}

//------------------------------------------------------------------------------
void vtkElementQuality::SetCriterionStatus(const char* name, int status)
{
  this->Criteria->SetArraySetting(name, status);
}

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
double vtkElementQuality::GetNumberOfCorners()
{
  vtkDataObject* input =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr;
  double corners = 0;
  for (vtkDataSet* data : vtkCompositeDataSet::GetDataSets<vtkDataSet>(input))
  {
    corners += CountCorners(data);
  }
  return corners;
}

//------------------------------------------------------------------------------
int vtkElementQuality::GetNumberOfThreads()
{
  int threads = 1;
  camaron::WithThreads([&] { threads = vtkSMPTools::GetEstimatedNumberOfThreads(); });
  return threads;
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
  return camaron::EstimateSeconds(
    criteria, this->GetNumberOfCorners(), this->GetNumberOfThreads());
}

//------------------------------------------------------------------------------
int vtkElementQuality::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkInformation* inInfo = inputVector[0]->GetInformationObject(0);
  const auto names = this->GetChosenCriteria();
  const bool neighbors = std::any_of(names.begin(), names.end(),
    [](const std::string& name)
    {
      const camaron::Criterion* criterion = camaron::FindCriterion(name);
      return criterion && criterion->Cost == camaron::Cost::Neighbors;
    });
  if (neighbors && outInfo->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1)
  {
    inInfo->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      std::max(1, outInfo->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS())));
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkElementQuality::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* input = vtkDataSet::GetData(inputVector[0]);
  vtkDataSet* output = vtkDataSet::GetData(outputVector);
  if (this->Preset != TickedCriteria() && !camaron::FindPreset(this->Preset))
  {
    vtkErrorMacro("There is no preset named '" << this->Preset << "'.");
    return 0;
  }
  std::vector<camaron::CriterionValues> rows;
  std::vector<vtkSmartPointer<vtkDoubleArray>> arrays;
  camaron::EvaluationOptions options;
  options.Angles =
    this->AngleUnits == DEGREES ? camaron::AngleUnit::Degrees : camaron::AngleUnit::Radians;
  options.TrustFaceOrientation = this->TrustFaceOrientation;
  options.DegeneracyTolerance = this->DegeneracyTolerance;
  options.ConvexityTolerance = this->ConvexityTolerance;
  options.PlanarityTolerance = this->PlanarityTolerance;
  try
  {
    const vtkSmartPointer<vtkDataSet> triangulated = camaron::WithoutStrips(input);
    output->ShallowCopy(triangulated);
    if (vtkUnsignedCharArray* ghosts = triangulated->GetCellGhostArray())
    {
      options.Ghosts = ghosts->GetPointer(0);
    }
    options.GlobalIds = triangulated->GetCellData()->GetGlobalIds();
    const camaron::MeshTopology topology(camaron::AsMesh(triangulated));
    for (const std::string& name : this->GetChosenCriteria())
    {
      const camaron::Criterion* criterion = camaron::FindCriterion(name);
      if (!criterion)
      {
        vtkErrorMacro("There is no criterion named '" << name << "'.");
        output->Initialize();
        return 0;
      }
      arrays.push_back(vtkSmartPointer<vtkDoubleArray>::New());
      arrays.back()->SetName(criterion->Name);
      arrays.back()->SetNumberOfValues(topology.GetMesh().GetNumberOfCells());
      arrays.back()->GetInformation()->Set(
        vtkDataArray::UNITS_LABEL(), criterion->UnitLabel(options.Angles));
      rows.push_back({ criterion, arrays.back()->GetPointer(0) });
    }
    const bool finished = camaron::Evaluate(topology, options, rows,
      [this](double done)
      {
        this->UpdateProgress(done);
        return !this->CheckAbort();
      });
    if (!finished)
    {
      return 1;
    }
    for (vtkDoubleArray* array : arrays)
    {
      output->GetCellData()->AddArray(array);
      if (this->WriteNullMask)
      {
        output->GetCellData()->AddArray(MakeNullMask(array, topology.GetMesh()));
      }
    }
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("The mesh cannot be evaluated: " << error.what() << '.');
    output->Initialize();
    return 0;
  }
  if (!arrays.empty())
  {
    output->GetCellData()->SetActiveScalars(arrays[0]->GetName());
  }
  return 1;
}
