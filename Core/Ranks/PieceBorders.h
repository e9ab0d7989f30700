// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PieceBorders
 * @brief Where pieces of a mesh may meet, and keys that identify points across pieces.
 *
 * Points of two pieces are the same if they have the same key: their global ids if all pieces have
 * them, otherwise their coordinates, converted to float if any piece stores float.
 */
#ifndef camaron_PieceBorders_h
#define camaron_PieceBorders_h

#include "Base/Hash.h"
#include "Geometry/Bounds.h"
#include "Ranks/LinkedPieces.h"
#include "Ranks/Reducer.h"

#include <array>   // for keys
#include <cstdint> // for keys
#include <tuple>   // for comparisons
#include <vector>  // for the pieces

namespace camaron
{
/// Identifies a point across all pieces.
using PointKey = std::array<std::uint64_t, 3>;

inline std::uint64_t Hash(const PointKey& key)
{
  return Mix(Mix(Mix(key[0]) ^ key[1]) ^ key[2]);
}

/// The box around a piece.
struct PieceBox
{
  std::int32_t Process, Piece, Block;
  Bounds Box;

  /// Whether it is of another piece of the same block.
  bool IsBeside(const PieceBox& other) const
  {
    return this->Block == other.Block &&
      (this->Process != other.Process || this->Piece != other.Piece);
  }
};

class PieceBorders
{
public:
  /// Collective. Keeps references to the pieces. @a withCopies: whether duplicates of cells belong
  /// to the pieces, too.
  PieceBorders(const std::vector<LinkedPiece>& pieces, Reducer& reducer, bool withCopies = false);

  /// Whether points are compared by their global ids.
  bool UsesIds() const { return this->HasIds; }
  PointKey GetKey(std::size_t piece, vtkIdType point) const;
  /// The key of a point with this global id and these coordinates.
  PointKey GetKey(std::int64_t id, const Vector& x) const;
  /// For every point, whether it is within the bounding box of the cells of another piece of the
  /// block; empty if none is.
  std::vector<unsigned char> FindNearPoints(std::size_t piece) const;

private:
  void FindWhatPointsHave(Reducer& reducer);
  void FindBoxes(Reducer& reducer);
  Vector GetPoint(const MeshView& mesh, vtkIdType id) const;

  const std::vector<LinkedPiece>& Pieces;
  const std::int32_t Process;
  const bool WithCopies;
  bool HasIds = false;
  bool HasFloats = false;
  std::vector<PieceBox> Boxes; // of the pieces of all ranks
};

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
