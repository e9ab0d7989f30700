// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshMatrices.h"

#include "vtkCamera.h"
#include "vtkProp3D.h"
#include "vtkRenderer.h"

namespace camaron
{
//------------------------------------------------------------------------------
MeshMatrices::MeshMatrices(
  vtkRenderer* renderer, vtkProp3D* actor, const std::array<double, 3>& middle)
{
  vtkNew<vtkMatrix4x4> shift;
  for (int i = 0; i < 3; ++i)
  {
    shift->SetElement(i, 3, middle[i]);
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkMatrix4x4::Multiply4x4(actor->GetMatrix(), shift, this->ToView);
  vtkMatrix4x4::Multiply4x4(camera->GetModelViewTransformMatrix(), this->ToView, this->ToView);
  vtkMatrix4x4::Multiply4x4(
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1), this->ToView,
    this->ToDisplay);
}
}
