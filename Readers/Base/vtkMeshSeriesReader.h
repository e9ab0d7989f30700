// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshSeriesReader
 * @brief Shows several files as time steps, for readers with a mesh and its boundaries as outputs.
 *
 * Up to and including ParaView 6.0, vtkFileSeriesReader passes on only the first output of its
 * reader, and sets the times only on the output that is requested first. Here both outputs have the
 * times of the series and always show the same time.
 */
#ifndef vtkMeshSeriesReader_h
#define vtkMeshSeriesReader_h

#include "CamaronReadersModule.h" // for export macro
#include "vtkFileSeriesReader.h"

class CAMARONREADERS_EXPORT vtkMeshSeriesReader : public vtkFileSeriesReader
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
