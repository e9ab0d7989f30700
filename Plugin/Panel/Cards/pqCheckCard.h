// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqCheckCard
 * @brief Card "Check": rules or a preset, and the verdicts on the mesh.
 *
 * The rules are those of `camaron check` (Documentation/check.md), and the same filter, Check
 * Quality, answers. Errors are shown at their line. A click on a verdict selects the failing cells.
 * The rules of a preset can be written into the editor, to be changed.
 */
#ifndef pqCheckCard_h
#define pqCheckCard_h

#include "InspectedMeshTypes.h"
#include "pqInspectorCard.h"

class pqRulesEditor;
class pqTableModel;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;
class QToolButton;

class pqCheckCard : public pqInspectorCard
{
  Q_OBJECT
  typedef pqInspectorCard Superclass;
  Q_PROPERTY(QString verdict READ verdict)
  /// Of the last check: failing and checked cells of each rule, such as "3/4080 0/528".
  Q_PROPERTY(QString counts READ counts)

public:
  pqCheckCard(pqInspectorState* state, QWidget* parent);

  /// Of the last check: "pass", "warn", "fail", "empty", or what is wrong with the
  /// rules; empty if there is none.
  QString verdict() const { return this->LastVerdict; }

  QString counts() const;

protected:
  void refresh() override;
  void recolor() override;

private:
  /// The rules of the editor and the preset as one text.
  QString rules() const;

  void check();
  /// Clears the result, which belongs to other rules or to another mesh.
  void forget();
  void showResult();
  void enableEdit();
  void editPreset();
  void selectFailing(int row);
  void openRules();
  void saveRules();

  QString LastVerdict;
  camaron::CheckResult Result;
  camaron::CheckRequest Checked; // to which the verdicts belong
  int CheckedMesh = 0;           // its version
  QComboBox* Preset;
  QToolButton* EditPreset;
  pqRulesEditor* Rules;
  QLineEdit* Tolerance;
  QPushButton* Check;
  QLabel* Verdict;
  pqTableModel* Verdicts;
  QTableView* Table;
};

#endif
