// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::HistogramPainter
 * @brief Draws the scene of a histogram plot.
 */
#ifndef camaron_HistogramPainter_h
#define camaron_HistogramPainter_h

#include "HistogramScene.h"
#include "PlotColors.h"

class QBrush;
class QPainter;
class QPalette;
class QPen;

namespace camaron
{
class HistogramPainter
{
public:
  HistogramPainter(QPainter* painter, const HistogramScene& scene, const QPalette& palette);

  void Paint();

private:
  ///@{
  /// From back to front.
  void PaintShades();
  void PaintColumnMarks();
  void PaintGrid();
  void PaintOutline(const QPen& pen, const QBrush& brush);
  void PaintBars();
  void PaintCurve();
  void PaintAxes();
  void PaintHandles();
  void PaintZoom();
  ///@}

  ///@{
  /// Parts of bars.
  void PaintBar(int column, const QRectF& bar, bool isFaded);
  void PaintJudgedBar(const QRectF& bar, bool isFaded);
  void PaintNotJudged(int column, const QRectF& bar, bool isFaded);
  void PaintStack(int column, const QRectF& bar, bool isFaded);
  void PaintLevels(int column, const QRectF& bar, bool isFaded);
  void PaintBreak(const QRectF& bar);
  void Fill(const QRectF& box, const QColor& color, bool isFaded);
  qint64 GetSelected(int column, std::size_t group) const;
  QColor GetColor(double value) const;
  QColor GetColorOfColumn(int column) const;
  QColor GetColorOfOutside(bool isBelow) const;
  ///@}

  ///@{
  /// Parts of axes; HistogramPainterAxes.cxx has these and the handles.
  void PaintCountAxis();
  void PaintPercentAxis();
  void PaintValueAxis();
  void PaintColumnLabels();
  void PaintTitles();
  void PaintLegend();
  void PaintLine(double left, double top, double right, double bottom);
  void PaintText(const QRectF& box, int flags, const QString& text, const QColor& color);
  ///@}

  void PaintHandle(LimitHandle handle);
  QRectF GetTextBox(LimitHandle handle, double width) const;

  QPainter* Painter;
  const HistogramScene& Scene;
  const PlotColors Colors;
};

/**
 * Draws a histogram for the cell of a table: bars without axes in @a rect, about 80 x 16 pixels:
 * green within the acceptable range and red outside, or neutral if neither limit is finite; pale
 * but for what is selected. No bar with elements is lower than two pixels. Draws no background and
 * leaves the state of the painter unchanged.
 */
void PaintSmallHistogram(QPainter* painter, const QRect& rect, const HistogramData& data,
  double acceptableLow, double acceptableHigh, const QPalette& palette);
}

#endif
