// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OuterFacets.h
 * @brief Marks the boundary faces of cells, in a form that can be passed on with the cells.
 *
 * If cells are sent to another rank or merged with those of another piece, a face may lose its
 * neighbor without being at the boundary.
 */
#ifndef camaron_OuterFacets_h
#define camaron_OuterFacets_h

#include <cstdint> // for the bits
#include <vector>  // for the result

namespace camaron
{
class FacetLinks;
class MeshTopology;

/// Shared by all faces from this index on.
constexpr int LastFacetBit = 63;

/// The bit of a face by its index in the cell.
inline std::uint64_t GetFacetBit(int local)
{
  return std::uint64_t(1) << (local < LastFacetBit ? local : LastFacetBit);
}

/// For every 3D cell the bits of its faces without another cell, in this piece or in @a links
/// (nullptr: no other pieces).
std::vector<std::uint64_t> FindOuterFacets(const MeshTopology& topology, const FacetLinks* links);
}

#endif
