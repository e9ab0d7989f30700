// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshSeriesReader
 * @brief Shows several files as time steps, for readers that have a mesh and its boundaries as
 * outputs.
 *
 * vtkFileSeriesReader passes on the first output of its reader only, up to and including
 * ParaView 6.0, and tells the times to the output alone that is asked for them first. Here both
 * outputs have the times of the series, and are of one time whichever of them is updated.
 */
#ifndef vtkMeshSeriesReader_h
#define vtkMeshSeriesReader_h

#include "CamaronFormatsModule.h" // for export macro
#include "vtkFileSeriesReader.h"

class CAMARONFORMATS_EXPORT vtkMeshSeriesReader : public vtkFileSeriesReader
{
public:
  static vtkMeshSeriesReader* New();
  vtkTypeMacro(vtkMeshSeriesReader, vtkFileSeriesReader);

protected:
  vtkMeshSeriesReader();
  ~vtkMeshSeriesReader() override = default;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMeshSeriesReader(const vtkMeshSeriesReader&) = delete;
  void operator=(const vtkMeshSeriesReader&) = delete;
};

#endif
