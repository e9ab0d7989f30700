// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedPoints.h
 * @brief Which points of a piece of a mesh other pieces have, too.
 *
 * Points within the box of another piece are compared by their keys (see PieceBorders); every
 * process compares its share of them.
 */
#ifndef camaron_SharedPoints_h
#define camaron_SharedPoints_h

#include "Ranks/PieceBorders.h"

#include <tuple>  // for comparisons
#include <vector> // for the points

namespace camaron
{
/// A piece of any process.
struct PieceAt
{
  std::int32_t Process, Piece;
  bool operator==(const PieceAt& other) const
  {
    return this->Process == other.Process && this->Piece == other.Piece;
  }
  bool operator<(const PieceAt& other) const
  {
    return std::tie(this->Process, this->Piece) < std::tie(other.Process, other.Piece);
  }
};

/// That a point of a piece is one of another piece.
struct SharedPoint
{
  vtkIdType Point;
  PieceAt Other;
};

/// Collective. Of every piece the points of its cells, but for copies, that such cells of other
/// pieces of the block have: sorted, with an entry for each of these pieces.
std::vector<std::vector<SharedPoint>> FindSharedPoints(
  const std::vector<LinkedPiece>& pieces, const PieceBorders& borders, Reducer& reducer);
}

#endif
