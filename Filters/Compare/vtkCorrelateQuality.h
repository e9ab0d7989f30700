// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCorrelateQuality
 * @brief Tells how the quality of cells goes together with a field, such as an error or the change
 * of a solution.
 *
 * Input: any vtkDataSet or composite of them with cell arrays, and the field, an array of cells or
 * points chosen by SetInputArrayToProcess(0, ...). A field of points becomes one of cells, see
 * camaron::CellField. By default every cell array that is named like a quality criterion is
 * evaluated, see AddArray(). Ghost cells do not count.
 *
 * Outputs:
 * 0. vtkTable, one row per array and group: Pearson's and Spearman's correlation with the field,
 * and how the field is in the cells outside of the acceptable range; the columns are listed in
 * Documentation/correlation.md;
 * 1. the mesh with the field as the cell array "<field>_Cells" or "<field>_Gradient".
 *
 * Parallel: the table is complete on process 0. Every number is the same, bit for bit, for any
 * number of threads and processes. For ranks each process takes over a range of the values; none
 * gets all.
 */
#ifndef vtkCorrelateQuality_h
#define vtkCorrelateQuality_h

#include "vtkQualityTables.h"

class vtkCorrelateQuality : public vtkQualityTables
{
public:
  static vtkCorrelateQuality* New();
  vtkTypeMacro(vtkCorrelateQuality, vtkQualityTables);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Whether the length of the field's gradient takes the place of the field. Of fields of points
  /// only. Default: off.
  vtkSetMacro(Gradient, bool);
  vtkGetMacro(Gradient, bool);
  vtkBooleanMacro(Gradient, bool);
  ///@}

protected:
  vtkCorrelateQuality();
  ~vtkCorrelateQuality() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void MakeColumns(vtkInformationVector* outputVector) override;
  void AddRows(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  const char* GetFailure() const override { return "The correlation cannot be computed"; }

private:
  vtkCorrelateQuality(const vtkCorrelateQuality&) = delete;
  void operator=(const vtkCorrelateQuality&) = delete;

  bool Gradient = false;
};

#endif
