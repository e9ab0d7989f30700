// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPolygonOFFReader
 * @brief Reads polygon meshes from OFF files of Geomview and many other programs.
 *
 * All keywords [ST][C][N][4][n]OFF are read, as text and as binary files, and what programs make of
 * them. See Readers/PolygonOFF/README.md.
 *
 * Output: a vtkUnstructuredGrid with the points of the file, double if it is text and float if it
 * is binary (in the unit of the file, which does not say which one), and its faces in their order
 * and direction: VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON, of fewer vertices VTK_LINE or VTK_VERTEX. A
 * file without faces gives one VTK_VERTEX per point. Normals become the point normals "Normals",
 * texture coordinates "TCoords", colors of vertices or faces unsigned char arrays "RGBA", indices
 * into a map of colors int arrays "ColorIndex" (-1 where there is none).
 *
 * In parallel every process scans the file and keeps its share of the cells, with the ghost cells
 * asked for, "GlobalPointIds" and "GlobalCellIds".
 *
 * @sa vtkPolygonOFFWriter
 */
#ifndef vtkPolygonOFFReader_h
#define vtkPolygonOFFReader_h

#include "vtkMeshFileReader.h"

class CAMARONFORMATS_EXPORT vtkPolygonOFFReader : public vtkMeshFileReader
{
public:
  static vtkPolygonOFFReader* New();
  vtkTypeMacro(vtkPolygonOFFReader, vtkMeshFileReader);

  int CanReadFile(const char* fileName) override;

protected:
  vtkPolygonOFFReader() = default;
  ~vtkPolygonOFFReader() override = default;

  bool ReadMesh(const std::string& path, const camaron::PieceRequest& request,
    vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
    const camaron::Progress& progress) override;

private:
  vtkPolygonOFFReader(const vtkPolygonOFFReader&) = delete;
  void operator=(const vtkPolygonOFFReader&) = delete;
};

#endif
