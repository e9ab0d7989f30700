// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PieceArrays.h
 * @brief The arrays that tell where points and cells of a piece are in the whole mesh.
 */
#ifndef camaron_PieceArrays_h
#define camaron_PieceArrays_h

#include "Base/Buffer.h"

class vtkDataSetAttributes;

namespace camaron
{
/// Makes @a ids the global ids, as an array of this name.
void SetGlobalIds(vtkDataSetAttributes* attributes, Buffer<vtkIdType>&& ids, const char* name);
/// Makes @a flags, one of vtkDataSetAttributes' per tuple, the array of ghosts.
void SetGhosts(vtkDataSetAttributes* attributes, Buffer<unsigned char>&& flags);
}

#endif
