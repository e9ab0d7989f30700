// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTRIReader
 * @brief Reads triangle meshes from TRI files of Camarón and Cart3D.
 *
 * A TRI file of Camarón is text: the number of vertices, their coordinates, the number of
 * triangles, and their vertices, counted from 0. Cart3D files may be binary; they begin with both
 * numbers and count vertices from 1. See Readers/TRI/README.md.
 *
 * Output: a vtkUnstructuredGrid with double coordinates (float if a binary file stores floats) in
 * the unit of the file, which the format does not state. Cells are VTK_TRIANGLE in the order and
 * orientation of the file; a file with vertices only gives one VTK_VERTEX each. Components of
 * Cart3D become the cell array "Component", scalars the point array "Scalars".
 *
 * In parallel every process scans the file and keeps its part of the cells, with the requested
 * ghost cells, "GlobalPointIds" and "GlobalCellIds".
 *
 * @sa vtkTRIWriter
 */
#ifndef vtkTRIReader_h
#define vtkTRIReader_h

#include "vtkMeshFileReader.h"

class CAMARONREADERS_EXPORT vtkTRIReader : public vtkMeshFileReader
{
public:
  static vtkTRIReader* New();
  vtkTypeMacro(vtkTRIReader, vtkMeshFileReader);

protected:
  vtkTRIReader();
  ~vtkTRIReader() override = default;

private:
  vtkTRIReader(const vtkTRIReader&) = delete;
  void operator=(const vtkTRIReader&) = delete;
};

#endif
