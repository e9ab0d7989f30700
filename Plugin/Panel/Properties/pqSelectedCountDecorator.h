// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqSelectedCountDecorator
 * @brief Shows, in the panel of Select Elements, the number of selected elements and the warning of
 * the last update.
 *
 * The text is below the widget of the decorated property, from an update of the filter until a
 * property changes.
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

private:
  void updateText();

  QLabel* Label;
};

#endif
