// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkQualityColors.h"

#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

vtkStandardNewMacro(vtkQualityColors);

namespace
{
using ColorOfPoint = std::array<double, 3>;
constexpr ColorOfPoint Ideal = { { 0.925, 0.945, 0.953 } };      // pale blue-gray
constexpr ColorOfPoint AtLimit = { { 0.612, 0.737, 0.816 } };    // the acceptable side of a limit
constexpr ColorOfPoint Beyond = { { 0.965, 0.647, 0.239 } };     // the other side: orange
constexpr ColorOfPoint Bad = { { 0.792, 0.247, 0.129 } };        // red
constexpr ColorOfPoint Worst = { { 0.416, 0.027, 0.098 } };      // dark red
constexpr ColorOfPoint Plain = { { 0.565, 0.690, 0.784 } };      // the middle without limits
constexpr ColorOfPoint Dark = { { 0.157, 0.322, 0.475 } };       // the worse end without limits
constexpr ColorOfPoint NoValue = { { 0.6, 0.5, 0.6 } };          // mauve
constexpr ColorOfPoint NotJudged = { { 0.65, 0.64, 0.58 } };     // warm gray
constexpr double Unlimited = std::numeric_limits<double>::max(); // a limit that is none

void AddColor(vtkDoubleArray* points, double value, const ColorOfPoint& color)
{
  for (const double number : { value, color[0], color[1], color[2] })
  {
    points->InsertNextValue(number);
  }
}

void SetColor(vtkDoubleArray* array, const ColorOfPoint& color)
{
  array->Reset();
  for (const double channel : color)
  {
    array->InsertNextValue(channel);
  }
}

// At most so many multiples of 1, 2 or 5 times a power of ten.
std::vector<double> GetRoundNumbers(double low, double high, int most)
{
  const double power = std::pow(10, std::floor(std::log10((high - low) / most)));
  std::vector<double> numbers;
  for (const int factor : { 1, 2, 5, 10 })
  {
    const double step = factor * power;
    const double first = std::ceil(low / step), last = std::floor(high / step);
    if (last - first < most)
    {
      for (double i = first; i <= last; ++i)
      {
        numbers.push_back(i * step);
      }
      break;
    }
  }
  return numbers;
}

// Between two values, of which the lower one is the worst if @a isLow, else the higher one.
void AddBadSide(vtkDoubleArray* points, double low, double high, bool isLow)
{
  AddColor(points, low, isLow ? Worst : Beyond);
  AddColor(points, low + 0.5 * (high - low), Bad);
  AddColor(points, high, isLow ? Beyond : Worst);
}
}

//------------------------------------------------------------------------------
vtkQualityColors::vtkQualityColors()
  : Acceptable{ -Unlimited, Unlimited }
{
}

//------------------------------------------------------------------------------
vtkQualityColors::~vtkQualityColors() = default;

//------------------------------------------------------------------------------
vtkDoubleArray* vtkQualityColors::GetPoints()
{
  vtkDoubleArray* points = this->Points;
  points->Reset();
  const double least = this->Acceptable[0], most = this->Acceptable[1];
  const bool isOpenBelow = !(least > -Unlimited), isOpenAbove = !(most < Unlimited);
  double low = this->Range[0], high = this->Range[1];
  const double size = std::max(std::abs(low), std::abs(high));
  constexpr double rounding = 1e-6, room = 0.01, singlePrecision = 1e-7;
  // An end that only rounding tells from zero is zero in the legend, if zero is acceptable and on
  // the outer side of the values.
  low = low > 0 && low < singlePrecision * size && !(least > 0) ? 0 : low;
  high = high < 0 && high > -singlePrecision * size && !(most < 0) ? 0 : high;
  if (!(high - low > rounding * size))
  { // values that only rounding tells apart have one color, that of the good end if they are not
    // bad
    const double width = room * (size > 0 ? size : 1);
    const bool isAtTop = isOpenAbove && (isOpenBelow ? this->Better > 0 : !(high < least));
    const double value = isAtTop ? high : low;
    if ((isAtTop && value - least < width && !(value < least)) ||
      (!isAtTop && most - value < width && !(value > most)))
    { // at a limit that is no alarm
      AddColor(points, value, Ideal);
      AddColor(points, value + width, Ideal);
      return points;
    }
    (isAtTop ? low : high) = isAtTop ? high - width : low + width;
  }
  // If only an end is acceptable, the map has room for its color, too.
  constexpr double roomAtEnd = 0.1;
  low -= !isOpenAbove && most == this->Range[0] ? roomAtEnd * (high - low) : 0;
  high += !isOpenBelow && least == this->Range[1] ? roomAtEnd * (high - low) : 0;
  if (isOpenBelow && isOpenAbove)
  {
    AddColor(points, low, this->Better > 0 ? Dark : Ideal);
    AddColor(points, low + 0.5 * (high - low), Plain);
    AddColor(points, high, this->Better > 0 ? Ideal : Dark);
    return points;
  }
  // Narrower than what a color map in single precision or a legend tells apart.
  const double step = rounding * (high - low);
  const bool hasLow = !isOpenBelow && least > low, hasHigh = !isOpenAbove && most < high;
  if (hasLow)
  {
    AddBadSide(points, low, least > high ? high : std::max(low, least - step), true);
  }
  const double first = hasLow ? least : low, last = hasHigh ? most : high;
  if (first <= last && first <= high && last >= low)
  {
    // Darker towards a limit; the ideal is the other end, or the middle between two limits.
    AddColor(points, first, isOpenBelow ? Ideal : AtLimit);
    if (isOpenBelow == isOpenAbove)
    {
      AddColor(points, first + 0.5 * (last - first), Ideal);
    }
    AddColor(points, last, isOpenAbove ? Ideal : AtLimit);
  }
  if (hasHigh)
  {
    AddBadSide(points, most < low ? low : std::min(high, most + step), high, false);
  }
  return points;
}

//------------------------------------------------------------------------------
std::array<double, 2> vtkQualityColors::GetEnds()
{
  constexpr int size = 4; // of a point
  vtkDoubleArray* points = this->GetPoints();
  return { { points->GetValue(0), points->GetValue(points->GetNumberOfValues() - size) } };
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkQualityColors::GetLabels()
{
  const std::array<double, 2> ends = this->GetEnds();
  constexpr double room = 0.1; // for a label, in a legend of a third of a view
  constexpr int most = 7;
  std::vector<double> labels;
  const auto add = [&](double value)
  {
    const auto isNear = [&](double label)
    { return std::abs(label - value) < room * (ends[1] - ends[0]); };
    if (value >= ends[0] && value <= ends[1] && std::none_of(labels.begin(), labels.end(), isNear))
    {
      labels.push_back(value);
    }
  };
  std::for_each(std::begin(this->Acceptable), std::end(this->Acceptable), add);
  std::for_each(ends.begin(), ends.end(), add);
  const std::vector<double> numbers = GetRoundNumbers(ends[0], ends[1], most);
  std::for_each(numbers.begin(), numbers.end(), add);
  std::sort(labels.begin(), labels.end());
  this->Labels->Reset();
  for (const double label : labels)
  {
    this->Labels->InsertNextValue(label);
  }
  return this->Labels;
}

//------------------------------------------------------------------------------
int vtkQualityColors::GetLabelDigits()
{
  const std::array<double, 2> ends = this->GetEnds();
  const double largest = std::max(std::abs(ends[0]), std::abs(ends[1]));
  const int power = static_cast<int>(std::floor(std::log10(largest)));
  const bool areWhole = ends[0] == std::floor(ends[0]) && ends[1] == std::floor(ends[1]);
  constexpr int few = 3, many = 15;
  const int powerOfSpan = static_cast<int>(std::floor(std::log10(ends[1] - ends[0])));
  const int powerOfLast = std::min(powerOfSpan - 1, areWhole ? 0 : power);
  return std::clamp(power - powerOfLast + 1, few, many);
}

//------------------------------------------------------------------------------
bool vtkQualityColors::IsBeyond(const double color[3])
{
  constexpr double rounding = 1e-6; // of states
  const auto is = [color](const ColorOfPoint& other)
  {
    return std::equal(other.begin(), other.end(), color,
      [](double one, double two) { return std::abs(one - two) < rounding; });
  };
  return is(Beyond) || is(Bad) || is(Worst);
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkQualityColors::GetUndefinedColor()
{
  SetColor(this->UndefinedColor, this->HasNotJudged && !this->HasUndefined ? NotJudged : NoValue);
  return this->UndefinedColor;
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkQualityColors::GetNotJudgedColor()
{
  SetColor(this->NotJudgedColor, NotJudged);
  return this->NotJudgedColor;
}

//------------------------------------------------------------------------------
const char* vtkQualityColors::GetUndefinedText() const
{
  // Annotations are centered: the empty line moves the second one beside its swatch.
  return !this->HasNotJudged ? "undefined"
    : this->HasUndefined     ? "not judged \u2013\nundefined \u2013\n "
                             : "not judged";
}
