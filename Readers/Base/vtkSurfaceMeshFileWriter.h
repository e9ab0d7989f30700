// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceMeshFileWriter
 * @brief Base class of writers of polygon formats.
 *
 * Adds the option which faces of 3D cells are written.
 *
 * The XML of every such writer has, in addition to that of vtkCellMeshFileWriter, the property
 * FacesOfVolumes, as in TRIWriter.xml.
 */
#ifndef vtkSurfaceMeshFileWriter_h
#define vtkSurfaceMeshFileWriter_h

#include "vtkCellMeshFileWriter.h"

namespace camaron
{
enum class SurfaceFaces;
}

class CAMARONREADERS_EXPORT vtkSurfaceMeshFileWriter : public vtkCellMeshFileWriter
{
public:
  vtkAbstractTypeMacro(vtkSurfaceMeshFileWriter, vtkCellMeshFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum FacesOfVolumesType
  {
    BOUNDARY = 0, ///< faces of only one cell
    EVERY = 1     ///< every face once
  };

  ///@{
  /**
   * Which faces of 3D cells are written. Default: BOUNDARY.
   */
  vtkSetClampMacro(FacesOfVolumes, int, BOUNDARY, EVERY);
  vtkGetMacro(FacesOfVolumes, int);
  ///@}

protected:
  vtkSurfaceMeshFileWriter() = default;
  ~vtkSurfaceMeshFileWriter() override = default;

  camaron::SurfaceFaces GetSurfaceFaces() const;

private:
  vtkSurfaceMeshFileWriter(const vtkSurfaceMeshFileWriter&) = delete;
  void operator=(const vtkSurfaceMeshFileWriter&) = delete;

  int FacesOfVolumes = BOUNDARY;
};

#endif
