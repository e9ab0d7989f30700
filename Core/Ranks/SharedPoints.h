// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedPoints.h
 * @brief Finds the points that a piece of a mesh shares with other pieces.
 *
 * Points within the bounding box of another piece are compared by their keys (see PieceBorders);
 * every rank compares a part of them.
 */
#ifndef camaron_SharedPoints_h
#define camaron_SharedPoints_h

#include "Ranks/PieceBorders.h"

#include <tuple>  // for comparisons
#include <vector> // for the points

namespace camaron
{
/// A piece of any rank.
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

/// States that a point of a piece is a point of another piece.
struct SharedPoint
{
  vtkIdType Point;
  PieceAt Other;
};

/// Collective. For every piece, those points of its cells that cells of other pieces of the block
/// use, ignoring duplicates: sorted, with an entry for each of these other pieces.
std::vector<std::vector<SharedPoint>> FindSharedPoints(
  const std::vector<LinkedPiece>& pieces, const PieceBorders& borders, Reducer& reducer);
}

#endif
