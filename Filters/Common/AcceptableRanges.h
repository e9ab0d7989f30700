// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AcceptableRanges.h
 * @brief Acceptable ranges and bad ends of criteria, found by the name of an array, and the cells
 * to which a range applies.
 *
 * An array with the name of a criterion of cells, faces, edges or vertices is judged by that
 * criterion (Core/Elements/ElementCriteria.h). Its acceptable range comes from a file of the user,
 * a preset, or the table of criteria.
 */
#ifndef camaron_AcceptableRanges_h
#define camaron_AcceptableRanges_h

#include "Criteria/Criterion.h"
#include "ElementBlocks.h"
#include "Ranks/Reducer.h"
#include "Statistics/Summary.h"
#include "Statistics/Worst.h"

#include "vtkSmartPointer.h" // for names

#include <cstdint>     // for shapes
#include <optional>    // for optional results
#include <string>      // for names
#include <string_view> // for names
#include <vector>      // for rules

class vtkStringArray;

namespace camaron
{
/// Choice of the Preset properties that means "the ranges of the table of criteria".
inline const char* GetDefaultRangesName()
{
  return "Default ranges";
}

/// Choices of a Preset property: @a first, which is not the name of a preset, then the names of all
/// presets.
vtkSmartPointer<vtkStringArray> MakePresetNames(const char* first);

/// A closed range of acceptable values, and the Shapes of the cells that it applies to: AnyCell if
/// it applies to all cells that have a value.
struct AcceptableRange : ValueRange
{
  unsigned Shapes = AnyCell;
};

/// The acceptable ranges that a user has chosen.
class AcceptableRanges
{
public:
  /**
   * Collective. A criterion has the range in the lines, else in the file, else that of the preset,
   * else that of the table of criteria.
   *
   * @param preset name of a preset or GetDefaultRangesName()
   * @param file path of a file of ranges (ParsedRules.h); empty: none. Process 0 reads it for all.
   * @param lines lines as of such a file, the same on all processes
   *
   * Throws std::invalid_argument for an unknown preset and std::runtime_error for a file that
   * cannot be read and for invalid lines, on all processes.
   */
  AcceptableRanges(const std::string& preset, const std::string& file, Reducer& reducer,
    const std::string& lines = {});

  /**
   * The range of a criterion in @a unit, the unit of the values: ranges of angles are converted if
   * it is "rad". None if the criterion is unknown or its range is unbounded at both ends. Ranges of
   * a file apply to all cells.
   */
  std::optional<AcceptableRange> Find(const std::string& criterion, const std::string& unit) const;

  /// Whether the lines, the file or the preset have a range for the criterion. With the default
  /// ranges only: whether the criterion exists.
  bool HasRule(const std::string& criterion) const;

  /// Whether the range of the criterion is only a hint, not a requirement of its source. Ranges of
  /// the user are never hints.
  bool IsHint(const Criterion& criterion) const;

private:
  const Preset::Rule* FindRule(const std::string& name) const;

  bool IsDefault;
  std::vector<Preset::Rule> Rules; // by priority: the first rule for a criterion applies
};

/// Shapes of the cells to which the range of the table of criteria applies; AnyCell if it applies
/// to all cells that have a value.
unsigned GetJudgedShapes(const Criterion& criterion);

/// Collective. The rules in lines of ranges, and in a file of ranges unless its path is empty, of
/// the criteria that find knows. Throws std::runtime_error on all processes for invalid lines and
/// for a file that cannot be read.
std::vector<Preset::Rule> ReadRanges(const std::string& lines, const std::string& path,
  Reducer& reducer, const Criterion* (*find)(std::string_view) = FindCriterion);

/// "Smaller", "Neither" or "Bigger".
const char* GetBetterName(Better better);

/// The bad end of the criterion's range. None if the criterion is unknown, or if neither small nor
/// large values are worse. A one-sided acceptable range has a bad end: volumes must be above 0.
std::optional<WorstEnd> FindWorstEnd(const std::string& criterion);

/// The bad end that the property Worst Values chooses: "By criterion" (as above), "Largest" or
/// "Smallest". Throws std::invalid_argument for any other text.
std::optional<WorstEnd> FindWorstEnd(const std::string& criterion, const std::string& choice);

/**
 * Shapes (Criterion.h) of every cell; 0 for points and lines. Cells of a fixed VTK type have the
 * shape of their type, even if they are degenerate. Polygons and polyhedra have the shape of their
 * topology: a VTK_POLYHEDRON with the faces of a hexahedron is a hexahedron.
 */
std::vector<std::uint16_t> FindCellShapes(vtkDataSet* data);

/// Name of a cell array of faces: the shapes of the cells that they are of, see vtkMeshSurface.
inline const char* GetCellShapesName()
{
  return "CellShapes";
}

/// Provides the shapes of all cells of a mesh. They are computed when a range that does not apply
/// to all cells is first used.
class BlockShapes
{
public:
  /// Stores a reference to @a blocks, which must outlive this object.
  explicit BlockShapes(const ElementBlocks& blocks)
    : Blocks(blocks)
  {
  }

  /// Sets in @a values to which cells the range applies, if that depends on their shapes, and
  /// returns whether it does. @a values borrows memory of this object.
  bool Judge(BlockValues& values, const std::optional<AcceptableRange>& range);

private:
  const ElementBlocks& Blocks;
  std::vector<std::vector<std::uint16_t>> Shapes; // one list per block
};
}

#endif
