// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRenameData
 * @brief Gives arrays, their components and blocks other names, and integers another type, for
 * writers that cannot write these.
 *
 * Output: a shallow copy of the input, of the same type. Unlike ParaView's Rename Arrays it takes
 * names of any bytes.
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
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Names of arrays and components, and what they become. Default: none, all keep theirs.
  void AddArrayName(const char* from, const char* to);
  void RemoveArrayNames();
  ///@}
  ///@{
  /// The same of blocks.
  void AddBlockName(const char* from, const char* to);
  void RemoveBlockNames();
  ///@}

  ///@{
  /**
   * What becomes of arrays of integers of 64 bits that have values beyond 32 bits: "Keep"
   * (default); "Int64", where those of vtkIdType become vtkTypeInt64Array, which writers of legacy
   * files do not cut to 32 bits; or "Double".
   */
  void SetLongIntegers(const char* choice);
  const char* GetLongIntegers() const { return this->LongIntegers.c_str(); }
  ///@}

protected:
  vtkRenameData() = default;
  ~vtkRenameData() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkRenameData(const vtkRenameData&) = delete;
  void operator=(const vtkRenameData&) = delete;

  vtkSmartPointer<vtkAbstractArray> Rename(vtkAbstractArray* array) const;
  vtkSmartPointer<vtkAbstractArray> Retype(vtkAbstractArray* array) const;
  void RenameArrays(vtkDataObject* object) const;
  void RenameFields(vtkFieldData* fields) const;
  void RenameBlocks(vtkDataObject* object) const;

  using Names = std::map<std::string, std::string>;
  Names ArrayNames;
  Names BlockNames;
  std::string LongIntegers = "Keep";
};

#endif
