// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshElements
 * @brief Takes the faces, edges and vertices of a mesh as data sets of their own.
 *
 * Input: any vtkDataSet or composite of them. Outputs: vtkPolyData of the faces of the 3D cells (port 0;
 * of a surface its polygons), of the edges (port 1) and of the vertices (port 2), each once, in an order
 * that does not depend on the number of threads. Arrays tell what belongs to what, what lies at the
 * boundary, and the criteria of faces between two cells; see camaron::MakeFaces, MakeEdges and
 * MakeVertices. Points and their data are those of the mesh. Criteria of polygons are evaluated for the faces
 * by vtkElementQuality.
 *
 * In parallel one level of ghost cells is asked for; elements that belong to another process are marked
 * as ghosts.
 */
#ifndef vtkMeshElements_h
#define vtkMeshElements_h

#include "vtkPolyDataAlgorithm.h"

class vtkMeshElements : public vtkPolyDataAlgorithm
{
public:
  static vtkMeshElements* New();
  vtkTypeMacro(vtkMeshElements, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether faces get the finite-volume criteria of the cells on both sides. Default: on.
   */
  vtkSetMacro(FaceCriteria, bool);
  vtkGetMacro(FaceCriteria, bool);
  vtkBooleanMacro(FaceCriteria, bool);
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

protected:
  vtkMeshElements();
  ~vtkMeshElements() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMeshElements(const vtkMeshElements&) = delete;
  void operator=(const vtkMeshElements&) = delete;

  bool FaceCriteria = true;
  int AngleUnits = DEGREES;
};

#endif
