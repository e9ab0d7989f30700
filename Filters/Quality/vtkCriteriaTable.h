// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCriteriaTable
 * @brief Lists all quality criteria, presets and arrays of elements with what is known about them.
 *
 * No input. Outputs, each a vtkTable, complete on process 0 and empty on the others:
 * 0. criteria, in the order in which people see them: "Name", "Label", "Description", "Unit"
 * ("deg", "sr" or empty), "Dimension" ("Length", "Area", "Volume" or empty), "AppliesTo",
 * "RangeLow", "RangeHigh", "Ideal" (NaN if none), "Better" ("Smaller", "Neither" or "Bigger"),
 * "AcceptableLow", "AcceptableHigh" (infinite at an open end), "AcceptableSource",
 * "AcceptableIsHint", "AcceptableFor" (shapes), "Family", and for the documentation "Formula",
 * "Degenerate" and "Agreement", and "Consequence": what cells outside the range do;
 * 1. rules of the presets: "Preset", "Description", "Criterion", "AcceptableLow", "AcceptableHigh",
 *    "AcceptableIsHint", "AcceptableFor";
 * 2. ranges of a file: "Criterion", "AcceptableLow", "AcceptableHigh";
 * 3. arrays of vtkMeshElements: "Element" ("Face", "Edge" or "Vertex"), "Name", "Description",
 * "Unit", "Cells" ("2D", "3D" or both: of which dimension the mesh must have cells), "IsDefault".
 */
#ifndef vtkCriteriaTable_h
#define vtkCriteriaTable_h

#include "vtkTableAlgorithm.h"

#include <string> // for the file

class vtkCriteriaTable : public vtkTableAlgorithm
{
public:
  static vtkCriteriaTable* New();
  vtkTypeMacro(vtkCriteriaTable, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// File of acceptable ranges (Core/Criteria/RangesFile.h) to list. Default: empty, none.
  vtkSetStdStringFromCharMacro(RangesFile);
  vtkGetCharFromStdStringMacro(RangesFile);
  ///@}

protected:
  vtkCriteriaTable();
  ~vtkCriteriaTable() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCriteriaTable(const vtkCriteriaTable&) = delete;
  void operator=(const vtkCriteriaTable&) = delete;

  std::string RangesFile;
};

#endif
