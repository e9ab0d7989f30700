// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTSReader
 * @brief Reads tetrahedra of Camarón or surfaces of GOCAD from TS files.
 *
 * A TS file of Camarón is text: the numbers of vertices and tetrahedra, the coordinates of the
 * vertices, and the vertices of the tetrahedra, counted from 0. A TSurf of GOCAD is text with a
 * keyword on every line. See Readers/TS/README.md.
 *
 * Output: a vtkUnstructuredGrid with double coordinates in the unit of the file. Cells are
 * VTK_TETRA or VTK_TRIANGLE in the order and orientation of the file; a file with vertices only
 * gives one VTK_VERTEX each. A TSurf adds the cell arrays "Part" and "TFace", a point array for
 * each property, "OriginalPointId", and field data "PartName", "ZPositive" and "AxisUnit" with a
 * value per part.
 *
 * In parallel every process scans the file and keeps its part of the cells, with the requested
 * ghost cells, "GlobalPointIds" and "GlobalCellIds".
 *
 * @sa vtkTSWriter
 */
#ifndef vtkTSReader_h
#define vtkTSReader_h

#include "vtkMeshFileReader.h"

class CAMARONREADERS_EXPORT vtkTSReader : public vtkMeshFileReader
{
public:
  static vtkTSReader* New();
  vtkTypeMacro(vtkTSReader, vtkMeshFileReader);

protected:
  vtkTSReader();
  ~vtkTSReader() override = default;

private:
  vtkTSReader(const vtkTSReader&) = delete;
  void operator=(const vtkTSReader&) = delete;
};

#endif
