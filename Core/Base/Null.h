// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Null.h
 * @brief Values that are undefined, and why.
 */
#ifndef camaron_Null_h
#define camaron_Null_h

namespace camaron
{
/// Why a value is null, as written to the mask arrays.
enum class NullReason : unsigned char
{
  Value = 0,           ///< not null
  NotApplicable = 1,   ///< the criterion has no meaning for this shape
  Degenerate = 2,      ///< 0/0
  InvalidTopology = 3, ///< open, non-manifold or too few points
  NoNeighbor = 4,      ///< needs a neighbor and is at the boundary
  MissingGhosts = 5,   ///< the neighbor lies in another piece and no ghost cell tells of it
  HigherOrder = 6      ///< the value is there, but of the corners of a higher-order cell
};

/// A quiet NaN that remembers its reason in its payload; it survives copying, not arithmetic.
double Null(NullReason reason);
/// The reason of a null value; Degenerate for a NaN made elsewhere.
NullReason GetNullReason(double value);
}

#endif
