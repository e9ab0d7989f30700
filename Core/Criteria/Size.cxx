// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/CellGeometry.h"

namespace camaron
{
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
}
