// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Pieces/PieceRequest.h"

#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"

namespace camaron
{
//------------------------------------------------------------------------------
void SetGlobalIds(vtkDataSetAttributes* attributes, Buffer<vtkIdType>&& ids, const char* name)
{
  attributes->SetGlobalIds(ids.TakeArray<vtkIdTypeArray>(1, name));
}

//------------------------------------------------------------------------------
void SetGhosts(vtkDataSetAttributes* attributes, Buffer<unsigned char>&& flags)
{
  attributes->AddArray(
    flags.TakeArray<vtkUnsignedCharArray>(1, vtkDataSetAttributes::GhostArrayName()));
}
}
