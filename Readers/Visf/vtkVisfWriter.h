// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkVisfWriter
 * @brief Writes polygonal and polyhedral meshes to Visf files.
 *
 * Visf is the format of the original Camarón; see Readers/Visf/README.md. It stores points in
 * single precision, polygons and polyhedra, and no arrays. Faces between two cells are written
 * once, oriented as in the first. Reading the file gives the same mesh, except that polyhedra with
 * the faces of a tetrahedron, pyramid, wedge or hexahedron become one, inverted cells are
 * corrected, and 2D cells follow the 3D cells.
 *
 * @sa vtkVisfReader
 */
#ifndef vtkVisfWriter_h
#define vtkVisfWriter_h

#include "vtkMeshFileWriter.h"

class CAMARONREADERS_EXPORT vtkVisfWriter : public vtkMeshFileWriter
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
    BINARY_VERSION_02 = 3     ///< version 0.2, little endian, which all releases of Camarón read
  };

  ///@{
  /**
   * Encoding of the file. Default: ASCII.
   */
  vtkSetClampMacro(Encoding, int, ASCII, BINARY_VERSION_02);
  vtkGetMacro(Encoding, int);
  ///@}

  ///@{
  /**
   * Whether to write for every polygon the polygons that share two or more vertices with it.
   * Programs can derive these from the polygons; the file becomes about twice as large. Default:
   * off.
   */
  vtkSetMacro(WriteNeighbors, bool);
  vtkGetMacro(WriteNeighbors, bool);
  vtkBooleanMacro(WriteNeighbors, bool);
  ///@}

protected:
  vtkVisfWriter() = default;
  ~vtkVisfWriter() override = default;

  int GetDigitsOfCoordinates() const override;
  bool WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) override;

private:
  vtkVisfWriter(const vtkVisfWriter&) = delete;
  void operator=(const vtkVisfWriter&) = delete;

  int Encoding = ASCII;
  bool WriteNeighbors = false;
};

#endif
