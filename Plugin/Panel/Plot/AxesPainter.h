// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::AxesPainter
 * @brief Draws axes, labels, titles and legend.
 */
#ifndef camaron_AxesPainter_h
#define camaron_AxesPainter_h

#include "HistogramLayout.h"
#include "PlotColors.h"

class QPainter;

namespace camaron
{
class AxesPainter
{
public:
  AxesPainter(QPainter* painter, const HistogramContent& content, const HistogramLayout& layout,
    const PlotColors& colors);

  /// Lines at the ticks of counts, behind the bars.
  void PaintGrid();
  /// Everything else.
  void Paint();

private:
  void PaintCountAxis();
  void PaintPercentAxis();
  void PaintValueAxis();
  void PaintColumnLabels();
  void PaintTitles();
  void PaintLegend();

  void PaintLine(double left, double top, double right, double bottom);
  void PaintText(const QRectF& box, int flags, const QString& text, const QColor& color);

  QPainter* Painter;
  const HistogramContent& Content;
  const HistogramLayout& Layout;
  const PlotColors& Colors;
};
}

#endif
