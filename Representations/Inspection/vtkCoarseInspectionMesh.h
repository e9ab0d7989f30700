// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCoarseInspectionMesh
 * @brief What a Mesh Inspection draws while the camera moves: the mesh with fewer cells.
 *
 * See CoarseMesh.h for which cells are left. Cells and points have all arrays of those that they
 * stand for, so that whatever is drawn of the mesh can be drawn of this, too.
 */
#ifndef vtkCoarseInspectionMesh_h
#define vtkCoarseInspectionMesh_h

#include "vtkUnstructuredGridAlgorithm.h"

class vtkCoarseInspectionMesh : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkCoarseInspectionMesh* New();
  vtkTypeMacro(vtkCoarseInspectionMesh, vtkUnstructuredGridAlgorithm);

  /// From 0, coarsest, to 1: ParaView's LOD Resolution. 0.5.
  vtkSetClampMacro(Resolution, double, 0, 1);
  vtkGetMacro(Resolution, double);

  /// No cells at all but the edges of the bounds. Off.
  vtkSetMacro(OutlineOnly, bool);
  vtkGetMacro(OutlineOnly, bool);

  /// Of all blocks and processes; 1, -1, ...: those of the input.
  vtkSetVector6Macro(WholeBounds, double);
  vtkGetVector6Macro(WholeBounds, double);

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
