// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Tables of the server in the panel: values, texts, colors. A failure means that a row shows
// another number than the server's.
#include "CellTypeNames.h"
#include "NumberText.h"
#include "pqTableModel.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"

#include <QAbstractItemModelTester>
#include <QColor>
#include <QSignalSpy>
#include <QTest>

#include <cmath>
#include <limits>

using camaron::PanelTable;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr qint64 LargeId = (1LL << 53) + 1; // no double is this number

PanelTable MakeTable()
{
  vtkNew<vtkTypeInt64Array> ids;
  vtkNew<vtkDoubleArray> values;
  vtkNew<vtkStringArray> types;
  ids->SetName("Id");
  values->SetName("Value");
  types->SetName("Typ\u00e9");
  for (const double value : { 0.1, NaN, -Infinity })
  {
    ids->InsertNextValue(LargeId + ids->GetNumberOfValues());
    values->InsertNextValue(value);
    types->InsertNextValue("poly\u00e8dre");
  }
  vtkNew<vtkTable> table;
  table->AddColumn(ids);
  table->AddColumn(values);
  table->AddColumn(types);
  return camaron::ToPanelTable(table);
}

pqTableModel* MakeModel(QObject* parent)
{
  return new pqTableModel(
    { pqTableModel::ShowColumn("Number", "Id"), pqTableModel::ShowColumn("Value", "Value"),
      pqTableModel::ShowColumn("Type", "Typ\u00e9", false),
      { "Twice", [](const PanelTable& table, int row)
        { return camaron::ShortNumber(2 * table.number(row, "Value")); } } },
    parent);
}
}

class TestTableModel : public QObject
{
  Q_OBJECT

private Q_SLOTS:
  void Tables();
  void NoTable();
  void Appended();
  void Texts();
  void Looks();
  void NewTable();
  void CellTypes();
};

//------------------------------------------------------------------------------
// Whether a cell belongs to shapes as the server lists them.
void TestTableModel::CellTypes()
{
  using camaron::IsAmong;
  const QString some = "tetrahedra, pyramids, wedges and hexahedra";
  for (const char* type : { "Tetra", "QuadraticTetra", "Pyramid", "Wedge", "Hexahedron", "Voxel" })
  {
    QVERIFY(IsAmong(type, some));
    QVERIFY(IsAmong(type, "polyhedra"));
    QVERIFY(IsAmong(type, "any cell"));
    QVERIFY(!IsAmong(type, "polygons"));
    QVERIFY(!IsAmong(type, "triangles and quadrilaterals"));
  }
  QVERIFY(!IsAmong("Wedge", "tetrahedra"));
  QVERIFY(!IsAmong("Polyhedron", some));
  QVERIFY(IsAmong("Polyhedron", "polygons and polyhedra"));
  for (const char* type : { "Triangle", "Quad", "BiquadraticQuad", "Pixel" })
  {
    QVERIFY(IsAmong(type, "triangles and quadrilaterals"));
    QVERIFY(IsAmong(type, "polygons"));
    QVERIFY(!IsAmong(type, "polyhedra"));
  }
  QVERIFY(!IsAmong("Polygon", "triangles and quadrilaterals"));
  QVERIFY(IsAmong("TriangleStrip", "polygons"));
}

//------------------------------------------------------------------------------
void TestTableModel::Tables()
{
  const PanelTable table = MakeTable();
  QCOMPARE(table.Columns, QStringList({ "Id", "Value", "Typ\u00e9" }));
  QCOMPARE(table.size(), 3);
  QCOMPARE(table.integer(2, "Id"), LargeId + 2);
  QCOMPARE(table.number(0, "Value"), 0.1);
  QVERIFY(std::isnan(table.number(1, "Value")));
  QCOMPARE(table.text(0, "Typ\u00e9"), QString("poly\u00e8dre"));
  for (const int row : { -1, 3 })
  {
    QVERIFY(!table.value(row, "Id").isValid());
  }
  QVERIFY(!table.value(0, "id").isValid());
  QVERIFY(std::isnan(table.number(0, "id"))); // not 0
}

//------------------------------------------------------------------------------
void TestTableModel::NoTable()
{
  QVERIFY(camaron::ToPanelTable(nullptr).isEmpty());
  vtkNew<vtkTable> empty;
  QVERIFY(camaron::ToPanelTable(empty).isEmpty());
}

//------------------------------------------------------------------------------
void TestTableModel::Appended()
{
  PanelTable table;
  table.append(MakeTable());
  PanelTable other;
  other.Columns = QStringList{ "Value", "Id" };
  other.Rows = { { 7.5, qlonglong(4) } };
  table.append(other);
  QCOMPARE(table.size(), 4);
  QCOMPARE(table.integer(3, "Id"), 4);
  QCOMPARE(table.number(3, "Value"), 7.5);
  QVERIFY(!table.value(3, "Typ\u00e9").isValid());
}

//------------------------------------------------------------------------------
void TestTableModel::Texts()
{
  pqTableModel* model = MakeModel(this);
  const QAbstractItemModelTester tester(model); // fatal if the model breaks a rule of Qt
  model->setTable(MakeTable());
  const auto text = [&](int row, int column)
  { return model->index(row, column).data().toString(); };
  QCOMPARE(model->rowCount(), 3);
  QCOMPARE(model->columnCount(), 4);
  QCOMPARE(text(0, 0), QString::number(LargeId));
  QCOMPARE(text(0, 1), QString("0.1"));
  QCOMPARE(text(1, 1), QString());
  QCOMPARE(text(2, 1), QString("-∞"));
  QCOMPARE(text(0, 2), QString("poly\u00e8dre"));
  QCOMPARE(text(0, 3), QString("0.2"));
  QCOMPARE(model->headerData(0, Qt::Horizontal, Qt::DisplayRole).toString(), QString("Number"));
}

//------------------------------------------------------------------------------
void TestTableModel::Looks()
{
  pqTableModel* model = MakeModel(this);
  model->setTable(MakeTable());
  const auto look = [&](int row, int column, int role)
  { return model->index(row, column).data(role); };
  QVERIFY(look(0, 0, Qt::TextAlignmentRole).toInt() & Qt::AlignRight);
  QVERIFY(look(0, 2, Qt::TextAlignmentRole).toInt() & Qt::AlignLeft);
  QVERIFY(!look(0, 0, Qt::ForegroundRole).isValid()); // the palette's
  model->setRowColor([](const PanelTable& table, int row)
    { return std::isnan(table.number(row, "Value")) ? QColor(Qt::red) : QColor(); });
  QVERIFY(!look(0, 0, Qt::ForegroundRole).isValid());
  QCOMPARE(look(1, 0, Qt::ForegroundRole).value<QColor>(), QColor(Qt::red));
}

//------------------------------------------------------------------------------
void TestTableModel::NewTable()
{
  pqTableModel* model = MakeModel(this);
  const QAbstractItemModelTester tester(model);
  const QSignalSpy resets(model, &QAbstractItemModel::modelReset);
  model->setTable(MakeTable());
  model->setTable({});
  QCOMPARE(resets.count(), 2);
  QCOMPARE(model->rowCount(), 0);
}

QTEST_GUILESS_MAIN(TestTableModel)
#include "TestTableModel.moc"
