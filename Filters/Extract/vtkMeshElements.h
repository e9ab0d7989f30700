// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshElements
 * @brief Takes the faces, edges and vertices of a mesh as data sets of their own.
 *
 * Input: any vtkDataSet or composite of them. Outputs: vtkPolyData (of blocks: the same blocks of
 * them) of the faces of the 3D cells (port 0; of a surface its polygons), of the edges (port 1) and
 * of the vertices (port 2), each once, in an order that does not depend on the number of threads;
 * see camaron::MakeFaces, MakeEdges and MakeVertices. Points and their data are those of the mesh.
 * Cell arrays tell what belongs to what, what lies at the boundary, and the criteria of faces,
 * edges and vertices; output port 3 of vtkCriteriaTable lists them. Only those that are ticked are
 * computed, and only if the mesh has cells for which they mean something. Criteria of polygons are
 * evaluated for the faces by vtkElementQuality.
 *
 * Elements and their values are those of the undivided mesh, however it is split over processes and
 * partitions: cells of other pieces of the block are found by their points (global ids, or
 * coordinates) and need not be there as ghost cells. An element between pieces belongs to the one
 * whose cell has the smallest global id, or without ids to the first one; in the others it is
 * marked as a ghost. Blocks have nothing to do with each other unless they are connected.
 */
#ifndef vtkMeshElements_h
#define vtkMeshElements_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkNew.h" // for the selections

class vtkDataArraySelection;

class vtkMeshElements : public vtkDataObjectAlgorithm
{
public:
  static vtkMeshElements* New();
  vtkTypeMacro(vtkMeshElements, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Arrays of the faces by name with their ticks.
  vtkDataArraySelection* GetFaceArrays();
  void ClearFaceArrays();
  void SetFaceArrayStatus(const char* name, int status);
  ///@}

  ///@{
  /// Arrays of the edges by name with their ticks.
  vtkDataArraySelection* GetEdgeArrays();
  void ClearEdgeArrays();
  void SetEdgeArrayStatus(const char* name, int status);
  ///@}

  ///@{
  /// Arrays of the vertices by name with their ticks.
  vtkDataArraySelection* GetVertexArrays();
  void ClearVertexArrays();
  void SetVertexArrayStatus(const char* name, int status);
  ///@}

  ///@{
  /**
   * Whether vertices get "VertexWorst<Criterion>", the worst value of the cells around, for every
   * array of a criterion that the cells of the input have. Default: off.
   */
  vtkSetMacro(WorstOfCells, bool);
  vtkGetMacro(WorstOfCells, bool);
  vtkBooleanMacro(WorstOfCells, bool);
  ///@}

  ///@{
  /**
   * Distance up to which points coincide, for DuplicatePoint and FaceMismatch; 0 (default) for 8
   * rounding units of their coordinates.
   */
  vtkSetClampMacro(MergeTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  enum AngleUnitsType
  {
    DEGREES = 0,
    RADIANS = 1
  };
  ///@{
  /**
   * Unit of plane angles. Default: DEGREES.
   */
  vtkSetClampMacro(AngleUnits, int, DEGREES, RADIANS);
  vtkGetMacro(AngleUnits, int);
  ///@}

  ///@{
  /// Add a mask array per array of real numbers that tells why a value is null, as
  /// vtkElementQuality. Default: off.
  vtkSetMacro(WriteNullMask, bool);
  vtkGetMacro(WriteNullMask, bool);
  vtkBooleanMacro(WriteNullMask, bool);
  ///@}

  ///@{
  /// Take the faces of polyhedra as directed outward, as vtkElementQuality. Default: off.
  vtkSetMacro(TrustFaceOrientation, bool);
  vtkGetMacro(TrustFaceOrientation, bool);
  vtkBooleanMacro(TrustFaceOrientation, bool);
  ///@}

  ///@{
  /// Share of a cell's diameter up to which an edge counts as collapsed, as in vtkElementQuality.
  /// Default: 0.
  vtkSetClampMacro(DegeneracyTolerance, double, 0.0, 1.0);
  vtkGetMacro(DegeneracyTolerance, double);
  ///@}

  ///@{
  /**
   * Whether blocks are pieces of one mesh, so that faces between them have a cell on either side,
   * and cells are numbered through all blocks. Default: off.
   */
  vtkSetMacro(ConnectBlocks, bool);
  vtkGetMacro(ConnectBlocks, bool);
  vtkBooleanMacro(ConnectBlocks, bool);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkMeshElements();
  ~vtkMeshElements() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
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
  int AngleUnits = DEGREES;
  bool WriteNullMask = false;
  bool TrustFaceOrientation = false;
  double DegeneracyTolerance = 0;
  bool ConnectBlocks = false;
};

#endif
