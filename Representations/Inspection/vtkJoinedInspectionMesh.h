// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkJoinedInspectionMesh
 * @brief Joins the blocks of an inspection mesh to one grid, whose cells ParaView can exchange
 * between processes, and provides samples of the blocks, which determine how each block looks.
 *
 * Input: the output of vtkInspectionMesh.
 *
 * Output 0: a vtkUnstructuredGrid. It has all arrays that any block has on any process. Blocks
 * without an array get NaN, 0 in byte arrays, which may be colors or ghosts, and empty text. The
 * cell array LeavesName is the number of the sample of the cell's block.
 *
 * Output 1: the tree of the input, the same on all processes, with a sample of each piece of a
 * block, numbered in the order of FindBlocks (InspectionBlocks.h). A sample is a vertex with the
 * arrays of the piece, with one value each, and the first value of its field data. Pieces with the
 * same number on several processes share a sample. Without blocks this is an empty grid.
 */
#ifndef vtkJoinedInspectionMesh_h
#define vtkJoinedInspectionMesh_h

#include "vtkDataObjectAlgorithm.h"

class vtkJoinedInspectionMesh : public vtkDataObjectAlgorithm
{
public:
  static vtkJoinedInspectionMesh* New();
  vtkTypeMacro(vtkJoinedInspectionMesh, vtkDataObjectAlgorithm);

protected:
  vtkJoinedInspectionMesh();
  ~vtkJoinedInspectionMesh() override = default;

  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkJoinedInspectionMesh(const vtkJoinedInspectionMesh&) = delete;
  void operator=(const vtkJoinedInspectionMesh&) = delete;
};

#endif
