// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRenameData
 * @brief Renames arrays, components and blocks, and converts 64-bit integers and texts, for
 * writers that cannot store them.
 *
 * Output: a shallow copy of the input, of the same type. Unlike ParaView's Rename Arrays, this
 * filter accepts names with any bytes.
 */
#ifndef vtkRenameData_h
#define vtkRenameData_h

#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSmartPointer.h" // for arrays

#include <map>    // for names
#include <string> // for names

class vtkAbstractArray;
class vtkDataObject;
class vtkFieldData;

class vtkRenameData : public vtkPassInputTypeAlgorithm
{
public:
  static vtkRenameData* New();
  vtkTypeMacro(vtkRenameData, vtkPassInputTypeAlgorithm);

  ///@{
  /// Old and new names of arrays and components. Default: none; others keep their names.
  void AddArrayName(const char* from, const char* to);
  void RemoveArrayNames();
  ///@}
  ///@{
  /// Old and new names of blocks. Default: none; others keep their names.
  void AddBlockName(const char* from, const char* to);
  void RemoveBlockNames();
  ///@}

  ///@{
  /**
   * Conversion of 64-bit integer arrays that have values beyond 32 bits: "Keep" (default) converts
   * nothing; "Int64" converts vtkIdTypeArrays to vtkTypeInt64Arrays, which writers of legacy files
   * do not truncate to 32 bits; "Double" converts them to double.
   */
  void SetLongIntegers(const char* choice);
  ///@}

  /// Whether arrays become columns of a table: quotation marks in texts are doubled, a text that a
  /// spreadsheet would run as a formula begins with an apostrophe, and integers of a byte are no
  /// characters. Default: off.
  vtkSetMacro(QuotesTexts, bool);

protected:
  vtkRenameData() = default;
  ~vtkRenameData() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkRenameData(const vtkRenameData&) = delete;
  void operator=(const vtkRenameData&) = delete;

  vtkSmartPointer<vtkAbstractArray> Rename(vtkAbstractArray* array) const;
  vtkSmartPointer<vtkAbstractArray> QuoteTexts(vtkAbstractArray* array) const;
  vtkSmartPointer<vtkAbstractArray> Retype(vtkAbstractArray* array) const;
  void RenameArrays(vtkDataObject* object) const;
  void RenameFields(vtkFieldData* fields) const;
  void RenameBlocks(vtkDataObject* object) const;

  using Names = std::map<std::string, std::string>;
  Names ArrayNames;
  Names BlockNames;
  std::string LongIntegers = "Keep";
  bool QuotesTexts = false;
};

#endif
