// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkJoinedInspectionMesh
 * @brief The blocks of an inspection mesh as one grid, whose cells ParaView can exchange between
 * processes, and samples of them, by which it is known what each block is to look like.
 *
 * Input: what vtkInspectionMesh makes.
 *
 * Output 0: a vtkUnstructuredGrid. Joined blocks have all arrays that any block has in any process.
 * Where a block lacks one it has NaN, 0 in arrays of bytes, which may be colors or ghosts, and no
 * text. The cell array LeavesName has the number of the sample that a cell's block has.
 *
 * Output 1: the tree of the input, the same in all processes, with a sample of each piece of a
 * block, numbered in the order of FindBlocks (InspectionBlocks.h): a vertex with the arrays of the
 * piece, of one value, and the first value of its field data. Pieces with the same number in
 * several processes have one sample. Where there are no blocks this is an empty grid.
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
