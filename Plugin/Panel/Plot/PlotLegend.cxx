// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlotLegend.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
// Pixels between a swatch and its text, and between entries.
constexpr double InnerGap = 4, OuterGap = 12;

// No label takes more than this fraction of a line.
constexpr double LongestLabel = 0.6;

QString GetRest(int number)
{
  return QCoreApplication::translate("pqHistogramPlot", "and %1 more").arg(number);
}
}

//------------------------------------------------------------------------------
PlotLegend::PlotLegend(const QStringList& labels, const QPointF& topLeft, double width,
  const QFontMetricsF& metrics, int mostLines)
{
  const double height = std::ceil(metrics.height());
  const double swatch = std::round(metrics.ascent() * 0.75);
  const int size = static_cast<int>(labels.size());
  double x = 0;
  int line = 0;
  for (int i = 0; i < size; ++i)
  {
    const QString text = metrics.elidedText(labels[i], Qt::ElideRight, width * LongestLabel);
    const double textWidth = std::ceil(metrics.horizontalAdvance(text));
    // Where this is the last line, the number of the other entries must fit behind this one.
    const bool isLast = i == size - 1;
    const double rest =
      isLast || line + 1 < mostLines ? 0 : OuterGap + metrics.horizontalAdvance(GetRest(size));
    if (x > 0 && x + swatch + InnerGap + textWidth + rest > width)
    {
      if (line + 1 == mostLines)
      {
        const QString others = GetRest(size - i);
        this->Entries.push_back({ -1, others, QRectF(),
          QRectF(topLeft.x() + x, topLeft.y() + line * height, width - x, height) });
        break;
      }
      x = 0;
      ++line;
    }
    const double top = topLeft.y() + line * height;
    this->Entries.push_back(
      { i, text, QRectF(topLeft.x() + x, top + std::round((height - swatch) / 2), swatch, swatch),
        QRectF(topLeft.x() + x + swatch + InnerGap, top, textWidth + 1, height) });
    x += swatch + InnerGap + textWidth + OuterGap;
  }
  this->Height = this->Entries.empty() ? 0 : (line + 1) * height;
}
}
