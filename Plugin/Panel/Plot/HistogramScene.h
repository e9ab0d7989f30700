// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::HistogramScene
 * @brief What a histogram plot shows, and where, for drawing and for the mouse.
 *
 * From left to right: axis of counts, underflow, bins, overflow, infinite, undefined, axis of
 * percentages; columns outside the bins only if they have elements. From top to bottom: legend,
 * handles, plot, ticks and labels, title.
 *
 * A handle of the acceptable range is a line through the plot with a grip above it, beside the line
 * on the side that is not acceptable, so that the grips never overlap. The grip of an infinite
 * limit is at the end of the axis, without a line.
 */
#ifndef camaron_HistogramScene_h
#define camaron_HistogramScene_h

#include "CumulativeCounts.h"
#include "HistogramBrush.h"
#include "HistogramData.h"
#include "Ticks.h"

#include <QFont>
#include <QFontMetricsF>
#include <QRectF>
#include <QSizeF>

#include <cmath>    // for std::isfinite
#include <optional> // for ranges
#include <utility>  // for pairs
#include <vector>   // for ticks

namespace camaron
{
constexpr double TickLength = 4;

/// Of the acceptable range.
enum class LimitHandle
{
  None,
  Low,
  High
};

/// The current interaction of the user with the plot.
struct HistogramMarks
{
  int HoveredColumn = -1;
  LimitHandle ActiveHandle = LimitHandle::None; ///< below the mouse, or dragged
  ///@{
  /// Columns that the keyboard has chosen, in any order; negative if none.
  int FirstCurrent = -1;
  int LastCurrent = -1;
  ///@}
  /// Range of pixels that the user marks along the axis to zoom.
  std::optional<std::pair<double, double>> Zoom;
};

struct LegendEntry
{
  int Index; ///< group, or number of groups for the outline, or -1 for "and 12 more"
  QString Text;
  QRectF Swatch;
  QRectF TextBox;
};

class HistogramScene
{
public:
  HistogramData Data;
  HistogramData Outline; ///< of another mesh; empty if there is none
  CumulativeCounts Curve;
  HistogramBrush Brush;
  double Low = -Infinity; ///< limits of the acceptable range
  double High = Infinity;
  bool LogarithmicCounts = false;
  bool Cumulative = false;
  QString EmptyText;
  /// Range of the axis while the user zooms and the bins are still those of another range.
  std::optional<std::pair<double, double>> VisibleRange;
  HistogramMarks Marks;

  /// There are elements, and an axis of values.
  bool HasValues() const { return !this->Data.Edges.empty() && !this->Data.IsEmpty(); }
  bool HasLimits() const { return std::isfinite(this->Low) || std::isfinite(this->High); }
  double GetLimit(LimitHandle handle) const
  {
    return handle == LimitHandle::Low ? this->Low : this->High;
  }

  /// Finds the positions below; those of handles and marks follow by themselves. @a font: that of
  /// the widget; texts are a little smaller.
  void Place(const QSizeF& size, const QFont& font, double pixelRatio);

  QFont Font; ///< of all texts
  QFontMetricsF Metrics{ Font };
  QSizeF Size;
  double PixelRatio = 1; ///< physical pixels per unit
  QRectF Plot;           ///< the bins
  QRectF Columns;        ///< the plot and the columns on both sides
  QRectF HandleStrip;    ///< above the plot
  QRectF ValueAxis;      ///< below the plot
  QRectF Title;
  QRectF CountTitle;               ///< to be rotated
  bool HasBriefLabels = false;     ///< of the columns beside the bins
  bool HasIntegerBins = false;     ///< as the data
  std::vector<LegendEntry> Legend; ///< left-aligned lines
  std::vector<Tick> ValueTicks;
  std::vector<Tick> CountTicks;
  double OutlineFactor = 0; ///< to counts of the data with the same percentage

  ///@{
  /// Values and pixels, not clamped to the plot.
  double ToX(double value) const;
  double ToValue(double x) const;
  ///@}
  /// Top of a bar; at least two pixels above the bottom of the plot for a count that is not 0.
  double ToY(double count) const;
  double PercentToY(double percent) const;
  /// The column has more elements than the axis of counts shows.
  bool IsCutOff(double count) const { return count > this->Counts.High; }

  /// The position is below the bins, where the user zooms.
  bool IsAtAxis(const QPointF& position) const;

  /// The slot of a column over the whole height; a null rectangle if it is not shown.
  QRectF GetSlot(int column) const;
  /// The column at a position, the nearest one if @a nearest; -1 if there is none.
  int FindColumn(const QPointF& position, bool nearest) const;
  /// The column at a position if it has elements, else -1.
  int FindBar(const QPointF& position) const;

  /// Position of a limit of the acceptable range within the plot; beside the bar of a limit for
  /// bins of integers. Infinite limits and limits beyond the ends of the axis are at the ends.
  double LimitToX(double limit, bool isLow) const;
  /// Position of the line of a handle.
  double GetHandleX(LimitHandle handle) const;
  QRectF GetGrip(LimitHandle handle) const;
  LimitHandle FindHandle(const QPointF& position) const;
  /**
   * The limit for a handle that is dragged to this position: if @a snap, the nearest of
   * GetRoundLimits, else the number with the fewest digits at that pixel. Infinite well beyond the
   * end of the axis. Never beyond the other limit.
   */
  double GetLimitAt(LimitHandle handle, double x, bool snap) const;

  /// The next multiple of a physical pixel.
  double Align(double position) const;

private:
  void PlaceLegend();
  void PlaceColumns(double left, double right);
  void PlaceBins();
  void MakeCountScale();
  void MakeValueTicks();
  /// Over the height of the plot.
  QRectF MakeSlot(double left, double right) const;
  double GetNumberAt(double x) const;
  double GetRoundLimitAt(double x, bool isLow) const;

  std::vector<QRectF> Slots;
  Scale Values;
  Scale Counts;
};
}

#endif
