// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PieceRequest.h
 * @brief The piece of a mesh that a reader reads, and the arrays that locate its points and cells
 * in the whole mesh.
 */
#ifndef camaron_PieceRequest_h
#define camaron_PieceRequest_h

#include "Base/Buffer.h"

class vtkDataSetAttributes;

namespace camaron
{
/// The requested piece of a mesh.
struct PieceRequest
{
  int Piece = 0;
  int NumberOfPieces = 1;
  int GhostLevels = 0;
};

/// Sets @a ids as global ids, in an array with this name.
void SetGlobalIds(vtkDataSetAttributes* attributes, Buffer<vtkIdType>&& ids, const char* name);
/// Sets @a flags, ghost flags of vtkDataSetAttributes per tuple, as the ghost array.
void SetGhosts(vtkDataSetAttributes* attributes, Buffer<unsigned char>&& flags);
}

#endif
