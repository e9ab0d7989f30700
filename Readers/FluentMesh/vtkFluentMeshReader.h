// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFluentMeshReader
 * @brief Reads meshes from mesh and case files of Ansys Fluent.
 *
 * Reads text and binary files of single and double precision, in two or three dimensions, with all
 * cell types, also compressed with gzip. See Readers/FluentMesh/README.md, and vtkFluentReader for
 * the outputs.
 *
 * @sa vtkFluentMeshWriter
 */
#ifndef vtkFluentMeshReader_h
#define vtkFluentMeshReader_h

#include "vtkFluentReader.h"

class CAMARONREADERS_EXPORT vtkFluentMeshReader : public vtkFluentReader
{
public:
  static vtkFluentMeshReader* New();
  vtkTypeMacro(vtkFluentMeshReader, vtkFluentReader);

protected:
  vtkFluentMeshReader();
  ~vtkFluentMeshReader() override = default;

  bool ReadZones(const std::string& path, const camaron::PieceRequest& request,
    vtkUnstructuredGrid* grid, vtkMultiBlockDataSet* boundaries, camaron::Warnings& warnings,
    camaron::ScanError& error, const camaron::Progress& progress) override;

private:
  vtkFluentMeshReader(const vtkFluentMeshReader&) = delete;
  void operator=(const vtkFluentMeshReader&) = delete;
};

#endif
