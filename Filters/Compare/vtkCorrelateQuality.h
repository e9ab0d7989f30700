// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCorrelateQuality
 * @brief Correlates the quality of cells with a field, such as an error or the change of a
 * solution.
 *
 * Input: any vtkDataSet or composite data set with cell arrays, and the field, a cell or point
 * array chosen with SetInputArrayToProcess(0, ...). Fields with several components contribute their
 * magnitude, and point fields the mean of the values at the points of each cell. By default the
 * filter evaluates every cell array that is named like a quality criterion; see AddArray(). Ghost
 * cells are ignored.
 *
 * Outputs:
 * 0. vtkTable with one row per array and group: Pearson's and Spearman's correlation with the
 *    field, and how the field differs in cells outside the acceptable range;
 *    Documentation/correlation.md lists the columns
 * 1. the mesh with the field as the cell array "<field>_Cells"
 *
 * Parallel: the table is complete on process 0. Every number is the same, to the last bit, for any
 * number of threads and processes. No process gathers all values: each ranks a range of them.
 */
#ifndef vtkCorrelateQuality_h
#define vtkCorrelateQuality_h

#include "vtkQualityTables.h"

class vtkCorrelateQuality : public vtkQualityTables
{
public:
  static vtkCorrelateQuality* New();
  vtkTypeMacro(vtkCorrelateQuality, vtkQualityTables);

protected:
  vtkCorrelateQuality();
  ~vtkCorrelateQuality() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void MakeColumns(vtkInformationVector* outputVector) override;
  void AddRows(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  const char* GetFailure() const override { return "The correlation cannot be computed"; }

private:
  vtkCorrelateQuality(const vtkCorrelateQuality&) = delete;
  void operator=(const vtkCorrelateQuality&) = delete;
};

#endif
