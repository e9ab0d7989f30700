// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkM3DReader
 * @brief Reads meshes of tetrahedra, pyramids, prisms and hexahedra from M3D files.
 *
 * An M3D file is text with a section of nodes, each with a code, coordinates and sometimes a
 * projection, and one of elements, each with a letter, nodes and three numbers of material. M2D
 * files are the same with triangles and quadrilaterals; MVM files have neither codes nor materials.
 * See Readers/M3D/README.md.
 *
 * Output: a vtkUnstructuredGrid with double coordinates (in the unit of the file, which does not
 * say which one) of VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON, VTK_TRIANGLE and VTK_QUAD in
 * the order of the file. Point arrays "NodeCode" and "Projection" if not all codes are 1; cell
 * array "Material" if materials differ, field data of that name if they do not.
 *
 * In parallel every process scans the file and keeps its share of the cells, with the ghost cells
 * asked for, "GlobalPointIds" and "GlobalCellIds".
 *
 * @sa vtkM3DWriter
 */
#ifndef vtkM3DReader_h
#define vtkM3DReader_h

#include "vtkMeshFileReader.h"

class CAMARONFORMATS_EXPORT vtkM3DReader : public vtkMeshFileReader
{
public:
  static vtkM3DReader* New();
  vtkTypeMacro(vtkM3DReader, vtkMeshFileReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether nodes of code 2 are moved by their projection, as Camarón does. Default: on.
   */
  vtkSetMacro(AddProjection, bool);
  vtkGetMacro(AddProjection, bool);
  vtkBooleanMacro(AddProjection, bool);
  ///@}

  int CanReadFile(const char* fileName) override;

protected:
  vtkM3DReader() = default;
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
