// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPolygonOFFReader
 * @brief Reads polygon meshes from OFF files of Geomview and many other programs.
 *
 * All keywords [ST][C][N][4][n]OFF are supported, in text and binary files, and deviations of
 * common programs. See Readers/PolygonOFF/README.md.
 *
 * Output: a vtkUnstructuredGrid. Points are double for text and float for binary files, in the unit
 * of the file, which the format does not state. Faces keep their order and orientation and become
 * VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON, or, with fewer vertices, VTK_LINE or VTK_VERTEX. A file
 * without faces gives one VTK_VERTEX per point. Normals become the point normals "Normals", texture
 * coordinates "TCoords", colors of vertices or faces unsigned char arrays "RGBA", indices into a
 * color map int arrays "ColorIndex" (-1 for none).
 *
 * In parallel every process scans the file and keeps its part of the cells, with the requested
 * ghost cells, "GlobalPointIds" and "GlobalCellIds".
 *
 * @sa vtkPolygonOFFWriter
 */
#ifndef vtkPolygonOFFReader_h
#define vtkPolygonOFFReader_h

#include "vtkMeshFileReader.h"

class CAMARONREADERS_EXPORT vtkPolygonOFFReader : public vtkMeshFileReader
{
public:
  static vtkPolygonOFFReader* New();
  vtkTypeMacro(vtkPolygonOFFReader, vtkMeshFileReader);

protected:
  vtkPolygonOFFReader();
  ~vtkPolygonOFFReader() override = default;

private:
  vtkPolygonOFFReader(const vtkPolygonOFFReader&) = delete;
  void operator=(const vtkPolygonOFFReader&) = delete;
};

#endif
