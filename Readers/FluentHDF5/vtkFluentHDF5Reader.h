// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFluentHDF5Reader
 * @brief Reads meshes from mesh and case files of Ansys Fluent in HDF5 (Common Fluids Format).
 *
 * The same mesh as of a file in text: see Readers/FluentHDF5/README.md for the files, and
 * vtkFluentReader for the outputs.
 */
#ifndef vtkFluentHDF5Reader_h
#define vtkFluentHDF5Reader_h

#include "vtkFluentReader.h"

class CAMARONREADERS_EXPORT vtkFluentHDF5Reader : public vtkFluentReader
{
public:
  static vtkFluentHDF5Reader* New();
  vtkTypeMacro(vtkFluentHDF5Reader, vtkFluentReader);

protected:
  vtkFluentHDF5Reader();
  ~vtkFluentHDF5Reader() override = default;

private:
  vtkFluentHDF5Reader(const vtkFluentHDF5Reader&) = delete;
  void operator=(const vtkFluentHDF5Reader&) = delete;
};

#endif
