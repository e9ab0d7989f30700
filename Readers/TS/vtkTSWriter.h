// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTSWriter
 * @brief Writes tetrahedra or surfaces to TS files of Camarón or GOCAD.
 *
 * See Readers/TS/README.md. Files of Camarón store points and tetrahedra, no arrays. TSurf files of
 * GOCAD store triangles, with point arrays as properties and the cell arrays "Part" and "TFace" if
 * possible; of 3D cells the surface is written. UnsupportedCells determines the treatment of other
 * cells. Numbers have the fewest digits that read back as the same numbers.
 *
 * @sa vtkTSReader
 */
#ifndef vtkTSWriter_h
#define vtkTSWriter_h

#include "vtkSurfaceMeshFileWriter.h"

class CAMARONREADERS_EXPORT vtkTSWriter : public vtkSurfaceMeshFileWriter
{
public:
  static vtkTSWriter* New();
  vtkTypeMacro(vtkTSWriter, vtkSurfaceMeshFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum DialectType
  {
    CAMARON = 0, ///< tetrahedra
    GOCAD = 1    ///< triangles
  };

  ///@{
  /**
   * Dialect of the file. Default: CAMARON.
   */
  vtkSetClampMacro(Dialect, int, CAMARON, GOCAD);
  vtkGetMacro(Dialect, int);
  ///@}

protected:
  vtkTSWriter() = default;
  ~vtkTSWriter() override = default;

  bool WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) override;

private:
  vtkTSWriter(const vtkTSWriter&) = delete;
  void operator=(const vtkTSWriter&) = delete;

  int Dialect = CAMARON;
};

#endif
