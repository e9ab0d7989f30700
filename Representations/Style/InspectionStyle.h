// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file InspectionStyle.h
 * @brief What a Mesh Inspection shows and how; the properties of the representation, all in one
 * place.
 */
#ifndef camaron_InspectionStyle_h
#define camaron_InspectionStyle_h

#include <array>  // for colors and planes
#include <string> // for array names
#include <vector> // for planes

namespace camaron
{
/// Which of the faces of the cells that are drawn.
enum class Walls
{
  Surface,       ///< those with one such cell
  Interior,      ///< those between two
  Complete,      ///< all, once for each cell
  InteriorOfBoth ///< those between two, once for each
};

/// Which cells are drawn, by the array Selected that Select Elements makes.
enum class Chosen
{
  All,
  Selected,
  Unselected
};

/// How the shape that cuts tells cells inside from cells outside.
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
  TwoColors,        ///< the array, between two colors
  Height,           ///< the coordinate along a direction
  Depth             ///< the distance from the eye, along the view
};

/// Which values are told apart from those of all other cells.
enum class Emphasis
{
  Nothing,
  Unacceptable, ///< those outside the range that the criterion of the array's name calls acceptable
  OutsideRange
};

/// A convex shape in the coordinates of the mesh.
struct ConvexShape
{
  static constexpr int MaxPlanes = 64; ///< as InShape.glsl

  /// Inside where a x + b y + c z + d <= 0 for all of them. None: a sphere.
  std::vector<std::array<double, 4>> Planes;
  /// Takes the sphere to the unit sphere; row by row.
  std::array<double, 16> ToUnitSphere = {};
  /// How far it was moved away from faces of cells in it, see MakeExactShape.
  double FaceClearance = 0;

  bool operator==(const ConvexShape& other) const
  {
    return this->Planes == other.Planes && this->ToUnitSphere == other.ToUnitSphere;
  }
};

using Color = std::array<double, 3>;
using Range = std::array<double, 2>;

/// What a mapper draws of the visible faces.
enum class Figure
{
  Faces, ///< themselves, their edges and their points
  FaceNormals,
  PointNormals,
  Isosurfaces,
  Cap ///< what an exact cut shows of the inside of cells
};

/// Of bounds that may be as large as numbers can be.
inline std::array<double, 3> GetMiddleOf(const std::array<double, 6>& bounds)
{
  std::array<double, 3> middle;
  for (int i = 0; i < 3; ++i)
  {
    middle[i] = 0.5 * bounds[2 * i] + 0.5 * bounds[2 * i + 1];
  }
  return middle;
}

struct InspectionStyle
{
  bool OnProcessor = false; ///< drawn as an ordinary surface, without the shaders
  Figure What = Figure::Faces;
  double NormalLength = 0; ///< of the lines that are normals, in the unit of coordinates; 0 without
  bool Faces = true;
  bool Edges = true;
  bool Points = false; ///< without faces and edges: of the whole cells, inside of the mesh also
  bool EdgesOfSelectedOnly = false;
  bool Glass = false; ///< this mapper draws nothing but the glass shell
  double GlassStrength = 0.5;

  Walls WallsToDraw = Walls::Surface;
  Chosen CellsToDraw = Chosen::All;
  double ShrinkFactor = 1; ///< 1: cells as they are, 0: shrunk to their centroid
  double ExplodeFactor =
    0; ///< 0: cells where they are, 1: twice as far from the middle of the mesh

  CutBy Cut = CutBy::Nothing;
  bool KeepInside = false;
  /// Faces towards another process are drawn in a part of the mesh: right behind what is opaque,
  /// walls behind the rest.
  bool BordersAreOpen = true;
  bool CutFaces = false; ///< walls that the cut opens have their own color
  Color CutColor = { { 0.9, 0.75, 0.4 } };
  ConvexShape Shape;
  ConvexShape ExactShape; ///< the one that cuts exactly, see MakeExactShape

  bool HasLooks = false;     ///< blocks of the mesh have colors or opacities of their own
  bool HasNegatives = false; ///< cells have negative tetrahedra, see CellTetrahedra.h

  Coloring ColorBy = Coloring::TransferFunction;
  std::array<double, 3> HeightDirection = { { 0, 0, 1 } };
  Color LowColor = { { 0.1, 0.2, 0.5 } };
  Color HighColor = { { 1, 0.9, 0.6 } };
  Color NullColor = { { 0.5, 0.5, 0.5 } };
  bool CustomColorRange = false; ///< off: what there is
  Range ColorRange = { { 0, 1 } };
  std::array<double, 6> Bounds = { { 1, -1, 1, -1, 1,
    -1 } }; ///< of all pieces; 1, -1: those of the one here

  Emphasis ValuesToEmphasize = Emphasis::Nothing;
  Range AcceptableRange = { { 0, 1 } };
  double Dimming = 0.85; ///< of the others; 0: not at all, 1: all the same gray

  bool Smooth = false; ///< light as if faces were curved
  double SmoothAngle =
    30; ///< degrees; a corner whose normal is farther from its face's has the latter

  std::string IsosurfaceArray; ///< of the points; one component or the magnitude
  std::vector<double> IsosurfaceValues;

  bool Isolines = false;
  std::string IsolineArray; ///< of the points; one component or the magnitude
  double IsolineFirst = 0;
  double IsolineSpacing = 1;
  double IsolineWidth = 1.5; ///< pixels
  Color IsolineColor = { { 0, 0, 0 } };

  /// The same faces of the same cells, nothing of which is drawn.
  InspectionStyle GetVisible() const
  {
    InspectionStyle style;
    style.Edges = false;
    style.WallsToDraw = this->WallsToDraw;
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
  bool DrawsPointsOnly() const { return this->Points && !this->Faces && !this->Edges; }
  /// True when edges are lines of their own, instead of a color of the faces beside them.
  bool DrawsEdgesAlone() const
  {
    return this->What == Figure::Faces && this->Edges && !this->Faces && !this->Glass;
  }
  /// True when colors depend on where things are.
  bool ColorsByDistance() const
  {
    return this->ColorBy == Coloring::Height || this->ColorBy == Coloring::Depth;
  }
  /// The middle of all pieces, which cells explode away from, relative to that of the piece here.
  std::array<double, 3> GetExplodeCenter(const std::array<double, 3>& middle) const
  {
    const std::array<double, 3> center =
      this->Bounds[0] <= this->Bounds[1] ? GetMiddleOf(this->Bounds) : middle;
    return { { center[0] - middle[0], center[1] - middle[1], center[2] - middle[2] } };
  }
  /// True when the figure is made of the faces of cells.
  bool DrawsFaces() const { return this->What != Figure::Isosurfaces && this->What != Figure::Cap; }
  /// True when the figure is made of lines of one color.
  bool DrawsNormals() const
  {
    return this->What == Figure::FaceNormals || this->What == Figure::PointNormals;
  }
  bool CutsExactly() const { return this->Cut == CutBy::Exactly; }
  /// True when whole cells are cut away.
  bool CutsCells() const { return this->Cut != CutBy::Nothing && !this->CutsExactly(); }
  /// True when cells move, so that each needs its own faces.
  bool MovesCells() const { return this->ShrinkFactor != 1 || this->ExplodeFactor != 0; }
  /// True when the faces that are seen are just those with one cell in the mesh.
  bool IsWholeSurface() const
  {
    return this->WallsToDraw == Walls::Surface && this->CellsToDraw == Chosen::All &&
      !this->CutsCells() && !this->MovesCells();
  }
};
}

#endif
