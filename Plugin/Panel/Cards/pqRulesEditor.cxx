// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRulesEditor.h"

#include "PanelColors.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QKeyEvent>
#include <QScrollBar>
#include <QStandardItemModel>
#include <QTextBlock>

namespace
{
constexpr int TextRole = Qt::UserRole + 1;
}

//------------------------------------------------------------------------------
pqRulesEditor::pqRulesEditor(QWidget* parent)
  : Superclass(parent)
  , Choices(new QStandardItemModel(this))
  , Completer(new QCompleter(this->Choices, this))
{
  this->setTabChangesFocus(true);
  this->Completer->setWidget(this);
  this->Completer->setWrapAround(false); // else no choice may be the current one
  this->Completer->setCompletionMode(QCompleter::UnfilteredPopupCompletion);
  this->Completer->popup()->setObjectName("RuleChoices");
  QObject::connect(this->Completer, QOverload<const QModelIndex&>::of(&QCompleter::activated), this,
    &pqRulesEditor::insert);
}

//------------------------------------------------------------------------------
void pqRulesEditor::keyPressEvent(QKeyEvent* event)
{
  const bool isShown = this->Completer->popup()->isVisible();
  const int key = event->key();
  if ((key == Qt::Key_Enter || key == Qt::Key_Return) && this->accept())
  {
    return;
  }
  const bool isRequest = key == Qt::Key_Space && event->modifiers() == Qt::ControlModifier;
  if (!isRequest)
  {
    Superclass::keyPressEvent(event);
  }
  const bool isTyped = !event->text().isEmpty() && event->text()[0].isPrint();
  if (isRequest || isTyped || (isShown && key == Qt::Key_Backspace))
  {
    this->offer();
  }
  else if (isShown && event->modifiers() == Qt::NoModifier)
  {
    this->Completer->popup()->hide();
  }
}

//------------------------------------------------------------------------------
bool pqRulesEditor::focusNextPrevChild(bool next)
{
  return this->accept() || Superclass::focusNextPrevChild(next);
}

//------------------------------------------------------------------------------
bool pqRulesEditor::accept()
{
  QAbstractItemView* list = this->Completer->popup();
  const QModelIndex choice = list->isVisible() ? list->currentIndex() : QModelIndex();
  list->hide();
  if (choice.isValid())
  {
    this->insert(choice);
  }
  return choice.isValid();
}

//------------------------------------------------------------------------------
QString pqRulesEditor::lineToCursor() const
{
  const QTextCursor cursor = this->textCursor();
  return cursor.block().text().left(cursor.positionInBlock());
}

//------------------------------------------------------------------------------
void pqRulesEditor::offer()
{
  const camaron::RuleCompletion completion =
    camaron::CompleteRule(this->lineToCursor(), this->Words);
  this->Choices->clear();
  for (const camaron::RuleCompletion::Choice& choice : completion.Choices)
  {
    auto* item = new QStandardItem(choice.Explanation.isEmpty()
        ? choice.Text
        : QString("%1  %2").arg(choice.Text, choice.Explanation));
    item->setData(choice.Text, TextRole);
    this->Choices->appendRow(item);
  }
  QAbstractItemView* list = this->Completer->popup();
  if (completion.Choices.isEmpty())
  {
    list->hide();
    return;
  }
  QRect place = this->cursorRect();
  place.setWidth(list->sizeHintForColumn(0) + list->verticalScrollBar()->sizeHint().width());
  this->Completer->complete(place);
  list->setCurrentIndex(this->Completer->completionModel()->index(0, 0));
}

//------------------------------------------------------------------------------
void pqRulesEditor::insert(const QModelIndex& index)
{
  const QString line = this->lineToCursor();
  const int start = camaron::CompleteRule(line, this->Words).Start;
  QTextCursor cursor = this->textCursor();
  cursor.movePosition(
    QTextCursor::Left, QTextCursor::KeepAnchor, static_cast<int>(line.size()) - start);
  cursor.insertText(index.data(TextRole).toString() + ' ');
  this->setTextCursor(cursor);
}

//------------------------------------------------------------------------------
QString pqRulesEditor::offered() const
{
  QStringList texts;
  for (int row = 0; this->Completer->popup()->isVisible() && row < this->Choices->rowCount(); ++row)
  {
    texts << this->Choices->item(row)->data(TextRole).toString();
  }
  return texts.join(", ");
}

//------------------------------------------------------------------------------
void pqRulesEditor::showProblems(const camaron::PanelTable& problems)
{
  QList<QTextEdit::ExtraSelection> marks;
  for (int row = 0; row < problems.size(); ++row)
  {
    if (problems.integer(row, "Line") == 0)
    {
      continue; // it is of no rule
    }
    const QTextBlock line =
      this->document()->findBlockByNumber(static_cast<int>(problems.integer(row, "Line")) - 1);
    QTextEdit::ExtraSelection mark;
    mark.cursor = QTextCursor(line);
    mark.cursor.select(QTextCursor::LineUnderCursor);
    mark.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
    mark.format.setUnderlineColor(camaron::PanelColors(this->palette()).Fails);
    mark.format.setToolTip(problems.text(row, "Text"));
    marks << mark;
  }
  this->setExtraSelections(marks);
}
