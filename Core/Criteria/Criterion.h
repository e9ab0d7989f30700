// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Criterion.h
 * @brief What there is to know about a quality criterion, and the values it may take.
 */
#ifndef camaron_Criterion_h
#define camaron_Criterion_h

#include "Base/Null.h"
#include "Base/Units.h"
#include "Cell/Needs.h"
#include "Cell/Shapes.h"

#include "vtkType.h" // for vtkIdType

#include <cmath>       // for infinity
#include <string>      // for units
#include <string_view> // for names
#include <vector>      // for lists of criteria

namespace camaron
{
class CellGeometry;
class CellNeighborhood;
class MeshContext;
class NondegenerateTetrahedra;

/// Which end of its range is good.
enum class Better
{
  Smaller,
  Neither,
  Bigger
};

enum class ValueKind
{
  Real,
  Integer, ///< counts and ids: one histogram bin per value
  Code ///< integers that no cell lacks to which they apply: arrays of integers, 0 for other cells
};

/// How much work a criterion is per cell.
enum class Cost
{
  Faces,     ///< one pass over the cell's own faces
  Edges,     ///< adjacency of faces and edges inside the cell
  Neighbors, ///< the mesh-wide table of facets
  Iterative, ///< linear programs
  Clipping   ///< the kernel as a body, which only polyhedra need
};

/// What the documentation says of a criterion beyond its description; Markdown on one line each.
struct CriterionNotes
{
  const char* Formula = "";    ///< definition with its symbols
  const char* Degenerate = ""; ///< answers for collapsed, flat, inverted and open elements
  const char* Agreement =
    ""; ///< which programs compute the same, and which something else by that name
  const char* Consequence =
    ""; ///< what cells outside of the acceptable range are, and do, in half a sentence
};

/// One row of the table of criteria. Text ends up in tooltips, tables and documentation.
struct Criterion
{
  const char* Name = "";                         ///< key and array name, CamelCase, never changes
  const char* Label = "";                        ///< for people
  const char* Description = "";                  ///< one sentence: definition, then remarks
  unsigned AppliesTo = NoShapes;                 ///< Shapes
  enum camaron::Unit Unit = camaron::Unit::None; // there is a function of that name, too
  double Range[2] = {}; ///< smallest and largest possible value; angles in degrees
  double Ideal = 0; ///< value of the perfect cell; NaN if there is none or it depends on the shape
  camaron::Better Better = camaron::Better::Neither;
  double Acceptable[2] = { -HUGE_VAL, HUGE_VAL }; ///< infinite where there is no limit on that side
  const char* AcceptableSource = "";              ///< who says so; empty when no range is given
  /// Common practice, not read in a document, or missed on purpose as by stretched cells.
  bool AcceptableIsHint = false;
  unsigned AcceptableFor =
    NoShapes; ///< Shapes that the source is about; no other cell is inside or outside
  ValueKind Kind = ValueKind::Real;
  camaron::Cost Cost = camaron::Cost::Faces;
  unsigned Needs = NeedsPoints;

  ///@{
  /**
   * One of the first three is set. CellFunction fills values for a block of cells whose geometry is
   * there; MeshFunction fills the values of cells [begin, end) of a mesh with neighbors;
   * NeighborFunction returns the value of a cell from its geometry and the cells at its faces.
   * TetrahedronFunction, where there is one, is CellFunction for blocks of cells that need no
   * topology.
   */
  void (*CellFunction)(const CellGeometry* cells, int numberOfCells, double* values) = nullptr;
  void (*MeshFunction)(
    const MeshContext& mesh, vtkIdType begin, vtkIdType end, double* values) = nullptr;
  double (*NeighborFunction)(const CellNeighborhood& cell) = nullptr;
  void (*TetrahedronFunction)(const NondegenerateTetrahedra& cells, double* values) = nullptr;
  ///@}

  CriterionNotes Notes;
  const char* Family = ""; ///< heading under which it is listed, from the list of families

  bool IsInteger() const { return this->Kind != ValueKind::Real; }
  bool HasAcceptableRange() const { return this->AcceptableSource[0] != '\0'; }
  /// See GetUnitLabel.
  std::string UnitLabel(AngleUnit angles = AngleUnit::Degrees) const;
};

/// All criteria in the order in which people see them.
const std::vector<Criterion>& GetCriteria();
/// The criterion of that name, or nullptr.
const Criterion* FindCriterion(std::string_view name);

/// A named set of criteria with ranges of its own.
struct Preset
{
  struct Rule
  {
    const char* Criterion;
    double Acceptable[2];
    bool IsHint = false;              ///< as AcceptableIsHint
    unsigned AcceptableFor = AnyCell; ///< as that of Criterion
  };
  const char* Name;
  const char* Description; ///< what for, and whose limits these are
  std::vector<Rule> Rules;
};

const std::vector<Preset>& GetPresets();
const Preset* FindPreset(std::string_view name);
}

#endif
