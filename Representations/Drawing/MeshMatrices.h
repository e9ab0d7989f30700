// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshMatrices.h
 * @brief Transforms from the coordinates of an InspectionMesh, which are relative to its middle, to
 * those of a view.
 */
#ifndef camaron_MeshMatrices_h
#define camaron_MeshMatrices_h

#include "vtkMatrix4x4.h" // for the matrices
#include "vtkNew.h"       // for the matrices

#include <array> // for the middle

class vtkProp3D;
class vtkRenderer;

namespace camaron
{
struct MeshMatrices
{
  /// For the camera of the renderer and the actor of the mesh, computed in double precision
  /// including the middle.
  MeshMatrices(vtkRenderer* renderer, vtkProp3D* actor, const std::array<double, 3>& middle);

  vtkNew<vtkMatrix4x4> ToView;    ///< to coordinates of the camera
  vtkNew<vtkMatrix4x4> ToDisplay; ///< to clip coordinates of OpenGL, where x, y, z are from -w to w
};
}

#endif
