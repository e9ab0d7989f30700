// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqCriteriaCostDecorator
 * @brief Says below the criteria of Element Quality how long they will take, where that is long.
 *
 * For the properties "Criteria" and "Preset": each shows the line when the criteria come from it.
 * The line follows ticks that are not applied yet. Nothing is shown for what takes less than some
 * seconds.
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
  ~pqCriteriaCostDecorator() override;

private Q_SLOTS:
  void updateText();

private:
  Q_DISABLE_COPY(pqCriteriaCostDecorator)

  QLabel* Label;
};

#endif
