// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPolygonPLYReader
 * @brief Reads points, polygons, strips, edges and polyhedra with all their arrays from PLY files.
 *
 * A PLY file (polygon file format, Stanford) declares elements and their properties in a header;
 * their values follow as text, or as binary in either byte order. See
 * Readers/PolygonPLY/README.md.
 *
 * Output: a vtkUnstructuredGrid. Coordinates are float, or double if the file has double or 32-bit
 * integers, in the unit of the file, which the format does not state. Faces become VTK_TRIANGLE,
 * VTK_QUAD or VTK_POLYGON, strips VTK_TRIANGLE, edges VTK_LINE; a file with vertices only gives one
 * VTK_VERTEX each. Cells given by faces become tetrahedra, pyramids, wedges or hexahedra if they
 * match, else VTK_POLYHEDRON. Normals, texture coordinates, and colors ("RGB", "RGBA") become
 * arrays with several components, every other property an array of its name and type.
 *
 * In parallel every process scans the file and keeps its part of the cells, with the requested
 * ghost cells, "GlobalPointIds" and "GlobalCellIds".
 *
 * @sa vtkPolygonPLYWriter
 */
#ifndef vtkPolygonPLYReader_h
#define vtkPolygonPLYReader_h

#include "vtkMeshFileReader.h"

class CAMARONREADERS_EXPORT vtkPolygonPLYReader : public vtkMeshFileReader
{
public:
  static vtkPolygonPLYReader* New();
  vtkTypeMacro(vtkPolygonPLYReader, vtkMeshFileReader);

protected:
  vtkPolygonPLYReader();
  ~vtkPolygonPLYReader() override = default;

private:
  vtkPolygonPLYReader(const vtkPolygonPLYReader&) = delete;
  void operator=(const vtkPolygonPLYReader&) = delete;
};

#endif
