// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCellMeshFileWriter
 * @brief Base class of writers of formats that store certain cell types only.
 *
 * Adds an option for the treatment of other cells. See camaron::ConvertCells for the cells that are
 * always converted, and for how cells are split.
 *
 * The XML of every such writer has the property UnsupportedCells, as in M3DWriter.xml.
 */
#ifndef vtkCellMeshFileWriter_h
#define vtkCellMeshFileWriter_h

#include "vtkMeshFileWriter.h"

namespace camaron
{
enum class UnsupportedCells;
}

class CAMARONREADERS_EXPORT vtkCellMeshFileWriter : public vtkMeshFileWriter
{
public:
  vtkAbstractTypeMacro(vtkCellMeshFileWriter, vtkMeshFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum UnsupportedCellsType
  {
    REFUSE = 0, ///< an error; nothing is written
    SKIP = 1,   ///< left out, with a warning
    CONVERT = 2 ///< cut into triangles or tetrahedra, without new points
  };

  ///@{
  /**
   * How to treat cells that the format cannot store. Default: REFUSE.
   */
  vtkSetClampMacro(UnsupportedCells, int, REFUSE, CONVERT);
  vtkGetMacro(UnsupportedCells, int);
  ///@}

protected:
  vtkCellMeshFileWriter() = default;
  ~vtkCellMeshFileWriter() override = default;

  camaron::UnsupportedCells GetOtherCells() const
  {
    return static_cast<camaron::UnsupportedCells>(this->UnsupportedCells);
  }

private:
  vtkCellMeshFileWriter(const vtkCellMeshFileWriter&) = delete;
  void operator=(const vtkCellMeshFileWriter&) = delete;

  int UnsupportedCells = REFUSE;
};

#endif
