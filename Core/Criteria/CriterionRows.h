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
constexpr const char* NoRange = "";
constexpr bool Hint = true;
constexpr bool Cited = false;
constexpr ValueKind Real = ValueKind::Real;
constexpr ValueKind Integer = ValueKind::Integer;
constexpr ValueKind Code = ValueKind::Code;

// Columns of a row: name, label, description; shapes, unit, range, ideal, better; acceptable range,
// its source, hint or cited, shapes that it is for, kind of values; cost, needs, function; notes
// for the documentation.

// `double Function(const CellGeometry&)`, called directly for every cell of a block.
#define CAMARON_BLOCK(Function)                                                                    \
  [](const CellGeometry* cells, int numberOfCells, double* values)                                 \
  {                                                                                                \
    for (int i = 0; i < numberOfCells; ++i)                                                        \
    {                                                                                              \
      values[i] = Function(cells[i]);                                                              \
    }                                                                                              \
  }
#define CAMARON_CELLS(Function) CAMARON_BLOCK(Function), nullptr, nullptr, nullptr
// The same where a formula that is a template of its cell gives the value of tetrahedra of which
// nothing is zero: they are evaluated two at a time and without topology.
#define CAMARON_CELLS_AND_TETRAHEDRA(Function, Formula)                                            \
  CAMARON_BLOCK(Function), nullptr, nullptr,                                                       \
    [](const NondegenerateTetrahedra& cells, double* values)                                       \
  { cells.Evaluate([](const TetrahedronPair& pair) { return Formula(pair); }, values); }
// The same for a function with neighbors, which has the loop itself.
#define CAMARON_MESH(Function) nullptr, Function, nullptr, nullptr
// The same for a function of a cell and the cells at its facets.
#define CAMARON_NEIGHBORS(Function) nullptr, nullptr, Function, nullptr
}

#endif
