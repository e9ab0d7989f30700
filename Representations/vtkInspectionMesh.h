// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkInspectionMesh
 * @brief Makes one unstructured grid of whatever a Mesh Inspection is to show.
 *
 * Input: a vtkDataSet or a composite of them. Output: vtkUnstructuredGrid with the same cells and arrays; a
 * grid, and a surface of polygons alone, are passed without a copy. When ids could get lost on the way to
 * the screen, because there are blocks or several processes, the output has the arrays of ids that
 * vtkMeshInspectionMapper picks by. With several processes, which may exchange cells before they draw, cells
 * also know which of their faces are on the outside.
 */
#ifndef vtkInspectionMesh_h
#define vtkInspectionMesh_h

#include "vtkSmartPointer.h" // for arrays
#include "vtkUnstructuredGridAlgorithm.h"

#include <vector> // for lists

class vtkDataArray;

namespace camaron
{
struct DataSetLeaf;
}

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
  /// Of every data set, in the order of leaves; none with one process.
  std::vector<vtkSmartPointer<vtkDataArray>> FindOuterFacets(
    const std::vector<camaron::DataSetLeaf>& leaves);

  vtkInspectionMesh(const vtkInspectionMesh&) = delete;
  void operator=(const vtkInspectionMesh&) = delete;
};

#endif
