// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTRIReader.h"

#include "TRIReading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTRIReader);

//------------------------------------------------------------------------------
vtkTRIReader::vtkTRIReader()
  : vtkMeshFileReader(camaron::IsTRI, camaron::ReadTRI)
{
}
