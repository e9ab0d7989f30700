// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkInspectionMesh
 * @brief Converts any input of Mesh Inspection to unstructured grids.
 *
 * Input: a vtkDataSet or composite data set. Output: a vtkUnstructuredGrid with the same cells and
 * arrays, or the tree of the input with such blocks. Unstructured grids, and surfaces that only
 * have polygons, share their memory with the input. A vtkPartitionedDataSet becomes the only one of
 * a collection; composite data sets that are not trees become a vtkMultiBlockDataSet.
 *
 * If there are blocks or several processes, ids could get lost before rendering. Then the grids
 * have the arrays of ids that vtkMeshInspectionMapper uses for picking. Blocks also have the arrays
 * by which ParaView distinguishes them: vtkCompositeIndex and vtkBlockColors. With several
 * processes, which may exchange cells before rendering, cells also store which of their faces are
 * outer faces.
 */
#ifndef vtkInspectionMesh_h
#define vtkInspectionMesh_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkSmartPointer.h" // for arrays

#include <vector> // for lists

class vtkDataArray;
class vtkUnstructuredGrid;

namespace camaron
{
struct DataSetLeaf;
}

class vtkInspectionMesh : public vtkDataObjectAlgorithm
{
public:
  static vtkInspectionMesh* New();
  vtkTypeMacro(vtkInspectionMesh, vtkDataObjectAlgorithm);

  /// Number of block colors: vtkBlockColors is the block number modulo this. Default: 7.
  vtkSetClampMacro(BlockColorsDistinctValues, int, 1, VTK_INT_MAX);

protected:
  vtkInspectionMesh() = default;
  ~vtkInspectionMesh() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  /// One array per data set, in the order of leaves; none if each process has at most one piece of
  /// each block.
  std::vector<vtkSmartPointer<vtkDataArray>> FindOuterFacets(
    const std::vector<camaron::DataSetLeaf>& leaves);

  /// The data sets that can be drawn; errors report the others.
  std::vector<camaron::DataSetLeaf> FindDrawable(const std::vector<camaron::DataSetLeaf>& leaves);
  void MarkBlock(vtkUnstructuredGrid* grid, unsigned int flatIndex, int number);

  int BlockColorsDistinctValues = 7;

  vtkInspectionMesh(const vtkInspectionMesh&) = delete;
  void operator=(const vtkInspectionMesh&) = delete;
};

#endif
