// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlotText.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <utility>

namespace camaron
{
namespace
{
constexpr int MostDigits = 17; // enough for any double

// Smaller limits of ranges stand for "above zero"; see the registry of criteria.
constexpr double SmallestLimit = 1e-300;

struct Text
{
  Q_DECLARE_TR_FUNCTIONS(pqHistogramPlot)
};

// 1e-06 and 1e+20 as 1e-6 and 1e20.
QString ShortenExponent(QString number)
{
  static const QRegularExpression exponent("e([+-])0*");
  const QRegularExpressionMatch match = exponent.match(number);
  return match.hasMatch() ? number.replace(match.capturedStart(), match.capturedLength(),
                              match.captured(1) == "-" ? "e-" : "e")
                          : number;
}
}

//------------------------------------------------------------------------------
QString FormatNumber(double value, int digits)
{
  return ShortenExponent(QString::number(value, 'g', digits));
}

//------------------------------------------------------------------------------
QString FormatScientific(double value)
{
  return ShortenExponent(QString::number(value, 'e', 0));
}

//------------------------------------------------------------------------------
int GetNumberOfDigits(double value, double tolerance, int least)
{
  int digits = least;
  while (digits < MostDigits &&
    !(std::abs(QString::number(value, 'g', digits).toDouble() - value) <= tolerance))
  {
    ++digits;
  }
  return digits;
}

//------------------------------------------------------------------------------
QPair<QString, QString> FormatNumbers(double low, double high)
{
  int digits = 6;
  while (digits < MostDigits && FormatNumber(low, digits) == FormatNumber(high, digits))
  {
    ++digits;
  }
  // Two more, so that the distance of the numbers can be seen.
  digits = digits > 6 ? std::min(digits + 2, MostDigits) : digits;
  return { FormatNumber(low, digits), FormatNumber(high, digits) };
}

//------------------------------------------------------------------------------
QString FormatMultiple(double value, int exponent)
{
  constexpr double largestPlain = 1e6;
  constexpr int mostDecimals = 5;
  if (value == 0)
  {
    return "0";
  }
  if (std::abs(value) < largestPlain && exponent >= -mostDecimals)
  {
    return QString::number(value, 'f', std::max(-exponent, 0));
  }
  const int digits = static_cast<int>(std::floor(std::log10(std::abs(value)))) - exponent + 1;
  return FormatNumber(value, std::clamp(digits, 1, MostDigits));
}

//------------------------------------------------------------------------------
QString GetUnitSuffix(const QString& unit)
{
  if (unit == "deg" || unit == QStringLiteral("°"))
  {
    return QStringLiteral("°");
  }
  return unit.isEmpty() ? QString() : ' ' + unit;
}

//------------------------------------------------------------------------------
QString FormatLimit(double value, const QString& unit, int digits)
{
  if (value > 0 && value < SmallestLimit)
  {
    return "> 0" + GetUnitSuffix(unit);
  }
  return FormatNumber(value, digits) + GetUnitSuffix(unit);
}

//------------------------------------------------------------------------------
QString FormatCount(qint64 count)
{
  // ParaView's locale may be "C", which does not separate groups.
  const QLocale locale;
  return (locale.language() == QLocale::C ? QLocale(QLocale::English) : locale).toString(count);
}

//------------------------------------------------------------------------------
QString FormatShortCount(double count)
{
  constexpr double plain = 1e4, largest = 1e13;
  if (count < plain)
  {
    return QString::number(count, 'f', 0);
  }
  if (count < largest)
  {
    for (const auto& [scale, suffix] : { std::pair(1e9, 'G'), { 1e6, 'M' }, { 1e3, 'k' } })
    {
      if (count >= scale)
      {
        return QString::number(count / scale) + suffix;
      }
    }
  }
  return FormatNumber(count);
}

//------------------------------------------------------------------------------
QString FormatPercent(double part, double whole)
{
  constexpr double smallest = 0.01, largest = 99.9;
  if (!(whole > 0) || !(part > 0))
  {
    return "0%";
  }
  const double percent = part == whole ? 100 : 100 * (part / whole);
  if (percent < smallest)
  {
    return "< 0.01%";
  }
  if (percent > largest && part != whole)
  {
    return "> 99.9%";
  }
  return QString::number(percent, 'g', 3) + '%';
}

//------------------------------------------------------------------------------
QString GetTitle(const HistogramData& data)
{
  const QString unit = GetUnitSuffix(data.Unit).trimmed();
  return unit.isEmpty() ? data.Name : QString("%1 (%2)").arg(data.Name, unit);
}

//------------------------------------------------------------------------------
QString GetElements(const HistogramData& data)
{
  return data.Elements.isEmpty() ? Text::tr("elements") : data.Elements;
}

//------------------------------------------------------------------------------
QString GetColumnName(const HistogramData& data, int column)
{
  const std::vector<double>& edges = data.Edges;
  const QString unit = GetUnitSuffix(data.Unit);
  switch (data.GetType(column))
  {
    case HistogramData::Column::Infinite:
      return Text::tr("Infinite");
    case HistogramData::Column::Undefined:
      return Text::tr("Undefined (NaN)");
    case HistogramData::Column::Underflow:
      return edges.empty() ? Text::tr("Not positive")
                           : Text::tr("Below %1").arg(FormatNumber(edges.front()) + unit);
    case HistogramData::Column::Overflow:
      return edges.empty() ? Text::tr("Above the range")
                           : Text::tr("Above %1").arg(FormatNumber(edges.back()) + unit);
    default:
      break;
  }
  const int bin = column - 1;
  if (data.IsConstant())
  {
    return FormatNumber(edges[0], MostDigits - 1) + unit;
  }
  if (data.HasIntegerBins())
  {
    return FormatNumber(edges[bin] + 0.5, MostDigits - 1) + unit;
  }
  const auto [low, high] = FormatNumbers(edges[bin], edges[bin + 1]);
  const bool isLast = column == data.GetNumberOfBins();
  return (isLast ? Text::tr("%1 ≤ value ≤ %2") : Text::tr("%1 ≤ value < %2"))
    .arg(low + unit, high + unit);
}

//------------------------------------------------------------------------------
QString GetColumnLabel(HistogramData::Column type, bool brief)
{
  switch (type)
  {
    case HistogramData::Column::Underflow:
      return brief ? "<" : Text::tr("below");
    case HistogramData::Column::Overflow:
      return brief ? ">" : Text::tr("above");
    case HistogramData::Column::Infinite:
      return brief ? QStringLiteral("∞") : Text::tr("infinite");
    case HistogramData::Column::Undefined:
      return brief ? "NaN" : Text::tr("undefined");
    default:
      return {};
  }
}
}
