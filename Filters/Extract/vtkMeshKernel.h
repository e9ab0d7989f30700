// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshKernel
 * @brief Makes the kernels of cells, or of a closed surface, as cells.
 *
 * The kernel of a shape is the set of points that see all of it: a convex cell itself, a part of
 * other cells, nothing of those that are not star-shaped.
 *
 * Input: any vtkDataSet or composite of them. Output: a vtkUnstructuredGrid of VTK_POLYHEDRON and
 * VTK_POLYGON cells, each with points of its own.
 *
 * - Of each cell: cell arrays "SourceCell" and "KernelRatio" and those of the mesh (of blocks those
 * that all blocks have), field array "CellsWithoutKernel"; see camaron::MakeKernelCells. Of a
 * composite input "SourceBlock" and "BlocksWithoutKernel" tell the blocks of these cells by VTK's
 * flat index on the process. On every process the kernels of its own cells.
 * - Of the whole surface: what all polygons of all blocks and processes enclose is one shape. Its
 *   polygons are gathered on the first process, which has the result: the same for any number of
 *   processes, to the last bit. Polygons may run either way round if they hang together.
 *
 * A warning says how many cells have no kernel, or that the surface has none. A surface that is not
 * closed is an error where it was asked for as a whole.
 */
#ifndef vtkMeshKernel_h
#define vtkMeshKernel_h

#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // for a member

namespace camaron
{
class ElementBlocks;
}

class vtkMeshKernel : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkMeshKernel* New();
  vtkTypeMacro(vtkMeshKernel, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum KernelOfType
  {
    AUTOMATIC = 0, ///< the whole surface if all data are vtkPolyData and closed, else each cell
    EACH_CELL = 1,
    WHOLE_SURFACE = 2
  };
  ///@{
  /**
   * What has a kernel. Default: AUTOMATIC.
   */
  vtkSetClampMacro(KernelOf, int, AUTOMATIC, WHOLE_SURFACE);
  vtkGetMacro(KernelOf, int);
  ///@}

  ///@{
  /**
   * Cell array with one component: only cells in which it is not 0 get a kernel. Empty or "All
   * cells" for all. Default: "All cells". Not for the whole surface.
   */
  vtkSetStdStringFromCharMacro(ChosenBy);
  vtkGetCharFromStdStringMacro(ChosenBy);
  ///@}

  ///@{
  /// As of vtkElementQuality, whose KernelRatio is the same with the same of these; not for the
  /// whole surface.
  vtkSetMacro(TrustFaceOrientation, bool);
  vtkGetMacro(TrustFaceOrientation, bool);
  vtkBooleanMacro(TrustFaceOrientation, bool);
  vtkSetMacro(DegeneracyTolerance, double);
  vtkGetMacro(DegeneracyTolerance, double);
  ///@}

protected:
  vtkMeshKernel() = default;
  ~vtkMeshKernel() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMeshKernel(const vtkMeshKernel&) = delete;
  void operator=(const vtkMeshKernel&) = delete;

  bool GoesOn(double done);
  int MakeOfSurface(const camaron::ElementBlocks& blocks, vtkUnstructuredGrid* output);
  void MakeOfCells(const camaron::ElementBlocks& blocks, vtkUnstructuredGrid* output);

  int KernelOf = AUTOMATIC;
  std::string ChosenBy = "All cells";
  bool TrustFaceOrientation = false;
  double DegeneracyTolerance = 0;
};

#endif
