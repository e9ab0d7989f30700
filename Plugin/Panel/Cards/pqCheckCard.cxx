// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqCheckCard.h"

#include "CardTools.h"
#include "NumberText.h"
#include "PanelColors.h"
#include "pqInspectedMesh.h"
#include "pqMeshFilters.h"
#include "pqMeshQuestions.h"
#include "pqMeshSelection.h"
#include "pqRulesEditor.h"

#include "pqScopedOverrideCursor.h"

#include <QComboBox>
#include <QFile>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace
{
using camaron::PanelTable;

constexpr qint64 LargestFile = 1 << 20; // as Check Quality reads

// At most eight rows; column 2, the rules in lines of 27 characters, takes what the others leave.
constexpr camaron::TableShape WideRules{ 8, 2, 27, true };

//------------------------------------------------------------------------------
QColor GetColor(const QString& verdict, const QPalette& palette)
{
  const camaron::PanelColors colors(palette);
  return verdict == "fail" ? colors.Fails
    : verdict == "warn"    ? colors.Warns
    : verdict == "pass"    ? colors.Passes
                           : colors.Unknown;
}

//------------------------------------------------------------------------------
QString SpellFailing(const PanelTable& table, int row)
{
  return QString("%1 (%2)").arg(camaron::GroupedInteger(table.integer(row, "Failing")),
    camaron::FormatPercent(
      double(table.integer(row, "Failing")), double(table.integer(row, "Checked"))));
}

//------------------------------------------------------------------------------
QString SpellWorstId(const PanelTable& table, int row)
{
  return table.integer(row, "WorstId") < 0 ? QString() : table.text(row, "WorstId");
}

//------------------------------------------------------------------------------
int GetRank(const QString& verdict)
{
  static const QStringList order = { "fail", "warn", "pass" };
  const auto rank = order.indexOf(verdict);
  return static_cast<int>(rank < 0 ? order.size() : rank);
}

//------------------------------------------------------------------------------
// What fails first.
PanelTable SortByVerdict(PanelTable table)
{
  const auto verdict = table.Columns.indexOf("Verdict");
  std::stable_sort(table.Rows.begin(), table.Rows.end(), [verdict](const auto& a, const auto& b)
    { return GetRank(a[verdict].toString()) < GetRank(b[verdict].toString()); });
  return table;
}

//------------------------------------------------------------------------------
QString SpellRules(int number)
{
  return number == 1 ? pqCheckCard::tr("1 rule") : pqCheckCard::tr("%1 rules").arg(number);
}
}

//------------------------------------------------------------------------------
pqCheckCard::pqCheckCard(pqInspectorState* state, QWidget* parent)
  : Superclass("Check", tr("Check"), false, state, parent)
  , Preset(camaron::Make<QComboBox>(this->content(), "Preset"))
  , Rules(camaron::Make<pqRulesEditor>(this->content(), "Rules"))
  , Tolerance(camaron::Make<QLineEdit>(this->content(), "Tolerance"))
  , Check(camaron::Make<QPushButton>(this->content(), "Check", tr("Check")))
  , Verdict(camaron::MakeText(this->content(), "Verdict"))
  , Verdicts(new pqTableModel(
      { pqTableModel::ShowColumn(tr("Verdict"), "Verdict", false),
        { tr("Failing"), SpellFailing, true }, pqTableModel::ShowColumn(tr("Rule"), "Rule", false),
        pqTableModel::ShowColumn(tr("Worst"), "WorstValue"), { tr("Id"), SpellWorstId, true } },
      this))
  , Table(camaron::MakeTable(this->content(), "Verdicts", this->Verdicts, WideRules))
{
  constexpr int visibleLines = 4;
  this->Table->setToolTip(tr("Click a rule to select the cells that violate it"));
  this->Verdicts->setRowColor([this](const PanelTable& table, int row)
    { return GetColor(table.text(row, "Verdict"), this->palette()); });
  this->Preset->setToolTip(tr("Rules of a preset, in addition to those below"));
  this->Rules->setPlaceholderText(
    tr("One rule per line, such as: MinDihedralAngle >= 10 tolerate 0.1%"));
  this->Rules->setToolTip(tr("Names are completed while you type, or with Ctrl+Space"));
  this->Rules->setMaximumHeight((visibleLines + 1) * this->fontMetrics().lineSpacing());
  this->Tolerance->setPlaceholderText(tr("none"));
  this->Tolerance->setToolTip(tr("Elements that may fail each rule that has no tolerance of its "
                                 "own, as a number or a percentage, "
                                 "such as 3 or 0.1%"));

  QHBoxLayout* choices = this->addRow();
  choices->addWidget(this->Preset, 1);
  this->EditPreset = this->addTool(choices, "EditPreset",
    tr("Write the rules of the preset into the editor, to change them"),
    [this] { this->editPreset(); });
  this->addTool(choices, "OpenRules", tr("Open a file of rules"), [this] { this->openRules(); });
  this->addTool(choices, "SaveRules", tr("Save the rules"), [this] { this->saveRules(); });
  this->contentLayout()->addWidget(this->Rules);
  QHBoxLayout* bottom = this->addRow();
  bottom->addWidget(new QLabel(tr("Tolerate"), this->content()));
  bottom->addWidget(this->Tolerance, 1);
  bottom->addWidget(this->Check);
  this->contentLayout()->addWidget(this->Verdict);
  this->contentLayout()->addWidget(this->Table);
  this->Verdict->hide();
  this->Table->hide();

  QObject::connect(this->Check, &QPushButton::clicked, this, &pqCheckCard::check);
  QObject::connect(this->Tolerance, &QLineEdit::returnPressed, this, &pqCheckCard::check);
  QObject::connect(this->Rules, &pqRulesEditor::textChanged, this, &pqCheckCard::forget);
  QObject::connect(this->Tolerance, &QLineEdit::textChanged, this, &pqCheckCard::forget);
  QObject::connect(this->Preset, &QComboBox::currentIndexChanged, this, &pqCheckCard::forget);
  QObject::connect(this->Preset, &QComboBox::currentIndexChanged, this, &pqCheckCard::enableEdit);
  for (const auto signal : { &QTableView::clicked, &QTableView::activated })
  {
    QObject::connect(this->Table, signal, this,
      [this](const QModelIndex& index) { this->selectFailing(index.row()); });
  }
  QObject::connect(this->questions(), &pqMeshQuestions::registryChanged, this,
    [this]
    {
      const QSignalBlocker blocker(this->Preset);
      this->Preset->clear(); // of another server
      this->refreshWhenVisible();
    });
  QObject::connect(state, &pqInspectorState::ruleAdded, this,
    [this](const QString& line)
    {
      this->Rules->appendPlainText(line);
      this->setOpen(true);
    });
}

//------------------------------------------------------------------------------
QString pqCheckCard::counts() const
{
  const PanelTable& table = this->Result.Verdicts;
  QStringList counts;
  for (int row = 0; row < table.size(); ++row)
  {
    counts << table.text(row, "Failing") + '/' + table.text(row, "Checked");
  }
  return counts.join(' ');
}

//------------------------------------------------------------------------------
void pqCheckCard::refresh()
{
  if (this->Preset->count() <= 1)
  {
    camaron::FillPresets(this->Preset, tr("No preset"), this->questions()->presets());
  }
  this->grayPresets(this->Preset);
  this->enableEdit();
  camaron::RuleWords words;
  for (const camaron::CriterionInfo& info : this->questions()->criteria())
  {
    const QPair<QString, QString> criterion(info.Name, info.Label);
    if (!words.Criteria.contains(criterion)) // of several elements
    {
      words.Criteria << criterion;
    }
  }
  for (const camaron::PresetInfo& preset : this->questions()->presets())
  {
    words.Presets << preset.Name;
  }
  words.GroupArrays = this->questions()->groupArrays();
  this->Rules->setWords(words);
  this->Check->setEnabled(this->mesh()->port() != nullptr);
  const bool isOther = this->mesh()->meshVersion() != this->CheckedMesh;
  if (isOther ||
    (!this->LastVerdict.isEmpty() &&
      this->Checked.Options != this->questions()->evaluationOptions()))
  { // the verdicts are those of another mesh, or of another evaluation
    this->forget();
  }
}

//------------------------------------------------------------------------------
void pqCheckCard::forget()
{
  this->Result = {};
  this->state()->setChecked({});
  this->Rules->showProblems({});
  this->Verdicts->setTable({});
  this->Table->hide();
  this->LastVerdict.clear();
  camaron::ShowText(this->Verdict, QString());
}

//------------------------------------------------------------------------------
QString pqCheckCard::rules() const
{
  const QString line = this->Preset->currentIndex() > 0
    ? QString("preset \"%1\"").arg(this->Preset->currentText())
    : QString();
  const QString text = this->Rules->toPlainText();
  // The last line, so that problems are at the lines of the editor.
  return line.isEmpty() ? text : text + '\n' + line;
}

//------------------------------------------------------------------------------
void pqCheckCard::check()
{
  const pqScopedOverrideCursor waiting(Qt::WaitCursor);
  this->Checked.Rules = this->rules();
  this->CheckedMesh = this->mesh()->meshVersion();
  this->Checked.Tolerate = this->Tolerance->text().trimmed();
  this->Checked.Options = this->questions()->evaluationOptions();
  this->Result = this->questions()->check(this->Checked);
  this->state()->setChecked(
    this->Result.Problems.isEmpty() ? this->Checked : camaron::CheckRequest());
  this->Verdicts->setTable(SortByVerdict(this->Result.Verdicts));
  this->Table->setVisible(!this->Result.Verdicts.isEmpty());
  this->showResult();
}

//------------------------------------------------------------------------------
void pqCheckCard::recolor()
{
  if (!this->LastVerdict.isEmpty())
  {
    this->showResult();
  }
}

//------------------------------------------------------------------------------
void pqCheckCard::showResult()
{
  const camaron::CheckResult& result = this->Result;
  this->LastVerdict = result.Verdict;
  this->Rules->showProblems(result.Problems);
  if (!result.Problems.isEmpty())
  {
    QStringList lines;
    for (int row = 0; row < result.Problems.size(); ++row)
    {
      const QString line = result.Problems.text(row, "Line"); // 0: of no rule
      const QString text = result.Problems.text(row, "Text");
      lines << (line != "0"                  ? tr("Line %1: %2").arg(line, text)
          : this->Checked.Tolerate.isEmpty() ? text
                                             : tr("Tolerate: %1").arg(text));
    }
    this->LastVerdict = lines.join('\n');
    camaron::ShowText(this->Verdict,
      QString("<span style=\"color:%1\">%2</span>")
        .arg(camaron::PanelColors(this->palette()).Fails.name(),
          this->LastVerdict.toHtmlEscaped().replace('\n', "<br/>")));
    return;
  }
  int failing = 0, passing = 0;
  for (int row = 0; row < result.Verdicts.size(); ++row)
  {
    failing += result.Verdicts.text(row, "Verdict") == "fail" ? 1 : 0;
    passing += result.Verdicts.text(row, "Verdict") == "pass" ? 1 : 0;
  }
  const QColor color = GetColor(result.Verdict, this->palette());
  const QString word = result.Verdict == "fail"
    ? tr("FAIL: %1 of %2").arg(failing).arg(SpellRules(result.Verdicts.size()))
    : result.Verdict == "warn" ? tr("WARN: only hints (recommended ranges) are violated")
    : result.Verdict == "empty"
    ? tr("No verdict: none of the rules has a cell to check")
    : tr("PASS: %1 of %2").arg(passing).arg(SpellRules(result.Verdicts.size()));
  camaron::ShowText(this->Verdict,
    result.Verdicts.isEmpty() ? result.Error.toHtmlEscaped()
                              : QString("<b style=\"color:%1\">%2</b>").arg(color.name(), word));
}

//------------------------------------------------------------------------------
void pqCheckCard::enableEdit()
{
  camaron::SetEnabled(
    this->EditPreset, this->Preset->currentIndex() > 0, tr("No preset is chosen."));
}

//------------------------------------------------------------------------------
void pqCheckCard::editPreset()
{
  const camaron::PresetInfo preset =
    this->questions()->presets().value(this->Preset->currentIndex() - 1);
  this->Preset->setCurrentIndex(0);
  this->Rules->appendPlainText(preset.Rules.join('\n'));
}

//------------------------------------------------------------------------------
void pqCheckCard::selectFailing(int row)
{
  const pqScopedOverrideCursor waiting(Qt::WaitCursor);
  const PanelTable& table = this->Verdicts->table();
  if (table.integer(row, "Failing") > 0 && table.text(row, "ScopeBy") != "elements")
  {
    QMap<QString, QVariant> properties = this->Checked.Options;
    properties["Rules"] = table.text(row, "Text");
    this->selection()->selectBy("Failed rules", properties);
  }
  else
  {
    this->selection()->clear();
  }
  if (this->questions()->evaluated().contains(table.text(row, "Criterion")))
  {
    this->state()->chooseCriterion(table.text(row, "Criterion"));
  }
}

//------------------------------------------------------------------------------
void pqCheckCard::openRules()
{
  const QString path = camaron::AskForPath(this, "OpenRulesDialog", tr("Open Rules"), nullptr,
    tr("Rules (*.rules *.txt)"), pqFileDialog::ExistingFile);
  QFile file(path);
  if (!path.isEmpty() && file.open(QIODevice::ReadOnly))
  {
    this->Rules->setPlainText(QString::fromUtf8(file.read(LargestFile)));
    this->Preset->setCurrentIndex(0);
  }
  else if (!path.isEmpty())
  {
    camaron::ShowText(this->Verdict, tr("%1 cannot be read: %2").arg(path, file.errorString()));
  }
}

//------------------------------------------------------------------------------
void pqCheckCard::saveRules()
{
  const QString path = camaron::AskForPath(this, "SaveRulesDialog", tr("Save Rules"), nullptr,
    tr("Rules (*.rules)"), pqFileDialog::AnyFile);
  const QString error =
    path.isEmpty() ? QString() : this->filters()->writeText(path, this->rules().toUtf8() + '\n');
  if (!error.isEmpty())
  {
    camaron::ShowText(this->Verdict, error);
  }
}
