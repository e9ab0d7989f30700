// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTetGenReader.h"

#include "TetGenReading.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTetGenReader);

//------------------------------------------------------------------------------
vtkTetGenReader::vtkTetGenReader()
  : vtkMeshFileReader(camaron::IsTetGen, camaron::ReadTetGen)
{
}
