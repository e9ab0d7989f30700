// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PlotColors
 * @brief Colors of histograms on a light or dark palette.
 */
#ifndef camaron_PlotColors_h
#define camaron_PlotColors_h

#include <QColor>

class QPalette;

namespace camaron
{
QColor WithAlpha(QColor color, int alpha); ///< up to 255

struct PlotColors
{
  explicit PlotColors(const QPalette& palette);

  QColor Background;
  QColor Text;
  QColor Axis; ///< lines of axes, and less important text
  QColor Grid;
  QColor Brush;     ///< brushed columns and the current one
  QColor Good;      ///< bars within the acceptable range
  QColor Bad;       ///< bars outside
  QColor Bar;       ///< bars of which neither is known
  QColor Special;   ///< infinite and undefined
  QColor GoodShade; ///< translucent, behind the bars
  QColor BadShade;
  QColor Curve;
  QColor Outline;

  /// Color of a value for the limits of the acceptable range; neutral if neither is finite.
  const QColor& GetJudged(double value, double low, double high) const;
  /// Color of a group, distinct for the first eight.
  QColor GetGroupColor(int group) const;
  /// Color of an item that is not brushed, if others are.
  QColor GetFaded(const QColor& color) const;
};
}

#endif
