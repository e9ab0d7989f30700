// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmallHistogram.h"

#include "HistogramData.h"
#include "PlotColors.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <functional>

namespace camaron
{
//------------------------------------------------------------------------------
void PaintSmallHistogram(QPainter* painter, const QRect& rect, const HistogramData& data,
  double acceptableLow, double acceptableHigh, const QPalette& palette)
{
  const int bins = data.GetNumberOfBins();
  const PlotColors colors(palette);
  const bool hasLimits = std::isfinite(acceptableLow) || std::isfinite(acceptableHigh);
  // Several bins share a column of pixels if there are more bins than pixels.
  const int columns = std::min(bins, rect.width());
  // The only bar of constant data is in the middle.
  const QRect plot =
    data.IsConstant() ? rect.adjusted(rect.width() / 3, 0, -(rect.width() / 3), 0) : rect;
  qint64 most = 0;
  for (int bin = 0; bin < bins; ++bin)
  {
    most = std::max(most, data.GetCount(data.GetColumnOfBin(bin)));
  }
  if (most == 0)
  {
    return;
  }
  painter->fillRect(
    QRectF(rect.left(), rect.bottom(), rect.width(), 1), colors.GetFaded(colors.Axis));
  const bool isOfSelection = !data.Selected.Counts.empty();
  const auto paintBars = [&](const std::function<qint64(int)>& countInBin, bool isFaded)
  {
    for (int column = 0; column < columns; ++column)
    {
      const int first = column * bins / columns, last = (column + 1) * bins / columns;
      for (const bool isBad : { false, true })
      {
        qint64 count = 0;
        for (int bin = first; bin < last; ++bin)
        {
          const double middle = data.Edges[bin] / 2 + data.Edges[bin + 1] / 2;
          const bool isOutside =
            hasLimits && !(middle >= acceptableLow && middle <= acceptableHigh);
          if (isOutside == isBad)
          {
            count = std::max(count, countInBin(bin));
          }
        }
        if (count > 0)
        {
          constexpr double lowest = 2;
          const double height = std::max(
            rect.height() * (static_cast<double>(count) / static_cast<double>(most)), lowest);
          const double width = static_cast<double>(plot.width()) / columns;
          const double left = plot.left() + width * column, right = left + width;
          const double bottom = rect.top() + rect.height();
          const QColor color = isBad ? colors.Bad : hasLimits ? colors.Good : colors.Bar;
          painter->fillRect(QRectF(QPointF(left, bottom - height), QPointF(right, bottom)),
            isFaded ? colors.GetFaded(color) : color);
        }
      }
    }
  };
  paintBars([&](int bin) { return data.GetCount(data.GetColumnOfBin(bin)); }, isOfSelection);
  if (isOfSelection)
  {
    paintBars([&](int bin) { return data.Selected.Counts[bin]; }, false);
  }
}
}
