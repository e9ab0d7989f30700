// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CriterionRows.h
 * @brief What the rows of criteria are written with; for the .cxx files that hold some.
 */
#ifndef camaron_CriterionRows_h
#define camaron_CriterionRows_h

#include "Cell/CellGeometry.h"
#include "Cell/CellNeighborhood.h"
#include "Cell/NondegenerateTetrahedra.h"
#include "Criteria/Criterion.h"
#include "Criteria/MeshContext.h"

#include <limits> // for infinity

namespace camaron
{
constexpr double Pi = 3.141592653589793238462643383279502884;
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double None = std::numeric_limits<double>::quiet_NaN();
constexpr double Positive = std::numeric_limits<double>::min(); // smallest value that is above zero

constexpr const char* VerdictManual = "Verdict manual, rev. A";
constexpr const char* CheckMesh = "OpenFOAM checkMesh";
constexpr bool Hint = true;
constexpr bool Cited = false;

/// A row of the table of criteria, column by column. Columns that are left out: no acceptable
/// range, real values.
class CriterionRow
{
public:
  CriterionRow(const char* name, const char* label, const char* description)
  {
    this->Result.Name = name;
    this->Result.Label = label;
    this->Result.Description = description;
  }

  /// What it is defined for, a combination of Shapes.
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
  /// The smallest and the largest possible value; angles in degrees.
  CriterionRow& Range(double low, double high)
  {
    this->Result.Range[0] = low;
    this->Result.Range[1] = high;
    return *this;
  }
  /// The value of the perfect cell, NaN if there is none, and the good direction.
  CriterionRow& Ideal(double value, camaron::Better better)
  {
    this->Result.Ideal = value;
    this->Result.Better = better;
    return *this;
  }
  /// The acceptable range, its source, whether it is a Hint or Cited, and the shapes it is about.
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
  /// The parts of the geometry that the function reads, a combination of Needs.
  CriterionRow& Needs(unsigned needs)
  {
    this->Result.Needs = needs;
    return *this;
  }

  ///@{
  /**
   * The function, one of Cells (of a cell; called directly for every cell of a block), Mesh (of
   * cells with neighbors, which contains the loop), and Neighbors (of a cell and the cells at its
   * facets). Tetrahedra in addition to Cells, with CAMARON_TETRAHEDRA: the same by a formula that
   * is a template of the cell, for tetrahedra two at a time.
   */
  template <double (*Function)(const CellGeometry&)>
  CriterionRow& Cells()
  {
    this->Result.CellFunction = [](const CellGeometry* cells, int numberOfCells, double* values)
    {
      for (int i = 0; i < numberOfCells; ++i)
      {
        values[i] = Function(cells[i]);
      }
    };
    return *this;
  }
  CriterionRow& Tetrahedra(decltype(Criterion::TetrahedronFunction) function)
  {
    this->Result.TetrahedronFunction = function;
    return *this;
  }
  CriterionRow& Mesh(decltype(Criterion::MeshFunction) function)
  {
    this->Result.MeshFunction = function;
    return *this;
  }
  CriterionRow& Neighbors(decltype(Criterion::NeighborFunction) function)
  {
    this->Result.NeighborFunction = function;
    return *this;
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

/// For CriterionRow::Tetrahedra, from a function template of the cell.
#define CAMARON_TETRAHEDRA(Formula)                                                                \
  [](const NondegenerateTetrahedra& cells, double* values)                                         \
  { cells.Evaluate([](const TetrahedronPair& pair) { return Formula(pair); }, values); }
}

#endif
