// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkVisfWriter
 * @brief Writes polygonal and polyhedral meshes to Visf files.
 *
 * Visf is the format of Camarón; see Readers/Visf/README.md. It holds points in single
 * precision, polygons and polyhedra, and no arrays. Faces that two cells share are written once, in
 * the direction of the first. What the reader makes of the file is the same mesh, except that a
 * polyhedron with the faces of a tetrahedron, pyramid, wedge or hexahedron becomes one, that cells
 * given inside out are turned, and that 2D cells come after 3D ones.
 *
 * @sa vtkVisfReader
 */
#ifndef vtkVisfWriter_h
#define vtkVisfWriter_h

#include "vtkMeshFileWriter.h"

class CAMARONFORMATS_EXPORT vtkVisfWriter : public vtkMeshFileWriter
{
public:
  static vtkVisfWriter* New();
  vtkTypeMacro(vtkVisfWriter, vtkMeshFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum EncodingType
  {
    ASCII = 0,                ///< version 0.3, text
    BINARY_LITTLE_ENDIAN = 1, ///< version 0.3
    BINARY_BIG_ENDIAN = 2,    ///< version 0.3
    BINARY_VERSION_02 = 3     ///< version 0.2, little endian, which all releases of Camarón open
  };

  ///@{
  /**
   * How the file is written. Default: ASCII.
   */
  vtkSetClampMacro(Encoding, int, ASCII, BINARY_VERSION_02);
  vtkGetMacro(Encoding, int);
  ///@}

  ///@{
  /**
   * Whether to write for every polygon the polygons that share two or more vertices with it.
   * Readers find these themselves if need be; the file gets about twice as large. Default: off.
   */
  vtkSetMacro(WriteNeighbors, bool);
  vtkGetMacro(WriteNeighbors, bool);
  vtkBooleanMacro(WriteNeighbors, bool);
  ///@}

protected:
  vtkVisfWriter() = default;
  ~vtkVisfWriter() override = default;

  bool WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) override;

private:
  vtkVisfWriter(const vtkVisfWriter&) = delete;
  void operator=(const vtkVisfWriter&) = delete;

  int Encoding = ASCII;
  bool WriteNeighbors = false;
};

#endif
