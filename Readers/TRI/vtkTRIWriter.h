// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTRIWriter
 * @brief Writes triangle meshes to TRI files of Camarón or Cart3D.
 *
 * See Readers/TRI/README.md. The format stores points and triangles. Of 3D cells the surface is
 * written; UnsupportedCells determines the treatment of other cells. Coordinates have the fewest
 * digits that read back as the same numbers.
 *
 * @sa vtkTRIReader
 */
#ifndef vtkTRIWriter_h
#define vtkTRIWriter_h

#include "vtkSurfaceMeshFileWriter.h"

class CAMARONREADERS_EXPORT vtkTRIWriter : public vtkSurfaceMeshFileWriter
{
public:
  static vtkTRIWriter* New();
  vtkTypeMacro(vtkTRIWriter, vtkSurfaceMeshFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum DialectType
  {
    CAMARON = 0, ///< vertices counted from 0
    CART3D = 1   ///< vertices counted from 1; with the cell array "Component" if there is one
  };

  ///@{
  /**
   * Dialect of the file. Default: CAMARON.
   */
  vtkSetClampMacro(Dialect, int, CAMARON, CART3D);
  vtkGetMacro(Dialect, int);
  ///@}

protected:
  vtkTRIWriter() = default;
  ~vtkTRIWriter() override = default;

  bool WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) override;

private:
  vtkTRIWriter(const vtkTRIWriter&) = delete;
  void operator=(const vtkTRIWriter&) = delete;

  int Dialect = CAMARON;
};

#endif
