// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqHistogramCard
 * @brief Card "Histogram": the distribution of the current criterion, to inspect, to brush, and to
 * set limits with.
 *
 * Brushed bars become the active selection when the mouse is released; while it moves only the
 * picture changes. Handles at the acceptable range show how many cells and how much volume a limit
 * rejects, which the cumulative curve answers without the server.
 */
#ifndef pqHistogramCard_h
#define pqHistogramCard_h

#include "InspectedMeshTypes.h"
#include "pqInspectorCard.h"

#include "pqOutputPort.h" // for a pointer to it

#include <QPointer>

class pqHistogramPlot;
class pqLimitFields;
class QComboBox;
class QLabel;
class QSpinBox;
class QToolButton;

class pqHistogramCard : public pqInspectorCard
{
  Q_OBJECT
  typedef pqInspectorCard Superclass;

public:
  pqHistogramCard(pqInspectorState* state, QWidget* parent);

protected:
  void refresh() override;
  void recolor() override;

private:
  void makeToolBar();
  void fillCriteria();
  void fillGroups();
  void showDistribution();
  void fillOutlines();
  void showOutline();
  void showLimits(double low, double high);
  void showVerdict(double low, double high);
  void selectFailing();
  void findEdges();
  /// Whether this is the acceptable range of the criterion.
  bool isOwnRange(double low, double high) const;
  void showBrush(double low, double high, qint64 count);
  void showSelection();
  /// Parts of the bars that are selected by other means than a brush.
  void showSelectedParts();
  /// Undoes the effect of showBrush() on the picture.
  void endBrush();
  void select(const QVector<QPair<double, double>>& ranges, int specials, qint64 count,
    Qt::KeyboardModifiers modifiers);
  void zoom(double low, double high);
  void copyRule();
  QString rangeText(double low, double high) const;

  camaron::DistributionRequest Request;
  camaron::Distribution Shown;
  QPointer<pqOutputPort> OutlineSource; ///< another mesh
  QString OutlineOf;                    ///< the type of elements it was chosen for
  bool IsSelecting = false;
  QComboBox* Criterion;
  QComboBox* Group;
  QSpinBox* Bins;
  QToolButton* Outline;
  QToolButton* CopyRule;
  pqHistogramPlot* Plot;
  pqLimitFields* Limits;
  QLabel* Verdict;
  QLabel* Brush;
};

#endif
