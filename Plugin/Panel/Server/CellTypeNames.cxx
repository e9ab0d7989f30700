// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellTypeNames.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <iterator>

namespace camaron
{
namespace
{
struct Names
{
  const char *Label, *One, *Many;
};

// The last words of VTK's names of cell types.
constexpr Names Known[] = {
  { "Cell", QT_TRANSLATE_NOOP("camaron", "cell"), QT_TRANSLATE_NOOP("camaron", "cells") },
  { "Curve", QT_TRANSLATE_NOOP("camaron", "curve"), QT_TRANSLATE_NOOP("camaron", "curves") },
  { "Edge", QT_TRANSLATE_NOOP("camaron", "edge"), QT_TRANSLATE_NOOP("camaron", "edges") },
  { "Hexahedron", QT_TRANSLATE_NOOP("camaron", "hexahedron"),
    QT_TRANSLATE_NOOP("camaron", "hexahedra") },
  { "Line", QT_TRANSLATE_NOOP("camaron", "line"), QT_TRANSLATE_NOOP("camaron", "lines") },
  { "Pixel", QT_TRANSLATE_NOOP("camaron", "pixel"), QT_TRANSLATE_NOOP("camaron", "pixels") },
  { "Polygon", QT_TRANSLATE_NOOP("camaron", "polygon"), QT_TRANSLATE_NOOP("camaron", "polygons") },
  { "Polyhedron", QT_TRANSLATE_NOOP("camaron", "polyhedron"),
    QT_TRANSLATE_NOOP("camaron", "polyhedra") },
  { "Prism", QT_TRANSLATE_NOOP("camaron", "prism"), QT_TRANSLATE_NOOP("camaron", "prisms") },
  { "Pyramid", QT_TRANSLATE_NOOP("camaron", "pyramid"), QT_TRANSLATE_NOOP("camaron", "pyramids") },
  { "Quad", QT_TRANSLATE_NOOP("camaron", "quadrangle"),
    QT_TRANSLATE_NOOP("camaron", "quadrangles") },
  { "Quadrilateral", QT_TRANSLATE_NOOP("camaron", "quadrangle"),
    QT_TRANSLATE_NOOP("camaron", "quadrangles") },
  { "Set", QT_TRANSLATE_NOOP("camaron", "set"), QT_TRANSLATE_NOOP("camaron", "sets") },
  { "Strip", QT_TRANSLATE_NOOP("camaron", "strip"), QT_TRANSLATE_NOOP("camaron", "strips") },
  { "Tetra", QT_TRANSLATE_NOOP("camaron", "tetrahedron"),
    QT_TRANSLATE_NOOP("camaron", "tetrahedra") },
  { "Tetrahedron", QT_TRANSLATE_NOOP("camaron", "tetrahedron"),
    QT_TRANSLATE_NOOP("camaron", "tetrahedra") },
  { "Triangle", QT_TRANSLATE_NOOP("camaron", "triangle"),
    QT_TRANSLATE_NOOP("camaron", "triangles") },
  { "Vertex", QT_TRANSLATE_NOOP("camaron", "vertex"), QT_TRANSLATE_NOOP("camaron", "vertices") },
  { "Voxel", QT_TRANSLATE_NOOP("camaron", "voxel"), QT_TRANSLATE_NOOP("camaron", "voxels") },
  { "Wedge", QT_TRANSLATE_NOOP("camaron", "wedge"), QT_TRANSLATE_NOOP("camaron", "wedges") },
};
}

//------------------------------------------------------------------------------
QString CellTypeName(const QString& label, qint64 count)
{
  // "QuadraticTetra" is a kind of "Tetra".
  static const QRegularExpression border("(?<=[a-z])(?=[A-Z])");
  QStringList words = label.split(border);
  const QString last = words.takeLast();
  QString noun = last.toLower();
  for (const Names& names : Known)
  {
    if (last == names.Label)
    {
      noun = QCoreApplication::translate("camaron", count == 1 ? names.One : names.Many);
    }
  }
  words = words.join(' ').toLower().split(' ', Qt::SkipEmptyParts);
  return (words << noun).join(' ');
}

//------------------------------------------------------------------------------
bool IsAmong(const QString& label, const QString& shapes)
{
  constexpr const char* surfaces[][2] = { { "Triangle", "triangles" }, { "Quad", "quadrilaterals" },
    { "Quadrilateral", "quadrilaterals" }, { "Pixel", "quadrilaterals" }, { "Polygon", "polygons" },
    { "Strip", "polygons" } };
  constexpr const char* solids[][2] = { { "Tetra", "tetrahedra" }, { "Tetrahedron", "tetrahedra" },
    { "Hexahedron", "hexahedra" }, { "Voxel", "hexahedra" }, { "Wedge", "wedges" },
    { "Pyramid", "pyramids" } };
  const auto isListed = [&](const char* const(&shape)[2])
  { return label.endsWith(shape[0]) && shapes.contains(shape[1]); };
  const bool isSurface = std::any_of(std::begin(surfaces), std::end(surfaces),
    [&](const char* const(&shape)[2]) { return label.endsWith(shape[0]); });
  return shapes == "any cell" || shapes.contains(isSurface ? "polygons" : "polyhedra") ||
    std::any_of(std::begin(surfaces), std::end(surfaces), isListed) ||
    std::any_of(std::begin(solids), std::end(solids), isListed);
}
}
