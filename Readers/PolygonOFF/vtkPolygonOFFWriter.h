// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPolygonOFFWriter
 * @brief Writes polygon meshes to OFF files, as text or binary.
 *
 * See Readers/PolygonOFF/README.md. The format stores points and polygons. Of 3D cells the surface
 * is written; lines and vertices become faces with two vertices and one; UnsupportedCells
 * determines the treatment of other cells. By default a file contains nothing else, so every
 * program can read it; normals, texture coordinates and colors are optional and change the keyword.
 *
 * @sa vtkPolygonOFFReader
 */
#ifndef vtkPolygonOFFWriter_h
#define vtkPolygonOFFWriter_h

#include "vtkSurfaceMeshFileWriter.h"

#include <string> // for names of arrays

class CAMARONREADERS_EXPORT vtkPolygonOFFWriter : public vtkSurfaceMeshFileWriter
{
public:
  static vtkPolygonOFFWriter* New();
  vtkTypeMacro(vtkPolygonOFFWriter, vtkSurfaceMeshFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum EncodingType
  {
    ASCII = 0,
    BINARY = 1 ///< big endian, real numbers as float
  };

  ///@{
  /**
   * Encoding of the file. Default: ASCII.
   */
  vtkSetClampMacro(Encoding, int, ASCII, BINARY);
  vtkGetMacro(Encoding, int);
  ///@}

  ///@{
  /**
   * Significant digits of real numbers in text, up to 17: 9 preserve every float, 17 every double.
   * Default: 0, the fewest that read back as the same number of the type of the coordinates.
   */
  vtkSetClampMacro(Digits, int, 0, 17);
  vtkGetMacro(Digits, int);
  ///@}

  ///@{
  /**
   * Whether to write the normals of the points (keyword N). Default: off.
   */
  vtkSetMacro(WriteNormals, bool);
  vtkGetMacro(WriteNormals, bool);
  vtkBooleanMacro(WriteNormals, bool);
  ///@}

  ///@{
  /**
   * Whether to write the texture coordinates of the points (keyword ST). Default: off.
   */
  vtkSetMacro(WriteTextureCoordinates, bool);
  vtkGetMacro(WriteTextureCoordinates, bool);
  vtkBooleanMacro(WriteTextureCoordinates, bool);
  ///@}

  ///@{
  /**
   * Name of the point array to write as colors (keyword C): three or four components, integers
   * from 0 to 255 or real numbers from 0 to 1. Empty or "None" for none. Default: empty.
   */
  vtkSetStdStringFromCharMacro(VertexColors);
  vtkGetCharFromStdStringMacro(VertexColors);
  ///@}

  ///@{
  /**
   * Name of the cell array to write as colors of faces: as VertexColors, or one integer, an index
   * into a color map; negative indices are not written. Empty or "None" for none. Default: empty.
   */
  vtkSetStdStringFromCharMacro(FaceColors);
  vtkGetCharFromStdStringMacro(FaceColors);
  ///@}

protected:
  vtkPolygonOFFWriter() = default;
  ~vtkPolygonOFFWriter() override = default;

  int GetDigitsOfCoordinates() const override;
  bool WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) override;

private:
  vtkPolygonOFFWriter(const vtkPolygonOFFWriter&) = delete;
  void operator=(const vtkPolygonOFFWriter&) = delete;

  int Encoding = ASCII;
  int Digits = 0;
  bool WriteNormals = false;
  bool WriteTextureCoordinates = false;
  std::string VertexColors;
  std::string FaceColors;
};

#endif
