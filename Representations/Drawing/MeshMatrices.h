// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshMatrices.h
 * @brief Where the coordinates of an InspectionMesh, which are relative to its middle, are in a
 * picture.
 */
#ifndef camaron_MeshMatrices_h
#define camaron_MeshMatrices_h

#include "vtkNew.h" // for the matrices

#include <array> // for the middle

class vtkMatrix4x4;
class vtkProp3D;
class vtkRenderer;

namespace camaron
{
struct MeshMatrices
{
  /// Of the camera of the renderer and the actor of the mesh; in double, with the middle put back.
  MeshMatrices(vtkRenderer* renderer, vtkProp3D* actor, const std::array<double, 3>& middle);
  ~MeshMatrices();

  vtkNew<vtkMatrix4x4> ToView;    ///< the coordinates of the camera
  vtkNew<vtkMatrix4x4> ToDisplay; ///< those of OpenGL, where x, y, z are from -w to w
};
}

#endif
