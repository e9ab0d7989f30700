// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshKernel
 * @brief Computes the kernels of cells, or of a closed surface, as cells.
 *
 * The kernel of a shape is the set of points that see the whole shape: all of a convex cell, a part
 * of a star-shaped cell, and nothing of other cells.
 *
 * Input: any vtkDataSet or composite data set. Output: a vtkUnstructuredGrid of VTK_POLYHEDRON and
 * VTK_POLYGON cells, each with its own points.
 *
 * - Each cell: the output has the cell arrays "SourceCell" and "KernelRatio" and those of the mesh
 *   (of composite data: those that all blocks have), and the field array "CellsWithoutKernel"; see
 *   camaron::MakeKernelCells. For composite input, "SourceBlock" and "BlocksWithoutKernel" contain
 *   the blocks of these cells as VTK's flat index on the process. Every process has the kernels of
 *   its own cells.
 * - Whole surface: all polygons of all blocks and processes together enclose one shape. They are
 *   gathered on the first process, which computes the kernel; the result is the same, to the last
 *   bit, for any number of processes. The orientation of polygons does not matter if they are
 *   connected.
 *
 * A warning reports how many cells have no kernel, or that the surface has none. A surface that is
 * not closed is an error if KernelOf is WHOLE_SURFACE.
 *
 * For the same TrustFaceOrientation and DegeneracyTolerance, KernelRatio of a cell is that of
 * vtkElementQuality. The whole surface depends on no option.
 */
#ifndef vtkMeshKernel_h
#define vtkMeshKernel_h

#include "vtkQualityAlgorithm.h"

#include <string> // for a member

namespace camaron
{
class ElementBlocks;
struct EvaluationOptions;
}

class vtkUnstructuredGrid;

class vtkMeshKernel : public vtkQualityAlgorithm
{
public:
  static vtkMeshKernel* New();
  vtkTypeMacro(vtkMeshKernel, vtkQualityAlgorithm);

  /// Values of KernelOf.
  enum KernelOfType
  {
    AUTOMATIC = 0, ///< the whole surface if all data are vtkPolyData and closed, else each cell
    EACH_CELL = 1,
    WHOLE_SURFACE = 2
  };
  /// Shapes whose kernels are computed. Default: AUTOMATIC.
  vtkSetClampMacro(KernelOf, int, AUTOMATIC, WHOLE_SURFACE);

  /// One-component cell array: only cells with a value other than 0 get a kernel. Empty or "All
  /// cells" (default): all cells. Ignored for the whole surface.
  vtkSetStdStringFromCharMacro(ChosenBy);

protected:
  vtkMeshKernel() = default;
  ~vtkMeshKernel() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMeshKernel(const vtkMeshKernel&) = delete;
  void operator=(const vtkMeshKernel&) = delete;

  bool GoesOn(double done);
  int MakeOfSurface(const camaron::ElementBlocks& blocks, vtkUnstructuredGrid* output);
  void MakeOfCells(const camaron::ElementBlocks& blocks, const camaron::EvaluationOptions& options,
    vtkUnstructuredGrid* output);

  int KernelOf = AUTOMATIC;
  std::string ChosenBy = "All cells";
};

#endif
