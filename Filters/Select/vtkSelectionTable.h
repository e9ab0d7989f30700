// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSelectionTable
 * @brief Lists the selected elements of a mesh.
 *
 * Input: the output of vtkSelectElements, or any vtkDataSet or composite data set with a cell or
 * point array `Selected`. Output: a vtkTable with one row per selected element of this process and
 * the columns `Id` (the global id if all elements have one, else the index, see
 * camaron::ElementBlocks), `Block`, `CellType` ("Point" for points), `X`, `Y`, `Z` (the mean of the
 * points of the cell), and all arrays of the elements. Ghosts are skipped. With SortBy, process 0
 * has all rows, sorted, without columns that have no value.
 */
#ifndef vtkSelectionTable_h
#define vtkSelectionTable_h

#include "vtkTableAlgorithm.h"

#include <string> // for the name of an array

class vtkSelectionTable : public vtkTableAlgorithm
{
public:
  static vtkSelectionTable* New();
  vtkTypeMacro(vtkSelectionTable, vtkTableAlgorithm);

  /// Array of one component by which the rows are sorted, undefined values last; its column follows
  /// the location. More than a million rows stay in the order of the elements. Default: empty, none
  /// are sorted.
  vtkSetStdStringFromCharMacro(SortBy);

  /// Whether large values come first. Default: false.
  vtkSetMacro(Descending, bool);

protected:
  vtkSelectionTable() = default;
  ~vtkSelectionTable() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSelectionTable(const vtkSelectionTable&) = delete;
  void operator=(const vtkSelectionTable&) = delete;

  std::string SortBy;
  bool Descending = false;
};

#endif
