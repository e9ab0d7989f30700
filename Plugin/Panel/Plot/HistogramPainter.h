// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::HistogramPainter
 * @brief Draws a histogram plot according to its layout.
 */
#ifndef camaron_HistogramPainter_h
#define camaron_HistogramPainter_h

#include "HistogramLayout.h"
#include "LimitHandles.h"
#include "PlotColors.h"

#include <QPolygonF>

#include <optional> // for the zoomed range
#include <utility>  // for pairs

class QPainter;
class QPalette;

namespace camaron
{
/// The current interaction of the user with the plot.
struct HistogramMarks
{
  int HoveredColumn = -1;
  LimitHandles::Handle ActiveHandle = LimitHandles::Handle::None; ///< below the mouse, or dragged
  ///@{
  /// Columns that the keyboard has chosen, in any order; negative if none.
  int FirstCurrent = -1;
  int LastCurrent = -1;
  ///@}
  /// Range of pixels that the user marks along the axis to zoom.
  std::optional<std::pair<double, double>> Zoom;
};

class HistogramPainter
{
public:
  HistogramPainter(QPainter* painter, const HistogramContent& content,
    const HistogramLayout& layout, const PlotColors& colors);

  void Paint(const HistogramMarks& marks);

private:
  void PaintEmpty();
  void PaintShades();
  void PaintColumnMarks(const HistogramMarks& marks);
  enum class OutlinePart
  {
    Area, ///< behind the bars
    Line  ///< in front of them
  };
  void PaintOutline(OutlinePart part);
  void PaintCurve();
  QPolygonF GetCurve() const;
  /// Without a curve.
  QPolygonF GetCurveOfBins() const;
  void PaintBars();
  void PaintBar(int column, const QRectF& bar, bool isFaded);
  void PaintStack(int column, const QRectF& bar, bool isFaded);
  void PaintLevels(int column, const QRectF& bar, bool isFaded);
  qint64 GetSelected(int column, std::size_t group) const;
  void PaintJudgedBar(const QRectF& bar, bool isFaded);
  void PaintNotJudged(int column, const QRectF& bar, bool isFaded);
  void PaintBreak(const QRectF& bar);
  void PaintZoom(double from, double to);

  void Fill(const QRectF& box, const QColor& color, bool isFaded);
  QColor GetColor(double value) const;
  QColor GetColorOfColumn(int column) const;
  QColor GetColorOfOutside(bool isBelow) const;

  QPainter* Painter;
  const HistogramContent& Content;
  const HistogramLayout& Layout;
  const PlotColors& Colors;
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
