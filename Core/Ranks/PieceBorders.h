// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PieceBorders
 * @brief Where pieces of a mesh may meet, and what tells their points apart.
 *
 * Points of two pieces are the same when they have the same key: their global ids if all pieces
 * have them, else their coordinates, as float if some piece has floats.
 */
#ifndef camaron_PieceBorders_h
#define camaron_PieceBorders_h

#include "Base/Hash.h"
#include "Ranks/LinkedPieces.h"
#include "Ranks/Reducer.h"

#include <array>   // for keys
#include <cstdint> // for keys
#include <vector>  // for the pieces

namespace camaron
{
/// What all pieces with a point, and no other point, have in common.
using PointKey = std::array<std::uint64_t, 3>;

inline std::uint64_t Hash(const PointKey& key)
{
  return Mix(Mix(Mix(key[0]) ^ key[1]) ^ key[2]);
}

class PieceBorders
{
public:
  /// Collective. Borrows the pieces. @a withCopies: whether cells that are copies of others belong
  /// to them, too.
  PieceBorders(const std::vector<LinkedPiece>& pieces, Reducer& reducer, bool withCopies = false);

  /// Whether points are compared by their global ids.
  bool UsesIds() const { return this->HasIds; }
  PointKey GetKey(std::size_t piece, vtkIdType point) const;
  /// The key of a point of any piece.
  PointKey GetKey(std::int64_t id, const double x[3]) const;
  /// Of every point whether it lies in the box around the cells of another piece of the block;
  /// empty if none does.
  std::vector<unsigned char> FindNearPoints(std::size_t piece) const;

private:
  struct Box
  {
    std::int32_t Process, Piece, Block;
    double Low[3], High[3];

    bool Intersects(const Box& other) const;
    bool Contains(const double x[3]) const;
  };
  void FindWhatPointsHave(Reducer& reducer);
  void FindBoxes(Reducer& reducer);
  void AddToBox(const LinkedPiece& piece, vtkIdType cell, Box& box) const;
  void GetPoint(const MeshView& mesh, vtkIdType id, double x[3]) const;

  const std::vector<LinkedPiece>& Pieces;
  const std::int32_t Process;
  const bool WithCopies;
  bool HasIds = false;
  bool HasFloats = false;
  std::vector<Box> Boxes; // of the pieces of all processes
};
}

#endif
