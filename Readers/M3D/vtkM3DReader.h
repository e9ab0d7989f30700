// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkM3DReader
 * @brief Reads meshes of tetrahedra, pyramids, prisms and hexahedra from M3D files.
 *
 * An M3D file is text with a section of nodes, each with a code, coordinates and sometimes a
 * projection, and a section of elements, each with a letter, nodes and three numbers that describe
 * the material. M2D files are the same with triangles and quadrilaterals; MVM files have neither
 * codes nor materials. See Readers/M3D/README.md.
 *
 * Output: a vtkUnstructuredGrid with double coordinates in the unit of the file, which the format
 * does not state. Cells are VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON, VTK_TRIANGLE and
 * VTK_QUAD in the order of the file. There are point arrays "NodeCode" and "Projection" if any code
 * is not 1, and a cell array "Material" if materials differ, else field data of that name.
 *
 * In parallel every process scans the file and keeps its part of the cells, with the requested
 * ghost cells, "GlobalPointIds" and "GlobalCellIds".
 *
 * @sa vtkM3DWriter
 */
#ifndef vtkM3DReader_h
#define vtkM3DReader_h

#include "vtkMeshFileReader.h"

class CAMARONREADERS_EXPORT vtkM3DReader : public vtkMeshFileReader
{
public:
  static vtkM3DReader* New();
  vtkTypeMacro(vtkM3DReader, vtkMeshFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether to move nodes with code 2 by their projection, as Camarón does. Default: on.
   */
  vtkSetMacro(AddProjection, bool);
  vtkGetMacro(AddProjection, bool);
  vtkBooleanMacro(AddProjection, bool);
  ///@}

protected:
  vtkM3DReader();
  ~vtkM3DReader() override = default;

  bool ReadMesh(const std::string& path, const camaron::PieceRequest& request,
    vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
    const camaron::Progress& progress) override;

private:
  vtkM3DReader(const vtkM3DReader&) = delete;
  void operator=(const vtkM3DReader&) = delete;

  bool AddProjection = true;
};

#endif
