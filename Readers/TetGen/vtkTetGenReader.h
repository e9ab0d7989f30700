// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTetGenReader
 * @brief Reads meshes from files of TetGen and Triangle.
 *
 * A mesh is several text files of one name: .node (points), .ele (tetrahedra or triangles), .face
 * (triangles), .edge (line segments), .neigh (neighbors), and .poly or .smesh (facets, holes and
 * regions of the domain). Any of them may be given, the others that it needs are found beside it.
 * See Readers/TetGen/README.md.
 *
 * Output: a vtkUnstructuredGrid with double coordinates in the unit of the files, which do not say
 * which one:
 * - .ele, or .node with an .ele beside it: VTK_TETRA, VTK_TRIANGLE, or these of second order;
 * .neigh adds the cell array "Neighbors";
 * - .node alone: one VTK_VERTEX per point;
 * - .face, .edge: VTK_TRIANGLE, VTK_LINE, or these of second order;
 * - .poly, .smesh: polygons of the facets; segments as VTK_LINE in two dimensions.
 *
 * Point arrays are "attr_0", "attr_1", ... and "BoundaryMarker"; cell arrays "Region", "attr_1",
 * ..., "BoundaryMarker", "Tetrahedra" and "Facet". Ids that do not count from 0 become
 * "OriginalPointId" and "OriginalCellId". Field arrays are "Holes", "Regions", "FacetHoles" and
 * "FacetOfHole".
 *
 * In parallel every process scans the files and keeps its share of the cells, with the ghost cells
 * asked for, "GlobalPointIds" and "GlobalCellIds".
 *
 * @sa vtkTetGenWriter
 */
#ifndef vtkTetGenReader_h
#define vtkTetGenReader_h

#include "vtkMeshFileReader.h"

class CAMARONFORMATS_EXPORT vtkTetGenReader : public vtkMeshFileReader
{
public:
  static vtkTetGenReader* New();
  vtkTypeMacro(vtkTetGenReader, vtkMeshFileReader);

  int CanReadFile(const char* fileName) override;

protected:
  vtkTetGenReader() = default;
  ~vtkTetGenReader() override = default;

  bool ReadMesh(const std::string& path, const camaron::PieceRequest& request,
    vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
    const camaron::Progress& progress) override;

private:
  vtkTetGenReader(const vtkTetGenReader&) = delete;
  void operator=(const vtkTetGenReader&) = delete;
};

#endif
