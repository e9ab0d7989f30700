// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CriterionRows.h
 * @brief Helpers to define rows of the table of criteria; included by the .cxx files with rows.
 */
#ifndef camaron_CriterionRows_h
#define camaron_CriterionRows_h

#include "Base/Number.h"
#include "Cell/CellGeometry.h"
#include "Cell/CellNeighborhood.h"
#include "Cell/NondegenerateTetrahedra.h"
#include "Criteria/Criterion.h"
#include "Criteria/MeshContext.h"

#include <algorithm>  // for the smaller and larger value
#include <functional> // for std::invoke
#include <limits>     // for infinity

namespace camaron
{
constexpr double None = std::numeric_limits<double>::quiet_NaN();
constexpr double Positive = std::numeric_limits<double>::min(); // smallest positive value
constexpr double RegularVolume =
  0.5132002392796673; // 8 sqrt(3) / 27: of a regular tetrahedron of circumradius 1

constexpr const char* VerdictManual = "Verdict manual, rev. A";
constexpr const char* CheckMesh = "OpenFOAM checkMesh";
constexpr bool Hint = true;
constexpr bool Cited = false;

/// Builds a row of the table of criteria, column by column. By default a criterion is defined for
/// polygons and polyhedra, there is no acceptable range, no ideal value and no good direction,
/// values are real, and the function reads points in one pass over the faces.
class CriterionRow
{
public:
  CriterionRow(const char* name, const char* label, const char* description)
  {
    this->Result.Name = name;
    this->Result.Label = label;
    this->Result.Description = description;
    this->Result.AppliesTo = PolygonsAndPolyhedra;
  }

  /// The Shapes it is defined for.
  CriterionRow& Shapes(unsigned shapes)
  {
    this->Result.AppliesTo = shapes;
    return *this;
  }
  CriterionRow& Unit(enum camaron::Unit unit)
  {
    this->Result.Unit = unit;
    return *this;
  }
  /// The minimum and maximum possible value; angles in degrees.
  CriterionRow& Range(double low, double high)
  {
    this->Result.Range[0] = low;
    this->Result.Range[1] = high;
    return *this;
  }
  /// The value of the perfect cell, NaN if there is none, and the good end of the range.
  CriterionRow& Ideal(double value, camaron::Better better)
  {
    this->Result.Ideal = value;
    this->Result.Better = better;
    return *this;
  }
  /// The acceptable range, its source, whether it is a Hint or Cited, and the Shapes that the
  /// source covers.
  CriterionRow& Acceptable(
    double low, double high, const char* source, bool isHint, unsigned shapes)
  {
    this->Result.Acceptable[0] = low;
    this->Result.Acceptable[1] = high;
    this->Result.AcceptableSource = source;
    this->Result.AcceptableIsHint = isHint;
    this->Result.AcceptableFor = shapes;
    return *this;
  }
  CriterionRow& Kind(ValueKind kind)
  {
    this->Result.Kind = kind;
    return *this;
  }
  CriterionRow& Cost(camaron::Cost cost)
  {
    this->Result.Cost = cost;
    return *this;
  }
  /// The Needs: parts of the geometry that the function reads.
  CriterionRow& Needs(unsigned needs)
  {
    this->Result.Needs = needs;
    return *this;
  }
  /// See Criterion::IsCurved, and CriterionNotes.
  CriterionRow& Curved(const char* text = "")
  {
    this->Result.IsCurved = true;
    this->Result.Notes.Curved = text;
    return *this;
  }

  ///@{
  /**
   * Set the function, by one of Cells (of a cell; inlined into the loop over a block), Mesh (of
   * cells with neighbors; contains the loop), and Neighbors (of a cell with its centroid and the
   * cells at its facets); the last two have Cost::Neighbors. Tetrahedra may be added to Cells: the
   * same formula for a TetrahedronPair. Cells and Tetrahedra also take methods of the cell.
   */
  template <auto Function>
  CriterionRow& Cells()
  {
    this->Result.CellFunction = [](const CellGeometry* cells, int numberOfCells, double* values)
    {
      for (int i = 0; i < numberOfCells; ++i)
      {
        values[i] = static_cast<double>(std::invoke(Function, cells[i]));
      }
    };
    return *this;
  }
  template <auto Function>
  CriterionRow& Tetrahedra()
  {
    this->Result.TetrahedronFunction = [](const NondegenerateTetrahedra& cells, double* values)
    {
      cells.Evaluate(
        [](const TetrahedronPair& pair) { return std::invoke(Function, pair); }, values);
    };
    return *this;
  }
  CriterionRow& Mesh(decltype(Criterion::MeshFunction) function)
  {
    this->Result.MeshFunction = function;
    return this->Cost(camaron::Cost::Neighbors);
  }
  CriterionRow& Neighbors(decltype(Criterion::NeighborFunction) function)
  {
    this->Result.NeighborFunction = function;
    this->Result.Needs |= NeedsCentroid;
    return this->Cost(camaron::Cost::Neighbors);
  }
  ///@}

  ///@{
  /// Notes for the documentation, Markdown; see CriterionNotes.
  CriterionRow& Formula(const char* text)
  {
    this->Result.Notes.Formula = text;
    return *this;
  }
  CriterionRow& Degenerate(const char* text)
  {
    this->Result.Notes.Degenerate = text;
    return *this;
  }
  CriterionRow& Agreement(const char* text)
  {
    this->Result.Notes.Agreement = text;
    return *this;
  }
  CriterionRow& Consequence(const char* text)
  {
    this->Result.Notes.Consequence = text;
    return *this;
  }
  ///@}

  operator const Criterion&() const { return this->Result; }

private:
  Criterion Result = {};
};

inline double GetSmaller(double a, double b)
{
  return std::min(a, b);
}
inline double GetLarger(double a, double b)
{
  return std::max(a, b);
}
}

#endif
