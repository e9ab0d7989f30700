// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkQualityStatistics
 * @brief Makes tables of statistics, histograms and worst cells of cell arrays.
 *
 * Input: any vtkDataSet or composite of them. By default every cell array that is named like a
 * quality criterion is evaluated, see AddArray(). Ghost cells (DUPLICATECELL, HIDDENCELL,
 * REFINEDCELL) do not count. NaN is null: counted, but in no other number. Infinite values are
 * counted apart; they are outside of any acceptable range that ends on their side and may be the
 * worst, but enter no moment, quantile or bin.
 *
 * Outputs, each a vtkTable:
 * 0. statistics, one row per array and group;
 * 1. histogram, one row per array, group and bin;
 * 2. worst cells, one row per array, group and rank; arrays without a worse end have none.
 *
 * The columns are listed in Documentation/statistics.md. A cell is named by its *Id*: its global id
 * if all cells have one, else its index among the cells of all blocks and processes, which for a
 * single data set is VTK's cell id (camaron::ElementBlocks).
 *
 * Parallel: the tables are complete on process 0 and empty, with all columns, on the others. Every
 * number is the same, bit for bit, for any number of threads and processes; nothing is gathered but
 * counts and the worst cells.
 */
#ifndef vtkQualityStatistics_h
#define vtkQualityStatistics_h

#include "vtkTableAlgorithm.h"

#include <string> // for choices
#include <vector> // for lists

class vtkQualityStatistics : public vtkTableAlgorithm
{
public:
  static vtkQualityStatistics* New();
  vtkTypeMacro(vtkQualityStatistics, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Cell arrays with one component to evaluate. Default: none, which means every one that is named
   * like a criterion.
   */
  void AddArray(const char* name);
  void ClearArrays();
  ///@}

  ///@{
  /**
   * Whose acceptable ranges to count by: "Default ranges" (default), those of the table of
   * criteria, or a preset, for the criteria it has a range for.
   */
  void SetPreset(const char* name) { this->SetText(this->Preset, name); }
  const char* GetPreset() const { return this->Preset.c_str(); }
  ///@}

  ///@{
  /**
   * File of acceptable ranges of the user (Core/Criteria/RangesFile.h), which come before those of
   * the preset. Default: empty, none.
   */
  void SetRangesFile(const char* path) { this->SetText(this->RangesFile, path); }
  const char* GetRangesFile() const { return this->RangesFile.c_str(); }
  ///@}

  ///@{
  /**
   * Rows per group of cells besides the one of all: "None" (default), "Cell type", "Block" or "Cell
   * array", by the whole numbers in GroupArray.
   */
  void SetGroupBy(const char* choice) { this->SetText(this->GroupBy, choice); }
  const char* GetGroupBy() const { return this->GroupBy.c_str(); }
  ///@}

  ///@{
  /**
   * Cell array with one component to group by, such as a material or a region; up to 1000 different
   * values. Cells with other values than whole numbers of 32 bits are in no group. Default: empty.
   */
  void SetGroupArray(const char* name) { this->SetText(this->GroupArray, name); }
  const char* GetGroupArray() const { return this->GroupArray.c_str(); }
  ///@}

  ///@{
  /**
   * Cell array with one component by which cells count in further columns: "Weight", "WeightedMean" and
   * "Bad<name>Fraction", the share of it outside of the acceptable range. Default: none.
   */
  void SetWeightArray(const char* name) { this->SetText(this->WeightArray, name); }
  const char* GetWeightArray() const { return this->WeightArray.c_str(); }
  ///@}

  ///@{
  /// Quantiles in percent, 0 to 100. Default: 0, 1, 5, 25, 50, 75, 95, 99, 100.
  void AddQuantile(double percent);
  void ClearQuantiles();
  const std::vector<double>& GetQuantiles() const { return this->Quantiles; }
  ///@}

  ///@{
  /// Number of bins per array. Default: 50. Integers have one bin each, constant data a single one.
  vtkSetClampMacro(NumberOfBins, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  ///@{
  /**
   * Range of the bins: "Automatic" (default, finite minimum to maximum), "Acceptable" (as Preset
   * says; an open end is that of the data) or "Custom".
   */
  void SetHistogramRange(const char* choice) { this->SetText(this->HistogramRange, choice); }
  const char* GetHistogramRange() const { return this->HistogramRange.c_str(); }
  ///@}

  ///@{
  /// Range of the bins if HistogramRange is "Custom". Default: 0 to 1.
  vtkSetVector2Macro(CustomRange, double);
  vtkGetVector2Macro(CustomRange, double);
  ///@}

  ///@{
  /// Bins of equal width, "Linear" (default), or of equal ratio of their edges, "Logarithmic".
  void SetHistogramScale(const char* choice) { this->SetText(this->HistogramScale, choice); }
  const char* GetHistogramScale() const { return this->HistogramScale.c_str(); }
  ///@}

  ///@{
  /// How many of the worst cells to list per array and group. Default: 10.
  vtkSetClampMacro(NumberOfWorst, int, 0, VTK_INT_MAX);
  vtkGetMacro(NumberOfWorst, int);
  ///@}

  ///@{
  /**
   * Which values are worst: "By criterion" (default, the end that the table of criteria calls
   * worse), "Largest", "Smallest", or "Null": those that are missing though the criterion has a meaning
   * for the cell, in the order of the ids.
   */
  void SetWorstValues(const char* choice) { this->SetText(this->WorstValues, choice); }
  const char* GetWorstValues() const { return this->WorstValues.c_str(); }
  ///@}

protected:
  vtkQualityStatistics();
  ~vtkQualityStatistics() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkQualityStatistics(const vtkQualityStatistics&) = delete;
  void operator=(const vtkQualityStatistics&) = delete;

  void SetText(std::string& member, const char* text);

  std::vector<std::string> Arrays;
  std::string Preset;
  std::string RangesFile;
  std::string GroupBy = "None";
  std::string GroupArray;
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
