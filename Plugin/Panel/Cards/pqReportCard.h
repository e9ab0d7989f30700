// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqReportCard
 * @brief Card "Report": the tables of the mesh as views, charts and files.
 */
#ifndef pqReportCard_h
#define pqReportCard_h

#include "pqInspectorCard.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QToolButton;

class pqReportCard : public pqInspectorCard
{
  Q_OBJECT
  typedef pqInspectorCard Superclass;

public:
  pqReportCard(pqInspectorState* state, QWidget* parent);

protected:
  void refresh() override;

private:
  void saveTables();
  void saveReport();
  void browse();
  void showTable(int table, const char* viewType);

  int MessageOf = 0; // version of the mesh
  QLabel* Hint;
  QLabel* Message;
  QLineEdit* Folder;
  QToolButton* Browse;
  QPushButton* Save;
  QList<QPushButton*> Buttons;
};

#endif
