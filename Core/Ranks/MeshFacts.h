// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshFacts.h
 * @brief What criteria read of the mesh as a whole, in all its pieces.
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
   * Collective. Computes the facts that @a needs, a combination of Needs, names, except those that
   * the options of the pieces have on all processes, and sets them in these options, which must not
   * outlive this object. Link the pieces before.
   * @param goesOn called before each step, on all processes; false stops
   * @return false when stopped
   */
  bool Find(unsigned needs, std::vector<LinkedPiece>& pieces, Reducer& reducer,
    const std::function<bool()>& goesOn);

private:
  MeanSizes Means;
  std::vector<SurfaceSides> Sides;
  std::vector<MeshRegions> Regions;
  std::vector<PointRegions> PointGroups;
};
}

#endif
