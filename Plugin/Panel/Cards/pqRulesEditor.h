// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRulesEditor
 * @brief An editor of rules that completes names while one types, and underlines problems.
 */
#ifndef pqRulesEditor_h
#define pqRulesEditor_h

#include "PanelTable.h"
#include "RuleCompletion.h"

#include <QPlainTextEdit>

class QCompleter;
class QStandardItemModel;

class pqRulesEditor : public QPlainTextEdit
{
  Q_OBJECT
  typedef QPlainTextEdit Superclass;
  /// What the list offers, such as "MinDihedralAngle, MinFaceAngle"; empty if it is hidden.
  Q_PROPERTY(QString offered READ offered)

public:
  explicit pqRulesEditor(QWidget* parent = nullptr);

  void setWords(const camaron::RuleWords& words) { this->Words = words; }

  /// Underlines lines; the columns are Line, from 1, and Text.
  void showProblems(const camaron::PanelTable& problems);

  QString offered() const;

protected:
  void keyPressEvent(QKeyEvent* event) override;
  /// The Tab key accepts a choice of the list.
  bool focusNextPrevChild(bool next) override;

private:
  /// Shows what the line may become up to the cursor, or hides the list.
  void offer();
  void insert(const QModelIndex& index);
  /// Inserts the current choice; false without a list.
  bool accept();
  QString lineToCursor() const;

  camaron::RuleWords Words;
  QStandardItemModel* Choices;
  QCompleter* Completer;
};

#endif
