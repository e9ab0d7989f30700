// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/ClosedShell.h"

#include <cmath>

namespace camaron
{
namespace
{
constexpr double FullSphere = 12.566370614359172953850573533118011537;
}

//------------------------------------------------------------------------------
void ClosedShell::Add(const Vector& a, const Vector& b, const Vector& c)
{
  for (const Vector& point : { a, b, c })
  {
    this->Box.Add(point);
  }
  this->Volume += Dot(a, Cross(b, c)) / 6;
  this->Triangles.push_back({ { a, b, c } });
}

//------------------------------------------------------------------------------
// The winding number of the shell around a point: the solid angles of its triangles, by Van
// Oosterom and Strackee. Fractional for points on the shell.
double ClosedShell::GetWinding(const Vector& point) const
{
  double half = 0;
  for (const std::array<Vector, 3>& triangle : this->Triangles)
  {
    const Vector a = triangle[0] - point, b = triangle[1] - point, c = triangle[2] - point;
    const double lengthA = Norm(a), lengthB = Norm(b), lengthC = Norm(c);
    half += std::atan2(Dot(a, Cross(b, c)),
      lengthA * lengthB * lengthC + Dot(a, b) * lengthC + Dot(b, c) * lengthA +
        Dot(c, a) * lengthB);
  }
  return 2 * half / FullSphere;
}

//------------------------------------------------------------------------------
// The point of the inner shell with the clearest result decides.
bool ClosedShell::IsInside(const ClosedShell& outer) const
{
  if (std::abs(this->Volume) >= std::abs(outer.Volume) || !outer.Box.Contains(this->Box))
  {
    return false;
  }
  constexpr double onSurface = 0.5, beyondDoubt = 0.499;
  double clearest = 0;
  for (const std::array<Vector, 3>& triangle : this->Triangles)
  {
    for (const Vector& point : triangle)
    {
      const double side = std::abs(outer.GetWinding(point)) - onSurface;
      clearest = std::abs(side) > std::abs(clearest) ? side : clearest;
      if (std::abs(clearest) > beyondDoubt)
      {
        return clearest > 0;
      }
    }
  }
  return clearest > 0;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> FindVoids(const std::vector<ClosedShell>& shells)
{
  std::vector<unsigned char> voids(shells.size(), 0);
  for (std::size_t i = 0; i < shells.size(); ++i)
  {
    for (const ClosedShell& outer : shells)
    {
      voids[i] ^= static_cast<unsigned char>(shells[i].IsInside(outer));
    }
  }
  return voids;
}
}
