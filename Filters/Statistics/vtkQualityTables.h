// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkQualityTables
 * @brief What filters that make tables of arrays have in common: which arrays, ranges, groups and
 * time steps.
 *
 * Inputs are any vtkDataSet or composite of them. With AllTimeSteps the tables have the rows of all
 * time steps, one step after the other, and the column "Time"; outputs that are meshes are those of
 * the last step. One step at a time is in memory. Arrays that are wanted and not there, or not at
 * all steps, are told in a warning.
 */
#ifndef vtkQualityTables_h
#define vtkQualityTables_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkSmartPointer.h" // for names

#include <memory> // for the steps
#include <set>    // for names
#include <string> // for choices
#include <vector> // for lists

class vtkStringArray;

namespace camaron
{
class ArraysOfSteps;
class Reducer;
class TimeSteps;
}

class vtkQualityTables : public vtkDataObjectAlgorithm
{
public:
  vtkTypeMacro(vtkQualityTables, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Arrays with one component to evaluate, each once. Default: none, which means every one that is
   * named like a criterion, or like a measure of faces, edges or vertices that vtkMeshElements
   * makes.
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
  /// The choices for Preset.
  vtkStringArray* GetPresetNames();
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
   * values. Cells with other values than whole numbers of 64 bits are in no group. Default: empty,
   * the first array of integers, else the first one.
   */
  void SetGroupArray(const char* name) { this->SetText(this->GroupArray, name); }
  const char* GetGroupArray() const { return this->GroupArray.c_str(); }
  ///@}

  ///@{
  /// Whether all time steps of the input are evaluated, and the tables have a column "Time".
  /// Default: off.
  vtkSetMacro(AllTimeSteps, bool);
  vtkGetMacro(AllTimeSteps, bool);
  vtkBooleanMacro(AllTimeSteps, bool);
  ///@}

protected:
  vtkQualityTables();
  ~vtkQualityTables() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Gives the tables their columns, and no rows.
  virtual void MakeColumns(vtkInformationVector* outputVector) = 0;
  /**
   * Collective. Adds the rows of a time step, on process 0. What may be wrong with properties is
   * found before the first exchange, by every process; throws std::exception on all processes or
   * none.
   */
  virtual void AddRows(vtkInformationVector** inputVector, vtkInformationVector* outputVector) = 0;
  /**
   * Collective. For AddRows: whether an array has integers that no double is, on this process; a
   * warning then says that columns of numbers have the nearest doubles.
   */
  void NoteRounding(const std::string& name, bool isRounded, camaron::Reducer& reducer);
  /// End of that warning: where all digits of such integers are, if they are.
  virtual const char* GetUnrounded() const { return ""; }
  /// Begin of the message if AddRows throws, such as "The statistics cannot be made".
  virtual const char* GetFailure() const = 0;
  /// Such as "cell".
  virtual const char* GetKindOfArrays() const { return "cell"; }

  void SetText(std::string& member, const char* text);
  /// For AddRows, @a numberOfGroups with that of all: says on the root if there is nothing to group
  /// by the array.
  void WarnOfNoGroups(const std::string& arrayName, std::size_t numberOfGroups, bool isRoot);

  std::vector<std::string> Arrays;
  vtkSmartPointer<vtkStringArray> PresetNames;
  std::string Preset;
  std::string RangesFile;
  std::string GroupBy = "None";
  std::string GroupArray;
  bool AllTimeSteps = false;
  std::set<std::string> Rounded; ///< names of arrays, of all steps so far

  ///@{
  /// For AddRows: the step at work, and the arrays that are evaluated at it.
  std::unique_ptr<camaron::TimeSteps> Steps;
  std::unique_ptr<camaron::ArraysOfSteps> Found;
  ///@}

private:
  vtkQualityTables(const vtkQualityTables&) = delete;
  void operator=(const vtkQualityTables&) = delete;
};

#endif
