// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkQualityTables
 * @brief Base class of filters that create tables about arrays: it handles arrays, acceptable
 * ranges, groups and time steps.
 *
 * Inputs are any vtkDataSet or composite data set. With AllTimeSteps the tables contain the rows of
 * all time steps, one step after the other, and a column "Time"; outputs that are meshes are those
 * of the last step. One step at a time is in memory. A warning reports requested arrays that are
 * missing at some or all steps.
 */
#ifndef vtkQualityTables_h
#define vtkQualityTables_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkSmartPointer.h" // for names
#include "vtkStringArray.h"  // for names

#include <memory> // for the steps
#include <string> // for choices
#include <vector> // for lists

namespace camaron
{
class ArraysOfSteps;
class TimeSteps;
}

class vtkQualityTables : public vtkDataObjectAlgorithm
{
public:
  vtkTypeMacro(vtkQualityTables, vtkDataObjectAlgorithm);

  ///@{
  /// One-component arrays to evaluate, each once. Default: none, which means all arrays named like
  /// a criterion, or like a measure of faces, edges or vertices of vtkMeshElements.
  void AddArray(const char* name);
  void ClearArrays();
  ///@}

  ///@{
  /// Source of the acceptable ranges: "Default ranges" (default), the table of criteria, or the
  /// name of a preset, for the criteria in the preset.
  vtkSetStdStringFromCharMacro(Preset);
  vtkGetCharFromStdStringMacro(Preset);
  /// All valid values of Preset.
  vtkStringArray* GetPresetNames() { return this->PresetNames; }
  ///@}

  ///@{
  /// File of acceptable ranges (Core/Rules/ParsedRules.h), which take precedence over those of
  /// the preset. Default: empty, no file.
  vtkSetStdStringFromCharMacro(RangesFile);
  vtkGetCharFromStdStringMacro(RangesFile);
  ///@}

  ///@{
  /// Groups that get their own rows in addition to the group of all cells: "None" (default), "Cell
  /// type", "Block", or "Cell array" with one group per integer or text of GroupArray.
  vtkSetStdStringFromCharMacro(GroupBy);
  vtkGetCharFromStdStringMacro(GroupBy);
  ///@}

  /**
   * One-component cell array to group by, such as a material or a region, with up to 1000 different
   * values. Cells whose values are neither integers nor texts are in no group. Default:
   * empty, the first integer array, else the first array of numbers, else of texts.
   */
  vtkSetStdStringFromCharMacro(GroupArray);

  ///@{
  /// Evaluate all time steps of the input, and add a column "Time". Default: off.
  vtkSetMacro(AllTimeSteps, bool);
  vtkGetMacro(AllTimeSteps, bool);
  ///@}

protected:
  vtkQualityTables();
  ~vtkQualityTables() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Creates the columns of the tables, without rows.
  virtual void MakeColumns(vtkInformationVector* outputVector) = 0;
  /**
   * Collective. Adds the rows of a time step, on process 0. Every process must check all properties
   * before the first exchange, so that std::exception is thrown on all processes or none.
   */
  virtual void AddRows(vtkInformationVector** inputVector, vtkInformationVector* outputVector) = 0;
  /// Start of the message if AddRows throws, such as "The statistics cannot be computed".
  virtual const char* GetFailure() const = 0;
  /// Element type of the arrays for messages, such as "cell".
  virtual const char* GetKindOfArrays() const { return "cell"; }

  /// For AddRows: warns, on the root, if there are no groups by the array. @a numberOfGroups
  /// includes the group of all elements.
  void WarnOfNoGroups(const std::string& arrayName, std::size_t numberOfGroups, bool isRoot);

  std::vector<std::string> Arrays;
  const vtkSmartPointer<vtkStringArray> PresetNames;
  std::string Preset;
  std::string RangesFile;
  std::string GroupBy = "None";
  std::string GroupArray;
  bool AllTimeSteps = false;

  ///@{
  /// For AddRows: the current step, and the arrays that were found at each step.
  std::unique_ptr<camaron::TimeSteps> Steps;
  std::unique_ptr<camaron::ArraysOfSteps> Found;
  ///@}

private:
  vtkQualityTables(const vtkQualityTables&) = delete;
  void operator=(const vtkQualityTables&) = delete;
};

#endif
