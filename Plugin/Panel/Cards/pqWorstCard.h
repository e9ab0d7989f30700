// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqWorstCard
 * @brief Card "Worst": the worst cells of the current criterion, and the places where bad cells
 * are, to step through.
 *
 * Cells are the rows of the table *Worst Elements*; places are connected groups of cells outside
 * the limits of the histogram. A step flies to the row, selects the cell, and, with *Open Mesh*,
 * cuts the mesh around it and draws the rest as glass. *Back* restores camera and display.
 *
 * Keys in the tables: N or Down for the next row, P or Up for the previous one, O to open, S to
 * select the listed cells, B to go back.
 */
#ifndef pqWorstCard_h
#define pqWorstCard_h

#include "InspectedMeshTypes.h"
#include "pqInspectorCard.h"

#include <QMap>

#include <functional> // for keys

class pqTableModel;
class QComboBox;
class QLabel;
class QSpinBox;
class QTableView;
class QToolButton;

class pqWorstCard : public pqInspectorCard
{
  Q_OBJECT
  typedef pqInspectorCard Superclass;

public:
  pqWorstCard(pqInspectorState* state, QWidget* parent);

protected:
  void refresh() override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  bool showsPlaces() const;
  /// Whether the acceptable range of the criterion, or the user's, is for a listed cell.
  bool isJudged(const camaron::PanelTable& table, int row) const;
  void step(int rows);
  void goToRow(int row);
  void refreshBack();
  void selectListed();
  void showListed();
  void showSummary();
  QTableView* shownTable() const;

  QMap<int, std::function<void()>> Keys; ///< in the tables
  QComboBox* Rows;
  QSpinBox* Number;
  QToolButton* Open;
  QToolButton* Back;
  QList<QToolButton*> OfRows; ///< tools that need listed ones
  pqTableModel* Cells;
  pqTableModel* Places;
  QTableView* CellTable;
  QTableView* PlaceTable;
  QLabel* Summary;
};

#endif
