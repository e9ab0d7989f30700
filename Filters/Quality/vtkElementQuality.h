// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkElementQuality
 * @brief Evaluates quality criteria for every cell of a mesh.
 *
 * Input: any vtkDataSet or composite data set. Output: the same type with one cell array per
 * criterion, which has the name of the criterion. The vtkDataArray::UNITS_LABEL() of an array is
 * "deg", "rad" or "sr"; it is missing if values are in units of the mesh or have none. The worst
 * criterion (see WorstCriterion.h) becomes the active cell scalars, so ParaView colors by it
 * initially, unless no criterion has a value.
 *
 * Arrays are of type double, except CellStatus and CellTypeId, which are vtkIdTypeArrays;
 * CellStatus of points and lines is 0. Values are NaN where a criterion is undefined or does not
 * apply, and +infinity where it grows without bound. With WriteUndefinedMask, an unsigned char
 * array
 * `<Name>_Undefined` contains the reason: 0 the value is defined, 1 the criterion does not apply to
 * this shape, 2 degenerate, 3 invalid topology, 4 no neighbor, 5 unknown piece (the neighbor is in
 * another piece and has no ghost cell), 6 the value is that of the linear cell with the vertices of
 * a higher-order cell.
 *
 * Every cell is evaluated as the polygon or polyhedron that it is, so a hexahedron has the same
 * values as VTK_HEXAHEDRON and as VTK_POLYHEDRON. Triangle strips become triangles.
 *
 * Parallel: values do not depend on how the mesh is split. Criteria with neighbors find the cells
 * beyond the border of a piece, be it a process or a partition of a block, by the points of their
 * faces: by global ids if all points have them, else by equal coordinates. Ghost cells are neither
 * needed nor created, unless the pipeline uses more pieces than there are processes. Ghost cells of
 * the input also get values; those that depend on missing cells are undefined with reason 5.
 *
 * Cost: one pass over the cells for all criteria together. Criteria that are not chosen cost
 * nothing, nor do those that the output already has for the same mesh and options. Criteria with
 * neighbors also compare, once, the faces within the bounds of other pieces; the processes share
 * this work.
 */
#ifndef vtkElementQuality_h
#define vtkElementQuality_h

#include "vtkQualityAlgorithm.h"

#include "vtkDataArraySelection.h" // for the selection
#include "vtkNew.h"                // for the selection
#include "vtkSmartPointer.h"       // for arrays
#include "vtkStringArray.h"        // for names

#include <array>  // for numbers of points
#include <map>    // for arrays of criteria
#include <memory> // for evaluated arrays
#include <string> // for the preset
#include <vector> // for the chosen criteria

class vtkDoubleArray;
namespace camaron
{
class EvaluatedArrays;
class Reducer;
struct Criterion;
struct DataSetLeaf;
struct EvaluationOptions;
}

class vtkElementQuality : public vtkQualityAlgorithm
{
public:
  static vtkElementQuality* New();
  vtkTypeMacro(vtkElementQuality, vtkQualityAlgorithm);

  /// Value of Preset that means "the ticked criteria".
  static const char* TickedCriteria() { return "Ticked criteria"; }

  ///@{
  /// Criteria by name, with their ticks. By default the criteria of the preset "Overview" are
  /// ticked. To evaluate a certain set of criteria, clear all ticks and tick these.
  vtkDataArraySelection* GetCriteria() { return this->Criteria; }
  void ClearCriteria() { this->Criteria->DisableAllArrays(); }
  void SetCriterionStatus(const char* name, int status)
  {
    this->Criteria->SetArraySetting(name, status);
  }
  ///@}

  ///@{
  /// Preset whose criteria are evaluated instead of the ticked ones. Default: TickedCriteria().
  void SetPreset(const char* name);
  const char* GetPreset() const { return this->Preset.c_str(); }
  /// All valid values of Preset.
  vtkStringArray* GetPresetNames() { return this->PresetNames; }
  ///@}

  /// Estimated time in seconds to evaluate the chosen criteria for the present input on this
  /// process. 0 before the input has executed.
  double GetEstimatedSeconds();

  vtkMTimeType GetMTime() override;

protected:
  vtkElementQuality();
  ~vtkElementQuality() override;

  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkElementQuality(const vtkElementQuality&) = delete;
  void operator=(const vtkElementQuality&) = delete;

  void CountCorners();
  std::vector<std::string> GetChosenCriteria();
  bool NeedsNeighbors();
  bool FindCriteria(std::vector<const camaron::Criterion*>& criteria);
  camaron::EvaluationOptions GetOptions(
    const std::vector<const camaron::Criterion*>& criteria) const;
  /// For each criterion, by name, its arrays for all data sets.
  using ArraysOfCriteria = std::map<std::string, std::vector<vtkSmartPointer<vtkDoubleArray>>>;
  void Evaluate(const std::vector<camaron::DataSetLeaf>& leaves,
    const camaron::EvaluationOptions& options,
    const std::vector<const camaron::Criterion*>& criteria, int numberOfPieces,
    ArraysOfCriteria& arrays);
  void AddArrays(const std::vector<camaron::DataSetLeaf>& leaves,
    const std::vector<const camaron::Criterion*>& criteria, const ArraysOfCriteria& arrays,
    const camaron::EvaluationOptions& options);
  void EvaluateMesh(vtkDataObject* input, vtkDataObject* output,
    const std::vector<const camaron::Criterion*>& criteria, int numberOfPieces);

  vtkNew<vtkDataArraySelection> Criteria;
  const vtkSmartPointer<vtkStringArray> PresetNames;
  std::string Preset = TickedCriteria();
  std::unique_ptr<camaron::EvaluatedArrays> Known;
  /// Number of points in the lists of the polygons, the tetrahedra and the other polyhedra; see
  /// camaron::GroupCorners.
  std::array<double, 3> NumberOfCorners = {};
  ///@{
  /// The data to which they belong, and their time.
  const vtkDataObject* CountedInput = nullptr;
  vtkMTimeType CountedTime = 0;
  ///@}
};

#endif
