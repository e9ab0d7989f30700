// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file QualityRegions.h
 * @brief Connected regions of bad cells, and what they contain.
 */
#ifndef camaron_QualityRegions_h
#define camaron_QualityRegions_h

#include "Statistics/Worst.h"
#include "Strategies/Strategy.h"

#include <array>    // for coordinates
#include <cstdint>  // for counts
#include <optional> // for the end of the range
#include <vector>   // for regions

namespace camaron
{
struct QualityRegion
{
  std::int64_t Count = 0; ///< number of cells
  ///@{
  /// The worst cell: its value, its id, and the number of its block. Of equal values, the smallest
  /// id.
  double WorstValue = 0;
  vtkIdType WorstId = -1;
  int BlockNumber = -1;
  ///@}
  std::array<double, 3> Center = {}; ///< mean of the positions of the cells, see PlaceFinder
  double Size = 0;                   ///< diagonal of the bounding box of the points of the cells
  double Volume = 0; ///< sum of the magnitudes of the volumes; undefined and infinite ones are 0
};

struct QualityRegions
{
  std::int64_t Total = 0; ///< number of all regions
  /// The largest regions, largest first; of equally large ones, the one with the smallest id.
  std::vector<QualityRegion> Largest;
  bool HaveVolumes = false;
};

/// The regions of a set of cells.
class RegionFinder
{
public:
  /// Collective. The bad cells are those outside of the range of @a task, see SelectByCriterion. If
  /// @a includesUndefined, those with an undefined value, too, if the criterion and the range apply
  /// to them. Stores a reference to @a task.
  RegionFinder(const SelectionTask& task, bool includesUndefined);

  /**
   * Collective. Finds the @a count largest regions (0: all) that are connected according to the
   * properties of the task. Results are the same on all processes, for any number of them.
   */
  QualityRegions Find(std::int64_t count);

private:
  struct Part;
  struct Sums;
  using CellsOfRegions = std::vector<std::vector<LargestParts::PartCell>>;

  Part GetPart(const ValueBlock& block, vtkIdType cell) const;
  std::vector<Part> FindParts(const CellsOfRegions& cells, std::size_t numberOfRegions) const;
  void AddSums(const CellsOfRegions& cells, const std::vector<Part>& parts,
    std::vector<QualityRegion>& regions) const;
  /// Calls visit(block number, cell, region) for the cells of all regions.
  template <typename Visit>
  static void ForEach(const CellsOfRegions& cells, Visit&& visit);

  const SelectionTask& Task;
  BlockValues Values, Volumes;
  ExactRange Range;
  std::optional<WorstEnd> End;
  std::vector<const ValueBlock*> ValuesOfBlocks, VolumesOfBlocks; // nullptr without the array
  SelectionMarks Marks;
};
}

#endif
