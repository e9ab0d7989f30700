// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTSReader.h"

#include "TSReading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTSReader);

//------------------------------------------------------------------------------
vtkTSReader::vtkTSReader()
  : vtkMeshFileReader(camaron::IsTS, camaron::ReadTS)
{
}
