// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMAPDLWriter
 * @brief Writes meshes to decks of Ansys Mechanical APDL.
 *
 * See Readers/MAPDL/README.md. A deck stores vertices, lines, triangles, quadrilaterals,
 * tetrahedra, pyramids, wedges and hexahedra, linear and quadratic; UnsupportedCells determines the
 * treatment of other cells. The arrays of vtkMAPDLReader are converted back to ids, types,
 * attributes and components; the latter are arrays of unsigned char with values 0 and 1. Other
 * arrays are not written.
 *
 * @sa vtkMAPDLReader
 */
#ifndef vtkMAPDLWriter_h
#define vtkMAPDLWriter_h

#include "vtkCellMeshFileWriter.h"

class CAMARONREADERS_EXPORT vtkMAPDLWriter : public vtkCellMeshFileWriter
{
public:
  static vtkMAPDLWriter* New();
  vtkTypeMacro(vtkMAPDLWriter, vtkCellMeshFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether to use ids from the arrays NodeId and ElementId, if these exist and their values are
   * positive and unique. Otherwise nodes and elements are numbered from 1. Default: on.
   */
  vtkSetMacro(OriginalIds, bool);
  vtkGetMacro(OriginalIds, bool);
  vtkBooleanMacro(OriginalIds, bool);
  ///@}

  ///@{
  /**
   * Significant digits of coordinates, 7 to 17: 9 preserve every float, 17 every double. Default:
   * 14, as Mechanical APDL writes.
   */
  vtkSetClampMacro(Digits, int, 7, 17);
  vtkGetMacro(Digits, int);
  ///@}

protected:
  vtkMAPDLWriter() = default;
  ~vtkMAPDLWriter() override = default;

  int GetDigitsOfCoordinates() const override { return this->Digits; }
  bool WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) override;

private:
  vtkMAPDLWriter(const vtkMAPDLWriter&) = delete;
  void operator=(const vtkMAPDLWriter&) = delete;

  bool OriginalIds = true;
  int Digits = 14;
};

#endif
