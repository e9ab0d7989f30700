// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::HistogramLayout
 * @brief Where the parts of a histogram plot are, for drawing and for the mouse.
 *
 * From left to right: axis of counts, underflow, bins, overflow, infinite, undefined, axis of
 * percentages; columns outside the bins only if they have elements. From top to bottom: legend,
 * handles, plot, ticks and labels, title.
 */
#ifndef camaron_HistogramLayout_h
#define camaron_HistogramLayout_h

#include "CumulativeCounts.h"
#include "HistogramBrush.h"
#include "HistogramData.h"
#include "Ticks.h"

#include <QFont>
#include <QFontMetricsF>
#include <QRectF>
#include <QSizeF>
#include <QStringList>

#include <cmath>    // for std::isfinite
#include <optional> // for the visible range
#include <utility>  // for pairs
#include <vector>   // for ticks

namespace camaron
{
constexpr double TickLength = 4;

/// Places the entries of a legend in lines.
class PlotLegend
{
public:
  struct Entry
  {
    int Index; ///< of the label, or -1 for "and 12 more"
    QString Text;
    QRectF Swatch;
    QRectF TextBox;
  };

  PlotLegend() = default;
  /// Left-aligned lines, at most @a mostLines; the last entry summarizes those that do not fit.
  PlotLegend(const QStringList& labels, const QPointF& topLeft, double width,
    const QFontMetricsF& metrics, int mostLines);

  const std::vector<Entry>& GetEntries() const { return this->Entries; }
  double GetHeight() const { return this->Height; }

private:
  std::vector<Entry> Entries;
  double Height = 0;
};

/// The contents of a histogram plot.
struct HistogramContent
{
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

  bool HasLimits() const { return std::isfinite(this->Low) || std::isfinite(this->High); }
};

class HistogramLayout
{
public:
  HistogramLayout() = default;
  /// @a font: that of the widget; texts are a little smaller.
  HistogramLayout(
    const HistogramContent& content, const QSizeF& size, const QFont& font, double pixelRatio);

  QFont Font; ///< of all texts
  QSizeF Size;
  double PixelRatio = 1; ///< physical pixels per unit
  QRectF Plot;           ///< the bins
  QRectF Columns;        ///< the plot and the columns on both sides
  QRectF HandleStrip;    ///< above the plot
  QRectF ValueAxis;      ///< below the plot
  QRectF Title;
  QRectF CountTitle;           ///< to be rotated
  bool HasBriefLabels = false; ///< of the columns beside the bins
  PlotLegend Legend;           ///< indices: groups, then the outline
  std::vector<Tick> ValueTicks;
  std::vector<Tick> CountTicks;

  ///@{
  /// Values and pixels, not clamped to the plot.
  double ToX(double value) const;
  double ToValue(double x) const;
  ///@}
  /// Top of a bar; at least two pixels above the bottom of the plot for a count that is not 0.
  double ToY(double count) const;
  double PercentToY(double percent) const;
  /// The column has more elements than the axis of counts shows.
  bool IsCutOff(double count) const;
  /// Factor from the counts of the outline to counts of the data with the same percentage.
  double GetOutlineFactor() const { return this->OutlineFactor; }

  /// Position of a limit of the acceptable range within the plot; beside the bar of a limit for
  /// bins of integers. Infinite limits and limits beyond the ends of the axis are at the ends.
  double LimitToX(double limit, bool isLow) const;

  /// The position is below the bins, where the user zooms.
  bool IsAtAxis(const QPointF& position) const;

  /// The slot of a column over the whole height; a null rectangle if it is not shown.
  QRectF GetSlot(int column) const;
  /// From left to right.
  std::vector<int> GetShownColumns() const;
  /// The column at a position, the nearest one if @a nearest; -1 if there is none.
  int FindColumn(const QPointF& position, bool nearest) const;

  /// The next multiple of a physical pixel.
  double Align(double position) const;

private:
  void PlaceColumns(const HistogramContent& content, double left, double right);
  void MakeCountScale(const HistogramContent& content);
  void MakeTicks(bool isEmpty);

  std::vector<QRectF> Slots;
  bool HasAxis = false; ///< with values
  bool HasIntegerBins = false;
  Scale Values;
  Scale Counts;
  double OutlineFactor = 0;
};
}

#endif
