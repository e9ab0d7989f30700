// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshSeriesReader.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMeshSeriesReader);

//------------------------------------------------------------------------------
vtkMeshSeriesReader::vtkMeshSeriesReader()
{
  this->SetNumberOfOutputPorts(2);
}
