// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Null.h
 * @brief Undefined values, which are NaN, with a reason.
 */
#ifndef camaron_Null_h
#define camaron_Null_h

namespace camaron
{
/// Why a value is undefined, as written to the mask arrays.
enum class NullReason : unsigned char
{
  Value = 0,           ///< the value is defined
  NotApplicable = 1,   ///< the criterion is not defined for this shape
  Degenerate = 2,      ///< 0/0
  InvalidTopology = 3, ///< open, non-manifold or too few points
  NoNeighbor = 4,      ///< requires a neighbor, and there is none
  MissingGhosts = 5,   ///< the neighbor is in another piece and not available as a ghost cell
  HigherOrder = 6      ///< the value is defined, but is that of the linear cell with the vertices
                       ///< of a higher-order cell
};

/// A quiet NaN with the reason in its payload, which survives copying but not arithmetic.
double Null(NullReason reason);
/// The reason of a NaN; Degenerate for a NaN from another source.
NullReason GetNullReason(double value);
}

#endif
