// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCompareQuality
 * @brief Compares the quality of two meshes, or of one before and after.
 *
 * Inputs: port 0 mesh A, port 1 mesh B, each any vtkDataSet or composite of them with cell arrays. By default every cell
 * array that both have and that is named like a quality criterion is compared, see AddArray(). Ghost cells, null and
 * infinite values count as in vtkQualityStatistics.
 *
 * Outputs:
 * 0. vtkTable, one row per array: statistics of A and B and their differences B - A; the distance of the distributions
 *    (Kolmogorov and Smirnov); if the meshes have the same cells, how many have improved and worsened;
 * 1. vtkTable, histograms of both over the same bins, as fractions: one row per array and bin;
 * 2. mesh B, and if both have the same cells an array "<name>_Delta" of B - A for each array.
 *
 * The columns are listed in Documentation/compare.md. Cells are the same if blocks, types and points (of polyhedra faces)
 * of the cells are, in the same order on the same processes; where the points are does not matter.
 *
 * Parallel: the tables are complete on process 0 and empty, with all columns, on the others. Every number is the same,
 * bit for bit, for any number of threads and processes. No process gets the values of all cells: for the distance each
 * takes over a range of them.
 */
#ifndef vtkCompareQuality_h
#define vtkCompareQuality_h

#include "vtkDataObjectAlgorithm.h"

#include <string> // for choices
#include <vector> // for lists

class vtkCompareQuality : public vtkDataObjectAlgorithm
{
public:
  static vtkCompareQuality* New();
  vtkTypeMacro(vtkCompareQuality, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Cell arrays with one component to compare. Default: none, which means every one that both meshes have and that is
   * named like a criterion, or like a measure that vtkMeshElements makes.
   */
  void AddArray(const char* name);
  void ClearArrays();
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

  ///@{
  /// Number of bins per array, at most 100000. Default: 50. Integers have one bin each, constant data a single one.
  vtkSetClampMacro(NumberOfBins, int, 1, 100000);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  ///@{
  /// Bins of equal width, "Linear" (default), or of equal ratio of their edges, "Logarithmic".
  void SetHistogramScale(const char* choice) { this->SetText(this->HistogramScale, choice); }
  const char* GetHistogramScale() const { return this->HistogramScale.c_str(); }
  ///@}

  ///@{
  /// Difference up to which a value counts as unchanged, relative to the larger magnitude. Default: 1e-9.
  vtkSetClampMacro(Tolerance, double, 0, 1);
  vtkGetMacro(Tolerance, double);
  ///@}

protected:
  vtkCompareQuality();
  ~vtkCompareQuality() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCompareQuality(const vtkCompareQuality&) = delete;
  void operator=(const vtkCompareQuality&) = delete;

  void SetText(std::string& member, const char* text);
  void Compare(vtkDataObject* a, vtkDataObject* b, vtkInformationVector* outputVector);

  std::vector<std::string> Arrays;
  std::string Preset;
  std::string RangesFile;
  int NumberOfBins = 50;
  std::string HistogramScale = "Linear";
  double Tolerance = 1e-9;
};

#endif
