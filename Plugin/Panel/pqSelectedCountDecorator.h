// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqSelectedCountDecorator
 * @brief Says in the panel of Select Elements how many elements it selects, and what it has to
 * report.
 *
 * Below the widget of the property that has it, from an update of the filter until it is changed.
 */
#ifndef pqSelectedCountDecorator_h
#define pqSelectedCountDecorator_h

#include "pqPropertyWidgetDecorator.h"

class QLabel;

class pqSelectedCountDecorator : public pqPropertyWidgetDecorator
{
  Q_OBJECT
  typedef pqPropertyWidgetDecorator Superclass;

public:
  pqSelectedCountDecorator(vtkPVXMLElement* xml, pqPropertyWidget* parent);
  ~pqSelectedCountDecorator() override;

private:
  Q_DISABLE_COPY(pqSelectedCountDecorator)

  void updateText();

  QLabel* Label;
};

#endif
