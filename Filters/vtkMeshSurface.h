// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshSurface
 * @brief Takes the outside of a mesh as polygons, fast also for polyhedra.
 *
 * Input: any vtkDataSet or composite of them. Output: vtkPolyData with one polygon per face that has one
 * 3D cell, plus the 2D cells, lines and vertices; faces keep all their points (they are not triangulated)
 * and run outward. Cell data are those of the cell behind the face, point data those of the point;
 * `vtkOriginalCellIds` and `vtkOriginalPointIds` say which. Ghost cells are left out, and a face towards
 * a ghost cell is not outside. Without ghost cells the border of a piece is outside.
 *
 * Cost: the faces of the mesh are found once and shared with all filters (camaron::MeshTopology), then
 * well below a microsecond per cell.
 */
#ifndef vtkMeshSurface_h
#define vtkMeshSurface_h

#include "vtkPolyDataAlgorithm.h"

class vtkMeshSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkMeshSurface* New();
  vtkTypeMacro(vtkMeshSurface, vtkPolyDataAlgorithm);

protected:
  vtkMeshSurface() = default;
  ~vtkMeshSurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMeshSurface(const vtkMeshSurface&) = delete;
  void operator=(const vtkMeshSurface&) = delete;
};

#endif
