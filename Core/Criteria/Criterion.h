// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Criterion.h
 * @brief What there is to know about a quality criterion, and the values it may take.
 */
#ifndef camaron_Criterion_h
#define camaron_Criterion_h

#include "vtkType.h" // for vtkIdType

#include <string>      // for units
#include <string_view> // for names
#include <vector>      // for lists of criteria

namespace camaron
{
class CellGeometry;
class CellNeighborhood;
class MeshContext;
class SoundTetrahedra;

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
  Code     ///< integers that no cell lacks to which they apply: arrays of integers, 0 for other cells
};

enum class Unit
{
  None,
  Angle, ///< degree or radian, as the user chooses
  SolidAngle,
  Length,
  Area,
  Volume
};

enum class AngleUnit
{
  Degrees,
  Radians
};

/// From radian.
constexpr double GetAngleFactor(AngleUnit unit)
{
  return unit == AngleUnit::Degrees ? 180 / 3.141592653589793238462643383279502884 : 1;
}

/// "deg", "rad", "sr" or "" (lengths, areas and volumes are in the units of the mesh).
const char* GetUnitLabel(enum Unit unit, AngleUnit angles);

/// Shapes for which a criterion has a meaning; every other cell gets null.
enum Shapes : unsigned
{
  Polygons = 1u,
  Polyhedra = 2u,
  PolygonsAndPolyhedra = Polygons | Polyhedra,
  Triangles = 4u,
  Tetrahedra = 8u,
  AnyCell = 16u,
  Quadrilaterals = 32u,
  Pyramids = 64u,
  Wedges = 128u,
  Hexahedra = 256u,
  SimplePolygons = Triangles | Quadrilaterals,
  SimplePolyhedra = Tetrahedra | Pyramids | Wedges | Hexahedra,
  NoShapes = 0u
};

/// How much work a criterion is per cell.
enum class Cost
{
  Faces,      ///< one pass over the cell's own faces
  Edges,      ///< adjacency of faces and edges inside the cell
  Neighbors,  ///< the mesh-wide table of facets
  Iterative,  ///< linear programs
  Clipping    ///< the kernel as a body, which only polyhedra need
};

/// Parts of CellGeometry that a criterion reads; only what some ticked criterion needs is computed.
enum Needs : unsigned
{
  NeedsPoints = 0u,
  NeedsEdges = 1u,    ///< distinct edges and their lengths
  NeedsFaces = 2u,    ///< vector areas, areas, centres
  NeedsVolume = 4u,   ///< orientation and volume of a polyhedron
  NeedsCorners = 8u,  ///< interior angles of the faces
  NeedsDihedral = 16u,
  NeedsSolidAngle = 32u,
  NeedsAngles = NeedsCorners | NeedsDihedral | NeedsSolidAngle, ///< any of them
  NeedsCentroid = 64u,  ///< with NeedsVolume for a polyhedron
  NeedsMeanSizes = 128u,   ///< of all cells of the mesh
  NeedsSurfaceSides = 256u, ///< which side of a closed surface is the outer one
  NeedsRegions = 512u,      ///< what hangs together
  NeedsPointRegions = 1024u ///< what hangs together at points
};

/// Why a value is null, as written to the mask arrays.
enum class NullReason : unsigned char
{
  Value = 0,          ///< not null
  NotApplicable = 1,  ///< the criterion has no meaning for this shape
  Degenerate = 2,     ///< 0/0
  InvalidTopology = 3,///< open, non-manifold or too few points
  NoNeighbor = 4,     ///< needs a neighbour and is at the boundary
  MissingGhosts = 5,  ///< the neighbour lies in another piece and no ghost cell tells of it
  HigherOrder = 6     ///< the value is there, but of the corners of a higher-order cell
};

/// A quiet NaN that remembers its reason in its payload; it survives copying, not arithmetic.
double Null(NullReason reason);
/// The reason of a null value; Degenerate for a NaN made elsewhere.
NullReason GetNullReason(double value);

/// What the documentation says of a criterion beyond its description; Markdown on one line each.
struct CriterionNotes
{
  const char* Formula = "";    ///< definition with its symbols
  const char* Degenerate = ""; ///< answers for collapsed, flat, inverted and open elements
  const char* Agreement = "";  ///< which programs compute the same, and which something else by that name
  const char* Consequence = ""; ///< what cells outside of the acceptable range are, and do, in half a sentence
};

/// One row of the table of criteria. Text ends up in tooltips, tables and documentation.
struct Criterion
{
  const char* Name;        ///< key and array name, CamelCase, never changes
  const char* Label;       ///< for people
  const char* Description; ///< one sentence: definition, then remarks
  unsigned AppliesTo;      ///< Shapes
  enum camaron::Unit Unit; // there is a function of that name, too
  double Range[2]; ///< smallest and largest possible value; angles in degrees
  double Ideal;    ///< value of the perfect cell; NaN if there is none or it depends on the shape
  camaron::Better Better;
  double Acceptable[2];         ///< infinite where there is no limit on that side
  const char* AcceptableSource; ///< who says so; empty when no range is given
  bool AcceptableIsHint;        ///< common practice, not read in a document, or missed on purpose as by stretched cells
  unsigned AcceptableFor;       ///< Shapes that the source is about; no other cell is inside or outside
  ValueKind Kind;
  camaron::Cost Cost;
  unsigned Needs;

  ///@{
  /**
   * One of the first three is set. CellFunction fills values for a block of cells whose geometry is there;
   * MeshFunction fills the values of cells [begin, end) of a mesh with neighbours; NeighborFunction
   * returns the value of a cell from its geometry and the cells at its faces. TetrahedronFunction, where there is
   * one, is CellFunction for blocks of cells that need no topology.
   */
  void (*CellFunction)(const CellGeometry* cells, int numberOfCells, double* values);
  void (*MeshFunction)(const MeshContext& mesh, vtkIdType begin, vtkIdType end, double* values);
  double (*NeighborFunction)(const CellNeighborhood& cell);
  void (*TetrahedronFunction)(const SoundTetrahedra& cells, double* values);
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
    bool IsHint = false;             ///< as AcceptableIsHint
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
