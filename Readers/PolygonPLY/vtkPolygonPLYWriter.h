// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPolygonPLYWriter
 * @brief Writes meshes with all their arrays to PLY files.
 *
 * See Readers/PolygonPLY/README.md. 2D cells become faces, lines become edges, and a mesh with
 * vertices only becomes points. Of 3D cells the surface is written, or they become elements `cell`
 * given by their faces. Numeric arrays become properties of their type; normals, colors and texture
 * coordinates get their usual names.
 *
 * @sa vtkPolygonPLYReader
 */
#ifndef vtkPolygonPLYWriter_h
#define vtkPolygonPLYWriter_h

#include "vtkSurfaceMeshFileWriter.h"

class CAMARONREADERS_EXPORT vtkPolygonPLYWriter : public vtkSurfaceMeshFileWriter
{
public:
  static vtkPolygonPLYWriter* New();
  vtkTypeMacro(vtkPolygonPLYWriter, vtkSurfaceMeshFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum EncodingType
  {
    ASCII = 0,
    BINARY_LITTLE_ENDIAN = 1,
    BINARY_BIG_ENDIAN = 2
  };
  enum CoordinatesType
  {
    AS_INPUT = 0, ///< float or double as in the mesh
    FLOAT = 1
  };

  ///@{
  /**
   * Encoding of the file. Default: BINARY_LITTLE_ENDIAN.
   */
  vtkSetClampMacro(Encoding, int, ASCII, BINARY_BIG_ENDIAN);
  vtkGetMacro(Encoding, int);
  ///@}

  ///@{
  /**
   * The type of coordinates. Default: AS_INPUT.
   */
  vtkSetClampMacro(Coordinates, int, AS_INPUT, FLOAT);
  vtkGetMacro(Coordinates, int);
  ///@}

  ///@{
  /**
   * Whether to write 3D cells as elements `cell`, lists of faces, which few programs read;
   * otherwise FacesOfVolumes selects the faces that are written. Default: off.
   */
  vtkSetMacro(WriteCells, bool);
  vtkGetMacro(WriteCells, bool);
  vtkBooleanMacro(WriteCells, bool);
  ///@}

protected:
  vtkPolygonPLYWriter() = default;
  ~vtkPolygonPLYWriter() override = default;

  int GetDigitsOfCoordinates() const override;
  bool WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) override;

private:
  vtkPolygonPLYWriter(const vtkPolygonPLYWriter&) = delete;
  void operator=(const vtkPolygonPLYWriter&) = delete;

  int Encoding = BINARY_LITTLE_ENDIAN;
  int Coordinates = AS_INPUT;
  bool WriteCells = false;
};

#endif
