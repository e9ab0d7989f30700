// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqCriterionRangeWidget
 * @brief Panel widget of the properties Range, LowerLimit and UpperLimit: a choice, two limits, and
 * the histogram of the array with handles.
 *
 * A handle that is dragged makes the range a custom one. As all changes in the panel, this awaits
 * Apply. The histogram is computed by itself for small meshes, see MeshOutput::isSmall(),
 * else on request.
 */
#ifndef pqCriterionRangeWidget_h
#define pqCriterionRangeWidget_h

#include "InspectedMeshTypes.h"
#include "pqPropertyGroupWidget.h"

#include <pqTimer.h> // for several changes in a row

class pqHistogramPlot;
class pqOutputPort;
class QComboBox;
class QLineEdit;
class QPushButton;

class pqCriterionRangeWidget : public pqPropertyGroupWidget
{
  Q_OBJECT
  typedef pqPropertyGroupWidget Superclass;

public:
  pqCriterionRangeWidget(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);

protected:
  void showEvent(QShowEvent* event) override;

private:
  pqOutputPort* input() const;
  QString array() const; ///< of cells; empty if points are selected
  void refresh();
  void compute();
  void showRange();
  void setLimits(double low, double high);

  QComboBox* Range;
  pqHistogramPlot* Plot;
  QPushButton* Compute;
  QLineEdit* Low;
  QLineEdit* High;
  camaron::Distribution Shown;
  pqTimer Delay;
};

#endif
