// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqCriteriaCostDecorator
 * @brief Shows, below the criteria of Element Quality, how long their evaluation will take if it
 * takes long.
 *
 * For the properties "Criteria" and "Preset": each shows the line if the criteria come from it. The
 * line also reflects ticks that have not been applied yet. Nothing is shown for a few seconds or
 * less.
 */
#ifndef pqCriteriaCostDecorator_h
#define pqCriteriaCostDecorator_h

#include "pqPropertyWidgetDecorator.h"

class QLabel;

class pqCriteriaCostDecorator : public pqPropertyWidgetDecorator
{
  Q_OBJECT
  typedef pqPropertyWidgetDecorator Superclass;

public:
  pqCriteriaCostDecorator(vtkPVXMLElement* xml, pqPropertyWidget* parent);

private Q_SLOTS:
  void updateText();

private:
  QLabel* Label;
};

#endif
