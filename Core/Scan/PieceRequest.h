// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PieceRequest.h
 * @brief Which piece of a mesh a reader reads, and the arrays that tell where its points and cells
 * are in the whole.
 */
#ifndef camaron_PieceRequest_h
#define camaron_PieceRequest_h

#include "Base/Buffer.h"

class vtkDataSetAttributes;

namespace camaron
{
/// What part of a mesh somebody wants.
struct PieceRequest
{
  int Piece = 0;
  int NumberOfPieces = 1;
  int GhostLevels = 0;
};

/// Makes @a ids the global ids, as an array of this name.
void SetGlobalIds(vtkDataSetAttributes* attributes, Buffer<vtkIdType>&& ids, const char* name);
/// Makes @a flags, one of vtkDataSetAttributes' per tuple, the array of ghosts.
void SetGhosts(vtkDataSetAttributes* attributes, Buffer<unsigned char>&& flags);
}

#endif
