// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshFacts.h
 * @brief Facts about the whole mesh, across all its pieces, that criteria need.
 */
#ifndef camaron_MeshFacts_h
#define camaron_MeshFacts_h

#include "Ranks/LinkedPieces.h"
#include "Ranks/Reducer.h"
#include "Ranks/SurfaceSides.h"

#include <cstdint>    // for numbers
#include <functional> // for the question whether to continue
#include <vector>     // for the pieces

namespace camaron
{
/// NaN if there is no such cell.
struct MeanSizes
{
  enum Kind
  {
    PolygonArea,
    PolyhedronVolume,
    TriangleArea, ///< this and the following sizes are those of Verdict
    QuadrilateralArea,
    TetrahedronVolume,
    HexahedronVolume,
    NumberOfKinds
  };
  double Of[NumberOfKinds];
};

/**
 * Collective. Means over all pieces of all ranks, computed exactly and rounded once, so they do
 * not depend on how the mesh is split. Ghost cells and cells without a finite size do not count;
 * inverted cells count as negative.
 */
MeanSizes GetMeanSizes(const std::vector<LinkedPiece>& pieces, Reducer& reducer);

/// Size of a triangle, quadrilateral, tetrahedron or hexahedron as Verdict computes it, and the
/// kind of this size; false for any other cell. Requires NeedsFaces and NeedsVolume.
bool GetVerdictSize(const CellGeometry& cell, MeanSizes::Kind& kind, double& size);

struct MeshRegions
{
  static constexpr std::int64_t None = -1;    ///< not a 2D or 3D cell, or one without facets
  static constexpr std::int64_t Unknown = -2; ///< a duplicate not connected to any own cell of its
                                              ///< piece
  std::vector<std::int64_t> OfCells;
};

/**
 * Collective. Regions of all pieces, connected over their Options.Links, numbered from 0 in the
 * order of their first cells: by global ids, otherwise block by block and piece by piece.
 */
std::vector<MeshRegions> FindMeshRegions(const std::vector<LinkedPiece>& pieces, Reducer& reducer);

/// For every point of a piece; see CountPointRegions.
struct PointRegions
{
  std::vector<Index> Counts;
};

/// Collective. Includes the cells of other pieces of the block at the points of each piece, whose
/// Data must be set. Additional time and memory are proportional to the number of cells at borders.
std::vector<PointRegions> FindPointRegions(
  const std::vector<LinkedPiece>& pieces, Reducer& reducer);

class MeshFacts
{
public:
  /**
   * Collective. Computes the facts named by @a needs, a combination of Needs, except those that
   * the options of the pieces already have on all ranks, and sets them in these options, which
   * must not outlive this object. The pieces must be linked before.
   * @param goOn called before each step, on all ranks; throws on all of them to stop
   */
  void Find(unsigned needs, std::vector<LinkedPiece>& pieces, Reducer& reducer,
    const std::function<void()>& goOn);

private:
  MeanSizes Means;
  std::vector<SurfaceSides> Sides;
  std::vector<MeshRegions> Regions;
  std::vector<PointRegions> PointGroups;
};
}

#endif
