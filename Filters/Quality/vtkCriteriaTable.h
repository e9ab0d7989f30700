// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCriteriaTable
 * @brief Lists all quality criteria, presets, arrays of elements and bits of CellStatus, with their
 * documentation.
 *
 * No input. Outputs, each a vtkTable that is complete on process 0 and empty on the others:
 * 0. criteria in display order: "Name", "Label", "Description", "Unit" ("deg", "sr" or empty),
 *    "Dimension" ("Length", "Area", "Volume" or empty), "AppliesTo", "RangeLow", "RangeHigh",
 *    "Ideal" (NaN if none), "Better" ("Smaller", "Neither" or "Bigger"), "AcceptableLow",
 *    "AcceptableHigh" (infinite at an open end), "AcceptableSource", "AcceptableIsHint",
 *    "AcceptableFor" (shapes), "IsCurved" (1 if it follows curved cells), "Family", and for the
 * documentation "Formula", "Degenerate", "Curved", "Agreement", and "Consequence" (the effect of
 * cells outside the range)
 * 1. rules of the presets: "Preset", "Description", "Criterion", "AcceptableLow", "AcceptableHigh",
 *    "AcceptableIsHint", "AcceptableFor", "Rule" (a line for vtkCheckQuality; empty without limits)
 * 2. ranges of Ranges and RangesFile: "Criterion", "AcceptableLow", "AcceptableHigh"
 * 3. arrays of vtkMeshElements: "Element" ("Face", "Edge" or "Vertex"), the columns of output 0
 * (the range of values is infinite where it is unknown), "Cells" (dimension of the cells that the
 * mesh must have: "2D", "3D" or both), "IsDefault"
 * 4. bits of the criterion CellStatus: "Bit" (its value), "Name" (for StatusBits of
 *    vtkSelectElements), "Description", "Invalid" (1 if cells with this bit are not valid)
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

  ///@{
  /// File of acceptable ranges (Core/Rules/ParsedRules.h) for output 2. Default: empty, no file.
  vtkSetStdStringFromCharMacro(RangesFile);
  vtkGetCharFromStdStringMacro(RangesFile);
  ///@}

  ///@{
  /// Lines as of RangesFile, which come first in output 2. Default: empty.
  vtkSetStdStringFromCharMacro(Ranges);
  vtkGetCharFromStdStringMacro(Ranges);
  ///@}

protected:
  vtkCriteriaTable();
  ~vtkCriteriaTable() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCriteriaTable(const vtkCriteriaTable&) = delete;
  void operator=(const vtkCriteriaTable&) = delete;

  std::string RangesFile;
  std::string Ranges;
};

#endif
