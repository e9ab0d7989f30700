// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::RecentTopologies
 * @brief Topologies of the cells before, which the next one shares if it has the same faces in local numbers.
 *
 * Cells of one or two kinds one after the other, as generators make them, so have their edges found once. Only few are
 * kept: where all cells differ, those that are should stay in the nearest cache.
 */
#ifndef camaron_RecentTopologies_h
#define camaron_RecentTopologies_h

#include "Mesh/CellTopology.h"

namespace camaron
{
class RecentTopologies
{
public:
  ///@{
  /// Of the next cell, as in CellTopology; what they hold may be overwritten.
  std::vector<int> FaceOffsets, FacePoints;
  ///@}

  /**
   * The finished topology of these faces, until the next call.
   * @param edgesCanWait and @a wasRepeated as of CellTopology::Finish
   */
  CellTopology& Find(int numberOfPoints, bool edgesCanWait, bool& wasRepeated);

private:
  CellTopology Topologies[2];
  int Last = 0; // the one that was found
};
}

#endif
