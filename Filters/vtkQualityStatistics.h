// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkQualityStatistics
 * @brief Makes tables of statistics, histograms and worst elements of cell or point arrays.
 *
 * Input: any vtkDataSet or composite of them. By default every cell array that is named like a
 * quality criterion is evaluated, see AddArray(). Ghost cells (DUPLICATECELL, HIDDENCELL,
 * REFINEDCELL) do not count. Faces, edges and vertices are cells of the outputs of vtkMeshElements. NaN is null: counted, but in no other number. Infinite values are
 * counted apart; they are outside of any acceptable range that ends on their side and may be the
 * worst, but enter no moment, quantile or bin.
 *
 * Outputs, each a vtkTable:
 * 0. statistics, one row per array and group;
 * 1. histogram, one row per array, group and bin;
 * 2. worst cells, one row per array, group and rank; arrays without a worse end have none;
 * 3. cumulative curve, one row per array, group and point, see SetCurvePoints.
 *
 * With AllTimeSteps the tables have the rows of all time steps, one step after the other.
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

class vtkDataObject;

class vtkQualityStatistics : public vtkTableAlgorithm
{
public:
  static vtkQualityStatistics* New();
  vtkTypeMacro(vtkQualityStatistics, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What has statistics: "Cells" (default) or "Points", by their arrays. A point that several pieces have counts once:
   * as vtkGhostType of the points says, else with the first piece that has it.
   */
  void SetElementType(const char* choice) { this->SetText(this->ElementType, choice); }
  const char* GetElementType() const { return this->ElementType.c_str(); }
  ///@}

  ///@{
  /**
   * Arrays with one component to evaluate. Default: none, which means every one that is named
   * like a criterion, or like a measure of faces, edges or vertices that vtkMeshElements makes.
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
  /// Whether only the elements count whose value of SelectionArray is neither 0 nor NaN. Default: off.
  vtkSetMacro(OnlySelected, bool);
  vtkGetMacro(OnlySelected, bool);
  vtkBooleanMacro(OnlySelected, bool);
  ///@}

  ///@{
  /// Array with one component for OnlySelected. Default: "Selected", which vtkSelectElements makes.
  void SetSelectionArray(const char* name) { this->SetText(this->SelectionArray, name); }
  const char* GetSelectionArray() const { return this->SelectionArray.c_str(); }
  ///@}

  ///@{
  /// Whether all time steps of the input are evaluated, and the tables have a column "Time". Default: off.
  vtkSetMacro(AllTimeSteps, bool);
  vtkGetMacro(AllTimeSteps, bool);
  vtkBooleanMacro(AllTimeSteps, bool);
  ///@}

  ///@{
  /**
   * Points of the cumulative curve of each array and group, which are values of elements: the share of the elements,
   * or of their weight, with values up to there. Default: 0, no curve.
   */
  vtkSetClampMacro(CurvePoints, int, 0, 100000);
  vtkGetMacro(CurvePoints, int);
  ///@}

  ///@{
  /// Quantiles in percent, 0 to 100. Default: 0, 1, 5, 25, 50, 75, 95, 99, 100.
  void AddQuantile(double percent);
  void ClearQuantiles();
  const std::vector<double>& GetQuantiles() const { return this->Quantiles; }
  ///@}

  ///@{
  /// Number of bins per array, at most 100000. Default: 50. Integers have one bin each, constant data a single one.
  vtkSetClampMacro(NumberOfBins, int, 1, 100000);
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
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkQualityStatistics(const vtkQualityStatistics&) = delete;
  void operator=(const vtkQualityStatistics&) = delete;

  struct Settings;
  struct Tables;

  void SetText(std::string& member, const char* text);
  Settings CheckSettings() const;
  void AddRows(vtkDataObject* input, const Settings& settings, const Tables& tables);
  int GetNumberOfSteps() const { return this->AllTimeSteps ? static_cast<int>(this->TimeSteps.size()) : 0; }

  std::string ElementType = "Cells";
  bool OnlySelected = false;
  std::string SelectionArray = "Selected";
  bool AllTimeSteps = false;
  int CurvePoints = 0;
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

  std::vector<double> TimeSteps; // of the input
  int TimeStep = 0;              // the one at work, with AllTimeSteps
};

#endif
