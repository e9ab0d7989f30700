// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTetGenWriter
 * @brief Writes tetrahedra or triangles to TetGen and Triangle files.
 *
 * A mesh consists of several files with the same name: .node for points, .ele for elements, and
 * .face for triangles if there are tetrahedra, too. FileName may be any of them. Elements are
 * tetrahedra if there are any, else triangles; the latter are written in 2D if all z are 0. They
 * are quadratic if all are. UnsupportedCells determines the treatment of other cells. See
 * Readers/TetGen/README.md.
 *
 * Arrays with one component become attributes, which have no names. "BoundaryMarker" of points, and
 * of triangles in a .face file, becomes the marker.
 *
 * @sa vtkTetGenReader
 */
#ifndef vtkTetGenWriter_h
#define vtkTetGenWriter_h

#include "vtkCellMeshFileWriter.h"

class CAMARONREADERS_EXPORT vtkTetGenWriter : public vtkCellMeshFileWriter
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
   * Whether to write arrays with one component as attributes and markers. Default: on.
   */
  vtkSetMacro(WriteArrays, bool);
  vtkGetMacro(WriteArrays, bool);
  vtkBooleanMacro(WriteArrays, bool);
  ///@}

  ///@{
  /**
   * Whether to write the boundary of the tetrahedra, with marker 1, to a .face file if the mesh has
   * no triangles. Triangles are always written. Default: off.
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
