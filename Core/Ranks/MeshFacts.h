// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshFacts.h
 * @brief Facts about the whole mesh, across all its pieces, that criteria need.
 */
#ifndef camaron_MeshFacts_h
#define camaron_MeshFacts_h

#include "Ranks/LinkedPieces.h"
#include "Ranks/MeanSizes.h"
#include "Ranks/MeshRegions.h"
#include "Ranks/SurfaceSides.h"

#include <functional> // for the question whether to continue
#include <vector>     // for the pieces

namespace camaron
{
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
