// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InspectionStyle.h
 * @brief What a Mesh Inspection shows, and how: the properties of the representation in one struct.
 */
#ifndef camaron_InspectionStyle_h
#define camaron_InspectionStyle_h

#include <algorithm> // for std::all_of
#include <array>     // for colors and planes
#include <limits>    // for ranges without limits
#include <set>       // for names of modes
#include <string>    // for array names
#include <vector>    // for planes

namespace camaron
{
/// Which faces of the drawn cells are drawn.
enum class DrawnFaces
{
  Surface,       ///< faces of exactly one drawn cell
  Interior,      ///< faces between two drawn cells, once
  Complete,      ///< all faces, once for each of their drawn cells
  InteriorOfBoth ///< faces between two drawn cells, once for each cell
};

/// Which cells are drawn, by the array Selected of Select Elements.
enum class DrawnCells
{
  All,
  Selected,
  Unselected
};

/// Which cells are inside the shape of a cut.
enum class CutBy
{
  Nothing,
  Centroid,
  AnyVertex,
  AllVertices,
  Exactly ///< cells are cut through
};

/// What faces are colored by.
enum class Coloring
{
  TransferFunction, ///< the array, as everywhere in ParaView
  TwoColors,        ///< the array, with a gradient between two colors
  Height,           ///< the coordinate along a direction
  Depth             ///< the distance from the eye, along the view
};

/// Which values are emphasized; all others are dimmed.
enum class Emphasis
{
  Nothing,
  Unacceptable, ///< outside the acceptable range of the criterion with the name of the array
  OutsideRange,
  InsideRange
};

/// Cells whose value of an array is in a closed range become selected, or no longer are.
struct Brush
{
  std::string Array; ///< cell array of one component
  std::array<double, 2> Values = {};
  bool Selects = true;

  bool operator==(const Brush& other) const
  {
    return this->Array == other.Array && this->Values == other.Values &&
      this->Selects == other.Selects;
  }
};

/// A convex shape in the coordinates of the mesh.
struct ConvexShape
{
  static constexpr int MaxPlanes = 64; ///< as in InShape.glsl

  /// The inside is where a x + b y + c z + d <= 0 for all planes. Empty: a sphere.
  std::vector<std::array<double, 4>> Planes;
  /// Transforms the sphere to the unit sphere; by rows.
  std::array<double, 16> ToUnitSphere = {};
  /// How far the shape was moved away from faces of cells, see MakeExactShape.
  double FaceClearance = 0;

  /// Whether a point is in the shape or on its surface, as in InShape.glsl.
  bool Contains(const double x[3]) const
  {
    const auto multiply = [x](const double* row)
    { return row[0] * x[0] + row[1] * x[1] + row[2] * x[2] + row[3]; };
    if (!this->Planes.empty())
    {
      return std::all_of(this->Planes.begin(), this->Planes.end(),
        [&](const auto& plane) { return multiply(plane.data()) <= 0; });
    }
    double square = 0;
    for (int row = 0; row < 3; ++row)
    {
      const double unit = multiply(&this->ToUnitSphere[4 * row]);
      square += unit * unit;
    }
    return square <= 1;
  }
  bool operator==(const ConvexShape& other) const
  {
    return this->Planes == other.Planes && this->ToUnitSphere == other.ToUnitSphere;
  }
};

using Color = std::array<double, 3>;
using Range = std::array<double, 2>;
constexpr Range Unlimited = { { -std::numeric_limits<double>::infinity(),
  std::numeric_limits<double>::infinity() } };

/// What a mapper draws for the visible faces.
enum class Figure
{
  Faces, ///< the faces, their edges and their points
  FaceNormals,
  PointNormals,
  Isosurfaces,
  Cap ///< the section through the cells of an exact cut
};

/// The center of the bounds, computed without overflow.
inline std::array<double, 3> GetMiddleOf(const std::array<double, 6>& bounds)
{
  std::array<double, 3> middle;
  for (int i = 0; i < 3; ++i)
  {
    middle[i] = 0.5 * bounds[2 * i] + 0.5 * bounds[2 * i + 1];
  }
  return middle;
}

/// Everything that a mapper has to know to draw a frame.
struct InspectionStyle
{
  std::set<std::string>
    Switches;               ///< names of the properties that are on, of modes without a member
  bool OnProcessor = false; ///< draw an ordinary surface, without the shaders
  Figure What = Figure::Faces;
  double NormalLength = 0; ///< of normal lines, in the unit of coordinates; 0: none
  bool Faces = true;
  bool Edges = true;
  bool Points = false; ///< without faces and edges: also points inside the mesh
  bool EdgesOfSelectedOnly = false;
  bool Glass = false; ///< this mapper only draws the glass shell
  double GlassStrength = 0.5;

  DrawnFaces FacesToDraw = DrawnFaces::Surface;
  DrawnCells CellsToDraw = DrawnCells::All;
  double ShrinkFactor = 1;  ///< 1: full size, 0: shrunk to their centroid
  double ExplodeFactor = 0; ///< 0: cells are not moved, 1: twice as far from the middle of the mesh

  CutBy Cut = CutBy::Nothing;
  bool KeepInside = false;
  /**
   * Whether cells of other processes count as not drawn, so that faces next to them are drawn if
   * only a part of the mesh is. Right for opaque meshes, which hide these faces; in translucent
   * meshes they would be visible as interior faces.
   */
  bool BordersAreOpen = true;
  Color CutColor = { { 0.9, 0.75, 0.4 } };
  ConvexShape Shape;
  ConvexShape ExactShape; ///< for exact cuts, see MakeExactShape

  bool HasLooks = false;     ///< some blocks have their own color or opacity
  bool HasNegatives = false; ///< some cells have negative tetrahedra, see CellTetrahedra.h

  Coloring ColorBy = Coloring::TransferFunction;
  std::array<double, 3> HeightDirection = { { 0, 0, 1 } };
  Color LowColor = { { 0.1, 0.2, 0.5 } };
  Color HighColor = { { 1, 0.9, 0.6 } };
  Color UndefinedColor = { { 0.5, 0.5, 0.5 } };
  bool CustomColorRange = false; ///< off: the range of the data
  Range ColorRange = { { 0, 1 } };
  std::array<double, 6> Bounds = { { 1, -1, 1, -1, 1,
    -1 } }; ///< of all pieces; 1, -1: use those of the piece here

  Emphasis ValuesToEmphasize = Emphasis::Nothing;
  Range AcceptableRange = { { 0, 1 } };
  /// One after another; what they select is emphasized instead of values, if there are any.
  std::vector<Brush> Brushes;
  /// Values of cells that the color map shows as acceptable; the others are drawn so large that one
  /// sees them. Unlimited: none are.
  Range ColorLimits = Unlimited;
  double Dimming = 0.85; ///< of values that are not emphasized; 0: none, 1: all the same gray
  std::array<double, 4> Accent = { { 1, 0, 1, 0 } }; ///< color of the others, and its share

  int SubdivisionLevel = 1; ///< of the faces of curved cells, see Drawing/SubdividedFacets.h
  bool Smooth = false;      ///< light faces as if they were curved
  double SmoothAngle = 30;  ///< degrees; beyond it a vertex of a face gets the normal of the face

  std::string IsosurfaceArray; ///< point array; one component, or the magnitude
  std::vector<double> IsosurfaceValues;

  bool Isolines = false;
  std::string IsolineArray; ///< point array; one component, or the magnitude
  double IsolineFirst = 0;
  double IsolineSpacing = 1;
  double IsolineWidth = 1.5; ///< pixels
  Color IsolineColor = { { 0, 0, 0 } };

  /// A style with the same faces of the same cells, in which no faces, edges or points are drawn.
  InspectionStyle GetVisible() const
  {
    InspectionStyle style;
    style.Edges = false;
    style.FacesToDraw = this->FacesToDraw;
    style.CellsToDraw = this->CellsToDraw;
    style.ShrinkFactor = this->ShrinkFactor;
    style.ExplodeFactor = this->ExplodeFactor;
    style.NormalLength = this->NormalLength;
    style.Bounds = this->Bounds;
    style.Cut = this->Cut;
    style.KeepInside = this->KeepInside;
    style.Shape = this->Shape;
    style.ExactShape = this->ExactShape;
    return style;
  }
  bool IsOn(const char* property) const { return this->Switches.count(property) > 0; }
  bool DrawsPointsOnly() const { return this->Points && !this->Faces && !this->Edges; }
  /// Whether edges are drawn as lines, not as a color of the faces next to them.
  bool DrawsEdgesAlone() const
  {
    return this->What == Figure::Faces && this->Edges && !this->Faces && !this->Glass;
  }
  /// Whether faces of cells are drawn in the colors of the transfer function.
  bool HasFacesOfColors() const
  {
    return this->What == Figure::Faces && this->Faces && !this->Glass &&
      this->ColorBy == Coloring::TransferFunction;
  }
  /// Whether colors depend on positions.
  bool ColorsByDistance() const
  {
    return this->ColorBy == Coloring::Height || this->ColorBy == Coloring::Depth;
  }
  /// The center of all pieces, from which cells move away, relative to @a middle of the piece here.
  std::array<double, 3> GetExplodeCenter(const std::array<double, 3>& middle) const
  {
    const std::array<double, 3> center =
      this->Bounds[0] <= this->Bounds[1] ? GetMiddleOf(this->Bounds) : middle;
    return { { center[0] - middle[0], center[1] - middle[1], center[2] - middle[2] } };
  }
  /// Whether the figure consists of faces of cells.
  bool DrawsFaces() const { return this->What != Figure::Isosurfaces && this->What != Figure::Cap; }
  /// Whether the figure consists of lines with a single color.
  bool DrawsNormals() const
  {
    return this->What == Figure::FaceNormals || this->What == Figure::PointNormals;
  }
  bool CutsExactly() const { return this->Cut == CutBy::Exactly; }
  /// Whether whole cells are cut away.
  bool CutsCells() const { return this->Cut != CutBy::Nothing && !this->CutsExactly(); }
  /// Whether cells move, so that each draws its own faces.
  bool MovesCells() const { return this->ShrinkFactor != 1 || this->ExplodeFactor != 0; }
  /// Whether the visible faces are exactly the faces of one cell of the mesh.
  bool IsWholeSurface() const
  {
    return this->FacesToDraw == DrawnFaces::Surface && this->CellsToDraw == DrawnCells::All &&
      !this->CutsCells() && !this->MovesCells();
  }
};
}

#endif
