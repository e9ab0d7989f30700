// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ticks.h"

#include "NumberText.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camaron
{
namespace
{
// Larger multiples of a step have no exact distance.
constexpr double LargestMultiple = 1e15;

// Digits * 10^Exponent. Powers of ten are kept as exponents, because 3 * 0.1 is not 0.3.
struct DecimalStep
{
  double Digits;
  int Exponent;

  double GetMultiple(double factor) const
  {
    const double number = factor * this->Digits;
    return this->Exponent < 0 ? number / std::pow(10.0, -this->Exponent)
                              : number * std::pow(10.0, this->Exponent);
  }
  double GetSize() const { return this->GetMultiple(1); }
};

// The smallest of 1, 2, 5, 10, ... of which at most so many steps cover the range.
DecimalStep GetRoundStep(double low, double high, int most, double smallestStep)
{
  const double size = std::max(high / most - low / most, smallestStep);
  // Powers of ten outside this range are no normal doubles.
  constexpr double smallest = -307, largest = 307;
  const int exponent =
    static_cast<int>(std::clamp(std::floor(std::log10(size)), smallest, largest));
  constexpr double tolerance = 1 + 1e-9; // of the quotient that led to the size
  for (const double digits : { 1.0, 2.0, 5.0 })
  {
    const DecimalStep step{ digits, exponent };
    if (step.GetSize() * tolerance >= size)
    {
      return step;
    }
  }
  return { 1, exponent + 1 };
}

std::vector<double> GetMultiples(double low, double high, const DecimalStep& step)
{
  std::vector<double> numbers;
  const double size = step.GetSize();
  const double first = std::floor(low / size), last = std::ceil(high / size);
  if (!(std::abs(first) < LargestMultiple && std::abs(last) < LargestMultiple))
  {
    return numbers;
  }
  for (double factor = first; factor <= last; ++factor)
  {
    const double number = step.GetMultiple(factor) + 0.0; // no negative zero
    if (number >= low && number <= high)
    {
      numbers.push_back(number);
    }
  }
  return numbers;
}

// Powers of ten within the scale, and the numbers between them that are round.
std::vector<double> GetDecadeNumbers(
  double low, double high, const std::vector<double>& digits, int stride = 1)
{
  std::vector<double> numbers;
  const int first = static_cast<int>(std::floor(std::log10(low)));
  const int last = static_cast<int>(std::ceil(std::log10(high)));
  for (int exponent = first; exponent <= last; ++exponent)
  {
    if (exponent % stride != 0)
    {
      continue;
    }
    for (const double digit : digits)
    {
      const double number = DecimalStep{ digit, exponent }.GetSize();
      if (number >= low && number <= high)
      {
        numbers.push_back(number);
      }
    }
  }
  return numbers;
}

const std::vector<double> AllDigits = { 1, 2, 3, 4, 5, 6, 7, 8, 9 };

// Labels of the round numbers of a logarithmic scale, and unlabeled ticks between them.
std::vector<Tick> GetDecadeTicks(const Scale& scale, int most, QString (*format)(double))
{
  const double low = scale.Low, high = scale.High;
  const double decades = std::log10(high) - std::log10(low);
  std::vector<double> labeled;
  for (const std::vector<double>& digits : { std::vector<double>{ 1, 2, 5 }, { 1, 3 }, { 1 } })
  {
    labeled = GetDecadeNumbers(low, high, digits);
    if (static_cast<int>(labeled.size()) <= most)
    {
      break;
    }
  }
  for (int stride = 2; static_cast<int>(labeled.size()) > most; ++stride)
  {
    labeled = GetDecadeNumbers(low, high, { 1 }, stride);
  }
  constexpr double mostDecadesWithMinorTicks = 8;
  const std::vector<double> all = GetDecadeNumbers(
    low, high, decades > mostDecadesWithMinorTicks ? std::vector<double>{ 1 } : AllDigits);
  std::vector<Tick> ticks;
  for (const double number : all)
  {
    const bool hasLabel = std::find(labeled.begin(), labeled.end(), number) != labeled.end();
    ticks.push_back({ number, hasLabel ? format(number) : QString() });
  }
  return ticks;
}

// Powers of ten of which only some need an exponent, which then all of them have.
QString FormatTick(double value)
{
  constexpr double smallest = 1e-3, largest = 1e5;
  return value >= smallest && value < largest ? ShortNumber(value) : FormatScientific(value);
}
}

//------------------------------------------------------------------------------
double Scale::ToFraction(double value) const
{
  if (this->Logarithmic)
  {
    const double low = std::log10(this->Low), high = std::log10(this->High);
    return value > 0 ? (std::log10(value) - low) / (high - low) : -1;
  }
  const double size = this->High - this->Low;
  // The difference of two huge numbers may be out of range.
  return std::isfinite(size) ? (value - this->Low) / size
                             : (value / 2 - this->Low / 2) / (this->High / 2 - this->Low / 2);
}

//------------------------------------------------------------------------------
double Scale::FromFraction(double fraction) const
{
  if (this->Logarithmic)
  {
    const double low = std::log10(this->Low), high = std::log10(this->High);
    return std::pow(10.0, low + fraction * (high - low));
  }
  return this->Low * (1 - fraction) + this->High * fraction;
}

//------------------------------------------------------------------------------
std::vector<double> GetRoundNumbers(double low, double high, int most, double smallestStep)
{
  return GetMultiples(low, high, GetRoundStep(low, high, most, smallestStep));
}

//------------------------------------------------------------------------------
std::vector<double> GetRoundNumbersOfDecades(double low, double high, int most)
{
  const double decades = std::log10(high) - std::log10(low);
  std::vector<double> tenths;
  for (int i = 10; i < 100; ++i)
  {
    tenths.push_back(i / 10.0);
  }
  for (const std::vector<double>& digits : { tenths, AllDigits, { 1, 2, 5 } })
  {
    if (decades * static_cast<double>(digits.size()) <= most)
    {
      return GetDecadeNumbers(low, high, digits);
    }
  }
  return GetDecadeNumbers(low, high, { 1 });
}

//------------------------------------------------------------------------------
std::vector<Tick> GetTicks(const Scale& scale, int most, double smallestStep)
{
  most = std::max(most, 2);
  if (scale.Logarithmic)
  {
    const std::vector<Tick> ticks = GetDecadeTicks(scale, most, &FormatTick);
    const auto labels = std::count_if(
      ticks.begin(), ticks.end(), [](const Tick& tick) { return !tick.Label.isEmpty(); });
    if (labels > 1)
    {
      return ticks;
    }
  }
  const DecimalStep step = GetRoundStep(scale.Low, scale.High, most, smallestStep);
  std::vector<Tick> ticks;
  for (const double number : GetMultiples(scale.Low, scale.High, step))
  {
    ticks.push_back({ number, FormatMultiple(number, step.Exponent) });
  }
  const std::size_t least = smallestStep > 0 ? 1 : 2;
  if (ticks.size() < least) // there are no round numbers between the ends
  {
    const auto [low, high] = FormatNumbers(scale.Low, scale.High);
    return { { scale.Low, low }, { scale.High, high } };
  }
  return ticks;
}

//------------------------------------------------------------------------------
std::vector<Tick> GetCountTicks(const Scale& scale, int most)
{
  most = std::max(most, 2);
  if (scale.Logarithmic)
  {
    return GetDecadeTicks(
      Scale(std::max(scale.Low, 1.0), scale.High, true), most, &FormatShortCount);
  }
  std::vector<Tick> ticks;
  for (const double number : GetRoundNumbers(scale.Low, scale.High, most, 1))
  {
    ticks.push_back({ number, FormatShortCount(number) });
  }
  return ticks;
}
}
