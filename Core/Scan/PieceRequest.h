// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef camaron_PieceRequest_h
#define camaron_PieceRequest_h

namespace camaron
{
/// What part of a mesh somebody wants.
struct PieceRequest
{
  int Piece = 0;
  int NumberOfPieces = 1;
  int GhostLevels = 0;
};
}

#endif
