// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqCutHandlesDecorator
 * @brief Shows handles of the shape of a cut in the view as the property CutHandles says.
 *
 * ParaView would show them at first, and keep nowhere whether the user wants them. It decorates the
 * property with the shapes.
 */
#ifndef pqCutHandlesDecorator_h
#define pqCutHandlesDecorator_h

#include "pqPropertyWidgetDecorator.h"
#include "pqTimer.h" // for a delayed update

class pqCutHandlesDecorator : public pqPropertyWidgetDecorator
{
  Q_OBJECT
  typedef pqPropertyWidgetDecorator Superclass;

public:
  pqCutHandlesDecorator(vtkPVXMLElement* xml, pqPropertyWidget* parent);

private:
  /// Shows or hides the handles, when the events so far have been handled.
  void updateLater() { this->Timer.start(); }
  void update();

  /// The user wants the handles or not, in the widget of the shape.
  void choose(bool areShown);

  pqTimer Timer;
};

#endif
