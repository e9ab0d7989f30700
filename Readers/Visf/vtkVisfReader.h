// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkVisfReader
 * @brief Reads polygonal and polyhedral meshes from Visf files.
 *
 * Visf is the format of the original Camarón: vertices, polygons as lists of vertices, polyhedra as
 * lists of polygons. All dialects are read: ASCII, binary in both byte orders, and the headers of
 * all versions. See Readers/Visf/README.md.
 *
 * Output: a vtkUnstructuredGrid with float coordinates in the unit of the file, which the format
 * does not state. Polyhedra become tetrahedra, pyramids, wedges or hexahedra where they match, else
 * VTK_POLYHEDRON with faces that point outward. Polygons of no polyhedron follow as 2D cells. A
 * file with vertices only gives one VTK_VERTEX each. Lists of faces do not distinguish inside from
 * outside, so every cell with a volume has a positive one.
 *
 * In parallel every process scans the file and keeps its part of the cells, with the requested
 * ghost cells, "GlobalPointIds" and "GlobalCellIds".
 *
 * @sa vtkVisfWriter
 */
#ifndef vtkVisfReader_h
#define vtkVisfReader_h

#include "vtkMeshFileReader.h"

class CAMARONREADERS_EXPORT vtkVisfReader : public vtkMeshFileReader
{
public:
  static vtkVisfReader* New();
  vtkTypeMacro(vtkVisfReader, vtkMeshFileReader);

protected:
  vtkVisfReader();
  ~vtkVisfReader() override = default;

private:
  vtkVisfReader(const vtkVisfReader&) = delete;
  void operator=(const vtkVisfReader&) = delete;
};

#endif
