// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqHistogramPlot
 * @brief Draws the histogram of a criterion and lets the user brush bars, drag the limits of the
 * acceptable range and zoom.
 *
 * The widget only knows what its owner sets and talks to no server. Its setters emit nothing; only
 * what the user does emits signals.
 *
 * Mouse: a click on a bar brushes it, a drag over several brushes them. Shift adds to the brush,
 * Ctrl subtracts, Ctrl+Shift intersects. A click on empty space, or Escape, clears. The handles of
 * the acceptable range snap to round numbers (camaron::GetRoundLimits); with Ctrl they follow the
 * mouse. A handle that is dragged beyond the end of the axis makes the range infinite. The wheel
 * over the x axis and a drag along it zoom; a double click there, or on empty space, resets.
 *
 * Keyboard: Left, Right, Home and End move the current bar, with Shift they extend it to several;
 * Return or Space brushes with the same modifiers as the mouse. + and - zoom, 0 resets.
 */
#ifndef pqHistogramPlot_h
#define pqHistogramPlot_h

#include "HistogramScene.h"

#include <QWidget>

class pqHistogramPlot : public QWidget
{
  Q_OBJECT
  typedef QWidget Superclass;

  ///@{
  /// Smallest and largest finite value that is brushed; NaN if none is.
  Q_PROPERTY(double brushLow READ brushLow)
  Q_PROPERTY(double brushHigh READ brushHigh)
  ///@}
  Q_PROPERTY(qint64 brushedCount READ brushedCount)
  ///@{
  /// Count of each bin, separated by blanks; of the data, and of the outline.
  Q_PROPERTY(QString binCounts READ binCounts)
  Q_PROPERTY(QString outlineCounts READ outlineCounts)
  ///@}
  /// Label and number of elements of each group.
  Q_PROPERTY(QString groupCounts READ groupCounts)
  ///@{
  /// Limits of the acceptable range; infinite if there is none.
  Q_PROPERTY(double acceptableLow READ acceptableLow)
  Q_PROPERTY(double acceptableHigh READ acceptableHigh)
  ///@}
  Q_PROPERTY(bool logarithmicCounts READ logarithmicCounts WRITE setLogarithmicCounts)
  Q_PROPERTY(bool cumulative READ cumulative WRITE setCumulative)

public:
  explicit pqHistogramPlot(QWidget* parent = nullptr);

  ///@{
  /// What to draw. The brush is kept if the bins are the same, else forgotten. Data that are not
  /// valid (HistogramData::IsValid) are replaced by empty ones.
  void setData(const camaron::HistogramData& data);
  const camaron::HistogramData& data() const { return this->Scene.Data; }
  ///@}

  /// The cumulative curve to draw.
  void setCurve(const camaron::CumulativeCounts& curve);

  /// Another mesh, drawn as an outline with the same percentages of its total. Request the same
  /// bins for it, so that the heights compare. Empty data: none.
  void setOutline(const camaron::HistogramData& outline);

  /// Text in the middle of the plot if there is nothing to draw. Default: "No data".
  void setEmptyText(const QString& text);

  /// Shows another acceptable range, without signals. NaN: no limit. Default: infinite on both
  /// sides.
  void showAcceptable(double low, double high);

  /// Shows another selection than that of the brush, without signals: nothing is brushed, and these
  /// parts of the bars, and of the groups if they are several, are selected; without counts, none.
  void showSelected(const camaron::HistogramData::Group& selected,
    const std::vector<camaron::HistogramData::Group>& groups = {});

  ///@{
  /// Draw the logarithm of the counts. Default: off.
  void setLogarithmicCounts(bool logarithmic);
  bool logarithmicCounts() const { return this->Scene.LogarithmicCounts; }
  ///@}

  ///@{
  /// Draw the cumulative curve, with an axis of percentages on the right. Default: off.
  void setCumulative(bool cumulative);
  bool cumulative() const { return this->Scene.Cumulative; }
  ///@}

  ///@{
  /// The brushed ranges, combined with those brushed before.
  double brushLow() const;
  double brushHigh() const;
  qint64 brushedCount() const { return this->Scene.Brush.GetCount(this->data()); }
  camaron::HistogramBrush::Ranges brushedRanges() const
  {
    return this->Scene.Brush.GetRanges(this->data());
  }
  ///@}

  QString binCounts() const;
  QString outlineCounts() const;
  QString groupCounts() const;
  double acceptableLow() const { return this->Scene.Low; }
  double acceptableHigh() const { return this->Scene.High; }

  /// Where the mouse finds a value: in the middle of the bins, or, if `isLimit`, on the handle of a
  /// limit there.
  Q_INVOKABLE QPoint positionOf(double value, bool isLimit);

  QSize sizeHint() const override { return QSize(360, 150); }
  QSize minimumSizeHint() const override { return QSize(240, 130); }

Q_SIGNALS:
  ///@{
  /// A handle moves; it was released. Either limit may be infinite.
  void acceptableDragging(double low, double high);
  void acceptableChanged(double low, double high);
  ///@}

  /**
   * A drag over bars goes on: lowest and highest value, and number of elements, of what will be
   * brushed if the mouse is released now. The values are NaN if nothing or only special values are.
   */
  void brushDragging(double low, double high, qint64 count);

  /// The drag is over, before brushed(), or without it.
  void brushEnded();

  /**
   * The user brushed. The arguments describe this brush alone, not what was brushed before, so that
   * the owner can combine it with any selection as @a modifiers say (camaron::ToCombination);
   * brushedRanges() etc. already return the combination. Cleared: no ranges, no specials, 0.
   * @a specials is a sum of camaron::HistogramBrush::Special.
   */
  void brushed(const QVector<QPair<double, double>>& closedRanges, int specials, qint64 count,
    Qt::KeyboardModifiers modifiers);

  ///@{
  /// The user zooms: the owner gets bins of this range, or of the full range, and sets them.
  void rangeRequested(double low, double high);
  void rangeReset();
  ///@}

protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  enum class Gestures
  {
    None,
    Brush,
    Limit,
    Zoom
  };

  /// The scene, placed for the present size and font.
  camaron::HistogramScene& placedScene();
  /// The content or the font has changed.
  void placeAgain();
  /// There is something to clear: a brush, or parts of bars that are selected otherwise.
  bool hasSelection() const
  {
    return !this->Scene.Brush.IsEmpty() || !this->data().Selected.Counts.empty();
  }

  ///@{
  /// Apply actions of the user and emit their signals. An empty brush that replaces clears.
  void brush(const camaron::HistogramBrush& newer, Qt::KeyboardModifiers modifiers);
  void zoomTo(double low, double high);
  void zoomAround(double x, double factor);
  ///@}

  ///@{
  /// The mouse.
  bool isDragging() const { return this->Gesture != Gestures::None; }
  void hover(const QPointF& position);
  void mark(int column, camaron::LimitHandle handle);
  void dragBrush(const QPointF& position);
  void showBrush(const camaron::HistogramBrush& brush);
  void dragLimit(double x, Qt::KeyboardModifiers modifiers);
  void releaseBrush();
  void releaseZoom(double x);
  /// Restores the state before the drag.
  void cancelDrag();
  /// Ends the drag, and marks nothing below the mouse.
  void endDrag();
  ///@}

  ///@{
  /// The keyboard. The first returns whether the key has a meaning.
  bool pressKey(int key, Qt::KeyboardModifiers modifiers);
  void moveCurrent(int key, bool extend);
  void moveLimit(int key);
  ///@}

  camaron::HistogramScene Scene;
  bool IsPlaced = false;

  Gestures Gesture = Gestures::None;
  QPointF PressedAt;
  Qt::KeyboardModifiers Modifiers; ///< when the mouse was pressed
  int Anchor = -1;                 ///< first column of a drag
  bool PressedOnBar = false;
  camaron::HistogramBrush Newer, BrushBefore;
  double LowBefore = 0, HighBefore = 0;
  double GrabOffset = 0; ///< from the line of a handle to the mouse
};

#endif
