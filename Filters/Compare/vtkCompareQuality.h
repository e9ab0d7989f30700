// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCompareQuality
 * @brief Compares the quality of two meshes, or of one before and after.
 *
 * Inputs: port 0 mesh A, port 1 mesh B, each any vtkDataSet or composite of them with cell arrays.
 * By default every cell array that both have and that is named like a quality criterion is
 * compared, see AddArray(). Ghost cells, null and infinite values count as in vtkQualityStatistics.
 *
 * Outputs:
 * 0. vtkTable, one row per array and group: statistics of A and B and their differences B - A; the
 * distance of the distributions (Kolmogorov and Smirnov); if the meshes have the same cells, how
 * many have improved and worsened;
 * 1. vtkTable, histograms of both over the same bins, as fractions: one row per array, group and
 * bin;
 * 2. mesh B, and if both have the same cells an array "<name>_Delta" of B - A for each array.
 *
 * Groups are those of both meshes, see vtkQualityTables; a cell that is compared with itself is in
 * its group of mesh B. Time steps are those of A, or of B if A has none; both meshes are taken at
 * the same time.
 *
 * The columns are listed in Documentation/compare.md. Cells are the same if blocks, types and
 * points (of polyhedra faces) of the cells are, in the same order on the same processes; where the
 * points are does not matter.
 *
 * Parallel: the tables are complete on process 0 and empty, with all columns, on the others. Every
 * number is the same, bit for bit, for any number of threads and processes. No process gets the
 * values of all cells: for the distance each takes over a range of them.
 */
#ifndef vtkCompareQuality_h
#define vtkCompareQuality_h

#include "vtkQualityTables.h"

#include <string> // for choices
#include <vector> // for arrays

namespace camaron
{
class ElementBlocks;
class Reducer;
struct StatisticsArray;
}

class vtkCompareQuality : public vtkQualityTables
{
public:
  static vtkCompareQuality* New();
  vtkTypeMacro(vtkCompareQuality, vtkQualityTables);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Number of bins per array, 1 to 100000. Default: 50. Integers have one bin each, constant data
  /// a single one.
  vtkSetMacro(NumberOfBins, int);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  ///@{
  /// Bins of equal width, "Linear" (default), or of equal ratio of their edges, "Logarithmic".
  void SetHistogramScale(const char* choice) { this->SetText(this->HistogramScale, choice); }
  const char* GetHistogramScale() const { return this->HistogramScale.c_str(); }
  ///@}

  ///@{
  /// Difference up to which a value counts as unchanged, relative to the larger magnitude, 0 to 1.
  /// Default: 1e-9.
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

protected:
  vtkCompareQuality();
  ~vtkCompareQuality() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void MakeColumns(vtkInformationVector* outputVector) override;
  void AddRows(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  const char* GetFailure() const override { return "The meshes cannot be compared"; }
  const char* GetKindOfArrays() const override { return "common cell"; }

private:
  vtkCompareQuality(const vtkCompareQuality&) = delete;
  void operator=(const vtkCompareQuality&) = delete;

  std::vector<camaron::StatisticsArray> ChooseCommonArrays(
    const camaron::ElementBlocks blocks[2], camaron::Reducer& reducer);

  int NumberOfBins = 50;
  std::string HistogramScale = "Linear";
  double Tolerance = 1e-9;
};

#endif
