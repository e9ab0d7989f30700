// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkInspectionMesh
 * @brief Makes one unstructured grid of whatever a Mesh Inspection is to show.
 *
 * Input: a vtkDataSet or a composite of them. Output: vtkUnstructuredGrid with the same cells and arrays; a
 * grid, and a surface of polygons alone, are passed without a copy. When ids could get lost on the way to
 * the screen, because there are blocks or several processes, the output has the arrays of ids that
 * vtkMeshInspectionMapper picks by.
 */
#ifndef vtkInspectionMesh_h
#define vtkInspectionMesh_h

#include "vtkUnstructuredGridAlgorithm.h"

class vtkInspectionMesh : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkInspectionMesh* New();
  vtkTypeMacro(vtkInspectionMesh, vtkUnstructuredGridAlgorithm);

protected:
  vtkInspectionMesh() = default;
  ~vtkInspectionMesh() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInspectionMesh(const vtkInspectionMesh&) = delete;
  void operator=(const vtkInspectionMesh&) = delete;
};

#endif
