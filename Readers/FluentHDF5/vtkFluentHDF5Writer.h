// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFluentHDF5Writer
 * @brief Writes 2D or 3D meshes for Ansys Fluent in HDF5, laid out as by Fluent Meshing.
 *
 * See Readers/FluentHDF5/README.md. Zones and boundaries come from the same arrays as for
 * vtkFluentMeshWriter. The compressed file is made in memory.
 *
 * @sa vtkFluentHDF5Reader
 */
#ifndef vtkFluentHDF5Writer_h
#define vtkFluentHDF5Writer_h

#include "vtkCellMeshFileWriter.h"

class CAMARONREADERS_EXPORT vtkFluentHDF5Writer : public vtkCellMeshFileWriter
{
public:
  static vtkFluentHDF5Writer* New();
  vtkTypeMacro(vtkFluentHDF5Writer, vtkCellMeshFileWriter);

protected:
  vtkFluentHDF5Writer() = default;
  ~vtkFluentHDF5Writer() override = default;

  bool HasZones() const override { return true; }
  bool WriteMesh(const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) override;

private:
  vtkFluentHDF5Writer(const vtkFluentHDF5Writer&) = delete;
  void operator=(const vtkFluentHDF5Writer&) = delete;
};

#endif
