// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Rule.h
 * @brief A rule that a mesh has to satisfy: a criterion, its acceptable range, its cells, and a
 * tolerance. Documentation/check.md describes the language.
 */
#ifndef camaron_Rule_h
#define camaron_Rule_h

#include "Criteria/Criterion.h"

#include <cstdint>     // for counts
#include <limits>      // for open ends
#include <optional>    // for scopes
#include <string>      // for names
#include <string_view> // for words
#include <vector>      // for families

namespace camaron
{
/// Cells of the same shape, by topology; see the criterion CellFamilyId.
struct CellFamily
{
  const char* Name; ///< plural, such as "tetrahedra"
  int Id;           ///< value of CellFamilyId
};
/// All families, in the order of the documentation.
const std::vector<CellFamily>& GetCellFamilies();

enum class ScopeKind
{
  Family,
  CellType,
  Block,
  Array,
  Elements ///< the faces, edges or vertices of the mesh instead of its cells
};

/// The cells of a rule, or its other elements.
struct Scope
{
  ScopeKind Kind = ScopeKind::Family;
  /// Names of families or "2D cells" or "3D cells", separated by ", "; a VTK cell type without
  /// "vtk"; the path of a block; an integer; or "faces", "edges" or "vertices".
  std::string Value;
  std::string Array; ///< for ScopeKind::Array

  bool operator==(const Scope& other) const;
  /// "shape", "type", "block", "array" or "elements".
  const char* GetName() const;
  /// As in a rule: "of tetrahedra", "where Material = 3" or "of faces".
  std::string GetText() const;
  /// Values of CellFamilyId for ScopeKind::Family.
  std::vector<int> GetFamilyIds() const;
};

/// What rules judge: "cells", then "faces", "edges" and "vertices" in the order of
/// GetElementTables().
const std::vector<std::string>& GetJudgedElements();

/// The criteria of one of GetJudgedElements(); nullptr for other words.
const std::vector<Criterion>* GetCriteriaOf(const std::string& elements);

/// The scope of the shapes that a range is for; none for all cells.
std::optional<Scope> ToScope(unsigned shapes);

/// The cells that may fail: a percentage of the checked cells, or a number.
class Tolerance
{
public:
  Tolerance() = default;
  static Tolerance OfPercent(double percent, const std::string& text);
  static Tolerance OfCells(std::int64_t count);

  /// The number of checked cells that may fail.
  std::int64_t GetCells(std::int64_t checked) const;
  bool IsZero() const { return !this->Percent && this->Count == 0; }
  /// For tables, such as "0.1%" or "5", with up to 6 digits of a percentage.
  std::string GetText() const;
  /// With all digits.
  const std::string& GetExactText() const { return this->Exact; }

private:
  std::optional<double> Percent;
  std::int64_t Count = 0;
  std::string Exact = "0";
};

struct Rule
{
  std::string Criterion;
  ///@{
  /// Limits as written, infinite without a limit, and whether the limits themselves are acceptable.
  /// Infinite values never are.
  double Low = -std::numeric_limits<double>::infinity();
  double High = std::numeric_limits<double>::infinity();
  bool LowIncluded = true;
  bool HighIncluded = true;
  ///@}
  std::optional<camaron::Scope> Scope; ///< none: all cells
  camaron::Tolerance Tolerance;
  bool UndefinedFails = true; ///< whether undefined values fail
  bool IsHint = false;        ///< of a preset: violations are warnings
  int Line = 0;               ///< line of the text, from 1; 0 if the rule is not from a text
  std::string Source;         ///< name of the text
  std::string Preset;         ///< name of the preset that it is from; empty if written out

  bool HasRange() const;
  /// What is judged: "cells", "faces", "edges" or "vertices"; for a count of 1 in the singular.
  std::string GetElements(std::int64_t count = 0) const;
  bool IsOfCells() const { return !this->Scope || this->Scope->Kind != ScopeKind::Elements; }
  /// The criterion of these elements; never nullptr for a parsed rule.
  const camaron::Criterion* FindCriterion() const;

  /// The smallest and the largest acceptable number.
  double GetLeast() const;
  double GetMost() const;

  /// For tables: "0.2 to 1" or "> 0", with up to 6 digits; empty without limits.
  std::string GetRangeText() const;
  std::string GetScopeText() const { return this->Scope ? this->Scope->GetText() : std::string(); }
  /// Criterion, range and scope for tables and messages.
  std::string GetText() const;
  /// A line of rules with the same meaning, all digits and all clauses. Hints become rules that
  /// fail.
  std::string GetLineText() const;
};
}

#endif
