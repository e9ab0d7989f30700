// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkQualityRegions
 * @brief Lists the connected regions of bad cells: places instead of single cells.
 *
 * Input: any vtkDataSet or composite data set with a cell array. Cells whose value is outside of
 * the range are bad; the properties of the range are those of vtkSelectElements. Bad cells of a
 * block that share a face, an edge or a vertex are in the same region, across all pieces of the
 * block. Ghost cells are ignored.
 *
 * Output: a vtkTable with one row per region, largest first; of equally large ones, the one with
 * the smallest id. Columns: `Rank`; `Count`, the number of cells; `WorstValue`, `WorstId` and
 * `IdSpace` of the worst cell (camaron::ElementBlocks); `X`, `Y`, `Z`, the mean of the positions of
 * the cells, where the position of a cell is the mean of its points; `Size`, the diagonal of the
 * bounding box of the points; with a cell array Volume, `Volume`, the sum of its magnitudes;
 * `Block`. The worst cell is the one nearest to the bad end of the criterion, or, if that is
 * unknown, farthest from the range; of equal ones, the one with the smallest id. The field data
 * array `NumberOfRegions` has the number of all regions, also of those that are not listed.
 *
 * Parallel: the table is complete on process 0, and empty with all columns on the others. Every
 * number is the same for any number of threads and processes.
 */
#ifndef vtkQualityRegions_h
#define vtkQualityRegions_h

#include "SelectionParameters.h"
#include "vtkTableAlgorithm.h"

#include "vtkSmartPointer.h" // for names
#include "vtkStringArray.h"  // for names

class vtkQualityRegions
  : public vtkTableAlgorithm
  , private camaron::SelectionParameters
{
public:
  static vtkQualityRegions* New();
  vtkTypeMacro(vtkQualityRegions, vtkTableAlgorithm);

  ///@{
  /// One-component cell array. Default: empty, the active scalars, else the first array.
  vtkSetStdStringFromCharMacro(Array);
  vtkGetCharFromStdStringMacro(Array);
  ///@}

  ///@{
  /// The range of good values, limits included: "Acceptable" (default), that of the criterion, or
  /// "Custom".
  vtkSetStdStringFromCharMacro(Range);
  vtkGetCharFromStdStringMacro(Range);
  ///@}

  ///@{
  /// Source of the acceptable range: "Default ranges" (default), or the name of a preset.
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
  /// Limits of the range "Custom" as text, finite numbers in the unit of the array. Default: empty,
  /// no limit.
  vtkSetStdStringFromCharMacro(LowerLimit);
  vtkGetCharFromStdStringMacro(LowerLimit);
  vtkSetStdStringFromCharMacro(UpperLimit);
  vtkGetCharFromStdStringMacro(UpperLimit);
  ///@}

  ///@{
  /// Undefined values (NaN) of cells to which the criterion and the range apply are bad, too.
  /// Default: off.
  vtkSetMacro(IncludeUndefined, bool);
  vtkGetMacro(IncludeUndefined, bool);
  ///@}

  ///@{
  /// What cells of a region share: a "Face" (2D cells: an edge), an "Edge" or a "Vertex" (default).
  vtkSetStdStringFromCharMacro(Adjacency);
  vtkGetCharFromStdStringMacro(Adjacency);
  ///@}

  ///@{
  /// Number of regions to list, the largest ones; 0: all. Default: 100.
  vtkSetMacro(NumberOfRegions, int);
  vtkGetMacro(NumberOfRegions, int);
  ///@}

protected:
  vtkQualityRegions();
  ~vtkQualityRegions() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkQualityRegions(const vtkQualityRegions&) = delete;
  void operator=(const vtkQualityRegions&) = delete;

  const vtkSmartPointer<vtkStringArray> PresetNames;
  bool IncludeUndefined = false;
  int NumberOfRegions = 100;
};

#endif
