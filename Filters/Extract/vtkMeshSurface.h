// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshSurface
 * @brief Extracts the surface of a mesh as polygons; also fast for polyhedra.
 *
 * Input: any vtkDataSet or composite data set. Output: a vtkPolyData, or a composite of them with
 * the blocks of the input, with one polygon per face that belongs to a single 3D cell, plus the 2D
 * cells, lines and vertices. Faces point outward and keep all their points unless Triangulate is
 * on. Cell data are those of the cell behind the face, point data those of the point;
 * `vtkOriginalCellIds` and `vtkOriginalPointIds` contain their ids.
 *
 * Ghost cells are skipped. Faces between a cell and a ghost cell, or a cell of another process or
 * another partition of the block, are not on the surface (see vtkElementQuality); ghost cells are
 * not needed for that.
 *
 * Cost: the faces of the mesh are computed once and shared by all filters (camaron::MeshTopology);
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

  /// Split polygons into triangles, including those that touch themselves, which VTK cannot draw.
  /// Default: off.
  vtkSetMacro(Triangulate, bool);

  /// Add the arrays vtkOriginalCellIds and vtkOriginalPointIds, the places of the cell and the
  /// point in the mesh. Default: on.
  vtkSetMacro(PassThroughIds, bool);

  /// Add the array CellShapes: for each face the shape of its cell, by which Mesh Inspection tells
  /// cells apart to which the acceptable range of a criterion does not apply. Default: off.
  vtkSetMacro(PassThroughShapes, bool);

protected:
  vtkMeshSurface() = default;
  ~vtkMeshSurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  bool Triangulate = false;
  bool PassThroughIds = true;
  bool PassThroughShapes = false;

  vtkMeshSurface(const vtkMeshSurface&) = delete;
  void operator=(const vtkMeshSurface&) = delete;
};

#endif
