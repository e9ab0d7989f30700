// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/CellShells.h"

#include "Criteria/CellGeometry.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
constexpr double FullSphere = 12.566370614359172953850573533118011537;

//------------------------------------------------------------------------------
void Extend(CellShell& shell, const Vector& point)
{
  Vector &low = shell.Low, &high = shell.High;
  low = { std::min(low.X, point.X), std::min(low.Y, point.Y), std::min(low.Z, point.Z) };
  high = { std::max(high.X, point.X), std::max(high.Y, point.Y), std::max(high.Z, point.Z) };
}

//------------------------------------------------------------------------------
bool IsWithinBox(const CellShell& inner, const CellShell& outer)
{
  return inner.Low.X >= outer.Low.X && inner.Low.Y >= outer.Low.Y && inner.Low.Z >= outer.Low.Z &&
    inner.High.X <= outer.High.X && inner.High.Y <= outer.High.Y && inner.High.Z <= outer.High.Z;
}

//------------------------------------------------------------------------------
// How often a shell surrounds a point: the solid angles of the triangles between its edges and the
// centres of its faces, by Van Oosterom and Strackee. In between for points on the shell.
double GetWinding(const CellGeometry& cell, const CellShell& shell, const Vector& point)
{
  double half = 0;
  for (const int f : shell.Faces)
  {
    const int* ring = cell.GetTopology().GetFace(f);
    const int size = cell.GetTopology().GetFaceSize(f);
    const Vector c = cell.GetFaceCenter(f) - point;
    const double lengthC = Norm(c);
    Vector a = cell.GetPoint(ring[size - 1]) - point;
    double lengthA = Norm(a);
    for (int i = 0; i < size; ++i)
    {
      const Vector b = cell.GetPoint(ring[i]) - point;
      const double lengthB = Norm(b);
      half += std::atan2(Dot(c, Cross(a, b)),
        lengthA * lengthB * lengthC + Dot(a, b) * lengthC + Dot(b, c) * lengthA +
          Dot(c, a) * lengthB);
      a = b;
      lengthA = lengthB;
    }
  }
  return 2 * half / FullSphere;
}

//------------------------------------------------------------------------------
// Shells may touch, but do not cut through each other: that place of the inner one counts which is
// clearest.
bool IsInside(const CellGeometry& cell, const CellShell& inner, const CellShell& outer)
{
  if (std::abs(inner.Volume) >= std::abs(outer.Volume) || !IsWithinBox(inner, outer))
  {
    return false;
  }
  constexpr double onSurface = 0.5, beyondDoubt = 0.499;
  double clearest = 0;
  const auto isBeyondDoubt = [&](const Vector& point)
  {
    const double side = std::abs(GetWinding(cell, outer, point)) - onSurface;
    clearest = std::abs(side) > std::abs(clearest) ? side : clearest;
    return std::abs(clearest) > beyondDoubt;
  };
  for (const int f : inner.Faces)
  {
    const int* ring = cell.GetTopology().GetFace(f);
    if (isBeyondDoubt(cell.GetFaceCenter(f)) ||
      std::any_of(ring, ring + cell.GetTopology().GetFaceSize(f),
        [&](int point) { return isBeyondDoubt(cell.GetPoint(point)); }))
    {
      break;
    }
  }
  return clearest > 0;
}
}

//------------------------------------------------------------------------------
std::vector<CellShell> GetCellShells(const CellGeometry& cell)
{
  const CellTopology& topology = cell.GetTopology();
  std::vector<CellShell> shells(topology.GetNumberOfShells());
  for (int f = 0; f < topology.GetNumberOfFaces(); ++f)
  {
    CellShell& shell = shells[topology.GetShell(f)];
    const int* ring = topology.GetFace(f);
    if (shell.Faces.empty())
    {
      shell.Low = shell.High = cell.GetPoint(ring[0]);
    }
    shell.Faces.push_back(f);
    shell.Volume += Dot(cell.GetFaceVector(f), cell.GetFaceCenter(f)) / 3;
    for (int i = 0; i < topology.GetFaceSize(f); ++i)
    {
      Extend(shell, cell.GetPoint(ring[i]));
    }
  }
  return shells;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> FindVoids(const CellGeometry& cell, const std::vector<CellShell>& shells)
{
  std::vector<unsigned char> voids(shells.size(), 0);
  for (std::size_t i = 0; i < shells.size(); ++i)
  {
    for (const CellShell& outer : shells)
    {
      voids[i] ^= static_cast<unsigned char>(IsInside(cell, shells[i], outer));
    }
  }
  return voids;
}
}
