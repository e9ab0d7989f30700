// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Criterion.h
 * @brief Describes a quality criterion, and presets of criteria.
 *
 * A criterion is a row of a table. Menus, arrays, statistics, reports and documentation follow
 * from it.
 */
#ifndef camaron_Criterion_h
#define camaron_Criterion_h

#include "Base/Null.h"
#include "Base/Units.h"
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

/// The good end of the range.
enum class Better
{
  Smaller,
  Neither,
  Bigger
};

enum class ValueKind
{
  Real,
  Integer, ///< counts and ids: histograms have one bin per value
  Code ///< bit fields and codes without undefined values: integer arrays, 0 where not applicable
};

/// The most expensive part of evaluating a criterion for a cell.
enum class Cost
{
  Faces,     ///< one pass over the cell's own faces
  Edges,     ///< adjacency of faces and edges inside the cell
  Neighbors, ///< the mesh-wide table of facets
  Iterative, ///< a linear program
  Clipping   ///< the kernel as a polyhedron, computed for polyhedra only
};

/// Further texts for the documentation, as Markdown on one line.
struct CriterionNotes
{
  const char* Formula = "";     ///< definition in symbols
  const char* Degenerate = "";  ///< values for collapsed, flat, inverted and open cells
  const char* Agreement = "";   ///< programs that compute the same, or use the name differently
  const char* Consequence = ""; ///< "cells outside the acceptable range are ...", and the effect
  const char* Curved = "";      ///< what it is of a cell of higher order that is curved
};

/// A row of the table of criteria. Texts appear in tooltips, tables and documentation.
struct Criterion
{
  const char* Name = "";        ///< key and array name in CamelCase; never changes
  const char* Label = "";       ///< display name
  const char* Description = ""; ///< definition in one sentence, then remarks
  /// Shapes it is defined for; all other cells are NaN.
  unsigned AppliesTo = NoShapes;
  enum camaron::Unit Unit = camaron::Unit::None; // "enum", because Unit is also a function
  double Range[2] = {}; ///< minimum and maximum possible value; angles in degrees
  double Ideal = NAN; ///< value of a perfect cell; NaN if there is none or it depends on the shape
  camaron::Better Better = camaron::Better::Neither;
  double Acceptable[2] = { -HUGE_VAL, HUGE_VAL }; ///< infinite without limit
  /// The document or program that sets the limits; empty if there are none.
  const char* AcceptableSource = "";
  /// Whether the range is common practice, not from a document, or violated on purpose, for example
  /// by stretched cells.
  bool AcceptableIsHint = false;
  /// Shapes that the source covers; other cells are neither inside nor outside.
  unsigned AcceptableFor = NoShapes;
  ValueKind Kind = ValueKind::Real;
  camaron::Cost Cost = camaron::Cost::Faces;
  unsigned Needs = NeedsPoints;
  /// Whether it follows the edges and faces of a curved cell; else it is evaluated for the linear
  /// cell with its vertices.
  bool IsCurved = false;

  ///@{
  /**
   * The first three are alternatives; one of them is set. CellFunction fills the values of a block
   * of cells from their geometry. MeshFunction fills the values of cells [begin, end) of a mesh
   * with neighbors. NeighborFunction returns the value of a cell from its geometry and the cells
   * at its facets. TetrahedronFunction optionally replaces CellFunction for regular tetrahedra,
   * which need no topology.
   */
  void (*CellFunction)(const CellGeometry* cells, int numberOfCells, double* values) = nullptr;
  void (*MeshFunction)(
    const MeshContext& mesh, vtkIdType begin, vtkIdType end, double* values) = nullptr;
  double (*NeighborFunction)(const CellNeighborhood& cell) = nullptr;
  void (*TetrahedronFunction)(const NondegenerateTetrahedra& cells, double* values) = nullptr;
  ///@}

  CriterionNotes Notes;
  const char* Family = ""; ///< heading in menus and documentation

  bool IsInteger() const { return this->Kind != ValueKind::Real; }
  bool HasAcceptableRange() const { return this->AcceptableSource[0] != '\0'; }
  /// See GetUnitLabel.
  std::string UnitLabel(AngleUnit angles = AngleUnit::Degrees) const;
};

/// All criteria, in display order.
const std::vector<Criterion>& GetCriteria();
/// The criterion with this name, or nullptr.
const Criterion* FindCriterion(std::string_view name);

/// A named set of criteria with its own acceptable ranges.
struct Preset
{
  struct Rule
  {
    const char* Criterion;
    double Acceptable[2];
    bool IsHint = false;              ///< see Criterion::AcceptableIsHint
    unsigned AcceptableFor = AnyCell; ///< see Criterion::AcceptableFor
  };
  const char* Name;
  const char* Description; ///< purpose, and the source of the limits
  std::vector<Rule> Rules;
};

const std::vector<Preset>& GetPresets();
const Preset* FindPreset(std::string_view name);
}

#endif
