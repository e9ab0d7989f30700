// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::RecentTopologies
 * @brief Cache of the topologies of the last cells, reused for a cell with the same faces in local
 * point numbers.
 *
 * Mesh generators write many cells of one or two types in a row, whose points and edges need to be
 * numbered only once. Only two topologies are kept, so that they stay in the first-level cache if
 * all cells differ.
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
  /// A cached topology. Corners are positions in the list of the points of all faces.
  struct Recent
  {
    CellTopology Topology;
    std::vector<int>
      PointCorners; ///< for every local number its first corner; set in what Recognize returns
    struct Repetition
    {
      int Corner, First; // of the same number
    };
    std::vector<Repetition> Repetitions; // all other corners
    bool HasCorners = false, IsInOrder = false;
  };

  ///@{
  /// Faces of the next cell, as in CellTopology. Fill them before Find or Recognize; the previous
  /// contents may be overwritten.
  std::vector<int> FaceOffsets, FacePoints;
  ///@}

  /**
   * The finished topology of these faces; valid until the next call.
   * @param edgesCanWait and @a wasRepeated as in CellTopology::Finish
   */
  CellTopology& Find(int numberOfPoints, bool edgesCanWait, bool& wasRepeated);

  /**
   * The topology that Find would return for corners with these point ids, but without FacePoints
   * and local numbers; nullptr if there is none or the comparison would take too long. None of its
   * faces has consecutive repeated points; its edges are present only if they were before.
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
  static constexpr int TableBits = 12; // few ids of a cell share an entry

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

  // Every id stores its number in a hash table. Only an id with the same hash overwrites it; such
  // ids are compared with all others.
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
  int Last = 0; // index of the last match
  unsigned char Table[1 << TableBits] = {};
};
}

#endif
