// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkQualityStatistics
 * @brief Makes tables of statistics, histograms and worst elements of cell or point arrays.
 *
 * Input: any vtkDataSet or composite of them. By default every cell array that is named like a
 * quality criterion is evaluated, see AddArray(). Ghost cells (DUPLICATECELL, HIDDENCELL,
 * REFINEDCELL) do not count. Faces, edges and vertices are cells of the outputs of vtkMeshElements.
 * NaN is null: counted, but in no other number. Infinite values are counted apart; they are outside
 * of any acceptable range that ends on their side and may be the worst, but enter no moment,
 * quantile or bin.
 *
 * Outputs, each a vtkTable:
 * 0. statistics, one row per array and group;
 * 1. histogram, one row per array, group and bin;
 * 2. worst cells, one row per array, group and rank; arrays without a worse end have none;
 * 3. cumulative curve, one row per array, group and point, see SetCurvePoints.
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

#include "vtkQualityTables.h"

#include <string> // for choices
#include <vector> // for lists

class vtkQualityStatistics : public vtkQualityTables
{
public:
  static vtkQualityStatistics* New();
  vtkTypeMacro(vtkQualityStatistics, vtkQualityTables);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What has statistics: "Cells" (default) or "Points", by their arrays. A point that several
   * pieces have counts once: as vtkGhostType of the points says, else with the first piece that has
   * it.
   */
  void SetElementType(const char* choice) { this->SetText(this->ElementType, choice); }
  const char* GetElementType() const { return this->ElementType.c_str(); }
  ///@}

  ///@{
  /**
   * Cell array with one component by which cells count in further columns: "Weight", "WeightedMean"
   * and "Bad<name>Fraction", the share of it outside of the acceptable range. Default: none.
   */
  void SetWeightArray(const char* name) { this->SetText(this->WeightArray, name); }
  const char* GetWeightArray() const { return this->WeightArray.c_str(); }
  ///@}

  ///@{
  /// Whether only the elements count whose value of SelectionArray is neither 0 nor NaN. Default:
  /// off.
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
  /**
   * Points of the cumulative curve of each array and group, which are values of elements: the share
   * of the elements, or of their weight, with values up to there. 0 (default, no curve) to 100000.
   */
  vtkSetMacro(CurvePoints, int);
  vtkGetMacro(CurvePoints, int);
  ///@}

  ///@{
  /// Further points of the curve, at these values of any array; not NaN. Default: none.
  void AddCurveValue(double value);
  void ClearCurveValues();
  const std::vector<double>& GetCurveValues() const { return this->CurveValues; }
  ///@}

  ///@{
  /// Quantiles in percent, 0 to 100. Default: 0, 1, 5, 25, 50, 75, 95, 99, 100.
  void AddQuantile(double percent);
  void ClearQuantiles();
  const std::vector<double>& GetQuantiles() const { return this->Quantiles; }
  ///@}

  ///@{
  /// Number of bins per array, 1 to 100000. Default: 50. Integers have one bin each, constant data
  /// a single one.
  vtkSetMacro(NumberOfBins, int);
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
  /// Range of the bins if HistogramRange is "Custom", the smaller number first. Default: 0 to 1.
  vtkSetVector2Macro(CustomRange, double);
  vtkGetVector2Macro(CustomRange, double);
  ///@}

  ///@{
  /// Bins of equal width, "Linear" (default), or of equal ratio of their edges, "Logarithmic".
  void SetHistogramScale(const char* choice) { this->SetText(this->HistogramScale, choice); }
  const char* GetHistogramScale() const { return this->HistogramScale.c_str(); }
  ///@}

  ///@{
  /// How many of the worst cells to list per array and group, 0 or more. Default: 10.
  vtkSetMacro(NumberOfWorst, int);
  vtkGetMacro(NumberOfWorst, int);
  ///@}

  ///@{
  /**
   * Which values are worst: "By criterion" (default, the end that the table of criteria calls
   * worse), "Largest", "Smallest", or "Null": those that are missing though the criterion has a
   * meaning for the cell, in the order of the ids.
   */
  void SetWorstValues(const char* choice) { this->SetText(this->WorstValues, choice); }
  const char* GetWorstValues() const { return this->WorstValues.c_str(); }
  ///@}

protected:
  vtkQualityStatistics();
  ~vtkQualityStatistics() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void MakeColumns(vtkInformationVector* outputVector) override;
  void AddRows(vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  const char* GetFailure() const override { return "The statistics cannot be computed"; }
  const char* GetUnrounded() const override
  {
    return "; MinInteger, MaxInteger and ValueInteger contain all digits";
  }
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
  bool OnlySelected = false;
  std::string SelectionArray = "Selected";
  int CurvePoints = 0;
  std::vector<double> CurveValues;
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
