// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqSelectionCard
 * @brief Card "Selection": what is selected, and ways to change and export it.
 *
 * Every change is a step: a Select Elements filter in the pipeline, which a state file keeps. The
 * list of steps goes back to any of them.
 */
#ifndef pqSelectionCard_h
#define pqSelectionCard_h

#include "pqInspectorCard.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QMenu;
class QToolButton;

class pqSelectionCard : public pqInspectorCard
{
  Q_OBJECT
  typedef pqInspectorCard Superclass;

public:
  pqSelectionCard(pqInspectorState* state, QWidget* parent);

protected:
  void refresh() override;

private:
  void makeTools();
  void fillStatus();
  void fillHistory();
  void goBackTo(int step);
  void exportSelection(bool onServer);

  QLabel* Summary;
  QComboBox* Adjacency;
  QDoubleSpinBox* WorstPercent;
  QMenu* Status;
  QMenu* History;
  QListWidget* Steps;
  QLabel* Message;
  QVector<QToolButton*> OfSelection; // of no use without one
  QToolButton* SelectWorst = nullptr;
};

#endif
