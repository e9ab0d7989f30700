// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkQualityAlgorithm.h"

#include "ControllerReducer.h"
#include "Criteria/Evaluation.h"
#include "MeshOutputs.h"
#include "PropertyValues.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

//------------------------------------------------------------------------------
void vtkQualityAlgorithm::SetEvaluationOptions(const vtkQualityAlgorithm* other)
{
  this->SetTrustFaceOrientation(other->TrustFaceOrientation);
  this->SetDegeneracyTolerance(other->DegeneracyTolerance);
  this->SetConvexityTolerance(other->ConvexityTolerance);
  this->SetPlanarityTolerance(other->PlanarityTolerance);
  this->SetConnectBlocks(other->ConnectBlocks);
}

//------------------------------------------------------------------------------
int vtkQualityAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
camaron::EvaluationOptions vtkQualityAlgorithm::GetEvaluationOptions() const
{
  camaron::CheckNumber("Degeneracy Tolerance", this->DegeneracyTolerance, 0.0, 1.0);
  camaron::CheckNumber("Convexity Tolerance", this->ConvexityTolerance, 0.0, 180.0);
  camaron::CheckNumber("Planarity Tolerance", this->PlanarityTolerance, 0.0, 1.0);
  camaron::EvaluationOptions options;
  options.TrustFaceOrientation = this->TrustFaceOrientation;
  options.DegeneracyTolerance = this->DegeneracyTolerance;
  options.ConvexityTolerance = this->ConvexityTolerance;
  options.PlanarityTolerance = this->PlanarityTolerance;
  options.Angles =
    this->AngleUnits == DEGREES ? camaron::AngleUnit::Degrees : camaron::AngleUnit::Radians;
  return options;
}

//------------------------------------------------------------------------------
void vtkQualityAlgorithm::RequestGhostCells(
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (camaron::GetNumberOfPieces(outputs) > camaron::ControllerReducer().GetNumberOfProcesses())
  {
    const int wanted =
      outputs->GetInformationObject(0)->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
    inputs[0]->GetInformationObject(0)->Set(
      Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), std::max(1, wanted));
  }
}
