// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::LimitHandles
 * @brief The two handles of the acceptable range: where they are, where they may be dragged, and
 * how they look.
 *
 * A handle is a line through the plot with a grip above it, beside the line on the side that is not
 * acceptable, so that the grips never overlap. The grip of an infinite limit is hollow, at the end
 * of the axis and without a line.
 */
#ifndef camaron_LimitHandles_h
#define camaron_LimitHandles_h

#include "HistogramLayout.h"

class QPainter;

namespace camaron
{
struct PlotColors;

class LimitHandles
{
public:
  enum class Handle
  {
    None,
    Low,
    High
  };

  LimitHandles(const HistogramContent& content, const HistogramLayout& layout);

  /// The handle at a position.
  Handle Find(const QPointF& position) const;

  /**
   * The limit for a handle that is dragged to this position: if @a snap, the nearest of
   * GetRoundLimits, else the number with the fewest digits at that pixel. Infinite well beyond the
   * end of the axis. Never beyond the other limit.
   */
  double GetLimit(Handle handle, double x, bool snap) const;

  /// Position of the line of a handle.
  double GetX(Handle handle) const;

  void Paint(QPainter* painter, const PlotColors& colors, Handle active) const;

private:
  QRectF GetGrip(Handle handle) const;
  double GetValue(Handle handle) const;
  double GetNumberAt(double x) const;
  double GetRoundLimitAt(double x, bool isLow) const;
  QString GetText(Handle handle) const;
  QRectF GetTextBox(Handle handle, double width) const;
  void PaintHandle(QPainter* painter, const PlotColors& colors, Handle handle, bool isActive) const;

  const HistogramContent& Content;
  const HistogramLayout& Layout;
};
}

#endif
