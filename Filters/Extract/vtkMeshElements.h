// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshElements
 * @brief Extracts the faces, edges and vertices of a mesh as data sets.
 *
 * Input: any vtkDataSet or composite data set. Outputs, each a vtkPolyData or a composite of them
 * with the blocks of the input:
 * 0. faces of the 3D cells; for surface meshes, their polygons
 * 1. edges
 * 2. vertices
 *
 * Every element appears once, in an order that does not depend on the number of threads; see
 * camaron::MakeFaces, MakeEdges and MakeVertices. Points and point data are those of the mesh. Cell
 * arrays contain the incidence between elements and cells, boundary flags, and criteria of faces,
 * edges and vertices; output 3 of vtkCriteriaTable lists them. Only the ticked arrays are computed,
 * and only if the mesh has cells to which they apply. To evaluate criteria of polygons for the
 * faces, apply vtkElementQuality to output 0.
 *
 * Elements and their values are those of the undivided mesh, however it is split into processes and
 * partitions. Cells of other pieces of the block are found by their points (global ids, else
 * coordinates); ghost cells are not needed. An element between pieces belongs to the piece with the
 * smallest global cell id or, without global ids, to the first piece; in the others it is marked as
 * a ghost. If there are several pieces, the faces have global ids, and so have edges and vertices
 * if all points of the mesh have some: their numbers in the undivided mesh, through all blocks.
 * Blocks are independent unless they are connected.
 */
#ifndef vtkMeshElements_h
#define vtkMeshElements_h

#include "vtkQualityAlgorithm.h"

#include "vtkDataArraySelection.h" // for the selections
#include "vtkNew.h"                // for the selections

class vtkMeshElements : public vtkQualityAlgorithm
{
public:
  static vtkMeshElements* New();
  vtkTypeMacro(vtkMeshElements, vtkQualityAlgorithm);

  ///@{
  /// Arrays of the faces, by name, with their ticks.
  vtkDataArraySelection* GetFaceArrays() { return this->FaceArrays; }
  void ClearFaceArrays() { this->FaceArrays->DisableAllArrays(); }
  void SetFaceArrayStatus(const char* name, int status)
  {
    this->FaceArrays->SetArraySetting(name, status);
  }
  ///@}

  ///@{
  /// Arrays of the edges, by name, with their ticks.
  vtkDataArraySelection* GetEdgeArrays() { return this->EdgeArrays; }
  void ClearEdgeArrays() { this->EdgeArrays->DisableAllArrays(); }
  void SetEdgeArrayStatus(const char* name, int status)
  {
    this->EdgeArrays->SetArraySetting(name, status);
  }
  ///@}

  ///@{
  /// Arrays of the vertices, by name, with their ticks.
  vtkDataArraySelection* GetVertexArrays() { return this->VertexArrays; }
  void ClearVertexArrays() { this->VertexArrays->DisableAllArrays(); }
  void SetVertexArrayStatus(const char* name, int status)
  {
    this->VertexArrays->SetArraySetting(name, status);
  }
  ///@}

  /// Add to the vertices an array "VertexWorst<Criterion>" for each criterion of which the cells of
  /// the input have an array: the worst value of the cells at the vertex. Default: off.
  vtkSetMacro(WorstOfCells, bool);

  /// Distance up to which points coincide, for DuplicatePoint and FaceMismatch, in the unit of
  /// coordinates. 0 (default): 8 times the machine epsilon of the coordinates.
  vtkSetClampMacro(MergeTolerance, double, 0.0, VTK_DOUBLE_MAX);

  vtkMTimeType GetMTime() override;

protected:
  vtkMeshElements();
  ~vtkMeshElements() override = default;

  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  void TakeElements(vtkDataObject* input, vtkInformationVector* outputs);

  vtkMeshElements(const vtkMeshElements&) = delete;
  void operator=(const vtkMeshElements&) = delete;

  vtkNew<vtkDataArraySelection> FaceArrays, EdgeArrays, VertexArrays;
  bool WorstOfCells = false;
  double MergeTolerance = 0;
};

#endif
