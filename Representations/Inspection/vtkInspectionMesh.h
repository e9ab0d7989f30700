// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkInspectionMesh
 * @brief Makes unstructured grids of whatever a Mesh Inspection is to show.
 *
 * Input: a vtkDataSet or a composite of them. Output: vtkUnstructuredGrid with the same cells and
 * arrays, or the tree of the input with such blocks; a grid, and a surface of polygons alone, are
 * passed without a copy. A vtkPartitionedDataSet becomes the only one of a collection, composites
 * that are no trees a vtkMultiBlockDataSet. When ids could get lost on the way to the screen,
 * because there are blocks or several processes, the grids have the arrays of ids that
 * vtkMeshInspectionMapper picks by. Blocks also have the arrays that ParaView tells them apart by:
 * vtkCompositeIndex and vtkBlockColors. With several processes, which may exchange cells before
 * they draw, cells also know which of their faces are on the outside.
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

  /// The number of colors of blocks: vtkBlockColors is the number of the block modulo this. 7.
  vtkSetClampMacro(BlockColorsDistinctValues, int, 1, VTK_INT_MAX);
  vtkGetMacro(BlockColorsDistinctValues, int);

protected:
  vtkInspectionMesh() = default;
  ~vtkInspectionMesh() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  /// Of every data set, in the order of leaves; none if one process has no more than one piece of
  /// each block.
  std::vector<vtkSmartPointer<vtkDataArray>> FindOuterFacets(
    const std::vector<camaron::DataSetLeaf>& leaves);

  void ReportFaults(const std::vector<camaron::DataSetLeaf>& leaves);
  void MarkBlock(vtkUnstructuredGrid* grid, unsigned int flatIndex, int number);

  int BlockColorsDistinctValues = 7;

  vtkInspectionMesh(const vtkInspectionMesh&) = delete;
  void operator=(const vtkInspectionMesh&) = delete;
};

#endif
