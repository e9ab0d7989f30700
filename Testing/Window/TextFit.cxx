// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextFit.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QStyleOptionComboBox>

namespace
{
//------------------------------------------------------------------------------
// Name of a widget below another one, such as Worst/Content/Rows.
QString GetPath(const QWidget* top, const QWidget* widget)
{
  QStringList names;
  for (; widget && widget != top; widget = widget->parentWidget())
  {
    names.prepend(
      widget->objectName().isEmpty() ? widget->metaObject()->className() : widget->objectName());
  }
  return names.join('/');
}

//------------------------------------------------------------------------------
int GetWidth(const QWidget* widget, const QString& text)
{
  return widget->fontMetrics().horizontalAdvance(text);
}

//------------------------------------------------------------------------------
bool IsLabelCut(const QLabel* label)
{
  if (label->text().isEmpty())
  {
    return false;
  }
  if (label->wordWrap())
  {
    return label->heightForWidth(label->width()) > label->height();
  }
  return label->sizeHint().width() > label->width() || label->sizeHint().height() > label->height();
}

//------------------------------------------------------------------------------
bool IsComboCut(const QComboBox* box)
{
  QStyleOptionComboBox option;
  option.initFrom(box);
  const QRect field =
    box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box);
  return GetWidth(box, box->currentText()) > field.width();
}

//------------------------------------------------------------------------------
bool IsEditCut(const QLineEdit* edit)
{
  constexpr int frame = 4;
  const QString text = edit->text().isEmpty() ? edit->placeholderText() : edit->displayText();
  return GetWidth(edit, text) > edit->width() - frame;
}

//------------------------------------------------------------------------------
// Cells of a table or tree that are elided, by what they show; those to which one scrolls are not.
QStringList FindCutItems(const QAbstractItemView* view, const QModelIndex& parent = {})
{
  QStringList cut;
  const QAbstractItemModel* model = view->model();
  for (int row = 0; model && row < model->rowCount(parent); ++row)
  {
    for (int column = 0; column < model->columnCount(parent); ++column)
    {
      const QModelIndex index = model->index(row, column, parent);
      const QRect shown = view->visualRect(index);
      if (shown.isEmpty() || !view->viewport()->rect().intersects(shown))
      {
        continue;
      }
      const QSize needed = view->sizeHintForIndex(index);
      if (needed.width() > shown.width() && needed.height() >= shown.height())
      {
        cut << index.data().toString();
      }
    }
    cut << FindCutItems(view, model->index(row, 0, parent));
  }
  return cut;
}

//------------------------------------------------------------------------------
QStringList FindCutHeaders(const QHeaderView* header)
{
  QStringList cut;
  for (int section = 0; section < header->count(); ++section)
  {
    const QString text = header->model()->headerData(section, header->orientation()).toString();
    if (GetWidth(header, text) > header->sectionSize(section))
    {
      cut << text;
    }
  }
  return cut;
}

//------------------------------------------------------------------------------
QStringList FindCutTextsOf(const QWidget* widget)
{
  if (const auto* label = qobject_cast<const QLabel*>(widget))
  {
    return IsLabelCut(label) ? QStringList(label->text()) : QStringList();
  }
  if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
  {
    const bool isCut = !button->text().isEmpty() && button->sizeHint().width() > button->width();
    return isCut ? QStringList(button->text()) : QStringList();
  }
  if (const auto* box = qobject_cast<const QComboBox*>(widget))
  {
    return IsComboCut(box) ? QStringList(box->currentText()) : QStringList();
  }
  if (const auto* edit = qobject_cast<const QLineEdit*>(widget))
  {
    const bool isInBox = qobject_cast<const QComboBox*>(edit->parentWidget());
    return !isInBox && IsEditCut(edit) ? QStringList(edit->text() + edit->placeholderText())
                                       : QStringList();
  }
  if (const auto* header = qobject_cast<const QHeaderView*>(widget))
  {
    return FindCutHeaders(header);
  }
  if (const auto* view = qobject_cast<const QAbstractItemView*>(widget))
  {
    return FindCutItems(view);
  }
  return {};
}
}

namespace camaron
{
//------------------------------------------------------------------------------
QStringList FindCutTexts(const QWidget* widget)
{
  QStringList cut;
  for (const QWidget* inner : widget->findChildren<QWidget*>())
  {
    if (!inner->isVisibleTo(widget))
    {
      continue;
    }
    for (const QString& text : FindCutTextsOf(inner))
    {
      cut << GetPath(widget, inner) + ": " + text;
    }
    if (inner->mapTo(widget, QPoint(inner->width(), 0)).x() > widget->width())
    {
      cut << GetPath(widget, inner) + " reaches beyond the right edge";
    }
  }
  return cut;
}
}
