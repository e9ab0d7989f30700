// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/CellGeometry.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
constexpr double Pi = 3.141592653589793238462643383279502884;

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
}
