// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The arithmetic of the histogram plot: brushed counts and ranges, cumulative counts, round numbers
// and texts. A failure means that a number beside the plot is not the number of selected elements.
#include "CumulativeCounts.h"
#include "HistogramBrush.h"
#include "HistogramData.h"
#include "NumberText.h"
#include "PlotText.h"
#include "Ticks.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace camaron;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Largest = std::numeric_limits<double>::max();
constexpr double Tiny = std::numeric_limits<double>::denorm_min();

// Counts as the definition of bins says, value by value.
HistogramData Count(
  const std::vector<double>& edges, const std::vector<double>& values, bool logarithmic = false)
{
  HistogramData data;
  data.Edges = edges;
  data.Logarithmic = logarithmic;
  data.Groups.resize(1);
  HistogramData::Group& group = data.Groups[0];
  group.Counts.assign(data.GetNumberOfColumns(), 0);
  for (const double value : values)
  {
    if (std::isnan(value))
    {
      ++group.Counts[data.GetColumn(HistogramData::Column::Undefined)];
    }
    else if (std::isinf(value))
    {
      ++group.Counts[data.GetColumn(HistogramData::Column::Infinite)];
    }
    else if (edges.empty() || value < edges.front())
    {
      ++group.Counts[data.GetColumn(HistogramData::Column::Underflow)];
    }
    else if (value > edges.back())
    {
      ++group.Counts[data.GetColumn(HistogramData::Column::Overflow)];
    }
    else
    {
      int bin = 0;
      while (bin + 1 < data.GetNumberOfBins() && value >= edges[bin + 1])
      {
        ++bin;
      }
      ++group.Counts[data.GetColumnOfBin(bin)];
    }
  }
  return data;
}

// Random values, every edge and its neighbors, and values without a range.
std::vector<double> MakeValues(const std::vector<double>& edges, std::mt19937& random)
{
  std::vector<double> values = { NaN, NaN, Infinity, -Infinity, 0.0, -0.0, Tiny, -Tiny, Largest,
    -Largest, 1e-300 };
  for (const double edge : edges)
  {
    values.insert(
      values.end(), { edge, std::nextafter(edge, -Infinity), std::nextafter(edge, Infinity) });
  }
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 200; ++i)
  {
    values.push_back(uniform(random) * (edges.empty() ? 1 : 1.2 * std::abs(edges.back())));
  }
  return values;
}

qint64 CountSelected(
  const std::vector<double>& values, const HistogramBrush::Ranges& ranges, int specials)
{
  return std::count_if(values.begin(), values.end(),
    [&](double value)
    {
      if (std::isnan(value))
      {
        return (specials & HistogramBrush::Undefined) != 0;
      }
      if (std::isinf(value))
      {
        return (specials & HistogramBrush::Infinite) != 0;
      }
      return std::any_of(ranges.begin(), ranges.end(),
        [=](const auto& range) { return value >= range.first && value <= range.second; });
    });
}

const std::vector<std::pair<std::vector<double>, bool>> Cases = { { {}, false }, { {}, true },
  { { 7, 7 }, false }, { { 0, 0 }, false }, { { 0.1, 0.3 }, false },
  { { 0, 0.1, 0.2, 0.30000000000000004, 0.4 }, false }, { { -3, -1, 0, 2, 5 }, false },
  { { 2.5, 3.5, 4.5, 5.5 }, false }, { { 1e-9, 1e-6, 1e-3, 1, 1000 }, true },
  { { 1, 1 + 2.220446049250313e-16, 1 + 4.440892098500626e-16 }, false }, { { 0, Tiny }, false },
  { { -Largest, 0, Largest }, false } };
}

class TestHistogramData : public QObject
{
  Q_OBJECT

private Q_SLOTS:
  void IntegerBins();
  void BrushedCountsAreExact();
  void AdjacentBinsShareARange();
  void HugeCounts();
  void Validity();
  void NotJudged();
  void CurveAtPointsAndBetween();
  void CountsOutsideRanges();
  void WeightsOutsideRanges();
  void RoundNumbers();
  void Scales();
  void Ticks();
  void Texts();
  void Counts();
  void Limits();
  void ColumnTexts();
};

//------------------------------------------------------------------------------
void TestHistogramData::IntegerBins()
{
  QVERIFY(Count({ 2.5, 3.5 }, {}).HasIntegerBins());
  QVERIFY(!Count({ 2, 3 }, {}).HasIntegerBins());
  QVERIFY(!Count({ 7, 7 }, {}).HasIntegerBins());
}

//------------------------------------------------------------------------------
// All combinations of columns on small histograms, or many random ones.
void TestHistogramData::BrushedCountsAreExact()
{
  std::mt19937 random(1);
  for (const auto& [edges, logarithmic] : Cases)
  {
    const std::vector<double> values = MakeValues(edges, random);
    const HistogramData data = Count(edges, values, logarithmic);
    QVERIFY(data.IsValid());
    QCOMPARE(data.GetTotal(), static_cast<qint64>(values.size()));
    const int columns = data.GetNumberOfColumns();
    for (int bits = 0; bits < 1 << columns; ++bits)
    {
      HistogramBrush brush;
      qint64 expected = 0;
      for (int column = 0; column < columns; ++column)
      {
        if (bits & 1 << column)
        {
          brush = brush.Combined(HistogramBrush(data, column, column), Combination::Add);
          expected += data.GetCount(column);
        }
      }
      // Without bins, all finite values are outside, and the column means "not positive".
      const bool isKnown = !edges.empty() || !brush.Contains(0);
      QCOMPARE(brush.GetCount(data), expected);
      if (isKnown)
      {
        QCOMPARE(CountSelected(values, brush.GetRanges(data), brush.GetSpecials(data)), expected);
      }
    }
  }
}

//------------------------------------------------------------------------------
void TestHistogramData::AdjacentBinsShareARange()
{
  const HistogramData data = Count({ 0, 1, 2, 3, 4 }, { -1, 0.5, 1.5, 2.5, 3.5, 9 });
  const auto below = [](double value) { return std::nextafter(value, -Infinity); };
  QCOMPARE(HistogramBrush(data, 2, 3).GetRanges(data), (HistogramBrush::Ranges{ { 1, below(3) } }));
  QCOMPARE(
    HistogramBrush(data, 0, 99).GetRanges(data), (HistogramBrush::Ranges{ { -Largest, Largest } }));
  const HistogramBrush two =
    HistogramBrush(data, 4, 4).Combined(HistogramBrush(data, 1, 1), Combination::Add);
  QCOMPARE(two.GetRanges(data), (HistogramBrush::Ranges{ { 0, below(1) }, { 3, 4 } }));
  QCOMPARE(two.Combined(HistogramBrush(data, 1, 3), Combination::Subtract).GetRanges(data),
    (HistogramBrush::Ranges{ { 3, 4 } }));
  QVERIFY(two.Combined(HistogramBrush(data, 2, 3), Combination::Intersect).IsEmpty());
  QVERIFY(
    two.Combined(HistogramBrush(data, 2, 3), Combination::Replace) == HistogramBrush(data, 3, 2));
  QCOMPARE(ToCombination(Qt::NoModifier), Combination::Replace);
  QCOMPARE(ToCombination(Qt::ShiftModifier), Combination::Add);
  QCOMPARE(ToCombination(Qt::ControlModifier), Combination::Subtract);
  QCOMPARE(ToCombination(Qt::ControlModifier | Qt::ShiftModifier), Combination::Intersect);
  // Empty special columns are not shown, so that no drag selects them.
  QVERIFY(!HistogramBrush(data, 0, 99).Contains(data.GetColumn(HistogramData::Column::Undefined)));
}

//------------------------------------------------------------------------------
void TestHistogramData::HugeCounts()
{
  HistogramData data = Count({ 0, 1, 2 }, {});
  data.Groups.push_back(data.Groups[0]);
  data.Groups[0].Counts = { 0, 1000000000000001, 3, 0, 0, 0 };
  data.Groups[1].Counts = { 0, 4000000000000001, 5, 0, 0, 0 };
  QCOMPARE(data.GetCount(1), 5000000000000002);
  QCOMPARE(data.GetTotal(), 5000000000000010);
  QCOMPARE(HistogramBrush(data, 1, 2).GetCount(data), 5000000000000010);
}

//------------------------------------------------------------------------------
void TestHistogramData::Validity()
{
  QVERIFY(HistogramData().IsValid());
  QVERIFY(HistogramData().IsEmpty());
  const auto isValid = [](const std::vector<double>& edges, bool logarithmic, std::size_t counts)
  {
    HistogramData data;
    data.Edges = edges;
    data.Logarithmic = logarithmic;
    data.Groups.resize(1);
    data.Groups[0].Counts.resize(counts);
    return data.IsValid();
  };
  QVERIFY(isValid({ 1, 2 }, false, 5));
  QVERIFY(!isValid({ 1 }, false, 4));
  QVERIFY(!isValid({ 1, 2 }, false, 6));
  QVERIFY(!isValid({ 2, 1 }, false, 5));
  QVERIFY(!isValid({ 1, 1, 1 }, false, 6));
  QVERIFY(!isValid({ 0, NaN }, false, 5));
  QVERIFY(!isValid({ 0, Infinity }, false, 5));
  QVERIFY(!isValid({ 0, 1 }, true, 5));
}

//------------------------------------------------------------------------------
void TestHistogramData::NotJudged()
{
  HistogramData data;
  data.Edges = { 0, 1, 2 };
  data.Groups.resize(1);
  data.Groups[0].Counts = { 0, 3, 2, 0, 0, 0 };
  QCOMPARE(data.GetNotJudged(1), 0); // nothing is known of a range
  data.Groups[0].Judged = { 1, 2 };
  QCOMPARE(data.GetNotJudged(1), 2);
  QCOMPARE(data.GetNotJudged(2), 0);
  QCOMPARE(data.GetNotJudged(0), 0);
  data.Groups[0].Judged = { 0, 0 }; // there is no range
  QCOMPARE(data.GetNotJudged(1), 0);
  data.Groups[0].Judged = { 1, 2 };
  data.Groups.push_back(data.Groups[0]);
  QCOMPARE(data.GetNotJudged(1), 0);
}

//------------------------------------------------------------------------------
void TestHistogramData::CurveAtPointsAndBetween()
{
  CumulativeCounts curve;
  const auto above = [&](double value) { return curve.GetOutside(-Infinity, value, 20).Count; };
  QCOMPARE(above(1).Value, 20.0);
  curve.Values = { 0, 10, 20, 30 };
  curve.Counts = { 2, 12, 12, 20 };
  QCOMPARE(above(10).Value, 8.0);
  QVERIFY(above(10).Exact);
  QCOMPARE(above(5).Value, 13.0);
  QVERIFY(!above(5).Exact);
  QCOMPARE(above(15).Value, 8.0); // nothing in between
  QVERIFY(above(15).Exact);
  QCOMPARE(above(-1).Value, 20.0);
  QCOMPARE(above(99).Value, 0.0);
  QVERIFY(std::isnan(curve.GetOutside(0, 1, 20).WeightPercent.Value));
}

//------------------------------------------------------------------------------
// With the values that the plot asks for, every limit that it offers is exact.
void TestHistogramData::CountsOutsideRanges()
{
  std::mt19937 random(2);
  for (const auto& [edges, logarithmic] : Cases)
  {
    std::vector<double> values = MakeValues(edges, random);
    const HistogramData data = Count(edges, values, logarithmic);
    CumulativeCounts curve;
    curve.Values = GetCurveValues(data, Tiny, 0.123);
    for (const double value :
      { -Infinity, -Largest, Largest }) // extreme values, as the server adds
    {
      curve.Values.push_back(value);
    }
    std::sort(curve.Values.begin(), curve.Values.end());
    curve.Values.erase(std::unique(curve.Values.begin(), curve.Values.end()), curve.Values.end());
    for (const double value : curve.Values)
    {
      curve.Counts.push_back(std::count_if(
        values.begin(), values.end(), [=](double element) { return element <= value; }));
    }
    std::vector<double> limits = GetRoundLimits(data);
    limits.insert(limits.end(), edges.begin(), edges.end());
    limits.insert(limits.end(), { Tiny, 0.123, Infinity, -Infinity });
    for (const double low : limits)
    {
      const double high = low == -Infinity ? 0.123 : Infinity;
      for (const auto& [first, last] : { std::pair(low, high), std::pair(-Infinity, low) })
      {
        const auto expected = std::count_if(values.begin(), values.end(),
          [first = first, last = last](double value) { return value < first || value > last; });
        const CumulativeCounts::Estimate count =
          curve.GetOutside(first, last, data.GetNumberOfValues()).Count;
        QVERIFY(count.Exact);
        QVERIFY(count.Value == static_cast<double>(expected));
      }
    }
  }
}

//------------------------------------------------------------------------------
void TestHistogramData::WeightsOutsideRanges()
{
  CumulativeCounts curve;
  curve.Values = { 0, 10, 20 };
  curve.Counts = { 1, 2, 4 };
  curve.WeightPercents = { 5, 40, 100 };
  const auto outside = curve.GetOutside(std::nextafter(0, 1), 10, 4);
  QCOMPARE(outside.Count.Value, 1.0 + 2.0);
  QCOMPARE(outside.WeightPercent.Value, 5.0 + 60.0);
  QVERIFY(outside.WeightPercent.Exact);
  QVERIFY(!curve.GetOutside(-Infinity, 15, 4).WeightPercent.Exact);
  QCOMPARE(curve.GetOutside(-Infinity, Infinity, 4).WeightPercent.Value, 0.0);
}

//------------------------------------------------------------------------------
void TestHistogramData::RoundNumbers()
{
  const std::vector<double> tenths = GetRoundNumbers(0, 1, 10, 0);
  QCOMPARE(tenths.size(), std::size_t(11));
  QVERIFY(tenths[3] == 0.3); // not 3 * 0.1
  QCOMPARE(GetRoundNumbers(-1, 1, 4, 0), (std::vector<double>{ -1, -0.5, 0, 0.5, 1 }));
  QVERIFY(!std::signbit(GetRoundNumbers(-1, 1, 2, 0)[1]));
  QCOMPARE(GetRoundNumbers(0.3, 3.7, 100, 1), (std::vector<double>{ 1, 2, 3 }));
  QCOMPARE(GetRoundNumbersOfDecades(1, 100, 6), (std::vector<double>{ 1, 2, 5, 10, 20, 50, 100 }));
  QVERIFY(GetRoundNumbersOfDecades(1e-6, 1e-5, 100)[3] == 1.3e-6);

  HistogramData data = Count({ 0.7, 71.3 }, {});
  QCOMPARE(GetRoundLimits(data).front(), 1.0);
  QCOMPARE(GetRoundLimits(data)[1], 2.0);
  QCOMPARE(GetRoundLimits(Count({ 3.5, 4.5, 5.5 }, {})), (std::vector<double>{ 4, 5 }));
  for (const auto& [edges, logarithmic] : Cases)
  {
    const HistogramData any = Count(edges, {}, logarithmic);
    const std::vector<double> limits = GetRoundLimits(any);
    QVERIFY(limits.size() <= 202);
    QVERIFY(std::is_sorted(limits.begin(), limits.end()));
    for (const double limit : limits)
    {
      const auto [low, high] = any.GetAxisRange();
      QVERIFY(limit >= low && limit <= high);
    }
  }
}

//------------------------------------------------------------------------------
void TestHistogramData::Scales()
{
  QCOMPARE(Scale(10, 20).ToFraction(15), 0.5);
  QCOMPARE(Scale(10, 20).FromFraction(0.5), 15.0);
  QCOMPARE(Scale(1, 10000, true).ToFraction(100), 0.5);
  QCOMPARE(Scale(1, 10000, true).FromFraction(0.25), 10.0);
  QCOMPARE(Scale(1, 10000, true).ToFraction(0), -1.0);
  QCOMPARE(Scale(-Largest, Largest).ToFraction(0), 0.5);
  QCOMPARE(Scale(0, Tiny).ToFraction(Tiny), 1.0);
}

//------------------------------------------------------------------------------
void TestHistogramData::Ticks()
{
  const auto getLabels = [](const std::vector<Tick>& ticks)
  {
    QStringList labels;
    for (const Tick& tick : ticks)
    {
      if (!tick.Label.isEmpty())
      {
        labels << tick.Label;
      }
    }
    return labels.join(' ');
  };
  QCOMPARE(getLabels(GetTicks(Scale(0, 1), 5)), QString("0 0.2 0.4 0.6 0.8 1.0"));
  QCOMPARE(getLabels(GetTicks(Scale(-50, 180), 5)), QString("-50 0 50 100 150"));
  QCOMPARE(getLabels(GetTicks(Scale(0, 3e7), 3)), QString("0 1e7 2e7 3e7"));
  QCOMPARE(getLabels(GetTicks(Scale(0.7, 71.3), 2)), QString("0.7 71.3"));
  QCOMPARE(getLabels(GetTicks(Scale(1e-5, 1, true), 9)), QString("1e-5 1e-4 0.001 0.01 0.1 1"));
  QCOMPARE(getLabels(GetTicks(Scale(1, 100, true), 9)), QString("1 2 5 10 20 50 100"));
  QCOMPARE(getLabels(GetTicks(Scale(30, 40, true), 3)), QString("30 35 40"));
  QCOMPARE(getLabels(GetTicks(Scale(-0.5, 1.5), 12, 1)), QString("0 1"));
  QCOMPARE(getLabels(GetTicks(Scale(0.5, 1.5), 12, 1)), QString("1"));
  QCOMPARE(getLabels(GetCountTicks(Scale(0, 3), 8)), QString("0 1 2 3"));
  QCOMPARE(getLabels(GetCountTicks(Scale(0, 42000), 5)), QString("0 10k 20k 30k 40k"));
  QCOMPARE(getLabels(GetCountTicks(Scale(0.5, 3e5, true), 6)), QString("1 10 100 1000 10k 100k"));
  for (const auto& [edges, logarithmic] : Cases)
  {
    const auto [low, high] = Count(edges, {}, logarithmic).GetAxisRange();
    for (const int most : { 0, 2, 7, 50 })
    {
      const std::vector<Tick> ticks =
        GetTicks(Scale(logarithmic ? std::max(low, 1e-300) : low, high, logarithmic), most);
      QVERIFY(ticks.size() >= 2 && ticks.size() < 400);
    }
  }
}

//------------------------------------------------------------------------------
void TestHistogramData::Texts()
{
  QCOMPARE(ShortNumber(0.000001), QString("1e-6"));
  QCOMPARE(ShortNumber(1e20), QString("1e20"));
  QCOMPARE(ShortNumber(-1.5), QString("-1.5"));
  QCOMPARE(ShortNumber(1e100), QString("1e100"));
  QCOMPARE(FormatNumbers(1, 1 + 1e-9), (QPair<QString, QString>("1", "1.000000001")));
  QCOMPARE(FormatNumbers(0.1, 0.2), (QPair<QString, QString>("0.1", "0.2")));
  QCOMPARE(ShortNumber(NaN), QString());
  QCOMPARE(ShortNumber(-Infinity), QString("-∞"));
  QCOMPARE(ShortNumber(1.0 / 3), QString("0.333333"));
  QCOMPARE(AddUnit("Solid angle", "sr"), QString("Solid angle (sr)"));
  QCOMPARE(AddUnit("Ratio", ""), QString("Ratio"));
  QCOMPARE(FormatShortCount(9999), QString("9999"));
  QCOMPARE(FormatShortCount(20000), QString("20k"));
  QCOMPARE(FormatShortCount(1.5e6), QString("1.5M"));
  QCOMPARE(FormatShortCount(2e15), QString("2e15"));
}

//------------------------------------------------------------------------------
void TestHistogramData::Counts()
{
  QCOMPARE(GroupedInteger(4080), QString("4080"));
  QCOMPARE(GroupedInteger(-12345), QString("-12\u202f345"));
  QCOMPARE(GroupedInteger(1234567), QString("1\u202f234\u202f567"));
  QCOMPARE(FormatPercent(0, 5), QString("0\u00a0%"));
  QCOMPARE(FormatPercent(1, 3), QString("33.3\u00a0%"));
  QCOMPARE(FormatPercent(5, 5), QString("100\u00a0%"));
  QCOMPARE(FormatPercent(1, 1e6), QString("< 0.01\u00a0%"));
  QCOMPARE(FormatPercent(4079, 4080), QString("> 99.9\u00a0%"));
  QCOMPARE(FormatPercent(0, 0), QString("0\u00a0%"));
  QCOMPARE(FormatDuration(99.4), QString("99 s"));
  QCOMPARE(FormatDuration(150), QString("3 min"));
  QCOMPARE(FormatDuration(9000), QString("2.5 h"));
  QCOMPARE(FormatDuration(1e6), QString("278 h"));
}

//------------------------------------------------------------------------------
// A limit that the user types, or that the server has, is the one that is shown.
void TestHistogramData::Limits()
{
  const double none = -std::numeric_limits<double>::infinity();
  const auto read = [&](const char* text) { return LimitValidator::Read(text, none); };
  QCOMPARE(read("30,5").value(), 30.5);
  QCOMPARE(read(" 1e-6 ").value(), 1e-6);
  QCOMPARE(read("").value(), none);
  for (const char* text : { "-", "1e400", "1,000.5", "inf", "nan", "> 0" })
  {
    QVERIFY(!read(text));
  }
  const LimitValidator validator;
  QString text("30,5");
  int place = 4;
  QCOMPARE(validator.validate(text, place), QValidator::Acceptable);
  QCOMPARE(text, QString("30.5"));
  text = "-";
  QCOMPARE(validator.validate(text, place), QValidator::Acceptable); // the owner replaces it
  text = "1a";
  QCOMPARE(validator.validate(text, place), QValidator::Invalid);

  QCOMPARE(read(ExactLimit(1.0 / 3).toUtf8()).value(), 1.0 / 3);
  QCOMPARE(ExactLimit(0.1), QString("0.1"));
  QCOMPARE(ExactLimit(none), QString());
  QCOMPARE(FormatLimit(12, "deg"), QString("12°"));
  QCOMPARE(FormatLimit(0.5, "m"), QString("0.5 m"));
  QVERIFY(IsPositive(Tiny) && IsPositive(1e-301) && !IsPositive(0) && !IsPositive(1e-300));
  QCOMPARE(FormatLimit(Tiny, ""), QString("> 0"));
}

//------------------------------------------------------------------------------
void TestHistogramData::ColumnTexts()
{
  HistogramData data = Count({ 0, 10, 20 }, { -1, 5, 15, 15, NaN });
  data.Name = "Angle";
  data.Unit = "deg";
  data.Elements = "cells";
  QCOMPARE(AddUnit(data.Name, data.Unit), QString("Angle (°)"));
  QCOMPARE(GetColumnName(data, 0), QString("Below 0°"));
  QCOMPARE(GetColumnName(data, 1), QString("0° ≤ value < 10°"));
  QCOMPARE(GetColumnName(data, 2), QString("10° ≤ value ≤ 20°"));
  QVERIFY(GetColumnToolTip(data, 2).contains("cells: 2 (40\u00a0%)"));
  QVERIFY(GetColumnToolTip(data, 2).contains("Cumulative: 100\u00a0%")); // of those with a value
  QVERIFY(GetColumnToolTip(data, 1).contains("&lt; 10°"));
  QVERIFY(!GetColumnToolTip(data, 2).contains("selected"));
  data.Selected.Counts = { 0, 0, 1, 0, 0, 0 };
  QVERIFY(GetColumnToolTip(data, 2).contains("selected: 1"));
  QCOMPARE(GetColumnName(Count({ 2.5, 3.5 }, {}), 1), QString("3"));
  QCOMPARE(GetColumnName(Count({ 7, 7 }, {}), 1), QString("7"));
}

QTEST_GUILESS_MAIN(TestHistogramData)
#include "TestHistogramData.moc"
