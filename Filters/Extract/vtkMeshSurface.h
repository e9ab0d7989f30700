// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshSurface
 * @brief Takes the outside of a mesh as polygons, fast also for polyhedra.
 *
 * Input: any vtkDataSet or composite of them. Output: vtkPolyData (of blocks: the same blocks of
 * them) with one polygon per face that has one 3D cell, plus the 2D cells, lines and vertices;
 * faces keep all their points (unless Triangulate is on) and run outward. Cell data are those of
 * the cell behind the face, point data those of the point; `vtkOriginalCellIds` and
 * `vtkOriginalPointIds` say which. Ghost cells are left out, and a face towards a ghost cell is not
 * outside. Nor is one that a cell of another process or of another partition of the block has, too
 * (see vtkElementQuality); no ghost cells are needed for that.
 *
 * Cost: the faces of the mesh are found once and shared with all filters (camaron::MeshTopology),
 * then well below a microsecond per cell.
 */
#ifndef vtkMeshSurface_h
#define vtkMeshSurface_h

#include "vtkDataObjectAlgorithm.h"

class vtkMeshSurface : public vtkDataObjectAlgorithm
{
public:
  static vtkMeshSurface* New();
  vtkTypeMacro(vtkMeshSurface, vtkDataObjectAlgorithm);

  ///@{
  /// Whether polygons are cut into triangles, also ones that touch themselves, which VTK cannot
  /// draw. Default: false.
  vtkSetMacro(Triangulate, bool);
  vtkGetMacro(Triangulate, bool);
  vtkBooleanMacro(Triangulate, bool);
  ///@}

protected:
  vtkMeshSurface() = default;
  ~vtkMeshSurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  bool Triangulate = false;

  vtkMeshSurface(const vtkMeshSurface&) = delete;
  void operator=(const vtkMeshSurface&) = delete;
};

#endif
