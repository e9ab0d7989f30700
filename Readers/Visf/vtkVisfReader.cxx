// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVisfReader.h"

#include "VisfReading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVisfReader);

//------------------------------------------------------------------------------
vtkVisfReader::vtkVisfReader()
  : vtkMeshFileReader(camaron::IsVisf, camaron::ReadVisf)
{
}
