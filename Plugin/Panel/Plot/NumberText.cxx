// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NumberText.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace camaron
{
namespace
{
constexpr int MostDigits = 17; // enough for any double

// Smaller limits of ranges mean "above zero", as in the rules and reports.
constexpr double SmallestLimit = 1e-300;

// 1e-06 and 1e+20 as 1e-6 and 1e20.
QString ShortenExponent(QString number)
{
  return number.replace("e-0", "e-").replace("e+0", "e").replace("e+", "e");
}
}

//------------------------------------------------------------------------------
QString ShortNumber(double number, int digits)
{
  if (std::isnan(number))
  {
    return QString();
  }
  return std::isinf(number) ? (number > 0 ? QString("∞") : QString("-∞"))
                            : ShortenExponent(QString::number(number, 'g', digits));
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
  while (digits < MostDigits && ShortNumber(low, digits) == ShortNumber(high, digits))
  {
    ++digits;
  }
  // Two more, so that the distance of the numbers can be seen.
  digits = digits > 6 ? std::min(digits + 2, MostDigits) : digits;
  return { ShortNumber(low, digits), ShortNumber(high, digits) };
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
  return ShortNumber(value, std::clamp(digits, 1, MostDigits));
}

//------------------------------------------------------------------------------
QString ExactNumber(double number)
{
  return QString::number(number, 'g', QLocale::FloatingPointShortest);
}

//------------------------------------------------------------------------------
QString ExactLimit(double limit)
{
  return std::isfinite(limit) ? ExactNumber(limit) : QString();
}

//------------------------------------------------------------------------------
bool IsPositive(double low)
{
  return low > 0 && low < SmallestLimit;
}

//------------------------------------------------------------------------------
QString FormatLimit(double value, const QString& unit, int digits)
{
  return (IsPositive(value) ? QString("> 0") : ShortNumber(value, digits)) + GetUnitSuffix(unit);
}

//------------------------------------------------------------------------------
QString GetUnitSuffix(const QString& unit)
{
  const bool isDegree = unit == "deg" || unit == "°";
  return isDegree ? QString("°") : unit.isEmpty() ? QString() : ' ' + unit;
}

//------------------------------------------------------------------------------
QString AddUnit(const QString& name, const QString& unit)
{
  return unit.isEmpty() ? name : QString("%1 (%2)").arg(name, GetUnitSuffix(unit).trimmed());
}

//------------------------------------------------------------------------------
QString GroupedInteger(qint64 number)
{
  constexpr qint64 shortest = 10000;
  constexpr char16_t narrowSpace = 0x202f; // without a line break
  return std::abs(number) < shortest
    ? QString::number(number)
    : QLocale(QLocale::English).toString(number).replace(',', QChar(narrowSpace));
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
  return ShortNumber(count);
}

//------------------------------------------------------------------------------
QString FormatPercent(double part, double whole)
{
  constexpr double smallest = 0.01, largest = 99.9;
  const QString sign("\u00a0%");
  if (!(whole > 0) || !(part > 0))
  {
    return '0' + sign;
  }
  const double percent = part == whole ? 100 : 100 * (part / whole);
  if (percent < smallest)
  {
    return "< 0.01" + sign;
  }
  return (percent > largest && part != whole ? "> 99.9" : QString::number(percent, 'g', 3)) + sign;
}

//------------------------------------------------------------------------------
QString FormatDuration(double seconds)
{
  constexpr double minute = 60, hour = 3600, largest = 100;
  if (seconds < largest)
  {
    return QString("%1 s").arg(std::lround(seconds));
  }
  if (seconds < largest * minute)
  {
    return QString("%1 min").arg(std::lround(seconds / minute));
  }
  constexpr double few = 10;
  return QString("%1 h").arg(seconds / hour, 0, 'f', seconds < few * hour ? 1 : 0);
}

//------------------------------------------------------------------------------
LimitValidator::LimitValidator(QObject* parent)
  : QDoubleValidator(parent)
{
  QLocale locale = QLocale::c();
  locale.setNumberOptions(QLocale::RejectGroupSeparator);
  this->setLocale(locale);
}

//------------------------------------------------------------------------------
QValidator::State LimitValidator::validate(QString& text, int& place) const
{
  text.replace(',', '.');
  const State state = this->QDoubleValidator::validate(text, place);
  return state == Intermediate ? Acceptable : state;
}

//------------------------------------------------------------------------------
std::optional<double> LimitValidator::Read(const QString& text, double none)
{
  const QString trimmed = text.trimmed();
  bool isNumber = false;
  const double number = QString(trimmed).replace(',', '.').toDouble(&isNumber);
  if (trimmed.isEmpty())
  {
    return none;
  }
  return isNumber && std::isfinite(number) ? std::optional<double>(number) : std::nullopt;
}
}
