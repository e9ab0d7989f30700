// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PointGrid
 * @brief Decides which positions coincide, and hashes cubes of space to find them.
 *
 * Two cubes may have the same hash, so distances must be compared in any case.
 */
#ifndef camaron_PointGrid_h
#define camaron_PointGrid_h

#include "Base/Vector.h"
#include "Ranks/PieceBorders.h"

#include <algorithm> // for the pieces
#include <cstdint>   // for hashes
#include <vector>    // for the pieces

namespace camaron
{
class PointGrid
{
public:
  /**
   * @param tolerance a length; 0 for 8 machine epsilons of the larger of the compared coordinates
   * @param hasFloats whether the machine epsilon is that of float, not double
   * @param largest largest coordinate of all positions
   */
  PointGrid(double tolerance, bool hasFloats, double largest);

  /// The largest absolute coordinate; infinite or NaN if any coordinate is.
  static double GetSize(const Vector& place);

  /// Maximum distance of coincident positions.
  double GetReach() const { return this->Reach; }
  bool AreNear(const Vector& a, const Vector& b) const;
  /// Hash of the cube around a position with finite coordinates.
  std::uint64_t GetHash(const Vector& place) const { return Hash(this->GetCube(place)); }
  /// Calls @a visit(hash) for all cubes within reach of a position; some may be visited twice.
  template <typename Visit>
  void ForNear(const Vector& place, Visit&& visit) const
  {
    const Vector reach = { this->Reach, this->Reach, this->Reach };
    const Vector low = this->GetCube(place - reach), high = this->GetCube(place + reach);
    for (double x = low.X; x <= high.X; ++x)
    {
      for (double y = low.Y; y <= high.Y; ++y)
      {
        for (double z = low.Z; z <= high.Z; ++z)
        {
          visit(Hash({ x, y, z }));
        }
      }
    }
  }

private:
  Vector GetCube(const Vector& place) const;
  static std::uint64_t Hash(const Vector& cube);

  double Tolerance, Rounding, Reach, Cube;
};

/// The properties of a piece, all of whose positions are compared, that all ranks know.
struct ComparedPiece : PieceBox
{
  double Largest; ///< largest finite absolute coordinate
  bool HasFloats;
};

/// The grid for the positions of all pieces.
template <typename Piece>
PointGrid MakePointGrid(double tolerance, const std::vector<Piece>& pieces)
{
  double largest = 0;
  bool hasFloats = false;
  for (const Piece& piece : pieces)
  {
    largest = std::max(largest, piece.Largest);
    hasFloats = hasFloats || piece.HasFloats;
  }
  return { tolerance, hasFloats, largest };
}

/// The boxes of the other pieces of the block of a piece, enlarged by a distance.
template <typename Piece>
std::vector<Bounds> FindOtherBoxes(
  const Piece& own, const std::vector<Piece>& pieces, double distance)
{
  std::vector<Bounds> boxes;
  for (const Piece& piece : pieces)
  {
    if (piece.IsBeside(own))
    {
      boxes.push_back(piece.Box);
      boxes.back().Grow(distance);
    }
  }
  return boxes;
}
}

#endif
