// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkQualityStatistics
 * @brief Computes tables of statistics, histograms and worst elements of cell or point arrays.
 *
 * Input: any vtkDataSet or composite data set. By default the filter evaluates every cell array
 * that is named like a quality criterion; see AddArray(). Ghost cells (DUPLICATECELL, HIDDENCELL,
 * REFINEDCELL) are ignored. To evaluate faces, edges and vertices, use the outputs of
 * vtkMeshElements, where they are cells.
 *
 * NaN means undefined: these values are counted and otherwise ignored. Infinite values are counted
 * separately. They are outside an acceptable range that is bounded on their side and may be the
 * worst values, but do not contribute to moments, quantiles or bins.
 *
 * Outputs, each a vtkTable:
 * 0. statistics, one row per array and group
 * 1. histogram, one row per array, group and bin
 * 2. worst cells, one row per array, group and rank; none for arrays without a bad end
 * 3. cumulative curve, one row per array, group and point; see SetCurvePoints
 *
 * Documentation/statistics.md lists the columns. The *Id* of a cell is its global id if all cells
 * have one, else its index among the cells of all blocks and processes, which is VTK's cell id for
 * a single data set (camaron::ElementBlocks).
 *
 * Parallel: the tables are complete on process 0, and empty with all columns on the others. Every
 * number is the same, to the last bit, for any number of threads and processes. Only counts and the
 * worst cells are gathered.
 */
#ifndef vtkQualityStatistics_h
#define vtkQualityStatistics_h

#include "vtkQualityTables.h"

#include <string> // for choices
#include <vector> // for lists

class vtkQualityStatistics : public vtkQualityTables
{
public:
  static vtkQualityStatistics* New();
  vtkTypeMacro(vtkQualityStatistics, vtkQualityTables);

  ///@{
  /// Evaluate arrays of "Cells" (default) or "Points". A point that several pieces have counts
  /// once: vtkGhostType of the points decides where, else the first piece that has it.
  vtkSetStdStringFromCharMacro(ElementType);
  vtkGetCharFromStdStringMacro(ElementType);
  ///@}

  ///@{
  /// Lines as of RangesFile, which take precedence over it. Default: empty.
  vtkSetStdStringFromCharMacro(Ranges);
  vtkGetCharFromStdStringMacro(Ranges);
  ///@}

  ///@{
  /**
   * One-component cell array with weights of the cells, such as Volume. Adds the columns "Weight",
   * "WeightedMean" and "Bad<name>Fraction", the fraction of the weight outside the acceptable
   * range. Default: empty, no weights.
   */
  vtkSetStdStringFromCharMacro(WeightArray);
  vtkGetCharFromStdStringMacro(WeightArray);
  ///@}

  /// Compute standard deviation, variance, skewness, kurtosis, root mean square, geometric mean,
  /// and the elements with the extremes. Otherwise, they are undefined, and counts and histograms
  /// take less time. Default: on.
  vtkSetMacro(Moments, bool);

  ///@{
  /// Evaluate only elements whose value of SelectionArray is neither 0 nor NaN. Default: off.
  vtkSetMacro(OnlySelected, bool);
  vtkGetMacro(OnlySelected, bool);
  ///@}

  ///@{
  /// One-component array for OnlySelected. Default: "Selected", the array that vtkSelectElements
  /// adds.
  vtkSetStdStringFromCharMacro(SelectionArray);
  vtkGetCharFromStdStringMacro(SelectionArray);
  ///@}

  ///@{
  /**
   * Number of points of the cumulative curve of each array and group. The points are at values of
   * elements and contain the fraction of the elements, or of their weight, up to that value. Range:
   * 0 (default, no curve) to 100000.
   */
  vtkSetMacro(CurvePoints, int);
  vtkGetMacro(CurvePoints, int);
  ///@}

  ///@{
  /// Additional points of the curve at given values, for all arrays; not NaN. Default: none.
  void AddCurveValue(double value);
  void ClearCurveValues();
  const std::vector<double>& GetCurveValues() const { return this->CurveValues; }
  ///@}

  ///@{
  /// Values at which histograms have an edge between bins, for all arrays; not NaN. Default: none.
  void AddBinEdge(double value);
  void ClearBinEdges();
  ///@}

  ///@{
  /// Quantiles in percent, 0 to 100. Default: 0, 1, 5, 25, 50, 75, 95, 99, 100.
  void AddQuantile(double percent);
  void ClearQuantiles();
  const std::vector<double>& GetQuantiles() const { return this->Quantiles; }
  ///@}

  ///@{
  /// Number of bins per array, 1 to 100000. Default: 50. Integer arrays have one bin per value,
  /// constant arrays a single bin.
  vtkSetMacro(NumberOfBins, int);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  ///@{
  /// Range of the bins: "Automatic" (default), the finite minimum to maximum; "All elements", the
  /// same of all elements with OnlySelected; "Acceptable", the acceptable range, with the end of
  /// the data where it is unbounded; or "Custom".
  vtkSetStdStringFromCharMacro(HistogramRange);
  vtkGetCharFromStdStringMacro(HistogramRange);
  ///@}

  ///@{
  /// Range of the bins if HistogramRange is "Custom", the smaller number first. Default: 0 to 1.
  vtkSetVector2Macro(CustomRange, double);
  vtkGetVector2Macro(CustomRange, double);
  ///@}

  ///@{
  /// "Linear" (default): bins of equal width; "Logarithmic": bins whose edges have equal ratios.
  vtkSetStdStringFromCharMacro(HistogramScale);
  vtkGetCharFromStdStringMacro(HistogramScale);
  ///@}

  ///@{
  /// Number of worst cells to list per array and group, 0 or more. Default: 10.
  vtkSetMacro(NumberOfWorst, int);
  vtkGetMacro(NumberOfWorst, int);
  ///@}

  ///@{
  /**
   * Values to list as worst: "By criterion" (default), the bad end according to the table of
   * criteria; "Largest"; "Smallest"; or "Undefined", the undefined values of cells to which the
   * criterion applies, by id.
   */
  vtkSetStdStringFromCharMacro(WorstValues);
  vtkGetCharFromStdStringMacro(WorstValues);
  ///@}

protected:
  vtkQualityStatistics();
  ~vtkQualityStatistics() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void MakeColumns(vtkInformationVector* outputVector) override;
  void AddRows(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  const char* GetFailure() const override { return "The statistics cannot be computed"; }
  const char* GetKindOfArrays() const override
  {
    return this->ElementType == "Points" ? "point" : "cell";
  }

private:
  vtkQualityStatistics(const vtkQualityStatistics&) = delete;
  void operator=(const vtkQualityStatistics&) = delete;

  struct Settings;
  Settings CheckSettings() const;

  std::string ElementType = "Cells";
  std::string Ranges;
  bool Moments = true;
  bool OnlySelected = false;
  std::string SelectionArray = "Selected";
  int CurvePoints = 0;
  std::vector<double> CurveValues;
  std::vector<double> BinEdges;
  std::string WeightArray;
  std::vector<double> Quantiles = { 0, 1, 5, 25, 50, 75, 95, 99, 100 };
  int NumberOfBins = 50;
  std::string HistogramRange = "Automatic";
  double CustomRange[2] = { 0, 1 };
  std::string HistogramScale = "Linear";
  int NumberOfWorst = 10;
  std::string WorstValues = "By criterion";
};

#endif
