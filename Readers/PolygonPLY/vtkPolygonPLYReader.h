// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPolygonPLYReader
 * @brief Reads points, polygons, strips, edges and polyhedra with all their arrays from PLY files.
 *
 * PLY (polygon file format, Stanford) describes in its header which elements with which properties
 * follow, as text or binary of either byte order. See Readers/PolygonPLY/README.md.
 *
 * Output: a vtkUnstructuredGrid. Coordinates are float, or double where the file has double or
 * integers of 32 bits (in the unit of the file, which does not say which one). Faces become
 * VTK_TRIANGLE, VTK_QUAD or VTK_POLYGON, strips VTK_TRIANGLE, edges VTK_LINE; a file of vertices
 * alone gives one VTK_VERTEX each. Cells given by faces become tetrahedra, pyramids, wedges or
 * hexahedra where they are such, else VTK_POLYHEDRON. Normals, texture coordinates, and colors
 * ("RGB", "RGBA") become arrays of several components, every other property an array of its name
 * and type.
 *
 * In parallel every process scans the file and keeps its share of the cells, with the ghost cells
 * asked for, "GlobalPointIds" and "GlobalCellIds".
 *
 * @sa vtkPolygonPLYWriter
 */
#ifndef vtkPolygonPLYReader_h
#define vtkPolygonPLYReader_h

#include "vtkMeshFileReader.h"

class CAMARONFORMATS_EXPORT vtkPolygonPLYReader : public vtkMeshFileReader
{
public:
  static vtkPolygonPLYReader* New();
  vtkTypeMacro(vtkPolygonPLYReader, vtkMeshFileReader);

  int CanReadFile(const char* fileName) override;

protected:
  vtkPolygonPLYReader() = default;
  ~vtkPolygonPLYReader() override = default;

  bool ReadMesh(const std::string& path, const camaron::PieceRequest& request,
    vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
    const camaron::Progress& progress) override;

private:
  vtkPolygonPLYReader(const vtkPolygonPLYReader&) = delete;
  void operator=(const vtkPolygonPLYReader&) = delete;
};

#endif
