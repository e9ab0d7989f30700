// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCorrelateQuality
 * @brief Tells how the quality of cells goes together with a field, such as an error or the change of a solution.
 *
 * Input: any vtkDataSet or composite of them with cell arrays, and the field, an array of cells or points chosen by
 * SetInputArrayToProcess(0, ...). A field of points becomes one of cells, see camaron::CellField. By default every cell
 * array that is named like a quality criterion is evaluated, see AddArray(). Ghost cells do not count.
 *
 * Outputs:
 * 0. vtkTable, one row per array: Pearson's and Spearman's correlation with the field, and how the field is in the
 *    cells outside of the acceptable range; the columns are listed in Documentation/correlation.md;
 * 1. the mesh with the field as the cell array "<field>_Cells" or "<field>_Gradient".
 *
 * Parallel: the table is complete on process 0. Every number is the same, bit for bit, for any number of threads and
 * processes. For ranks each process takes over a range of the values; none gets all.
 */
#ifndef vtkCorrelateQuality_h
#define vtkCorrelateQuality_h

#include "vtkDataObjectAlgorithm.h"

#include <string> // for choices
#include <vector> // for lists

class vtkCorrelateQuality : public vtkDataObjectAlgorithm
{
public:
  static vtkCorrelateQuality* New();
  vtkTypeMacro(vtkCorrelateQuality, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Cell arrays with one component to evaluate. Default: none, which means every one that is named like a criterion.
  void AddArray(const char* name);
  void ClearArrays();
  ///@}

  ///@{
  /// Whether the length of the field's gradient takes the place of the field. Of fields of points only. Default: off.
  vtkSetMacro(Gradient, bool);
  vtkGetMacro(Gradient, bool);
  vtkBooleanMacro(Gradient, bool);
  ///@}

  ///@{
  /// Whose acceptable ranges to count by, as in vtkQualityStatistics. Default: "Default ranges".
  void SetPreset(const char* name) { this->SetText(this->Preset, name); }
  const char* GetPreset() const { return this->Preset.c_str(); }
  ///@}

  ///@{
  /// File of acceptable ranges of the user, which come before those of the preset. Default: empty, none.
  void SetRangesFile(const char* path) { this->SetText(this->RangesFile, path); }
  const char* GetRangesFile() const { return this->RangesFile.c_str(); }
  ///@}

protected:
  vtkCorrelateQuality();
  ~vtkCorrelateQuality() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCorrelateQuality(const vtkCorrelateQuality&) = delete;
  void operator=(const vtkCorrelateQuality&) = delete;

  void SetText(std::string& member, const char* text);
  void Correlate(vtkDataObject* input, vtkInformationVector* outputVector);

  std::vector<std::string> Arrays;
  bool Gradient = false;
  std::string Preset;
  std::string RangesFile;
};

#endif
