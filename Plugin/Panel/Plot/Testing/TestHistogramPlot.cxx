// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Brushing, dragging and zooming in the histogram plot with mouse and keyboard. A failure means
// that the user selects other elements than the picture and the signals say.
#include "HistogramPainter.h"
#include "HistogramScene.h"
#include "PlotColors.h"
#include "pqHistogramPlot.h"

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <cmath>
#include <limits>

using camaron::HistogramBrush;
using camaron::HistogramData;
using camaron::Infinity;
using Ranges = QVector<QPair<double, double>>;

namespace
{
constexpr double Largest = std::numeric_limits<double>::max();

// Ten bins from 0 to 100 with 1 to 10 elements; 3 below, 4 above, 5 infinite, 6 undefined.
HistogramData MakeData()
{
  HistogramData data;
  data.Name = "Angle";
  data.Unit = "deg";
  data.Groups.resize(1);
  for (int i = 0; i <= 10; ++i)
  {
    data.Edges.push_back(10 * i);
  }
  data.Groups[0].Counts = { 3, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 4, 5, 6 };
  return data;
}

double Below(double value)
{
  return std::nextafter(value, -Infinity);
}

int CountPixels(const QImage& image, const QColor& color)
{
  int number = 0;
  for (int y = 0; y < image.height(); ++y)
  {
    for (int x = 0; x < image.width(); ++x)
    {
      number += image.pixelColor(x, y) == color;
    }
  }
  return number;
}

// A plot of fixed size, and the mouse at its parts.
class Plot : public pqHistogramPlot
{
public:
  explicit Plot(const HistogramData& data)
  {
    this->resize(500, 200);
    this->setData(data);
    this->show();
  }

  camaron::HistogramScene Scene() const
  {
    camaron::HistogramScene scene;
    scene.Data = this->data();
    scene.Place(this->size(), this->font(), this->devicePixelRatioF());
    return scene;
  }
  QPointF Bin(int bin) const { return this->Column(bin + 1); }
  QPointF Column(int column) const { return this->Scene().GetSlot(column).center(); }
  QPointF Grip(bool isLow, double value) const
  {
    const QRectF plot = this->Scene().Plot;
    return { this->Scene().LimitToX(value, isLow) + (isLow ? -3 : 3), plot.top() - 6 };
  }
  QPointF Axis(double value) const
  {
    return { this->Scene().ToX(value), this->Scene().ValueAxis.center().y() };
  }

  void Send(QEvent::Type type, const QPointF& position, Qt::KeyboardModifiers modifiers)
  {
    const bool isMove = type == QEvent::MouseMove;
    QMouseEvent event(type, position, this->mapToGlobal(position),
      isMove ? Qt::NoButton : Qt::LeftButton,
      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, modifiers);
    QCoreApplication::sendEvent(this, &event);
  }
  void Press(const QPointF& position, Qt::KeyboardModifiers modifiers = {})
  {
    this->Send(QEvent::MouseButtonPress, position, modifiers);
  }
  void Move(const QPointF& position, Qt::KeyboardModifiers modifiers = {})
  {
    this->Send(QEvent::MouseMove, position, modifiers);
  }
  void Release(const QPointF& position, Qt::KeyboardModifiers modifiers = {})
  {
    this->Send(QEvent::MouseButtonRelease, position, modifiers);
  }
  void Click(const QPointF& position, Qt::KeyboardModifiers modifiers = {})
  {
    this->Press(position, modifiers);
    this->Release(position, modifiers);
  }
  void Drag(const QPointF& from, const QPointF& to, Qt::KeyboardModifiers modifiers = {})
  {
    this->Press(from, modifiers);
    this->Move((from + to) / 2, modifiers);
    this->Move(to, modifiers);
    this->Release(to, modifiers);
  }
  bool Wheel(
    const QPointF& position, int angle, Qt::KeyboardModifiers modifiers = Qt::ControlModifier)
  {
    QWheelEvent event(position, this->mapToGlobal(position), {}, { 0, angle }, Qt::NoButton,
      modifiers, Qt::NoScrollPhase, false);
    event.ignore();
    QCoreApplication::sendEvent(this, &event);
    return event.isAccepted();
  }
};

// The last emission of brushed().
struct Brushed
{
  explicit Brushed(const QSignalSpy& spy)
    : Values(spy.isEmpty() ? Ranges() : spy.back()[0].value<Ranges>())
    , Specials(spy.isEmpty() ? -1 : spy.back()[1].toInt())
    , Count(spy.isEmpty() ? -1 : spy.back()[2].toLongLong())
    , Modifiers(spy.isEmpty() ? Qt::NoModifier : spy.back()[3].value<Qt::KeyboardModifiers>())
  {
  }
  Ranges Values;
  int Specials;
  qint64 Count;
  Qt::KeyboardModifiers Modifiers;
};
}

class TestHistogramPlot : public QObject
{
  Q_OBJECT

private Q_SLOTS:
  void WholeNumbers();
  void ClickBrushesABar();
  void DragBrushesSeveral();
  void DragReportsTheCount();
  void ModifiersCombine();
  void ClicksOnSpecialBars();
  void ClickOnEmptySpaceClears();
  void EscapeClearsAndCancels();
  void Properties();
  void HandleSnapsToRoundNumbers();
  void HandleFollowsTheMouseWithCtrl();
  void HandleOfInfiniteLimit();
  void HandlesOfIntegers();
  void Zoom();
  void Keyboard();
  void NewDataKeepOrForgetTheBrush();
  void SettersAreSilent();
  void ExtremeDataAndSizes();
  void SingleElementsAreVisible();
  void StacksShowSelectedParts();
};

//------------------------------------------------------------------------------
// Else the axis of Valid, which is 0 or 1, has ticks from -0.4 to 1.4.
void TestHistogramPlot::WholeNumbers()
{
  const auto getTicks = [](const std::vector<double>& edges)
  {
    camaron::HistogramScene scene;
    scene.Data.Edges = edges;
    scene.Data.Groups.resize(1);
    std::vector<qint64>& counts = scene.Data.Groups[0].Counts;
    counts.resize(scene.Data.GetNumberOfColumns());
    std::fill_n(counts.begin() + scene.Data.GetColumnOfBin(0), edges.size() - 1, 1);
    scene.Place({ 400, 200 }, QFont(), 1);
    QStringList labels;
    for (const camaron::Tick& tick : scene.ValueTicks)
    {
      labels << tick.Label;
    }
    return labels.join(' ');
  };
  QCOMPARE(getTicks({ -0.5, 0.5, 1.5 }), QString("0 1"));
  QCOMPARE(getTicks({ 1, 1 }), QString("1"));
  QCOMPARE(getTicks({ 2.5, 3.5, 4.5, 5.5 }), QString("3 4 5"));
  QVERIFY(getTicks({ 0, 0.5, 1 }).contains("0.5"));
  QVERIFY(getTicks({ 0.5, 0.5 }).contains("0.5"));
}

//------------------------------------------------------------------------------
void TestHistogramPlot::ClickBrushesABar()
{
  Plot plot(MakeData());
  QSignalSpy brushed(&plot, &pqHistogramPlot::brushed);
  plot.Click(plot.Bin(3));
  QCOMPARE(brushed.size(), 1);
  QCOMPARE(Brushed(brushed).Values, (Ranges{ { 30, Below(40) } }));
  QCOMPARE(Brushed(brushed).Count, 4);
  QCOMPARE(Brushed(brushed).Specials, 0);
  plot.Click(plot.Bin(9)); // the last one includes its upper edge
  QCOMPARE(Brushed(brushed).Values, (Ranges{ { 90, 100 } }));
  QCOMPARE(plot.brushedCount(), 10);
}

//------------------------------------------------------------------------------
void TestHistogramPlot::DragBrushesSeveral()
{
  Plot plot(MakeData());
  QSignalSpy brushed(&plot, &pqHistogramPlot::brushed);
  plot.Drag(plot.Bin(5), plot.Bin(2)); // to the left
  QCOMPARE(brushed.size(), 1);
  QCOMPARE(Brushed(brushed).Values, (Ranges{ { 20, Below(60) } }));
  QCOMPARE(Brushed(brushed).Count, 3 + 4 + 5 + 6);
  // Beyond the right end of the widget: everything there.
  plot.Drag(plot.Bin(8), QPointF(2000, 50));
  QCOMPARE(Brushed(brushed).Values, (Ranges{ { 80, Largest } }));
  QCOMPARE(Brushed(brushed).Specials, HistogramBrush::Undefined | HistogramBrush::Infinite);
  QCOMPARE(Brushed(brushed).Count, 9 + 10 + 4 + 5 + 6);
}

//------------------------------------------------------------------------------
void TestHistogramPlot::DragReportsTheCount()
{
  Plot plot(MakeData());
  QSignalSpy dragging(&plot, &pqHistogramPlot::brushDragging);
  QSignalSpy brushed(&plot, &pqHistogramPlot::brushed);
  plot.Press(plot.Bin(1));
  QCOMPARE(dragging.size(), 1);
  plot.Move(plot.Bin(2));
  QCOMPARE(dragging.size(), 2);
  QCOMPARE(dragging.back()[0].toDouble(), 10.0);
  QVERIFY(dragging.back()[1].toDouble() == Below(30));
  QCOMPARE(dragging.back()[2].toLongLong(), 5);
  plot.Move(plot.Bin(2) + QPointF(1, 30)); // the same bar
  QCOMPARE(dragging.size(), 2);
  QCOMPARE(brushed.size(), 0);
  plot.Release(plot.Bin(2));
  QCOMPARE(brushed.size(), 1);
  QCOMPARE(dragging.back()[2].toLongLong(), plot.brushedCount());
}

//------------------------------------------------------------------------------
void TestHistogramPlot::ModifiersCombine()
{
  Plot plot(MakeData());
  QSignalSpy brushed(&plot, &pqHistogramPlot::brushed);
  plot.Drag(plot.Bin(1), plot.Bin(4));
  plot.Click(plot.Bin(7), Qt::ShiftModifier);
  // The signal describes the new brush alone, the plot all of it.
  QCOMPARE(Brushed(brushed).Values, (Ranges{ { 70, Below(80) } }));
  QCOMPARE(Brushed(brushed).Modifiers, Qt::ShiftModifier);
  QCOMPARE(plot.brushedRanges(), (Ranges{ { 10, Below(50) }, { 70, Below(80) } }));
  QCOMPARE(plot.brushedCount(), 2 + 3 + 4 + 5 + 8);
  plot.Click(plot.Bin(2), Qt::ControlModifier);
  QCOMPARE(Brushed(brushed).Modifiers, Qt::ControlModifier);
  QCOMPARE(
    plot.brushedRanges(), (Ranges{ { 10, Below(20) }, { 30, Below(50) }, { 70, Below(80) } }));
  plot.Drag(plot.Bin(0), plot.Bin(3), Qt::ControlModifier | Qt::ShiftModifier);
  QCOMPARE(Brushed(brushed).Modifiers, Qt::ControlModifier | Qt::ShiftModifier);
  QCOMPARE(plot.brushedRanges(), (Ranges{ { 10, Below(20) }, { 30, Below(40) } }));
  plot.Click(plot.Bin(0));
  QCOMPARE(plot.brushedRanges(), (Ranges{ { 0, Below(10) } }));
}

//------------------------------------------------------------------------------
void TestHistogramPlot::ClicksOnSpecialBars()
{
  const HistogramData data = MakeData();
  Plot plot(data);
  QSignalSpy brushed(&plot, &pqHistogramPlot::brushed);
  plot.Click(plot.Column(0));
  QCOMPARE(Brushed(brushed).Values, (Ranges{ { -Largest, Below(0) } }));
  QCOMPARE(Brushed(brushed).Count, 3);
  plot.Click(plot.Column(data.GetColumn(HistogramData::Column::Overflow)));
  QCOMPARE(Brushed(brushed).Values, (Ranges{ { std::nextafter(100, Infinity), Largest } }));
  QCOMPARE(Brushed(brushed).Count, 4);
  plot.Click(plot.Column(data.GetColumn(HistogramData::Column::Infinite)));
  QVERIFY(Brushed(brushed).Values.isEmpty());
  QCOMPARE(Brushed(brushed).Specials, HistogramBrush::Infinite);
  QCOMPARE(Brushed(brushed).Count, 5);
  plot.Click(plot.Column(data.GetColumn(HistogramData::Column::Undefined)), Qt::ShiftModifier);
  QCOMPARE(Brushed(brushed).Specials, HistogramBrush::Undefined);
  QCOMPARE(plot.brushedCount(), 11);
  QVERIFY(std::isnan(plot.brushLow()));
}

//------------------------------------------------------------------------------
void TestHistogramPlot::ClickOnEmptySpaceClears()
{
  HistogramData data = MakeData();
  data.Groups[0].Counts[data.GetColumnOfBin(5)] = 0;
  Plot plot(data);
  QSignalSpy brushed(&plot, &pqHistogramPlot::brushed);
  plot.Click(plot.Bin(3));
  plot.Click(plot.Bin(5), Qt::ShiftModifier); // nothing to add
  QCOMPARE(brushed.size(), 1);
  plot.Click(plot.Bin(5));
  QCOMPARE(brushed.size(), 2);
  QVERIFY(Brushed(brushed).Values.isEmpty());
  QCOMPARE(Brushed(brushed).Count, 0);
  QCOMPARE(plot.brushedCount(), 0);
  // A drag that begins on empty space brushes nevertheless.
  plot.Drag(plot.Bin(5), plot.Bin(6));
  QCOMPARE(Brushed(brushed).Values, (Ranges{ { 50, Below(70) } }));
  plot.Click(QPointF(plot.width() / 2.0, 1)); // above the plot
  QCOMPARE(plot.brushedCount(), 0);
}

//------------------------------------------------------------------------------
void TestHistogramPlot::EscapeClearsAndCancels()
{
  Plot plot(MakeData());
  QSignalSpy brushed(&plot, &pqHistogramPlot::brushed);
  QSignalSpy dragging(&plot, &pqHistogramPlot::brushDragging);
  plot.Click(plot.Bin(3));
  plot.Press(plot.Bin(6));
  plot.Move(plot.Bin(7));
  QTest::keyClick(&plot, Qt::Key_Escape);
  QCOMPARE(plot.brushedCount(), 4);
  QCOMPARE(dragging.back()[2].toLongLong(), 4);
  plot.Release(plot.Bin(7));
  QCOMPARE(brushed.size(), 1);
  QTest::keyClick(&plot, Qt::Key_Escape);
  QCOMPARE(plot.brushedCount(), 0);
  QCOMPARE(brushed.size(), 2);
  QTest::keyClick(&plot, Qt::Key_Escape);
  QCOMPARE(brushed.size(), 2); // nothing is selected
  HistogramData::Group parts;
  parts.Counts.assign(14, 1);
  plot.showSelected(parts); // by others
  QTest::keyClick(&plot, Qt::Key_Escape);
  QCOMPARE(brushed.size(), 3);

  plot.showAcceptable(20, 80);
  QSignalSpy changed(&plot, &pqHistogramPlot::acceptableChanged);
  plot.Press(plot.Grip(true, 20));
  plot.Move(plot.Grip(true, 50));
  QCOMPARE(plot.acceptableLow(), 50.0);
  QTest::keyClick(&plot, Qt::Key_Escape);
  QCOMPARE(plot.acceptableLow(), 20.0);
  plot.Release(plot.Grip(true, 50));
  QCOMPARE(changed.size(), 0);
}

//------------------------------------------------------------------------------
void TestHistogramPlot::Properties()
{
  Plot plot(MakeData());
  QCOMPARE(plot.property("binCounts").toString(), QString("1 2 3 4 5 6 7 8 9 10"));
  plot.Drag(plot.Bin(2), plot.Bin(3));
  QCOMPARE(plot.property("brushLow").toString(), QString("20"));
  QVERIFY(plot.property("brushHigh").toDouble() == Below(40));
  QCOMPARE(plot.property("brushedCount").toString(), QString("7"));
  plot.showAcceptable(12.5, Infinity);
  QCOMPARE(plot.property("acceptableLow").toString(), QString("12.5"));
  QCOMPARE(plot.property("acceptableHigh").toString(), QString("inf"));
  QVERIFY(plot.setProperty("logarithmicCounts", true) && plot.logarithmicCounts());
  QVERIFY(plot.setProperty("cumulative", true) && plot.cumulative());
}

//------------------------------------------------------------------------------
void TestHistogramPlot::HandleSnapsToRoundNumbers()
{
  Plot plot(MakeData());
  plot.showAcceptable(20, 80);
  QSignalSpy dragging(&plot, &pqHistogramPlot::acceptableDragging);
  QSignalSpy changed(&plot, &pqHistogramPlot::acceptableChanged);
  plot.Click(plot.Grip(true, 20));
  QCOMPARE(dragging.size() + changed.size(), 0);
  plot.Drag(plot.Grip(true, 20), plot.Grip(true, 33.1));
  QVERIFY(dragging.size() >= 2);
  QCOMPARE(changed.size(), 1);
  QCOMPARE(changed.back()[0].toDouble(), 33.0);
  QCOMPARE(changed.back()[1].toDouble(), 80.0);
  // By its line, which bars of this width leave free.
  plot.Drag({ plot.Scene().ToX(80), 100 }, { plot.Scene().ToX(70), 100 });
  QCOMPARE(plot.acceptableHigh(), 70.0);
  // Not beyond the other one.
  plot.Drag(plot.Grip(false, 70), plot.Grip(false, 10));
  QCOMPARE(plot.acceptableHigh(), 33.0);
  QCOMPARE(plot.acceptableLow(), 33.0);
  QCOMPARE(plot.brushedCount(), 0);
}

//------------------------------------------------------------------------------
void TestHistogramPlot::HandleFollowsTheMouseWithCtrl()
{
  HistogramData data = MakeData();
  for (double& edge : data.Edges)
  {
    edge *= 1000; // round numbers are 1000 apart
  }
  Plot plot(data);
  plot.showAcceptable(20000, 80000);
  plot.Drag(plot.Grip(true, 20000), plot.Grip(true, 33254), Qt::ControlModifier);
  const double pixel = 100000 / plot.Scene().Plot.width();
  QVERIFY(std::abs(plot.acceptableLow() - 33254) < pixel);
  QVERIFY(std::fmod(plot.acceptableLow(), 1000) != 0);
}

//------------------------------------------------------------------------------
void TestHistogramPlot::HandleOfInfiniteLimit()
{
  Plot plot(MakeData());
  QSignalSpy changed(&plot, &pqHistogramPlot::acceptableChanged);
  // The grip at the end of the axis; a trembling hand changes nothing.
  plot.Drag(plot.Grip(true, 0), plot.Grip(true, 0) + QPointF(1, 0));
  QCOMPARE(changed.size(), 0);
  plot.Drag(plot.Grip(true, 0), plot.Grip(true, 40));
  QCOMPARE(plot.acceptableLow(), 40.0);
  QCOMPARE(plot.acceptableHigh(), Infinity);
  plot.Drag(plot.Grip(false, 100), plot.Grip(false, 60));
  QCOMPARE(plot.acceptableHigh(), 60.0);
  plot.Drag(plot.Grip(true, 40), plot.Grip(true, 0) - QPointF(20, 0));
  QCOMPARE(plot.acceptableLow(), -Infinity);
  QCOMPARE(changed.size(), 3);
}

//------------------------------------------------------------------------------
void TestHistogramPlot::HandlesOfIntegers()
{
  HistogramData data;
  data.Groups.resize(1);
  data.Groups[0].Counts = { 0, 10, 20, 30, 5, 0, 0, 0 };
  data.Edges = { 3.5, 4.5, 5.5, 6.5, 7.5 };
  Plot plot(data);
  plot.showAcceptable(4, 7);
  // The line is between the bars 5 and 6.
  plot.Drag(plot.Grip(true, 4), plot.Grip(true, 6));
  QCOMPARE(plot.acceptableLow(), 6.0);
  QVERIFY(std::abs(plot.Scene().LimitToX(6, true) - plot.Scene().GetSlot(3).left()) <= 0.5);
  plot.Drag(plot.Grip(true, 6), plot.Grip(true, 5), Qt::ControlModifier);
  QCOMPARE(plot.acceptableLow(), 5.0);
}

//------------------------------------------------------------------------------
void TestHistogramPlot::Zoom()
{
  HistogramData data = MakeData();
  data.Groups[0].Counts[data.GetColumnOfBin(5)] = 0;
  Plot plot(data);
  QSignalSpy requested(&plot, &pqHistogramPlot::rangeRequested);
  QSignalSpy reset(&plot, &pqHistogramPlot::rangeReset);
  plot.Drag(plot.Axis(60), plot.Axis(20));
  QCOMPARE(requested.size(), 1);
  const auto isNear = [&](int argument, double expected)
  { return std::abs(requested.back()[argument].toDouble() - expected) < 1e-6; };
  QVERIFY(isNear(0, 20) && isNear(1, 60));
  plot.setData(data);
  plot.Click(plot.Axis(60));
  QCOMPARE(requested.size(), 1);
  // Two steps before the owner answers: the range shrinks twice, around the mouse.
  QVERIFY(plot.Wheel(plot.Axis(50), 120));
  QVERIFY(isNear(0, 10) && isNear(1, 90));
  QVERIFY(plot.Wheel(plot.Axis(50), 120));
  QVERIFY(isNear(0, 18) && isNear(1, 82));
  plot.setData(data);
  QVERIFY(plot.Wheel(plot.Axis(50), -120));
  QVERIFY(isNear(0, -12.5) && isNear(1, 112.5));
  plot.setData(data);
  QVERIFY(!plot.Wheel(plot.Bin(4), 120)); // scrolls the panel
  plot.clearFocus();
  QVERIFY(!plot.Wheel(plot.Axis(50), 120, Qt::NoModifier));
  QCOMPARE(requested.size(), 4);

  plot.Send(QEvent::MouseButtonDblClick, plot.Axis(50), Qt::NoModifier);
  QCOMPARE(reset.size(), 1);
  plot.Send(QEvent::MouseButtonDblClick, plot.Bin(5), Qt::NoModifier); // empty
  QCOMPARE(reset.size(), 2);
  plot.Send(QEvent::MouseButtonDblClick, plot.Bin(4), Qt::NoModifier);
  QCOMPARE(reset.size(), 2);

  data.Logarithmic = true;
  data.Edges = { 1, 10, 100, 1000 };
  data.Groups[0].Counts = { 0, 1, 2, 3, 0, 0, 0 };
  plot.setData(data);
  plot.Drag(plot.Axis(10), plot.Axis(100));
  QVERIFY(isNear(0, 10) && isNear(1, 100));
}

//------------------------------------------------------------------------------
void TestHistogramPlot::Keyboard()
{
  Plot plot(MakeData());
  QSignalSpy brushed(&plot, &pqHistogramPlot::brushed);
  QTest::keyClick(&plot, Qt::Key_Return); // no current bar
  QCOMPARE(brushed.size(), 0);
  QTest::keyClick(&plot, Qt::Key_Home);
  QTest::keyClick(&plot, Qt::Key_Return);
  QCOMPARE(Brushed(brushed).Count, 3); // below the first edge
  QTest::keyClick(&plot, Qt::Key_Right);
  QTest::keyClick(&plot, Qt::Key_Right);
  QTest::keyClick(&plot, Qt::Key_Right, Qt::ShiftModifier);
  QTest::keyClick(&plot, Qt::Key_Right, Qt::ShiftModifier);
  QTest::keyClick(&plot, Qt::Key_Left, Qt::ShiftModifier);
  QTest::keyClick(&plot, Qt::Key_Space);
  QCOMPARE(Brushed(brushed).Values, (Ranges{ { 10, Below(30) } }));
  QTest::keyClick(&plot, Qt::Key_End);
  QTest::keyClick(&plot, Qt::Key_Right); // already there
  QTest::keyClick(&plot, Qt::Key_Return, Qt::ShiftModifier);
  QCOMPARE(Brushed(brushed).Specials, HistogramBrush::Undefined);
  QCOMPARE(Brushed(brushed).Modifiers, Qt::ShiftModifier);
  QCOMPARE(plot.brushedCount(), 2 + 3 + 6);

  QSignalSpy limits(&plot, &pqHistogramPlot::acceptableChanged);
  plot.showAcceptable(-Infinity, 20);
  QTest::keyClick(&plot, Qt::Key_Left, Qt::AltModifier); // already infinite
  QCOMPARE(limits.size(), 0);
  QTest::keyClick(&plot, Qt::Key_Right, Qt::AltModifier);
  const double first = plot.acceptableLow();
  QTest::keyClick(&plot, Qt::Key_Right, Qt::AltModifier);
  QVERIFY(first >= 0 && plot.acceptableLow() > first && plot.acceptableLow() <= 2);
  QTest::keyClick(&plot, Qt::Key_Left, Qt::AltModifier);
  QCOMPARE(plot.acceptableLow(), first);
  QTest::keyClick(&plot, Qt::Key_Down, Qt::AltModifier);
  QVERIFY(plot.acceptableHigh() < 20 && plot.acceptableHigh() >= 18);
  for (int i = 0; i < 200; ++i)
  {
    QTest::keyClick(&plot, Qt::Key_Right, Qt::AltModifier);
  }
  QCOMPARE(plot.acceptableLow(), plot.acceptableHigh()); // not beyond the other limit
  for (int i = 0; i < 200; ++i)
  {
    QTest::keyClick(&plot, Qt::Key_Up, Qt::AltModifier);
  }
  QCOMPARE(plot.acceptableHigh(), Infinity);

  QSignalSpy requested(&plot, &pqHistogramPlot::rangeRequested);
  QSignalSpy reset(&plot, &pqHistogramPlot::rangeReset);
  QTest::keyClick(&plot, Qt::Key_Plus);
  QTest::keyClick(&plot, Qt::Key_0);
  QCOMPARE(requested.size(), 1);
  QCOMPARE(reset.size(), 1);
}

//------------------------------------------------------------------------------
void TestHistogramPlot::NewDataKeepOrForgetTheBrush()
{
  HistogramData data = MakeData();
  Plot plot(data);
  QSignalSpy brushed(&plot, &pqHistogramPlot::brushed);
  plot.Click(plot.Bin(3));
  data.Groups[0].Counts[data.GetColumnOfBin(3)] = 1000;
  plot.setData(data); // another time step
  QCOMPARE(plot.brushedCount(), 1000);
  data.Edges.back() = 101;
  plot.setData(data);
  QCOMPARE(plot.brushedCount(), 0);
  // In the middle of a drag.
  plot.Press(plot.Bin(2));
  data.Edges.back() = 102;
  plot.setData(data);
  plot.Move(plot.Bin(4));
  plot.Release(plot.Bin(4));
  QCOMPARE(plot.brushedCount(), 0);
  QCOMPARE(brushed.size(), 1);
  data.Groups[0].Counts.pop_back(); // invalid
  plot.setData(data);
  QVERIFY(plot.data().IsEmpty());
}

//------------------------------------------------------------------------------
void TestHistogramPlot::SettersAreSilent()
{
  Plot plot(MakeData());
  plot.Click(plot.Bin(1));
  QSignalSpy brushed(&plot, &pqHistogramPlot::brushed);
  QSignalSpy changed(&plot, &pqHistogramPlot::acceptableChanged);
  plot.showAcceptable(20, std::nan(""));
  QCOMPARE(plot.acceptableHigh(), Infinity);
  plot.showSelected({});
  QCOMPARE(plot.brushedCount(), 0);
  plot.setData({});
  QCOMPARE(brushed.size() + changed.size(), 0);
}

//------------------------------------------------------------------------------
// Neither a crash, nor an endless loop, nor a picture that depends on undefined numbers.
void TestHistogramPlot::ExtremeDataAndSizes()
{
  const double tiny = std::numeric_limits<double>::denorm_min();
  const std::vector<std::pair<std::vector<double>, bool>> cases = { { {}, false }, { {}, true },
    { { 4, 4 }, false }, { { 0, 0 }, false }, { { tiny, tiny }, true }, { { tiny, tiny }, false },
    { { Largest, Largest }, true }, { { Largest, Largest }, false },
    { { -Largest, 0, Largest }, false }, { { 0, tiny }, false }, { { tiny, Largest }, true },
    { { 1, std::nextafter(1, 2) }, false }, { { 1, std::nextafter(1, 2) }, true },
    { { -1e-300, 1e-300 }, false }, { { 0.5, 1.5 }, false } };
  for (const auto& [edges, logarithmic] : cases)
  {
    HistogramData data;
    data.Edges = edges;
    data.Logarithmic = logarithmic;
    data.Groups.resize(2);
    for (HistogramData::Group& group : data.Groups)
    {
      group.Label = "A group with a name that is much too long for its legend";
      group.Counts.assign(data.GetNumberOfColumns(), 0);
      std::fill_n(group.Counts.begin() + 1, data.GetNumberOfBins(), qint64(1e15));
      group.Counts.back() = 1;
    }
    QVERIFY(data.IsValid());
    for (const bool isOn : { false, true })
    {
      for (const QSize size : { QSize(1, 1), QSize(100, 40), QSize(280, 180), QSize(4000, 10) })
      {
        pqHistogramPlot plot;
        plot.setData(data);
        plot.setCurve({ edges, std::vector<qint64>(edges.size(), 1), {} });
        plot.setOutline(data);
        plot.setLogarithmicCounts(isOn);
        plot.setCumulative(isOn);
        plot.showAcceptable(isOn ? -1e-5 : -Infinity, isOn ? Largest : Infinity);
        plot.resize(size);
        plot.grab();
        QTest::keyClick(&plot, Qt::Key_Plus);
        for (const QPointF position : { QPointF(0, 0), QPointF(60, 30), QPointF(200, 150) })
        {
          QTest::mousePress(&plot, Qt::LeftButton, {}, position.toPoint());
          QTest::mouseMove(&plot, position.toPoint() + QPoint(30, 3));
          QTest::mouseRelease(&plot, Qt::LeftButton, {}, position.toPoint() + QPoint(30, 3));
        }
        plot.grab();
      }
    }
  }
}

//------------------------------------------------------------------------------
void TestHistogramPlot::SingleElementsAreVisible()
{
  HistogramData data;
  data.Groups.resize(1);
  data.Groups[0].Counts.assign(2004, 0); // more bins than pixels
  data.Groups[0].Counts[data.GetColumnOfBin(7)] = 1;
  data.Groups[0].Counts[data.GetColumnOfBin(1000)] = 1000000000;
  for (int i = 0; i <= 2000; ++i)
  {
    data.Edges.push_back(i);
  }
  Plot plot(data);
  plot.showAcceptable(500, Infinity);
  const camaron::PlotColors colors(plot.palette());
  QVERIFY(CountPixels(plot.grab().toImage(), colors.Bad) >= 4);

  QImage small(80, 16, QImage::Format_RGB32);
  small.fill(colors.Background);
  QPainter painter(&small);
  camaron::PaintSmallHistogram(&painter, small.rect(), data, 500, Infinity, plot.palette());
  painter.end();
  QVERIFY(CountPixels(small, colors.Bad) >= 2);
  QVERIFY(CountPixels(small, colors.Good) >= 16);

  // A selection is drawn over pale bars.
  data.Selected.Counts.assign(data.GetNumberOfColumns(), 0);
  data.Selected.Counts[data.GetColumnOfBin(7)] = 1;
  const int all = CountPixels(small, colors.Good) + CountPixels(small, colors.Bad);
  small.fill(colors.Background);
  painter.begin(&small);
  camaron::PaintSmallHistogram(&painter, small.rect(), data, -Infinity, 500, plot.palette());
  painter.end();
  const int selected = CountPixels(small, colors.Good) + CountPixels(small, colors.Bad);
  QVERIFY(selected > 0);
  QVERIFY(selected < all);
}

//------------------------------------------------------------------------------
// In each bar, what is selected of each group has its color, and all else is pale.
void TestHistogramPlot::StacksShowSelectedParts()
{
  HistogramData data = MakeData();
  data.Groups.resize(2);
  data.Groups[0].Counts = { 0, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 0, 0, 0 };
  data.Groups[1].Counts = { 0, 30, 30, 30, 30, 30, 30, 30, 30, 30, 30, 0, 0, 0 };
  Plot plot(data);
  const camaron::PlotColors colors(plot.palette());
  const auto count = [&](int group)
  { return CountPixels(plot.grab().toImage(), colors.GetGroupColor(group)); };
  for (const bool isLogarithmic : { false, true })
  {
    plot.setLogarithmicCounts(isLogarithmic);
    plot.showSelected({});
    const int all = count(0);
    std::vector<HistogramData::Group> parts(1); // none of the second group
    parts[0].Counts.assign(14, 0);
    parts[0].Counts[data.GetColumnOfBin(4)] = 50;
    plot.showSelected(parts[0], parts);
    const int swatch = count(1); // of the legend
    const int bars = all - swatch, selected = count(0) - swatch;
    // Half of one of ten bars, or the line at the half.
    const int expected = isLogarithmic ? bars / 10 : bars / 20;
    QVERIFY(std::abs(selected - expected) <= bars / 100);
    QVERIFY(swatch < bars / 10);
  }
}

//------------------------------------------------------------------------------
int main(int argc, char** argv)
{
  qputenv("QT_QPA_PLATFORM", "offscreen"); // no screen, and the same on every machine
  QApplication application(argc, argv);
  TestHistogramPlot test;
  return QTest::qExec(&test, argc, argv);
}

#include "TestHistogramPlot.moc"
