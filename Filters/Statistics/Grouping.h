// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::Grouping
 * @brief Divides the cells or points of a mesh into groups that have statistics of their own.
 *
 * The first group is always that of all cells. A way to group is a row of the table in
 * Grouping.cxx: a key for each cell and a label for the key.
 */
#ifndef camaron_Grouping_h
#define camaron_Grouping_h

#include "ElementBlocks.h"

#include <string> // for labels
#include <vector> // for lists

namespace camaron
{
/// Those of a way to group are the same if they are equal, in whatever mesh.
struct Group
{
  bool IsAll = false;
  ExactValue Key; ///< an integer
  std::string Label;

  bool operator==(const Group& other) const
  {
    return this->IsAll == other.IsAll && this->Key == other.Key && this->Label == other.Label;
  }
};

class Grouping
{
public:
  /**
   * Collective. @a name: "None", "Cell type", "Block" or "Cell array"; throws std::invalid_argument
   * for any other, and for points by cell type, on all processes alike. By cell array, of points by
   * point array, there is a group for each whole number of 64 bits that the array @a arrayName with
   * one component holds, or if it is empty on all processes, the first array of integers, else the
   * first array; throws if there are more than 1000. Keeps a reference to @a blocks.
   */
  Grouping(const std::string& name, const std::string& arrayName, const ElementBlocks& blocks,
    Reducer& reducer);

  /// That of all elements, then the others by their keys; the same on every process.
  const std::vector<Group>& GetGroups() const { return this->Groups; }

  /// True if there is one group besides that of all elements and all are in it, which then has the
  /// same numbers.
  bool IsOneGroup() const { return this->OneGroup; }

  /// Of the array to group by; the same on every process.
  const std::string& GetArrayName() const { return this->ArrayName; }

  /// The part of @a values in a group, which may be one of another mesh; valid until the next call.
  Population GetPopulation(const Group& group, const BlockValues& values);

private:
  const ElementBlocks& Blocks;
  std::string ArrayName;
  bool OneGroup = false;
  std::vector<Group> Groups;
  std::vector<std::vector<int>>
    GroupNumbers; ///< in Groups, of the elements of each block, or one for all of them
  std::vector<std::vector<unsigned char>> Masks;
};

/// All groups of both, in their order.
std::vector<Group> JoinGroups(const std::vector<Group>& a, const std::vector<Group>& b);

/// Name of a cell type for people, such as "Tetra" or "Polyhedron".
std::string GetCellTypeLabel(int cellType);
/// Names of the blocks of all processes by their number. Collective.
std::vector<std::pair<int, std::string>> GetBlockNames(
  const ElementBlocks& blocks, Reducer& reducer);
}

#endif
