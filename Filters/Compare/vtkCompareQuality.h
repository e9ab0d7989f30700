// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCompareQuality
 * @brief Compares the quality of two meshes, or of one mesh before and after a change.
 *
 * Inputs: mesh A (port 0) and mesh B (port 1), each any vtkDataSet or composite data set with cell
 * arrays. By default the filter compares every cell array that both meshes have and that is named
 * like a quality criterion; see AddArray(). Arrays whose units differ are skipped with a warning.
 * Ghost cells, NaN and infinite values count as in vtkQualityStatistics.
 *
 * Outputs:
 * 0. vtkTable with one row per array and group: statistics of A and B, their differences B - A, and
 *    the Kolmogorov-Smirnov distance of the distributions; if the meshes have the same cells, also
 *    the numbers of improved and worsened cells
 * 1. vtkTable with the histograms of both over the same bins, as fractions: one row per array,
 *    group and bin
 * 2. mesh B; if the meshes have the same cells, with an array "<name>_Delta" of B - A for each
 *    array
 *
 * The groups are those of both meshes, see vtkQualityTables. A cell compared with itself belongs to
 * its group of mesh B. Time steps are those of A, or those of B if A has none; both meshes are
 * evaluated at the same time.
 *
 * Documentation/compare.md lists the columns. The meshes have the same cells if blocks, types and
 * points (for polyhedra: faces) of the cells are identical, in the same order on the same
 * processes; coordinates do not matter.
 *
 * Parallel: the tables are complete on process 0, and empty with all columns on the others. Every
 * number is the same, to the last bit, for any number of threads and processes. No process gathers
 * the values of all cells: each computes the distance for a range of values.
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

  ///@{
  /// Number of bins per array, 1 to 100000. Default: 50. Integer arrays have one bin per value,
  /// constant arrays a single bin.
  vtkSetMacro(NumberOfBins, int);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  ///@{
  /// "Linear" (default): bins of equal width; "Logarithmic": bins whose edges have equal ratios.
  vtkSetStdStringFromCharMacro(HistogramScale);
  vtkGetCharFromStdStringMacro(HistogramScale);
  ///@}

  ///@{
  /// Relative difference, to the larger magnitude, up to which a value counts as unchanged. Range:
  /// 0 to 1. Default: 1e-9.
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

protected:
  vtkCompareQuality();
  ~vtkCompareQuality() override = default;

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
