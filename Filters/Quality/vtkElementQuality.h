// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkElementQuality
 * @brief Evaluates quality criteria for every cell of a mesh.
 *
 * Input: any vtkDataSet or composite of them. Output: the same type with one cell array per
 * criterion, named like it, whose vtkDataArray::UNITS_LABEL() is "deg", "rad" or "sr", or not there
 * (units of the mesh); the worst one, see WorstCriterion.h, becomes the active cell scalars, by
 * which the mesh is colored at first, unless none has a value. The arrays are of double, but those
 * of CellStatus and CellTypeId of vtkIdType, with CellStatus 0 for points and lines. Where a
 * criterion has no meaning or is undefined the value is NaN; where it grows without bound,
 * +infinity. With WriteNullMask an unsigned char array
 * `<Name>_Null` tells why: 0 value, 1 not applicable to this shape, 2 degenerate, 3 invalid
 * topology, 4 no neighbor, 5 neighbor's piece unknown, 6 value of the corners of a higher-order
 * cell.
 *
 * Every cell is evaluated as the polygon or polyhedron that it is, so a hexahedron has the same
 * values whether it is a VTK_HEXAHEDRON or a VTK_POLYHEDRON. Triangle strips become triangles.
 *
 * Parallel: the values do not depend on how the mesh is split. At the borders of pieces, which may
 * be processes or partitions of one block, criteria with neighbors find the cells of other pieces
 * by the points of their faces: by global ids if all points have them, else by equal coordinates.
 * No ghost cells are needed or made for that, unless the pipeline works in more pieces than there
 * are processes. Those of the input get values, too; where these depend on cells that are not there
 * they are null with reason 5.
 *
 * Cost: one pass over the cells for all criteria together; nothing is computed for those not
 * chosen, nor for those that the output has already of the same mesh and options. Criteria with
 * neighbors compare the faces within the boxes of other pieces once, shared out among the
 * processes.
 */
#ifndef vtkElementQuality_h
#define vtkElementQuality_h

#include "vtkNew.h" // for the selection
#include "vtkPassInputTypeAlgorithm.h"

#include "vtkSmartPointer.h" // for arrays

#include <array>  // for the corners
#include <map>    // for arrays of criteria
#include <memory> // for what is known
#include <string> // for the preset
#include <vector> // for the chosen criteria

class vtkDataArraySelection;
class vtkDoubleArray;
class vtkStringArray;
namespace camaron
{
class EvaluatedArrays;
class Reducer;
struct Criterion;
struct DataSetLeaf;
struct EvaluationOptions;
}

class vtkElementQuality : public vtkPassInputTypeAlgorithm
{
public:
  static vtkElementQuality* New();
  vtkTypeMacro(vtkElementQuality, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum AngleUnitsType
  {
    DEGREES = 0,
    RADIANS = 1
  };

  /// Preset name that stands for "the criteria that are ticked".
  static const char* TickedCriteria() { return "Ticked criteria"; }

  ///@{
  /**
   * Criteria by name with their ticks; by default those of the preset "Overview" are ticked. To
   * evaluate exactly some criteria, clear all ticks and tick those.
   */
  vtkDataArraySelection* GetCriteria();
  void ClearCriteria();
  void SetCriterionStatus(const char* name, int status);
  ///@}

  ///@{
  /// Name of a preset whose criteria are evaluated instead of the ticked ones. Default:
  /// TickedCriteria.
  void SetPreset(const char* name);
  const char* GetPreset() const { return this->Preset.c_str(); }
  /// The choices for Preset.
  vtkStringArray* GetPresetNames();
  ///@}

  ///@{
  /// Unit of plane angles, DEGREES (default) or RADIANS. Solid angles are in steradian always.
  vtkSetClampMacro(AngleUnits, int, DEGREES, RADIANS);
  vtkGetMacro(AngleUnits, int);
  ///@}

  ///@{
  /// Add a mask array per criterion that tells why a value is null. Default: off.
  vtkSetMacro(WriteNullMask, bool);
  vtkGetMacro(WriteNullMask, bool);
  vtkBooleanMacro(WriteNullMask, bool);
  ///@}

  ///@{
  /**
   * Take the faces of polyhedra as they are: directed outward, so that an inverted one has a
   * negative volume. Off (default): make them consistent and outward first, as files are careless
   * about it.
   */
  vtkSetMacro(TrustFaceOrientation, bool);
  vtkGetMacro(TrustFaceOrientation, bool);
  vtkBooleanMacro(TrustFaceOrientation, bool);
  ///@}

  ///@{
  /**
   * An edge shorter than this share of the cell's diameter counts as collapsed, faces and cells
   * accordingly. 0 (default): the larger of 1e-12 and 8 rounding units of double precision.
   */
  vtkSetMacro(DegeneracyTolerance, double);
  vtkGetMacro(DegeneracyTolerance, double);
  ///@}

  ///@{
  /**
   * How far an angle may exceed 180 degrees in a cell that CellStatus and IsConvex take as convex,
   * in degrees whatever AngleUnits says. Default: 1e-4.
   */
  vtkSetMacro(ConvexityTolerance, double);
  vtkGetMacro(ConvexityTolerance, double);
  ///@}

  ///@{
  /**
   * Largest warpage (see MaxWarpage) of a face that CellStatus takes as planar. Default: 0.1.
   */
  vtkSetMacro(PlanarityTolerance, double);
  vtkGetMacro(PlanarityTolerance, double);
  ///@}

  ///@{
  /**
   * Of the input that is there now, on this process: how many points the lists of its polygons, its
   * tetrahedra and its other polyhedra have (see camaron::GroupCorners), and how many threads would
   * work on them. 0 before the input has run.
   */
  double* GetNumberOfCorners() VTK_SIZEHINT(3);
  int GetNumberOfThreads();
  ///@}

  /// About how many seconds the chosen criteria will take for the input that is there now.
  double GetEstimatedSeconds();

  ///@{
  /**
   * Whether cells of different blocks are neighbors where their faces have the same points: by
   * global ids if all points have them, else by equal coordinates. Partitions of one block always
   * are. Default: off.
   */
  vtkSetMacro(ConnectBlocks, bool);
  vtkGetMacro(ConnectBlocks, bool);
  vtkBooleanMacro(ConnectBlocks, bool);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkElementQuality();
  ~vtkElementQuality() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkElementQuality(const vtkElementQuality&) = delete;
  void operator=(const vtkElementQuality&) = delete;

  std::vector<std::string> GetChosenCriteria();
  bool NeedsNeighbors();
  bool FindCriteria(std::vector<const camaron::Criterion*>& criteria);
  camaron::EvaluationOptions GetOptions(
    const std::vector<const camaron::Criterion*>& criteria) const;
  /// Collective. False where some process was stopped, or is not finished.
  bool GoOn(double progress, camaron::Reducer& reducer, bool isFinished = true);
  /// Of each criterion by its name those of all data sets.
  using ArraysOfCriteria = std::map<std::string, std::vector<vtkSmartPointer<vtkDoubleArray>>>;
  /// False if it was stopped.
  bool Evaluate(const std::vector<camaron::DataSetLeaf>& leaves,
    const camaron::EvaluationOptions& options,
    const std::vector<const camaron::Criterion*>& criteria, int numberOfPieces,
    ArraysOfCriteria& arrays);
  void AddArrays(const std::vector<camaron::DataSetLeaf>& leaves,
    const std::vector<const camaron::Criterion*>& criteria, const ArraysOfCriteria& arrays,
    const camaron::EvaluationOptions& options);
  void EvaluateMesh(vtkDataObject* input, vtkDataObject* output,
    const std::vector<const camaron::Criterion*>& criteria, int numberOfPieces);

  vtkNew<vtkDataArraySelection> Criteria;
  vtkSmartPointer<vtkStringArray> PresetNames;
  std::string Preset = TickedCriteria();
  int AngleUnits = DEGREES;
  bool WriteNullMask = false;
  bool TrustFaceOrientation = false;
  double DegeneracyTolerance = 0;
  double ConvexityTolerance = 1e-4;
  double PlanarityTolerance = 0.1;
  bool ConnectBlocks = false;
  std::unique_ptr<camaron::EvaluatedArrays> Known;
  std::array<double, 3> NumberOfCorners = {};
};

#endif
