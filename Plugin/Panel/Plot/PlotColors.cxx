// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlotColors.h"

#include <QPalette>

#include <array>
#include <cmath>

namespace camaron
{
namespace
{
QColor Mix(const QColor& color, const QColor& other, double fractionOfOther)
{
  const auto mix = [=](int a, int b)
  { return static_cast<int>(a + fractionOfOther * (b - a) + 0.5); };
  return QColor(mix(color.red(), other.red()), mix(color.green(), other.green()),
    mix(color.blue(), other.blue()));
}
}

//------------------------------------------------------------------------------
QColor WithAlpha(QColor color, int alpha)
{
  color.setAlpha(alpha);
  return color;
}

//------------------------------------------------------------------------------
PlotColors::PlotColors(const QPalette& palette)
  : Background(palette.color(QPalette::Base))
  , Text(palette.color(QPalette::Text))
  , Axis(Mix(Text, Background, 0.4))
  , Grid(Mix(Text, Background, 0.88))
  , Brush(palette.color(QPalette::Highlight))
{
  constexpr int middle = 128;
  const bool isDark = this->Background.lightness() < middle;
  this->Good = isDark ? QColor(84, 178, 130) : QColor(61, 150, 104);
  this->Bad = isDark ? QColor(232, 104, 84) : QColor(203, 67, 46);
  this->Bar = isDark ? QColor(118, 154, 196) : QColor(88, 124, 166);
  this->Special = isDark ? QColor(150, 150, 156) : QColor(128, 128, 134);
  this->GoodShade = WithAlpha(this->Good, isDark ? 38 : 30);
  this->BadShade = WithAlpha(this->Bad, isDark ? 44 : 28);
  this->Curve = isDark ? QColor(196, 160, 255) : QColor(102, 62, 178);
  this->Outline = Mix(this->Text, this->Background, 0.25);
}

//------------------------------------------------------------------------------
const QColor& PlotColors::GetJudged(double value, double low, double high) const
{
  if (!std::isfinite(low) && !std::isfinite(high))
  {
    return this->Bar;
  }
  return value >= low && value <= high ? this->Good : this->Bad;
}

//------------------------------------------------------------------------------
QColor PlotColors::GetGroupColor(int group) const
{
  // Neither the green nor the red of good and bad bars; distinct for color-blind people, too.
  static const std::array<QColor, 8> colors = { QColor(78, 121, 167), QColor(242, 142, 43),
    QColor(89, 179, 171), QColor(176, 122, 161), QColor(227, 192, 75), QColor(156, 117, 95),
    QColor(255, 157, 167), QColor(150, 150, 150) };
  constexpr int percent = 30;
  const int size = static_cast<int>(colors.size());
  const QColor color = colors[group % size];
  const int round = group / size;
  return round % 3 == 0 ? color
    : round % 3 == 1    ? color.lighter(100 + percent)
                        : color.darker(100 + percent);
}

//------------------------------------------------------------------------------
QColor PlotColors::GetFaded(const QColor& color) const
{
  return Mix(color, this->Background, 0.62);
}
}
