// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFluentMeshWriter
 * @brief Writes 2D or 3D meshes for Ansys Fluent.
 *
 * See Readers/FluentMesh/README.md. Cells of the highest dimension are written as faces; cells of
 * one dimension less that are faces of others determine the zones of these faces. The cell array
 * "Zone" contains the zones, the field data "ZoneIds", "ZoneNames", "ZoneTypes" and
 * "ZoneBoundaryTypes" their names and types, as created by vtkFluentMeshReader.
 *
 * @sa vtkFluentMeshReader
 */
#ifndef vtkFluentMeshWriter_h
#define vtkFluentMeshWriter_h

#include "vtkCellMeshFileWriter.h"

class CAMARONREADERS_EXPORT vtkFluentMeshWriter : public vtkCellMeshFileWriter
{
public:
  static vtkFluentMeshWriter* New();
  vtkTypeMacro(vtkFluentMeshWriter, vtkCellMeshFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum EncodingType
  {
    ASCII = 0,
    BINARY_SINGLE = 1, ///< coordinates in single precision
    BINARY_DOUBLE = 2  ///< coordinates in double precision
  };

  ///@{
  /**
   * Encoding of the file. Default: ASCII.
   */
  vtkSetClampMacro(Encoding, int, ASCII, BINARY_DOUBLE);
  vtkGetMacro(Encoding, int);
  ///@}

protected:
  vtkFluentMeshWriter() = default;
  ~vtkFluentMeshWriter() override = default;

  int GetDigitsOfCoordinates() const override;
  bool HasZones() const override { return true; }
  bool WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) override;

private:
  vtkFluentMeshWriter(const vtkFluentMeshWriter&) = delete;
  void operator=(const vtkFluentMeshWriter&) = delete;

  int Encoding = ASCII;
};

#endif
