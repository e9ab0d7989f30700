// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The place of a cut as a share of the bounds. A failure means that the slider of the card "View"
// is elsewhere than the cut, or turns or moves what it should only push or scale.
#include "CutPlacement.h"

#include <QTest>

#include <cmath>

namespace
{
const camaron::CutBounds Bounds = { -1, 1, 0, 4, 10, 13 };
const QString Plane = "Plane", Sphere = "CuttingSphere", Box = "CuttingBox";

QVariantList ToList(double x, double y, double z)
{
  return { x, y, z };
}
}

class TestCutPlacement : public QObject
{
  Q_OBJECT

private Q_SLOTS:
  // A cut at a share has this share.
  void agrees()
  {
    for (const QString& shape : { Plane, Sphere, Box })
    {
      const camaron::CutValues made = camaron::MakeCut(shape, Bounds, 2);
      for (const double share : { 0.25, 0.5, 1.0 })
      {
        const camaron::CutValues moved = camaron::MoveCut(shape, Bounds, made, share);
        QCOMPARE(camaron::GetCutShare(shape, Bounds, moved), share);
      }
    }
  }

  // Across the chosen axis, else the longest one, also instead of one in which the mesh is flat.
  void planes()
  {
    QCOMPARE(camaron::MakeCut(Plane, Bounds, 2)["Normal"].toList(), ToList(0, 0, 1));
    QCOMPARE(camaron::MakeCut(Plane, Bounds, -1)["Normal"].toList(), ToList(0, 1, 0));
    QCOMPARE(camaron::MakeCut(Plane, { -1, 1, 0, 4, 3, 3 }, 2)["Normal"].toList(), ToList(0, 1, 0));
    const camaron::CutValues up = { { "Origin", ToList(7, 8, 11) }, { "Normal", ToList(0, 0, 2) } };
    QCOMPARE(camaron::MoveCut(Plane, Bounds, up, 0.5)["Origin"].toList(), ToList(7, 8, 11.5));
    QCOMPARE(camaron::SpellCut(Plane, Bounds, up), QString("11"));
    QCOMPARE(camaron::GetCutShare(Plane, Bounds, up), 1 / 3.0);
    camaron::CutValues down = up;
    down["Normal"] = ToList(0, 0, -1);
    QCOMPARE(camaron::SpellCut(Plane, Bounds, down), QString("11"));
    QCOMPARE(camaron::GetCutShare(Plane, Bounds, down), 1 / 3.0);
  }

  // A tilted plane keeps its normal, and moves along it from corner to corner.
  void tilted()
  {
    const camaron::CutValues tilted = { { "Origin", ToList(0, 0, 10) },
      { "Normal", ToList(3, 4, 0) } };
    QCOMPARE(camaron::GetCutShare(Plane, Bounds, tilted), 3 / (6 + 16.0));
    const camaron::CutValues last = camaron::MoveCut(Plane, Bounds, tilted, 1);
    QCOMPARE(last["Normal"], tilted["Normal"]);
    const QVariantList origin = last["Origin"].toList();
    QCOMPARE(3 * origin[0].toDouble() + 4 * origin[1].toDouble(), 3 * 1 + 4 * 4.0); // the corner
    QCOMPARE(origin[2].toDouble(), 10.0);
  }

  // Only the size changes; a box that was made flat gets its shape back.
  void sizes()
  {
    const camaron::CutValues ball = { { "Center", ToList(5, 5, 5) }, { "Radius", 1.0 } };
    const camaron::CutValues larger = camaron::MoveCut(Sphere, Bounds, ball, 1);
    QCOMPARE(larger["Center"], ball["Center"]);
    QCOMPARE(larger["Radius"].toDouble(), std::hypot(2.0, 4.0, 3.0) / 2);
    const camaron::CutValues box = { { "Position", ToList(1, 1, 1) },
      { "Scale", ToList(1, 1, 1) } };
    QCOMPARE(camaron::GetCutShare(Box, Bounds, box), 0.5); // of the side of length 2
    const camaron::CutValues none = camaron::MoveCut(Box, Bounds, box, 0);
    const camaron::CutValues whole = camaron::MoveCut(Box, Bounds, none, 1);
    QCOMPARE(whole["Position"], box["Position"]);
    for (const QVariant& length : whole["Scale"].toList())
    {
      QCOMPARE(length.toDouble(), 2.0);
    }
  }
};

QTEST_GUILESS_MAIN(TestCutPlacement)
#include "TestCutPlacement.moc"
