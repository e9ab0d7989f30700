// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/CellMesh/ConversionFindings.h"

#include "Base/Text.h"
#include "Intake/CellMesh/ConversionPlan.h"
#include "Mesh/CellShape.h"
#include "Scan/MappedFile.h"

#include <algorithm>
#include <vector>

namespace camaron
{
namespace
{
using Kind = ConversionStep::Kind;

//------------------------------------------------------------------------------
std::string Join(const std::vector<std::string>& parts)
{
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    text += (i == 0 ? "" : i + 1 < parts.size() ? ", " : " and ") + parts[i];
  }
  return text;
}

//------------------------------------------------------------------------------
void AddPerType(Warnings& warnings, const std::array<Tally, 256>& tallies, const std::string& what)
{
  for (int type = 0; type < 256; ++type)
  {
    const std::string name = " of type " + GetCellTypeName(static_cast<unsigned char>(type)) + what;
    warnings.Add(tallies[type], "cell", "cells", name.c_str() + 1);
  }
}
}

//------------------------------------------------------------------------------
bool HasUnsupported(const ConversionFindings& found)
{
  return std::any_of(found.Unsupported.begin(), found.Unsupported.end(),
    [](const Tally& tally) { return tally.Count > 0; });
}

//------------------------------------------------------------------------------
std::string DescribeRefusal(const CellConversion& how, const ConversionFindings& found,
  bool holdsSome, const std::string& path)
{
  CellConversion cutting = how;
  cutting.Others = UnsupportedCells::Convert;
  const ConversionPlan plan(cutting);
  std::vector<std::string> kinds;
  bool triangles = false, tetrahedra = false;
  for (int type = 0; type < 256; ++type)
  {
    const Tally& tally = found.Unsupported[type];
    if (tally.Count == 0)
    {
      continue;
    }
    const auto step = plan[static_cast<unsigned char>(type)].What;
    tetrahedra = tetrahedra || step == Kind::Tetrahedra || step == Kind::Polyhedron;
    triangles =
      triangles || ((step == Kind::Surface || step == Kind::Polygon) && plan.CutsPolygons());
    kinds.push_back(CountOf(tally.Count, "cell", "cells") + " of type " +
      GetCellTypeName(static_cast<unsigned char>(type)) +
      (tally.Count == 1 ? " (cell " : " (the first is cell ") + std::to_string(tally.First) + ")");
  }
  std::string help;
  if ((triangles || tetrahedra) && how.Others != UnsupportedCells::Convert)
  {
    help = std::string("Convert to cut them into ") +
      (triangles && tetrahedra ? "triangles and tetrahedra"
          : triangles          ? "triangles"
                               : "tetrahedra");
  }
  if (holdsSome)
  {
    help += std::string(help.empty() ? "" : ", or to ") + "Skip to omit them";
  }
  return GetFileName(path) + ": " + how.Format + " files cannot store " + Join(kinds) +
    (help.empty() ? "; choose another format, such as ParaView's .vtu, which stores all cell types"
                  : "; set Unsupported Cells to " + help);
}

//------------------------------------------------------------------------------
void WarnOfConversion(
  const CellConversion& how, const ConversionFindings& found, Warnings& warnings)
{
  AddPerType(warnings, found.Reduced, " written without their higher-order nodes");
  const std::string faces = std::string("of dimension 3 written as ") +
    (how.Surface == SurfaceFaces::Every ? "all their faces, " : "their boundary faces, ") +
    CountOf(found.NumberOfFaces, "polygon", "polygons") +
    (found.NumberOfLostPoints > 0
        ? ", without " + std::to_string(found.NumberOfLostPoints) + " of the points"
        : "");
  warnings.Add(found.Surface, "cell", "cells", faces.c_str());
  std::array<Tally, 256> cut2D = found.Cut, cut3D = found.Cut;
  for (int type = 0; type < 256; ++type)
  {
    const bool isCell = GetCellShape(static_cast<unsigned char>(type)).Dimension == 3 &&
      how.Surface == SurfaceFaces::None;
    (isCell ? cut2D : cut3D)[type] = Tally();
  }
  AddPerType(warnings, cut2D, " cut into triangles");
  AddPerType(warnings, cut3D, " cut into tetrahedra");
  if (cut3D[VTK_POLYHEDRON].Count > 0 && found.NumberOfLostPoints > 0)
  {
    // Points on edges of a polyhedron may be in no tetrahedron, because faces are divided from one
    // vertex.
    warnings.Add(
      CountOf(found.NumberOfLostPoints, "point", "points") + " omitted, used by no written cell");
  }
  warnings.Add(found.Uncut, "cell", "cells",
    "with self-intersecting or zero-area polygons, which are triangulated arbitrarily");
  const std::string bad = "not convex or inverted; of their tetrahedra, " +
    CountOf(found.NumberOfNotPositive, "has", "have") + " no positive volume";
  warnings.Add(found.NotPositive, "cell", "cells", bad.c_str());
  AddPerType(warnings, found.Unsupported,
    " omitted because " + how.Format + " files cannot store this type");
}
}
