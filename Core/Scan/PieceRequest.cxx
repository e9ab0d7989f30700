// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/PieceRequest.h"

#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"

namespace camaron
{
//------------------------------------------------------------------------------
void SetGlobalIds(vtkDataSetAttributes* attributes, Buffer<vtkIdType>&& ids, const char* name)
{
  const auto array = ids.TakeArray<vtkIdTypeArray>();
  array->SetName(name);
  attributes->SetGlobalIds(array);
}

//------------------------------------------------------------------------------
void SetGhosts(vtkDataSetAttributes* attributes, Buffer<unsigned char>&& flags)
{
  const auto array = flags.TakeArray<vtkUnsignedCharArray>();
  array->SetName(vtkDataSetAttributes::GhostArrayName());
  attributes->AddArray(array);
}
}
