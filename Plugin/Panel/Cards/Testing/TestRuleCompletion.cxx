// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What the editor of rules offers. A failure means that a name is not offered where it may stand,
// or that accepting it spoils the line.
#include "RuleCompletion.h"

#include <QTest>

namespace
{
const camaron::RuleWords Words = { { { "MinDihedralAngle", "Minimum dihedral angle" },
                                     { "MaxFaceAngle", "Maximum face angle" },
                                     { "Volume", "Volume" } },
  { "General", "Finite volume" }, { "Material", "Zone id" } };

// The line after each choice.
QStringList GetLines(const QString& line)
{
  const camaron::RuleCompletion completion = camaron::CompleteRule(line, Words);
  QStringList lines;
  for (const camaron::RuleCompletion::Choice& choice : completion.Choices)
  {
    lines << line.left(completion.Start) + choice.Text;
  }
  return lines;
}
}

class TestRuleCompletion : public QObject
{
  Q_OBJECT

private Q_SLOTS:
  void offers_data()
  {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QStringList>("lines");
    const auto add = [](const char* line, const QStringList& lines)
    { QTest::newRow(line) << QString(line) << lines; };
    add("", {});
    add("min", { "MinDihedralAngle" });
    add("  min", { "  MinDihedralAngle" });
    add("Minimum dihedral", { "MinDihedralAngle" });
    add("min di", { "MinDihedralAngle" });
    add("angle face", { "MaxFaceAngle" });
    add("angle", { "MinDihedralAngle", "MaxFaceAngle" });
    add("max", { "MaxFaceAngle" });
    add("MinDihedralAngle", {});
    add("MinDihedralAngle ", {});
    add("pre", { "preset" });
    add("preset ", { "preset General", "preset \"Finite volume\"" });
    add("preset fin", { "preset \"Finite volume\"" });
    add("preset \"fin", { "preset \"Finite volume\"" });
    add("preset General", {});
    add("preset General o", { "preset General of" });
    add("Volume > 0 ", {});
    add("Volume > 0 o", { "Volume > 0 of" });
    add("Volume 0 * to", { "Volume 0 * tolerate" });
    add("Volume > 0 of t", { "Volume > 0 of triangles", "Volume > 0 of tetrahedra" });
    add("Volume > 0 of f", { "Volume > 0 of faces" });
    add("Volume > 0 of tetrahedra, w", { "Volume > 0 of tetrahedra, wedges" });
    add("Volume > 0 of tetrahedra", {});
    add("Volume 0 1 of w", { "Volume 0 1 of wedges" });
    add("Volume > 0 where ", { "Volume > 0 where Material", "Volume > 0 where \"Zone id\"" });
    add("Volume > 0 where zo", { "Volume > 0 where \"Zone id\"" });
    add("Volume > 0 where Material = 3 un", { "Volume > 0 where Material = 3 undefined" });
    add("Volume > 0 undefined p", { "Volume > 0 undefined passes" });
    add("Volume > 0 tolerate 0.1% o", { "Volume > 0 tolerate 0.1% of" });
    add("# min", {});
    add("Volume > 0 # o", {});
  }
  void offers()
  {
    QFETCH(QString, line);
    QFETCH(QStringList, lines);
    QCOMPARE(GetLines(line), lines);
  }

  void explainsCriteria()
  {
    QCOMPARE(camaron::CompleteRule("max", Words).Choices[0].Explanation, "Maximum face angle");
  }
};

QTEST_APPLESS_MAIN(TestRuleCompletion)
#include "TestRuleCompletion.moc"
