// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshMatrices.h
 * @brief Transforms from the coordinates of an InspectionMesh, which are relative to its middle, to
 * those of a view.
 */
#ifndef camaron_MeshMatrices_h
#define camaron_MeshMatrices_h

#include "vtkCamera.h"    // for the matrices
#include "vtkMatrix4x4.h" // for the matrices
#include "vtkNew.h"       // for the matrices
#include "vtkProp3D.h"    // for the matrices
#include "vtkRenderer.h"  // for the camera

#include <array> // for the middle

namespace camaron
{
struct MeshMatrices
{
  /// For the camera of the renderer and the actor of the mesh, computed in double precision
  /// including the middle.
  MeshMatrices(vtkRenderer* renderer, vtkProp3D* actor, const std::array<double, 3>& middle)
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

  vtkNew<vtkMatrix4x4> ToView;    ///< to coordinates of the camera
  vtkNew<vtkMatrix4x4> ToDisplay; ///< to clip coordinates of OpenGL, where x, y, z are from -w to w
};
}

#endif
