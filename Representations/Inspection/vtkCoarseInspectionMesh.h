// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCoarseInspectionMesh
 * @brief Reduces the mesh for Mesh Inspection while the camera moves.
 *
 * CoarseMesh.h describes which cells remain. Cells and points have all arrays of the elements that
 * they represent, so everything that is drawn for the mesh can be drawn for the coarse mesh.
 */
#ifndef vtkCoarseInspectionMesh_h
#define vtkCoarseInspectionMesh_h

#include "vtkUnstructuredGridAlgorithm.h"

class vtkCoarseInspectionMesh : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkCoarseInspectionMesh* New();
  vtkTypeMacro(vtkCoarseInspectionMesh, vtkUnstructuredGridAlgorithm);

  /// From 0 (coarsest) to 1: ParaView's LOD Resolution. Default: 0.5.
  vtkSetClampMacro(Resolution, double, 0, 1);

  /// Output only the edges of the bounds, no cells. Default: off.
  vtkSetMacro(OutlineOnly, bool);

  /// Bounds of all blocks and processes. Default: 1, -1, ..., which means those of the input.
  vtkSetVector6Macro(WholeBounds, double);

protected:
  vtkCoarseInspectionMesh() = default;
  ~vtkCoarseInspectionMesh() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCoarseInspectionMesh(const vtkCoarseInspectionMesh&) = delete;
  void operator=(const vtkCoarseInspectionMesh&) = delete;

  double Resolution = 0.5;
  bool OutlineOnly = false;
  double WholeBounds[6] = { 1, -1, 1, -1, 1, -1 };
};

#endif
