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

#include <optional> // for the zoomed range
#include <utility>  // for pairs

class QPainter;

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
  void PaintBars();
  void PaintBar(int column, const QRectF& bar, bool isFaded);
  void PaintStack(int column, const QRectF& bar, bool isFaded);
  void PaintLevels(int column, const QRectF& bar, bool isFaded);
  void PaintJudgedBar(const QRectF& bar, bool isFaded);
  void PaintBreak(const QRectF& bar);
  void PaintZoom(double from, double to);

  bool HasLimits() const;
  QColor GetColor(double value) const;
  QColor GetColorOfColumn(int column) const;
  QColor GetColorOfOutside(bool isBelow) const;

  QPainter* Painter;
  const HistogramContent& Content;
  const HistogramLayout& Layout;
  const PlotColors& Colors;
};
}

#endif
