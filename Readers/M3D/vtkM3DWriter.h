// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkM3DWriter
 * @brief Writes meshes of mixed elements to M3D and M2D files.
 *
 * See Readers/M3D/README.md. M3D files store tetrahedra, pyramids, prisms and hexahedra, M2D files,
 * which have this extension, triangles and quadrilaterals; UnsupportedCells determines the
 * treatment of other cells. The only array written is "Material", of cells or field data, with
 * three components. Nodes are written at their position, with code 1.
 *
 * @sa vtkM3DReader
 */
#ifndef vtkM3DWriter_h
#define vtkM3DWriter_h

#include "vtkCellMeshFileWriter.h"

class CAMARONREADERS_EXPORT vtkM3DWriter : public vtkCellMeshFileWriter
{
public:
  static vtkM3DWriter* New();
  vtkTypeMacro(vtkM3DWriter, vtkCellMeshFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Significant digits of coordinates, up to 17: 9 preserve every float, 17 every double. Default:
   * 0, which stands for 9, as mesh generators write, or 17 if 9 do not preserve the mesh.
   */
  vtkSetClampMacro(Digits, int, 0, 17);
  vtkGetMacro(Digits, int);
  ///@}

protected:
  vtkM3DWriter() = default;
  ~vtkM3DWriter() override = default;

  int GetDigitsOfCoordinates() const override { return this->Digits; } // 0: all
  bool WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) override;

private:
  vtkM3DWriter(const vtkM3DWriter&) = delete;
  void operator=(const vtkM3DWriter&) = delete;

  int Digits = 0;
};

#endif
