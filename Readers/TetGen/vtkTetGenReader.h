// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTetGenReader
 * @brief Reads meshes from TetGen and Triangle files.
 *
 * A mesh consists of several text files with the same name: .node (points), .ele (tetrahedra or
 * triangles), .face (triangles), .edge (line segments), .neigh (neighbors), and .poly or .smesh
 * (facets, holes and regions of the domain). FileName may be any of them; the others are found next
 * to it. See Readers/TetGen/README.md.
 *
 * Output: a vtkUnstructuredGrid with double coordinates in the unit of the files, which the format
 * does not state:
 * - .ele, or .node with an .ele next to it: VTK_TETRA, VTK_TRIANGLE, or their quadratic versions;
 * .neigh adds the cell array "Neighbors";
 * - .node alone: one VTK_VERTEX per point;
 * - .face, .edge: VTK_TRIANGLE, VTK_LINE, or their quadratic versions;
 * - .poly, .smesh: polygons of the facets; segments as VTK_LINE in 2D.
 *
 * Point arrays are "attr_0", "attr_1", ... and "BoundaryMarker"; cell arrays "Region", "attr_1",
 * ..., "BoundaryMarker", "Tetrahedra" and "Facet". Ids that do not count from 0 become
 * "OriginalPointId" and "OriginalCellId". Field arrays are "Holes", "Regions", "FacetHoles" and
 * "FacetOfHole".
 *
 * In parallel every process scans the files and keeps its part of the cells, with the requested
 * ghost cells, "GlobalPointIds" and "GlobalCellIds".
 *
 * @sa vtkTetGenWriter
 */
#ifndef vtkTetGenReader_h
#define vtkTetGenReader_h

#include "vtkMeshFileReader.h"

class CAMARONREADERS_EXPORT vtkTetGenReader : public vtkMeshFileReader
{
public:
  static vtkTetGenReader* New();
  vtkTypeMacro(vtkTetGenReader, vtkMeshFileReader);

protected:
  vtkTetGenReader();
  ~vtkTetGenReader() override = default;

private:
  vtkTetGenReader(const vtkTetGenReader&) = delete;
  void operator=(const vtkTetGenReader&) = delete;
};

#endif
