// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InspectedMeshTypes.h
 * @brief Questions of the Mesh Inspector about a mesh, and their answers: plain data.
 */
#ifndef camaron_InspectedMeshTypes_h
#define camaron_InspectedMeshTypes_h

#include "PanelTable.h"

#include "CumulativeCounts.h"
#include "HistogramData.h"

#include <QMap>
#include <QPair>
#include <QString>
#include <QStringList>
#include <QVariant>
#include <QVector>

#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace camaron
{
/// The group of all cells in tables of Quality Statistics.
constexpr const char* AllCells = "All";
/// The XML name of steps of selection.
constexpr const char* SelectName = "SelectElements";

/// A row of the server's table of criteria.
struct CriterionInfo
{
  QString Element; ///< "Cell", "Face", "Edge" or "Vertex"
  QString Name, Label, Family, Unit, AppliesTo, Description, Consequence, Source;
  QString AcceptableFor; ///< shapes that the acceptable range covers, such as "tetrahedra"
  double Ideal = std::numeric_limits<double>::quiet_NaN(); ///< NaN if there is none
  double Low = -std::numeric_limits<double>::infinity();   ///< infinite for no limit
  double High = std::numeric_limits<double>::infinity();
  bool IsHint = false;   ///< whether the range is common practice, not a limit
  bool IsCurved = false; ///< whether it follows the edges and faces of cells of higher order
  int Better = 0;        ///< 1 if larger values are better, -1 if smaller ones, 0 if neither

  /// Whether there is an acceptable range.
  bool hasRange() const;

  /// Label with unit, such as "Minimum dihedral angle (°)".
  QString title() const;

  /// Such as "10 to 160°", "at least 0.2"; empty without a range.
  QString rangeText() const;

  /// Rich text for tooltips: meaning, unit, ideal value, acceptable range and its source.
  QString toolTip() const;
};

struct PresetInfo
{
  QString Name, Description;
  QStringList Criteria;
  QStringList Shapes; ///< for which each of them has a range; empty if it has none
  QStringList Rules;  ///< lines of rules with the same ranges; hints say that they are none here
};

struct MeshSummary
{
  QString Name,
    Step; ///< of the mesh and, if it is another one, of the filter whose output is inspected
  qint64 Cells = 0, Points = 0;
  qint64 Memory = 0;                 ///< of the data on all processes, in KiB
  qint64 Blocks = 0;                 ///< of composite data
  std::array<double, 6> Bounds = {}; ///< empty if the minimum is larger than the maximum
};

/// A range with infinite ends for no limit; without one, the acceptable range of the criterion.
using Limits = std::optional<QPair<double, double>>;

/// How to bin and group values.
struct DistributionRequest
{
  int Bins = 50;
  bool Logarithmic = false;
  Limits Range;             ///< of the bins; without it, that of all elements
  QVector<double> Edges;    ///< where a bin must end
  QString GroupBy = "None"; ///< "None", "Cell type", "Block" or "Cell array"
  QString GroupArray;
  bool CountsSelected = false;       ///< groups, and Selected, are of those only
  QString Preset = "Default ranges"; ///< of acceptable ranges
  QStringList Ranges;                ///< of the user, as lines of a file of ranges
  QVector<double> CurveValues;       ///< where the cumulative curve must be exact
  int CurvePoints = 0;               ///< further points of the curve
};

/// Statistics and histogram of an array.
struct Distribution
{
  QString Array;
  qint64 Count = 0, Undefined = 0;
  qint64 Applicable = 0; ///< cells of shapes to which the criterion applies
  /// Cells to which the range applies; of these, undefined, below and above it.
  qint64 Judged = 0, JudgedUndefined = 0, Below = 0, Above = 0;
  /// Acceptable range; infinite if there is none for the shapes of these cells.
  double Low = -std::numeric_limits<double>::infinity();
  double High = std::numeric_limits<double>::infinity();
  double BadVolume = std::numeric_limits<double>::quiet_NaN(); ///< fraction, if volumes are known
  HistogramData Histogram;
  CumulativeCounts Cumulative;

  /// Whether there is an acceptable range for some of the cells.
  bool hasRange() const { return std::isfinite(this->Low) || std::isfinite(this->High); }

  /// Whether there is one, but not for all cells that the criterion applies to.
  bool hasNotJudged() const { return this->Judged < this->Applicable && this->hasRange(); }

  /// Cells that fail a check of the acceptable range.
  qint64 failing() const { return this->JudgedUndefined + this->Below + this->Above; }
};

/// An element and its neighbors.
struct ElementInfo
{
  PanelTable Values;     ///< a row with all its arrays; empty if there is no such element
  QStringList Neighbors; ///< ids of those across faces
  QStringList Failing;   ///< criteria whose acceptable range it violates
};

/// Counts of cells by type and by defect.
struct ValidityInfo
{
  struct NamedCount
  {
    QString Name;
    QString Label; ///< in words
    qint64 Count = 0;
    bool IsInvalid = false; ///< a defect that IsValid counts
  };
  QVector<NamedCount> Types;
  QVector<NamedCount>
    Defects; ///< bits of CellStatus with the number of cells; a cell may have several
};

/// Rules in the language of Documentation/check.md.
struct CheckRequest
{
  QString Rules;
  QString Tolerate; ///< such as "3" or "0.1%"; empty for none
  /// How criteria are evaluated, as properties of Check Quality.
  QMap<QString, QVariant> Options;
};

/// What a report is about, besides the mesh.
struct ReportRequest
{
  CheckRequest Rules;
  QStringList
    Ranges; ///< that the user has set: lines of a file of ranges (Core/Rules/ParsedRules.h)
};

struct CheckResult
{
  PanelTable Verdicts; ///< as output 0 of Check Quality
  QString Verdict;     ///< "pass", "warn", "fail", "empty"; empty if there are problems
  PanelTable Problems; ///< Line, Text
  QString Error;       ///< why there is no verdict although the rules are understood
};

/// The active selection of the inspected mesh.
struct SelectionInfo
{
  bool IsOfPoints = false;
  qint64 Count = 0, Total = 0;
};

/// Where an element is, or a connected group of elements outside the limits of an array.
struct Location
{
  QString Id, IdSpace; ///< of the element, or of one of the group
  QString GroupArray;  ///< empty for an element
  Limits GroupLimits;
  double Center[3] = { 0, 0, 0 };
  double Size = 0; ///< diagonal of its bounding box; 0 if unknown

  bool isFinite() const
  {
    return std::isfinite(this->Center[0]) && std::isfinite(this->Center[1]) &&
      std::isfinite(this->Center[2]);
  }
};
}

#endif
