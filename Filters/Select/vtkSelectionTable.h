// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSelectionTable
 * @brief Lists the selected elements of a mesh.
 *
 * Input: what vtkSelectElements leaves, any vtkDataSet or composite of them with the array
 * `Selected` of its cells or its points. Output: a vtkTable with a row for every selected element
 * of this process and the columns `Id` (the global id if all elements have one, else the index, see
 * camaron::ElementBlocks), `Block`, `CellType` ("Point" for points), the mean of the points of the
 * cell as `X`, `Y`, `Z`, and all arrays of the elements. Ghosts are left out.
 */
#ifndef vtkSelectionTable_h
#define vtkSelectionTable_h

#include "vtkTableAlgorithm.h"

class vtkSelectionTable : public vtkTableAlgorithm
{
public:
  static vtkSelectionTable* New();
  vtkTypeMacro(vtkSelectionTable, vtkTableAlgorithm);

protected:
  vtkSelectionTable();
  ~vtkSelectionTable() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSelectionTable(const vtkSelectionTable&) = delete;
  void operator=(const vtkSelectionTable&) = delete;
};

#endif
