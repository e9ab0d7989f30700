// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OuterFacets.h
 * @brief Which faces of cells are on the outside, in a form that goes with the cells wherever they
 * go.
 *
 * Cells that are moved to another process, or joined with those of another piece, take this along:
 * a face that is left without a neighbor there is no part of the outside for that.
 */
#ifndef camaron_OuterFacets_h
#define camaron_OuterFacets_h

#include <cstdint> // for the bits
#include <vector>  // for the result

namespace camaron
{
class FacetLinks;
class MeshTopology;

/// The one that the faces from this number on share.
constexpr int LastFacetBit = 63;

/// The bit for a face by its number in the cell.
inline std::uint64_t GetFacetBit(int local)
{
  return std::uint64_t(1) << (local < LastFacetBit ? local : LastFacetBit);
}

/// Of every 3D cell the bits of its faces that no other cell has, here or by @a links (null:
/// nowhere else).
std::vector<std::uint64_t> FindOuterFacets(const MeshTopology& topology, const FacetLinks* links);
}

#endif
