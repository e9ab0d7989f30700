// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellTypeNames.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

namespace camaron
{
//------------------------------------------------------------------------------
QString CellTypeName(const QString& label, qint64 count)
{
  struct Names
  {
    const char *Label, *One, *Many;
  };
  constexpr Names known[] = { { "Vertex", QT_TRANSLATE_NOOP("camaron", "vertex"),
                                QT_TRANSLATE_NOOP("camaron", "vertices") },
    { "Quad", QT_TRANSLATE_NOOP("camaron", "quadrangle"),
      QT_TRANSLATE_NOOP("camaron", "quadrangles") },
    { "Tetra", QT_TRANSLATE_NOOP("camaron", "tetrahedron"),
      QT_TRANSLATE_NOOP("camaron", "tetrahedra") },
    { "Hexahedron", QT_TRANSLATE_NOOP("camaron", "hexahedron"),
      QT_TRANSLATE_NOOP("camaron", "hexahedra") },
    { "Polyhedron", QT_TRANSLATE_NOOP("camaron", "polyhedron"),
      QT_TRANSLATE_NOOP("camaron", "polyhedra") } };
  // "QuadraticTetra" is a kind of "Tetra".
  static const QRegularExpression border("(?<=[a-z])(?=[A-Z])");
  QStringList words = label.split(border);
  const QString last = words.takeLast();
  QString noun = count == 1 ? last.toLower() : last.toLower() + 's';
  for (const Names& names : known)
  {
    if (last == names.Label)
    {
      noun = QCoreApplication::translate("camaron", count == 1 ? names.One : names.Many);
    }
  }
  words = words.join(' ').toLower().split(' ', Qt::SkipEmptyParts);
  return (words << noun).join(' ');
}
}
