// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMAPDLWriter
 * @brief Writes meshes to decks of Ansys Mechanical APDL.
 *
 * See Readers/MAPDL/README.md. A deck holds vertices, lines, triangles, quadrilaterals, tetrahedra,
 * pyramids, wedges and hexahedra, linear and quadratic; other cells become what UnsupportedCells
 * says. The arrays of vtkMAPDLReader become what they were: ids, types and attributes of elements,
 * and components, which are arrays of unsigned char with values 0 and 1. No other arrays are
 * written.
 *
 * @sa vtkMAPDLReader
 */
#ifndef vtkMAPDLWriter_h
#define vtkMAPDLWriter_h

#include "vtkCellMeshFileWriter.h"

class CAMARONFORMATS_EXPORT vtkMAPDLWriter : public vtkCellMeshFileWriter
{
public:
  static vtkMAPDLWriter* New();
  vtkTypeMacro(vtkMAPDLWriter, vtkCellMeshFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether to take ids from the arrays NodeId and ElementId, if these are there and their values
   * positive and unique. Otherwise nodes and elements are counted from 1. Default: on.
   */
  vtkSetMacro(OriginalIds, bool);
  vtkGetMacro(OriginalIds, bool);
  vtkBooleanMacro(OriginalIds, bool);
  ///@}

  ///@{
  /**
   * Significant digits of coordinates, 7 to 17: 9 keep every float, 17 every double. Default: 14,
   * as Mechanical APDL writes.
   */
  vtkSetClampMacro(Digits, int, 7, 17);
  vtkGetMacro(Digits, int);
  ///@}

protected:
  vtkMAPDLWriter() = default;
  ~vtkMAPDLWriter() override = default;

  bool WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) override;

private:
  vtkMAPDLWriter(const vtkMAPDLWriter&) = delete;
  void operator=(const vtkMAPDLWriter&) = delete;

  bool OriginalIds = true;
  int Digits = 14;
};

#endif
