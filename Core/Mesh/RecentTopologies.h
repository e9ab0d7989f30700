// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::RecentTopologies
 * @brief Topologies of the cells before, which the next one shares if it has the same faces in
 * local numbers.
 *
 * Cells of one or two kinds one after the other, as generators make them, so have their points
 * numbered and their edges found once. Only few are kept: where all cells differ, those that are
 * should stay in the nearest cache.
 */
#ifndef camaron_RecentTopologies_h
#define camaron_RecentTopologies_h

#include "Base/Hash.h"
#include "Mesh/CellTopology.h"

#include <cstdint> // for the table

namespace camaron
{
class RecentTopologies
{
public:
  /// One of them; corners are places in the list of the points of all faces.
  struct Recent
  {
    CellTopology Topology;
    std::vector<int>
      PointCorners; ///< of every local number its first corner; of what Recognize returns
    struct Repetition
    {
      int Corner, First; // of the same number
    };
    std::vector<Repetition> Repetitions; // of all other corners
    bool HasCorners = false, IsInOrder = false;
  };

  ///@{
  /// Of the next cell, as in CellTopology; what they hold may be overwritten.
  std::vector<int> FaceOffsets, FacePoints;
  ///@}

  /**
   * The finished topology of these faces, until the next call.
   * @param edgesCanWait and @a wasRepeated as of CellTopology::Finish
   */
  CellTopology& Find(int numberOfPoints, bool edgesCanWait, bool& wasRepeated);

  /**
   * The one that Find would find for the corners with these ids, without FacePoints and numbers, or
   * none if there is none or telling takes too long. No point of its faces follows itself; edges
   * are there only if they were.
   */
  template <typename Id>
  Recent* Recognize(const Id* ids)
  {
    for (const int i : { this->Last, 1 - this->Last })
    {
      Recent& recent = this->Recents[i];
      if (recent.Topology.KnowsSizes(this->FaceOffsets) && this->HasSameNumbers(ids, recent))
      {
        this->Last = i;
        return &recent;
      }
    }
    return nullptr;
  }

private:
  static constexpr int TableBits = 12; // few ids of a cell meet in one place

  template <typename Id>
  bool HasSameNumbers(const Id* ids, Recent& recent)
  {
    if (!recent.HasCorners)
    {
      FindCorners(recent);
    }
    Id difference = 0;
    for (const Recent::Repetition& repetition : recent.Repetitions)
    {
      difference |= ids[repetition.Corner] ^ ids[repetition.First];
    }
    return recent.IsInOrder && difference == 0 && this->AreDistinct(ids, recent.PointCorners);
  }

  // Every id writes its number into a table, where it finds another one only if their hashes are
  // the same: then it is compared with all.
  template <typename Id>
  bool AreDistinct(const Id* ids, const std::vector<int>& corners)
  {
    const int size = static_cast<int>(corners.size());
    std::uint16_t places[MaxNumbers];
    if (size > MaxNumbers)
    {
      return false;
    }
    for (int i = 0; i < size; ++i)
    {
      places[i] = static_cast<std::uint16_t>(
        static_cast<std::uint64_t>(ids[corners[i]]) * HashFactor >> (64 - TableBits));
      this->Table[places[i]] = static_cast<unsigned char>(i);
    }
    int isTaken = 0;
    for (int i = 0; i < size; ++i)
    {
      isTaken |= this->Table[places[i]] ^ i;
    }
    for (int i = 0; isTaken && i < size; ++i)
    {
      for (int j = 0; this->Table[places[i]] != i && j < size; ++j)
      {
        if (j != i && ids[corners[j]] == ids[corners[i]])
        {
          return false;
        }
      }
    }
    return true;
  }

  static void FindCorners(Recent& recent);

  static constexpr int MaxNumbers = 256;
  Recent Recents[2];
  int Last = 0; // the one that was found
  unsigned char Table[1 << TableBits] = {};
};
}

#endif
