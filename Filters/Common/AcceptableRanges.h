// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AcceptableRanges.h
 * @brief What the table of criteria knows about an array that is named like a criterion.
 */
#ifndef camaron_AcceptableRanges_h
#define camaron_AcceptableRanges_h

#include "Criteria/Criterion.h"
#include "Ranks/Reducer.h"
#include "Statistics/Summary.h"
#include "Statistics/Worst.h"

#include "vtkSmartPointer.h" // for names

#include <optional> // for what may be unknown
#include <string>   // for names
#include <vector>   // for rules

class vtkStringArray;

namespace camaron
{
/// Stands for the ranges of the table of criteria where the name of a preset is expected.
inline const char* GetDefaultRangesName()
{
  return "Default ranges";
}

/// The choices of a property for presets: @a first, which is none of them, then the presets by
/// name.
vtkSmartPointer<vtkStringArray> MakePresetNames(const char* first);

/// A range, and the Shapes of the cells that it is for; AnyCell where it is for all that have
/// values.
struct AcceptableRange : ValueRange
{
  unsigned Shapes = AnyCell;
};

/// Ranges in which values of criteria are acceptable.
class AcceptableRanges
{
public:
  /**
   * Those of a file of the user (RangesFile.h; none if the path is empty), else of the preset, else
   * of the table of criteria. Throws std::invalid_argument for an unknown preset and
   * std::runtime_error for a file that cannot be read, on all processes alike: process 0 reads it
   * for all.
   */
  AcceptableRanges(const std::string& preset, const std::string& file, Reducer& reducer);

  /// The range of a criterion, if there is one. @a unit is that of the values: angles may be in
  /// "rad". Those of a file are for all cells.
  std::optional<AcceptableRange> Find(const std::string& criterion, const std::string& unit) const;

  /// Whether the file or the preset says something of a criterion; without both, whether there is
  /// one of that name.
  bool HasRule(const std::string& criterion) const;

  /// Whether its range is a hint only; what a file of the user says is not.
  bool IsHint(const Criterion& criterion) const;

private:
  const Preset::Rule* FindRule(const std::string& name) const;

  bool IsDefault;
  std::vector<Preset::Rule> Rules; // in the order in which they count
};

/// Shapes of the cells that the range of the table of criteria is for; AnyCell if it is for all
/// that have values.
unsigned GetJudgedShapes(const Criterion& criterion);

/// The rules of a file of ranges; collective, throws std::runtime_error as above.
std::vector<Preset::Rule> ReadRangesFile(const std::string& path, Reducer& reducer);

/// Where the bad values of the criterion are, if it has a direction.
std::optional<WorstEnd> FindWorstEnd(const std::string& criterion);

/**
 * The same with the choice of a user: "By criterion", "Largest" or "Smallest"; throws
 * std::invalid_argument for any other.
 */
std::optional<WorstEnd> FindWorstEnd(const std::string& criterion, const std::string& choice);
}

#endif
