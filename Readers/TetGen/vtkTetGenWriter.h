// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTetGenWriter
 * @brief Writes tetrahedra or triangles to files of TetGen and Triangle.
 *
 * A mesh is several files of one name: .node with the points, .ele with the elements, and .face
 * with triangles beside tetrahedra. The name of the file may be that of any of them. Elements are
 * tetrahedra if there are any, else triangles, in two dimensions if all z are 0; of second order if
 * all are. Other cells become what UnsupportedCells says. See Readers/TetGen/README.md.
 *
 * Arrays of one component become attributes, which have no names; "BoundaryMarker" of points and of
 * triangles beside tetrahedra becomes the marker.
 *
 * @sa vtkTetGenReader
 */
#ifndef vtkTetGenWriter_h
#define vtkTetGenWriter_h

#include "vtkCellMeshFileWriter.h"

class CAMARONFORMATS_EXPORT vtkTetGenWriter : public vtkCellMeshFileWriter
{
public:
  static vtkTetGenWriter* New();
  vtkTypeMacro(vtkTetGenWriter, vtkCellMeshFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The first id of points and elements, 0 or 1. Default: 0.
   */
  vtkSetClampMacro(FirstId, int, 0, 1);
  vtkGetMacro(FirstId, int);
  ///@}

  ///@{
  /**
   * Whether to write arrays of one component as attributes and markers. Default: on.
   */
  vtkSetMacro(WriteArrays, bool);
  vtkGetMacro(WriteArrays, bool);
  vtkBooleanMacro(WriteArrays, bool);
  ///@}

  ///@{
  /**
   * Whether to write the boundary of tetrahedra, with marker 1, to a .face file if the mesh has no
   * triangles, which are always written. Default: off.
   */
  vtkSetMacro(WriteBoundaryFaces, bool);
  vtkGetMacro(WriteBoundaryFaces, bool);
  vtkBooleanMacro(WriteBoundaryFaces, bool);
  ///@}

protected:
  vtkTetGenWriter() = default;
  ~vtkTetGenWriter() override = default;

  bool WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) override;

private:
  vtkTetGenWriter(const vtkTetGenWriter&) = delete;
  void operator=(const vtkTetGenWriter&) = delete;

  int FirstId = 0;
  bool WriteArrays = true;
  bool WriteBoundaryFaces = false;
};

#endif
