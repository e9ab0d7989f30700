// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqElementCard
 * @brief Card "Element": all values of one cell, and its neighbors across faces to walk to.
 *
 * The cell is the one that another card shows (pqInspectorState::showElement), that the user picks
 * in a view, or whose id the user types.
 */
#ifndef pqElementCard_h
#define pqElementCard_h

#include "InspectedMeshTypes.h"
#include "pqInspectorCard.h"

class pqTableModel;
class QLabel;
class QLineEdit;
class QTableView;
class QToolButton;

class pqElementCard : public pqInspectorCard
{
  Q_OBJECT
  typedef pqInspectorCard Superclass;

public:
  pqElementCard(pqInspectorState* state, QWidget* parent);

protected:
  void refresh() override;
  void recolor() override;

private:
  void goToText();
  void goTo(qint64 id);
  void showNeighbors();
  void showPicked();
  void showElement(qint64 id, const QString& idSpace);

  QString IdSpace; // of the id
  QStringList NeighborIds;
  QString Wanted;   // text of an id; empty for none
  int WantedIn = 0; // version of the mesh
  QLineEdit* Id;
  QToolButton* Copy;
  QToolButton* Select;
  QLabel* Summary;
  pqTableModel* Values;
  QTableView* Table;
  QLabel* Neighbors;
};

#endif
