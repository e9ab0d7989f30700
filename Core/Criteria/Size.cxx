// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/CriterionRows.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The smallest or largest measure(face) of all faces.
template <typename Measure, typename Choose>
double ChooseOfFaces(const CellGeometry& cell, Measure&& measure, Choose&& choose)
{
  const int faces = cell.GetTopology().GetNumberOfFaces();
  if (faces == 0)
  {
    return Null(NullReason::InvalidTopology);
  }
  double chosen = measure(0);
  for (int f = 1; f < faces; ++f)
  {
    chosen = choose(chosen, measure(f));
  }
  return chosen;
}

double GetSmaller(double a, double b)
{
  return std::min(a, b);
}
double GetLarger(double a, double b)
{
  return std::max(a, b);
}
}

//------------------------------------------------------------------------------
double Area(const CellGeometry& cell)
{
  return cell.GetPolygonArea();
}

//------------------------------------------------------------------------------
double Perimeter(const CellGeometry& cell)
{
  return cell.GetTotalEdgeLength();
}

//------------------------------------------------------------------------------
double SurfaceArea(const CellGeometry& cell)
{
  return cell.GetSurfaceArea();
}

//------------------------------------------------------------------------------
double Volume(const CellGeometry& cell)
{
  return cell.GetVolume();
}

//------------------------------------------------------------------------------
double VertexCount(const CellGeometry& cell)
{
  return cell.GetNumberOfPoints();
}

//------------------------------------------------------------------------------
double EdgeCount(const CellGeometry& cell)
{
  return static_cast<double>(cell.GetTopology().Edges.size());
}

//------------------------------------------------------------------------------
double FaceCount(const CellGeometry& cell)
{
  return cell.GetTopology().GetNumberOfFaces();
}

//------------------------------------------------------------------------------
double MinEdgeLength(const CellGeometry& cell)
{
  return cell.GetMinEdgeLength();
}

//------------------------------------------------------------------------------
double MaxEdgeLength(const CellGeometry& cell)
{
  return cell.GetMaxEdgeLength();
}

//------------------------------------------------------------------------------
double MeanEdgeLength(const CellGeometry& cell)
{
  const std::size_t count = cell.GetTopology().Edges.size();
  return count > 0 ? cell.GetTotalEdgeLength() / static_cast<double>(count) : 0;
}

//------------------------------------------------------------------------------
double Diameter(const CellGeometry& cell)
{
  return cell.GetDiameter();
}

//------------------------------------------------------------------------------
double CellTypeId(const CellGeometry& cell)
{
  return cell.GetCellType();
}

//------------------------------------------------------------------------------
double MinFaceVertexCount(const CellGeometry& cell)
{
  return ChooseOfFaces(
    cell, [&](int f) { return double(cell.GetTopology().GetFaceSize(f)); }, GetSmaller);
}

//------------------------------------------------------------------------------
double MaxFaceVertexCount(const CellGeometry& cell)
{
  return ChooseOfFaces(
    cell, [&](int f) { return double(cell.GetTopology().GetFaceSize(f)); }, GetLarger);
}

//------------------------------------------------------------------------------
double MinFaceArea(const CellGeometry& cell)
{
  return ChooseOfFaces(cell, [&](int f) { return cell.GetFaceArea(f); }, GetSmaller);
}

//------------------------------------------------------------------------------
double MaxFaceArea(const CellGeometry& cell)
{
  return ChooseOfFaces(cell, [&](int f) { return cell.GetFaceArea(f); }, GetLarger);
}

//------------------------------------------------------------------------------
double EquivalentRadius(const CellGeometry& cell)
{
  if (cell.GetShapes() & Polygons)
  {
    return std::sqrt(cell.GetPolygonArea() / Pi);
  }
  const double volume = cell.GetVolume();
  return std::isnan(volume) ? volume : std::cbrt(3 * std::max(volume, 0.0) / (4 * Pi));
}

//------------------------------------------------------------------------------
std::vector<Criterion> SizeCriteria()
{
  // clang-format off
  return {
    { "Area", "Area", "Length of the polygon's vector area; the area of a planar polygon.",
      Polygons, Unit::Area, { 0, Infinity }, None, Better::Neither,
      { Positive, Infinity }, "not collapsed", Cited, Real, Cost::Faces, NeedsFaces, CAMARON_CELLS(Area) },
    { "Perimeter", "Perimeter", "Sum of the edge lengths.",
      Polygons, Unit::Length, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsEdges, CAMARON_CELLS(Perimeter) },
    { "SurfaceArea", "Surface area",
      "Sum over the faces of the signed triangle areas about the face centre; of a planar face its area.",
      Polyhedra, Unit::Area, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsFaces, CAMARON_CELLS(SurfaceArea) },
    { "Volume", "Volume",
      "Volume by the divergence theorem, the same for a standard cell and for its polyhedron; negative "
      "for a standard cell whose nodes are in the wrong order. Null for an open polyhedron.",
      Polyhedra, Unit::Volume, { -Infinity, Infinity }, None, Better::Neither,
      { Positive, Infinity }, "neither flat nor inverted", Cited, Real, Cost::Edges, NeedsVolume, CAMARON_CELLS(Volume) },
    { "VertexCount", "Vertices", "Number of distinct points.",
      PolygonsAndPolyhedra, Unit::None, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Integer, Cost::Faces, NeedsPoints, CAMARON_CELLS(VertexCount) },
    { "EdgeCount", "Edges", "Number of distinct edges.",
      PolygonsAndPolyhedra, Unit::None, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Integer, Cost::Edges, NeedsPoints, CAMARON_CELLS(EdgeCount) },
    { "FaceCount", "Faces", "Number of faces with at least three distinct points.",
      Polyhedra, Unit::None, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Integer, Cost::Faces, NeedsPoints, CAMARON_CELLS(FaceCount) },
    { "MinEdgeLength", "Shortest edge", "Length of the shortest edge; 0 when an edge is collapsed.",
      PolygonsAndPolyhedra, Unit::Length, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsEdges, CAMARON_CELLS(MinEdgeLength) },
    { "MaxEdgeLength", "Longest edge", "Length of the longest edge.",
      PolygonsAndPolyhedra, Unit::Length, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsEdges, CAMARON_CELLS(MaxEdgeLength) },
    { "MeanEdgeLength", "Mean edge", "Mean length of the distinct edges.",
      PolygonsAndPolyhedra, Unit::Length, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsEdges, CAMARON_CELLS(MeanEdgeLength) },
    { "Diameter", "Diameter", "Largest distance between two vertices.",
      PolygonsAndPolyhedra, Unit::Length, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsPoints, CAMARON_CELLS(Diameter) },
    { "MinFaceVertexCount", "Fewest vertices of a face", "Number of points of the face with the fewest.",
      Polyhedra, Unit::None, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Integer, Cost::Faces, NeedsPoints, CAMARON_CELLS(MinFaceVertexCount) },
    { "MaxFaceVertexCount", "Most vertices of a face", "Number of points of the face with the most.",
      Polyhedra, Unit::None, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Integer, Cost::Faces, NeedsPoints, CAMARON_CELLS(MaxFaceVertexCount) },
    { "MinFaceArea", "Smallest face", "Length of the vector area of the smallest face.",
      Polyhedra, Unit::Area, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsFaces, CAMARON_CELLS(MinFaceArea) },
    { "MaxFaceArea", "Largest face", "Length of the vector area of the largest face.",
      Polyhedra, Unit::Area, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Faces, NeedsFaces, CAMARON_CELLS(MaxFaceArea) },
    { "EquivalentRadius", "Equivalent radius",
      "Radius of the circle of the same area, or of the ball of the same volume; 0 where that is not "
      "positive.",
      PolygonsAndPolyhedra, Unit::Length, { 0, Infinity }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Real,
      Cost::Edges, NeedsFaces | NeedsVolume, CAMARON_CELLS(EquivalentRadius) },
    { "CellTypeId", "Cell type", "VTK's number of the cell type, for grouping.",
      AnyCell, Unit::None, { 0, 255 }, None, Better::Neither,
      { -Infinity, Infinity }, NoRange, Cited, Integer, Cost::Faces, NeedsPoints, CAMARON_CELLS(CellTypeId) },
  };
  // clang-format on
}
}
