// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqHistogramPlot::pqInternals
 * @brief What the plot shows, and the gestures of mouse and keyboard that change it.
 */
#ifndef pqHistogramPlotInternals_h
#define pqHistogramPlotInternals_h

#include "HistogramLayout.h"
#include "HistogramPainter.h"
#include "pqHistogramPlot.h"

class pqHistogramPlot::pqInternals
{
public:
  explicit pqInternals(pqHistogramPlot* plot);

  camaron::HistogramContent Content;
  camaron::HistogramMarks Marks;

  /// For the present content, size and font.
  const camaron::HistogramLayout& GetLayout();

  /// The content or the font has changed.
  void Invalidate();

  ///@{
  /// Applies actions of the user and emits their signals.
  void Brush(const camaron::HistogramBrush& newer, Qt::KeyboardModifiers modifiers);
  void Clear();
  void SetLimits(double low, double high);
  void Request(double low, double high);
  ///@}

  ///@{
  /// Mouse.
  void Press(const QPointF& position, Qt::KeyboardModifiers modifiers);
  void Drag(const QPointF& position, Qt::KeyboardModifiers modifiers);
  void Release(const QPointF& position);
  void Hover(const QPointF& position);
  void DoubleClick(const QPointF& position);
  /// Returns whether the position is at the axis.
  bool Wheel(const QPointF& position, double steps);
  ///@}

  bool IsDragging() const { return this->Gesture != Gestures::None; }
  /// Whether there is something to clear: a brush, or parts of bars that are selected otherwise.
  bool HasSelection() const
  {
    return !this->Content.Brush.IsEmpty() || !this->Content.Data.Selected.Counts.empty();
  }
  /// Restores the state before the drag.
  void Cancel();
  /// Ends the drag, as its bars are gone.
  void Forget();

  /// Returns whether the key has a meaning.
  bool Key(int key, Qt::KeyboardModifiers modifiers);

private:
  enum class Gestures
  {
    None,
    Brush,
    Limit,
    Zoom
  };
  void DragBrush(const QPointF& position);
  void DragLimit(const QPointF& position, Qt::KeyboardModifiers modifiers);
  void ReleaseBrush();
  void ReleaseZoom(const QPointF& position);
  void EmitBrushDragging();
  void EmitBrush(const camaron::HistogramBrush& brush, Qt::KeyboardModifiers modifiers);
  void ShowHover(int column, camaron::LimitHandles::Handle handle);
  void MoveCurrent(int key, bool extend);
  void MoveLimit(int key);
  void ZoomAround(double x, double factor);

  pqHistogramPlot* Plot;
  camaron::HistogramLayout Layout;
  bool IsLayoutValid = false;

  Gestures Gesture = Gestures::None;
  QPointF PressedAt;
  Qt::KeyboardModifiers Modifiers; ///< when the mouse was pressed
  int Anchor = -1;                 ///< first column of a drag
  bool PressedOnBar = false;
  camaron::HistogramBrush Newer, BrushBefore;
  camaron::LimitHandles::Handle Handle = camaron::LimitHandles::Handle::None;
  double LowBefore = 0, HighBefore = 0;
  double GrabOffset = 0; ///< from the line of a handle to the mouse
};

#endif
