// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFluentHDF5Reader.h"

#include "FluentHDF5Reading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkFluentHDF5Reader);

//------------------------------------------------------------------------------
vtkFluentHDF5Reader::vtkFluentHDF5Reader()
  : vtkFluentReader(camaron::IsFluentHDF5, camaron::ReadFluentHDF5)
{
}
