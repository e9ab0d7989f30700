// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSelectElements
 * @brief Selects cells of a mesh by one of several strategies.
 *
 * Input: any vtkDataSet or composite of them. Outputs:
 * 0. the input with the unsigned char cell array `Selected`, 1 for selected cells and 0 for others;
 * 1. a vtkSelection of the selected cells by index, with a node for each data set of this process.
 *
 * Strategies, by name:
 * - "By criterion": values of Array inside or outside of a range; NaN is on neither side, infinite
 *   values take part;
 * - "Worst N": the NumberOfWorst worst values of Array in exact order, the smaller identity first
 * among equal ones; NaN never, infinite values take part;
 * - "Null": NaN in Array;
 * - "By id": a list of ids.
 *
 * Ghost cells are never selected. The same cells are selected on any number of processes, if these
 * have global ids or hold consecutive ranges of the cells; see camaron::ElementBlocks.
 */
#ifndef vtkSelectElements_h
#define vtkSelectElements_h

#include "vtkDataObjectAlgorithm.h"

#include <memory> // for the parameters
#include <string> // for the report

namespace camaron
{
struct SelectionParameters;
}

class vtkSelectElements : public vtkDataObjectAlgorithm
{
public:
  static vtkSelectElements* New();
  vtkTypeMacro(vtkSelectElements, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Name of the array that is added to the cells.
  static const char* GetSelectedArrayName() { return "Selected"; }

  ///@{
  /// How to select, see above. Default: "By criterion".
  void SetStrategy(const char* name);
  const char* GetStrategy() const;
  ///@}

  ///@{
  /// By id: ids and ranges of them, such as "3, 10-20, 40". Default: none.
  void SetIds(const char* ids);
  const char* GetIds() const;
  ///@}

  ///@{
  /**
   * By id: what an id is. "Index" (default): the index among the cells of all blocks and processes,
   * VTK's cell id if there is only one data set; "Global id" or "Pedigree id": of the arrays with
   * that role.
   */
  void SetIdSpace(const char* name);
  const char* GetIdSpace() const;
  ///@}

  ///@{
  /// By criterion, Worst N, Null: cell array with one component. Default: none.
  void SetArray(const char* name);
  const char* GetArray() const;
  ///@}

  ///@{
  /// By criterion: select values on this side of the range, "Outside" (default) or "Inside".
  void SetSide(const char* name);
  const char* GetSide() const;
  ///@}

  ///@{
  /**
   * By criterion: the closed range, "Acceptable" (default, the one in which values of the criterion
   * are acceptable) or "Custom" (LowerLimit to UpperLimit).
   */
  void SetRange(const char* name);
  const char* GetRange() const;
  ///@}

  ///@{
  /**
   * By criterion: whose acceptable range, "Default ranges" (default, those of the table of
   * criteria) or the name of a preset.
   */
  void SetPreset(const char* name);
  const char* GetPreset() const;
  ///@}

  ///@{
  /**
   * File of acceptable ranges of the user (Core/Criteria/RangesFile.h), which come before those of
   * the preset. Default: empty, none.
   */
  ///@{
  /**
   * By criterion: file of acceptable ranges of the user (Core/Criteria/RangesFile.h), which come before those of
   * the preset. Default: empty, none.
   */
  void SetRangesFile(const char* path);
  const char* GetRangesFile() const;
  ///@}

  ///@{
  /// By criterion: ends of a custom range as text, in the unit of the array. Default: empty, no
  /// end.
  void SetLowerLimit(const char* number);
  const char* GetLowerLimit() const;
  void SetUpperLimit(const char* number);
  const char* GetUpperLimit() const;
  ///@}

  ///@{
  /// Worst N: how many cells. Default: 10.
  void SetNumberOfWorst(int number);
  int GetNumberOfWorst() const;
  ///@}

  ///@{
  /**
   * Worst N: "By criterion" (default, the end that the table of criteria calls worse), "Largest" or
   * "Smallest".
   */
  void SetWorstValues(const char* name);
  const char* GetWorstValues() const;
  ///@}

  /// Selected cells of all processes after the last update.
  vtkGetMacro(NumberOfSelectedCells, vtkIdType);
  /// What the last update has to say, such as "2 of 5 ids do not exist"; else empty.
  const char* GetReport() const { return this->Report.c_str(); }

protected:
  vtkSelectElements();
  ~vtkSelectElements() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSelectElements(const vtkSelectElements&) = delete;
  void operator=(const vtkSelectElements&) = delete;

  void SetText(std::string& member, const char* text);

  std::unique_ptr<camaron::SelectionParameters> Parameters;
  vtkIdType NumberOfSelectedCells = 0;
  std::string Report;
};

#endif
