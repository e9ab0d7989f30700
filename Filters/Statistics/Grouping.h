// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::Grouping
 * @brief Divides the cells or points of a mesh into groups with their own statistics.
 *
 * The first group always contains all cells or points. A way to group is a row of the table in
 * Grouping.cxx: a function that computes a key for each element, and a label for the key.
 */
#ifndef camaron_Grouping_h
#define camaron_Grouping_h

#include "ElementBlocks.h"

#include <string> // for labels
#include <vector> // for lists

namespace camaron
{
/// A group. Groups of different meshes, for the same way to group, correspond if they are equal:
/// the numbers of blocks and zones differ between meshes.
struct Group
{
  bool IsAll = false;
  double Key = 0;    ///< an integer, for the order; not of texts
  std::string Label; ///< other groups of the mesh have others

  bool operator==(const Group& other) const
  {
    return this->IsAll == other.IsAll && this->Label == other.Label;
  }
};

class Grouping
{
public:
  /**
   * Collective. Stores a reference to @a blocks.
   *
   * @param name "None", "Cell type" (not for points), "Block" or "Cell array"
   * @param arrayName for "Cell array": a one-component cell array, for points a point array, with
   * one group per integer that is one of its values, or per text, at most 1000. Empty on all
   * processes: the first integer array, else the first array of numbers, else of texts. Labels are
   * the texts, in their order, and where the field data have arrays that name the values, such as
   * ZoneIds and ZoneNames for Zone, these names.
   *
   * Throws std::invalid_argument on all processes if @a name is unknown or not for this element
   * type, if there are too many groups, if the array has texts only in some blocks and numbers in
   * others, or as ElementBlocks::RequireExactIntegers does.
   */
  Grouping(const std::string& name, const std::string& arrayName, const ElementBlocks& blocks,
    Reducer& reducer);

  /// The group of all elements, then the others by key; the same on every process.
  const std::vector<Group>& GetGroups() const { return this->Groups; }

  /// Whether there is only one group besides that of all elements and it contains all of them, so
  /// that its statistics are the same.
  bool IsOneGroup() const { return this->OneGroup; }

  /// Name of the array to group by; the same on every process.
  const std::string& GetArrayName() const { return this->ArrayName; }

  /// The part of @a values that belongs to @a group, which may be a group of another mesh. Valid
  /// until the next call.
  Population GetPopulation(const Group& group, const BlockValues& values);

private:
  void RefuseMany(std::size_t number, std::size_t most) const;

  const ElementBlocks& Blocks;
  std::string ArrayName;
  bool OneGroup = false;
  std::vector<Group> Groups;
  std::vector<std::vector<int>>
    GroupNumbers; ///< index in Groups per element of each block, or one index for the whole block
  std::vector<std::vector<unsigned char>> Masks;
};

/// The union of the groups of two meshes, in their order.
std::vector<Group> JoinGroups(const std::vector<Group>& a, const std::vector<Group>& b);

/// Display name of a VTK cell type, such as "Tetra" or "Polyhedron".
std::string GetCellTypeLabel(int cellType);
/// Numbers and names of blocks, by number.
using BlockNames = std::vector<std::pair<int, std::string>>;
/// Collective. Those of the blocks of all processes.
BlockNames GetBlockNames(const ElementBlocks& blocks, Reducer& reducer);
/// The name of a block; empty if it is not among them.
std::string FindBlockName(const BlockNames& names, int number);
}

#endif
