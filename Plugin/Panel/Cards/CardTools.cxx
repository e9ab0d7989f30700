// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CardTools.h"

#include "NumberText.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QCoreApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QToolButton>

#include <algorithm>

namespace
{
//------------------------------------------------------------------------------
// Divides its width among the columns.
class CardTable : public QTableView
{
public:
  CardTable(const camaron::TableShape& shape, pqTableModel* model, QWidget* parent)
    : QTableView(parent)
    , Shape(shape)
  {
    this->setModel(model);
    QObject::connect(model, &QAbstractItemModel::modelReset, this, [this] { this->fitColumns(); });
  }

protected:
  void resizeEvent(QResizeEvent* event) override
  {
    this->QTableView::resizeEvent(event);
    this->fitColumns();
  }

  void keyPressEvent(QKeyEvent* event) override
  {
    if (event->key() == Qt::Key_Space && this->currentIndex().isValid())
    {
      Q_EMIT this->activated(this->currentIndex());
      return;
    }
    this->QTableView::keyPressEvent(event);
  }

private:
  int widthOfContents(int column) const
  {
    return std::max(
      this->sizeHintForColumn(column), this->horizontalHeader()->sectionSizeHint(column));
  }

  void fitColumns()
  {
    const int width = this->viewport()->width();
    const int most = this->Shape.Characters > 0 ? width / 2 : width; // else texts break into lines
    int before = 0, others = 0;                                      // widths of columns
    for (int column = 0; column < this->model()->columnCount(); ++column)
    {
      if (column != this->Shape.WideColumn)
      {
        this->setColumnWidth(column, std::min(this->widthOfContents(column), most));
        others += this->columnWidth(column);
        before += column < this->Shape.WideColumn ? this->columnWidth(column) : 0;
      }
    }
    int least = this->widthOfContents(this->Shape.WideColumn);
    if (this->Shape.Characters > 0)
    {
      least = std::min(least, this->Shape.Characters * this->fontMetrics().averageCharWidth());
    }
    this->setColumnWidth(this->Shape.WideColumn,
      width - others >= least ? width - others : std::max(least, width - before));
    if (this->Shape.Characters > 0)
    {
      this->resizeRowsToContents();
    }
    if (this->Shape.ShrinksToRows)
    {
      this->fitHeight();
    }
  }

  void fitHeight()
  {
    const int rows = this->verticalHeader()->length();
    const int most = this->Shape.Rows * this->verticalHeader()->defaultSectionSize();
    this->setFixedHeight(std::min(rows, most) + this->horizontalHeader()->sizeHint().height() +
      this->horizontalScrollBar()->sizeHint().height() + 2 * this->frameWidth());
  }

  camaron::TableShape Shape;
};

//------------------------------------------------------------------------------
// Draws a second line of an item in the list of a combo box, from PurposeRole.
constexpr int PurposeRole = Qt::UserRole + 1;
constexpr int DescriptionRole = PurposeRole + 1;
class PurposeDelegate : public QStyledItemDelegate
{
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
  {
    const QString purpose = index.data(PurposeRole).toString();
    QSize size = this->QStyledItemDelegate::sizeHint(option, index);
    if (!purpose.isEmpty())
    {
      size.setWidth(
        std::max(size.width(), option.fontMetrics.horizontalAdvance(purpose) + 2 * Margin));
      size.rheight() += option.fontMetrics.height() + 2 * Margin;
    }
    return size;
  }

  void paint(
    QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
  {
    const QString purpose = index.data(PurposeRole).toString();
    if (purpose.isEmpty())
    {
      this->QStyledItemDelegate::paint(painter, option, index);
      return;
    }
    QStyleOptionViewItem background = option;
    this->initStyleOption(&background, index);
    background.text.clear();
    option.widget->style()->drawControl(
      QStyle::CE_ItemViewItem, &background, painter, option.widget);
    const bool isSelected = option.state & QStyle::State_Selected;
    const auto group = option.state & QStyle::State_Enabled ? QPalette::Active : QPalette::Disabled;
    QColor color =
      option.palette.color(group, isSelected ? QPalette::HighlightedText : QPalette::Text);
    const QRect inner = option.rect.adjusted(Margin, Margin, -Margin, -Margin);
    painter->save();
    painter->setPen(color);
    painter->drawText(inner, Qt::AlignLeft | Qt::AlignTop, index.data().toString());
    constexpr double pale = 0.7;
    color.setAlphaF(pale);
    painter->setPen(color);
    painter->drawText(inner, Qt::AlignLeft | Qt::AlignBottom, purpose);
    painter->restore();
  }

private:
  static constexpr int Margin = 3;
};
}

namespace camaron
{
//------------------------------------------------------------------------------
QTableView* MakeTable(
  QWidget* parent, const char* name, pqTableModel* model, const TableShape& shape)
{
  auto* view = Make<CardTable>(parent, name, shape, model);
  view->setSelectionBehavior(QAbstractItemView::SelectRows);
  view->setSelectionMode(QAbstractItemView::SingleSelection);
  view->setEditTriggers(QAbstractItemView::NoEditTriggers);
  view->setWordWrap(shape.Characters > 0);
  view->setTabKeyNavigation(false); // Tab leaves the table
  view->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  view->setShowGrid(false);
  view->setAlternatingRowColors(true);
  view->verticalHeader()->hide();
  const int height = view->fontMetrics().height() + 4;
  view->verticalHeader()->setDefaultSectionSize(height);
  view->verticalHeader()->setMinimumSectionSize(height);
  view->horizontalHeader()->setHighlightSections(false);
  view->setFixedHeight((shape.Rows + 2) * height);
  return view;
}

//------------------------------------------------------------------------------
QToolButton* MakeTool(QWidget* parent, const char* name, const QString& tip)
{
  auto* button = Make<QToolButton>(parent, name);
  button->setIcon(PanelIcon(name));
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setAutoRaise(true);
  return button;
}

//------------------------------------------------------------------------------
void SetEnabled(QWidget* widget, bool isEnabled, const QString& reason)
{
  constexpr const char* tipName = "ToolTipIfEnabled";
  if (!widget->property(tipName).isValid())
  {
    widget->setProperty(tipName, widget->toolTip());
  }
  const QString tip = widget->property(tipName).toString();
  widget->setEnabled(isEnabled);
  widget->setToolTip(isEnabled ? tip : tip + "\n" + reason);
}

//------------------------------------------------------------------------------
QLabel* MakeText(QWidget* parent, const char* name, bool hasLinks)
{
  auto* label = Make<QLabel>(parent, name);
  label->setWordWrap(true);
  // Links make it a stop of the Tab key.
  label->setTextInteractionFlags(hasLinks ? Qt::TextBrowserInteraction : Qt::TextSelectableByMouse);
  return label;
}

//------------------------------------------------------------------------------
void ShowText(QLabel* label, const QString& text)
{
  label->setText(text);
  label->setVisible(!text.isEmpty());
}

//------------------------------------------------------------------------------
void FillPresets(QComboBox* box, const QString& none, const QVector<PresetInfo>& presets)
{
  const QSignalBlocker blocker(box);
  const QString before = box->currentText();
  box->clear();
  box->addItem(none);
  for (const PresetInfo& preset : presets)
  {
    const int place = box->count();
    box->addItem(preset.Name, preset.Criteria);
    box->setItemData(place, preset.Description, DescriptionRole);
  }
  GrayPresets(box, {});
  if (!dynamic_cast<PurposeDelegate*>(box->itemDelegate()))
  {
    box->setItemDelegate(new PurposeDelegate(box));
  }
  box->view()->setMinimumWidth(box->view()->sizeHintForColumn(0));
  box->setCurrentIndex(std::max(0, box->findText(before)));
}

//------------------------------------------------------------------------------
QString SpellWork(double seconds)
{
  constexpr double worthTelling = 1;
  return seconds < worthTelling
    ? QCoreApplication::translate("CardTools", "Evaluating...")
    : QCoreApplication::translate("CardTools", "Evaluating: about %1").arg(FormatDuration(seconds));
}

//------------------------------------------------------------------------------
void GrayPresets(QComboBox* box, const QMap<QString, QString>& reasons)
{
  auto* items = qobject_cast<QStandardItemModel*>(box->model());
  box->setProperty("grayed", reasons.keys().join(", ")); // for GUI tests
  for (int place = 1; items && place < items->rowCount(); ++place)
  {
    static const QRegularExpression end("[.,:;]");
    QStandardItem* item = items->item(place);
    const QString reason = reasons.value(item->text());
    const bool isFit = reason.isEmpty();
    const QString description = item->data(DescriptionRole).toString();
    item->setEnabled(isFit);
    item->setToolTip(description);
    item->setData(isFit ? description.section(end, 0, 0) : reason, PurposeRole);
  }
}

//------------------------------------------------------------------------------
QString AskForPath(QWidget* parent, const char* name, const QString& title, pqServer* server,
  const QString& filters, pqFileDialog::FileMode mode)
{
  pqFileDialog dialog(server, parent, title, QString(), filters, false);
  dialog.setObjectName(name);
  dialog.setFileMode(mode);
  return dialog.exec() == QDialog::Accepted ? dialog.getSelectedFiles().value(0) : QString();
}
}
