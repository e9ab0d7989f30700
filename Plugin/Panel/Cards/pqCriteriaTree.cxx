// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqCriteriaTree.h"

#include "HistogramData.h"
#include "HistogramPainter.h"
#include "NumberText.h"
#include "PanelColors.h"

#include <QHeaderView>
#include <QMap>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyledItemDelegate>

#include <numeric>

Q_DECLARE_METATYPE(camaron::Distribution)

namespace
{
enum Column
{
  Label,
  Values,
  Outside
};
enum Verdict
{
  Passes,
  Warns,
  Fails
};
enum Role
{
  NameRole = Qt::UserRole,
  SearchRole,
  DistributionRole,
  VerdictRole
};

//------------------------------------------------------------------------------
// Wraps labels that are wider than their column.
class LabelDelegate : public QStyledItemDelegate
{
public:
  explicit LabelDelegate(pqCriteriaTree* tree)
    : QStyledItemDelegate(tree)
    , Tree(tree)
  {
  }

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
  {
    const bool isSpanned = this->Tree->isFirstColumnSpanned(index.row(), index.parent());
    const int depth = index.parent().isValid() ? 2 : 1;
    QStyleOptionViewItem placed = option;
    placed.rect.setWidth(
      (isSpanned ? this->Tree->viewport()->width() : this->Tree->columnWidth(Label)) -
      depth * this->Tree->indentation());
    placed.rect.setHeight(1); // of any height; an empty rectangle has no width either
    return this->QStyledItemDelegate::sizeHint(placed, index);
  }

private:
  pqCriteriaTree* Tree;
};

//------------------------------------------------------------------------------
// Draws the histogram of an item.
class HistogramDelegate : public QStyledItemDelegate
{
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override
  {
    constexpr int width = 56, margin = 4;
    return QSize(width, option.fontMetrics.height() + margin);
  }

  void paint(
    QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override
  {
    QStyledItemDelegate::paint(painter, option, index);
    const QVariant value = index.data(DistributionRole);
    if (value.isValid())
    {
      const auto shown = value.value<camaron::Distribution>();
      const QRect inner = option.rect.adjusted(2, 2, -2, -2);
      painter->fillRect(inner, option.palette.base()); // also of a selected row
      camaron::PaintSmallHistogram(
        painter, inner, shown.Histogram, shown.Low, shown.High, option.palette);
    }
  }
};

//------------------------------------------------------------------------------
// Colors a number by its verdict.
class VerdictDelegate : public QStyledItemDelegate
{
public:
  using QStyledItemDelegate::QStyledItemDelegate;

protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
  {
    QStyledItemDelegate::initStyleOption(option, index);
    const camaron::PanelColors colors(option->palette);
    const QVariant verdict = index.data(VerdictRole);
    if (verdict.isValid())
    {
      option->palette.setColor(QPalette::Text,
        verdict == Passes    ? colors.Passes
          : verdict == Warns ? colors.Warns
                             : colors.Fails);
    }
  }
};
}

//------------------------------------------------------------------------------
pqCriteriaTree::pqCriteriaTree(QWidget* parent)
  : Superclass(parent)
{
  this->setColumnCount(3);
  this->setHeaderLabels({ tr("Criterion"), tr("Values"), tr("Bad") });
  this->headerItem()->setToolTip(Outside,
    tr("Elements outside the acceptable range, or without a value where the criterion applies"));
  this->setItemDelegateForColumn(Label, new LabelDelegate(this));
  this->setItemDelegateForColumn(Values, new HistogramDelegate(this));
  this->setItemDelegateForColumn(Outside, new VerdictDelegate(this));
  this->setWordWrap(true); // of long labels
  this->setAlternatingRowColors(true);
  constexpr int indentation = 10;
  this->setIndentation(indentation);
  this->header()->setStretchLastSection(false);
  this->header()->setSectionResizeMode(Label, QHeaderView::Stretch);
  this->header()->setSectionResizeMode(Values, QHeaderView::ResizeToContents);
  this->header()->setSectionResizeMode(Outside, QHeaderView::ResizeToContents);
  QObject::connect(this->header(), &QHeaderView::sectionResized, this,
    [this](int column)
    {
      if (column == Label)
      {
        this->scheduleDelayedItemsLayout(); // heights of wrapped labels
      }
    });
  QObject::connect(this, &QTreeWidget::itemChanged, this,
    [this](QTreeWidgetItem*, int column)
    {
      if (column == Label)
      {
        Q_EMIT this->ticksChanged();
      }
    });
  const auto choose = [this](const QTreeWidgetItem* item)
  {
    const QString name = item ? item->data(Label, NameRole).toString() : QString();
    if (!name.isEmpty())
    {
      Q_EMIT this->criterionChosen(name);
    }
  };
  QObject::connect(this, &QTreeWidget::currentItemChanged, this, choose);
  // Once more for the current one: perhaps the mesh has other colors meanwhile.
  QObject::connect(this, &QTreeWidget::itemClicked, this,
    [this, choose](QTreeWidgetItem* item, int column)
    {
      choose(item);
      if (column == Outside && item->font(Outside).underline())
      {
        Q_EMIT this->failingChosen(item->data(Label, NameRole).toString());
      }
    });
}

//------------------------------------------------------------------------------
void pqCriteriaTree::setCriteria(
  const QVector<camaron::CriterionInfo>& criteria, const QString& element)
{
  const QSignalBlocker blocker(this);
  this->clear();
  this->Criteria.clear();
  QMap<QString, QTreeWidgetItem*> families;
  for (const camaron::CriterionInfo& info : criteria)
  {
    if (info.Element != element)
    {
      continue;
    }
    this->Criteria << info;
    QTreeWidgetItem* parent = this->invisibleRootItem();
    if (!info.Family.isEmpty())
    {
      QTreeWidgetItem*& family = families[info.Family];
      if (!family)
      {
        family = new QTreeWidgetItem(this, { info.Family });
        family->setFlags(Qt::ItemIsEnabled);
        family->setFirstColumnSpanned(true);
        family->setExpanded(true);
        QFont bold = this->font();
        bold.setBold(true);
        family->setFont(Label, bold);
      }
      parent = family;
    }
    auto* item = new QTreeWidgetItem(parent, { info.Label });
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(Label, Qt::Unchecked);
    item->setToolTip(Label, info.toolTip());
    item->setData(Label, NameRole, info.Name);
    item->setData(Label, SearchRole, info.Label + ' ' + info.Name + ' ' + info.Description);
    item->setTextAlignment(Outside, Qt::AlignRight | Qt::AlignVCenter);
  }
}

//------------------------------------------------------------------------------
QList<QTreeWidgetItem*> pqCriteriaTree::items() const
{
  QList<QTreeWidgetItem*> found;
  for (int i = 0; i < this->topLevelItemCount(); ++i)
  {
    QTreeWidgetItem* top = this->topLevelItem(i);
    if (!top->data(Label, NameRole).toString().isEmpty())
    {
      found << top;
    }
    for (int k = 0; k < top->childCount(); ++k)
    {
      found << top->child(k);
    }
  }
  return found;
}

//------------------------------------------------------------------------------
QStringList pqCriteriaTree::ticks() const
{
  QStringList names;
  for (const QTreeWidgetItem* item : this->items())
  {
    if (item->checkState(Label) == Qt::Checked)
    {
      names << item->data(Label, NameRole).toString();
    }
  }
  return names;
}

//------------------------------------------------------------------------------
void pqCriteriaTree::setTicks(const QStringList& names)
{
  const QSignalBlocker blocker(this);
  for (QTreeWidgetItem* item : this->items())
  {
    const bool isTicked = names.contains(item->data(Label, NameRole).toString());
    item->setCheckState(Label, isTicked ? Qt::Checked : Qt::Unchecked);
  }
  this->viewport()->update();
}

//------------------------------------------------------------------------------
void pqCriteriaTree::setTicksText(const QString& text)
{
  this->setTicks(text.split(' ', Qt::SkipEmptyParts));
  Q_EMIT this->ticksChanged();
}

//------------------------------------------------------------------------------
void pqCriteriaTree::setDistributions(const QVector<camaron::Distribution>& distributions,
  const QString& elements, const QStringList& own)
{
  const QSignalBlocker blocker(this);
  QMap<QString, const camaron::Distribution*> known;
  for (const camaron::Distribution& shown : distributions)
  {
    known[shown.Array] = &shown;
  }
  QMap<QString, const camaron::CriterionInfo*> infos;
  for (const camaron::CriterionInfo& info : this->Criteria)
  {
    infos[info.Name] = &info;
  }
  for (QTreeWidgetItem* item : this->items())
  {
    const QString name = item->data(Label, NameRole).toString();
    const camaron::Distribution* shown = known.value(name);
    item->setData(Values, DistributionRole, shown ? QVariant::fromValue(*shown) : QVariant());
    item->setFirstColumnSpanned(!shown || shown->Undefined == shown->Count);
    item->setText(Outside, QString());
    item->setToolTip(Outside, QString());
    item->setData(Outside, VerdictRole, QVariant());
    QFont font = this->font();
    item->setFont(Outside, font);
    if (shown && shown->Judged > 0 && shown->hasRange())
    {
      const qint64 failing = shown->failing();
      const bool warns = infos[name]->IsHint && !own.contains(name);
      const Verdict bad = warns ? Warns : Fails;
      item->setText(Outside, failing == 0 ? QString("✔") : camaron::GroupedInteger(failing));
      font.setUnderline(failing > 0); // as a link
      item->setFont(Outside, font);
      item->setData(Outside, VerdictRole, failing == 0 ? Passes : bad);
      item->setToolTip(Outside,
        tr(failing == 0 ? "%1 of %2 %3: %4" : "%1 of %2 %3: %4; click to select them")
          .arg(camaron::GroupedInteger(failing), camaron::GroupedInteger(shown->Count), elements,
            failing == 0 ? tr("pass")
              : warns    ? tr("warning")
                         : tr("fail")));
    }
  }
  this->viewport()->update();
}

//------------------------------------------------------------------------------
QString pqCriteriaTree::badCounts() const
{
  QStringList counts;
  for (const QTreeWidgetItem* item : this->items())
  {
    const QVariant verdict = item->data(Outside, VerdictRole);
    if (verdict.isValid() && verdict.toInt() != Passes)
    {
      counts << item->data(Label, NameRole).toString() + ' ' + item->text(Outside);
    }
  }
  return counts.join(", ");
}

//------------------------------------------------------------------------------
QString pqCriteriaTree::selectedCounts() const
{
  QStringList counts;
  for (const QTreeWidgetItem* item : this->items())
  {
    const QVariant value = item->data(Values, DistributionRole);
    const auto data = value.value<camaron::Distribution>().Histogram;
    const std::vector<qint64>& selected = data.Selected.Counts;
    if (!selected.empty())
    {
      counts << QString::number(std::accumulate(selected.begin(), selected.end(), qint64(0)));
    }
  }
  counts.removeDuplicates();
  return counts.join(' ');
}

//------------------------------------------------------------------------------
void pqCriteriaTree::setCurrentCriterion(const QString& name)
{
  const QSignalBlocker blocker(this);
  for (QTreeWidgetItem* item : this->items())
  {
    if (item->data(Label, NameRole).toString() == name)
    {
      this->setCurrentItem(item);
      return;
    }
  }
  this->setCurrentItem(nullptr);
}

//------------------------------------------------------------------------------
void pqCriteriaTree::search(const QString& text)
{
  const QStringList words = text.split(' ', Qt::SkipEmptyParts);
  for (QTreeWidgetItem* item : this->items())
  {
    bool isFound = true;
    for (const QString& word : words)
    {
      isFound =
        isFound && item->data(Label, SearchRole).toString().contains(word, Qt::CaseInsensitive);
    }
    item->setHidden(!isFound);
  }
  for (int i = 0; i < this->topLevelItemCount(); ++i)
  {
    QTreeWidgetItem* family = this->topLevelItem(i);
    bool hasVisible = family->childCount() == 0 && !family->isHidden();
    for (int k = 0; k < family->childCount(); ++k)
    {
      hasVisible = hasVisible || !family->child(k)->isHidden();
    }
    family->setHidden(!hasVisible);
  }
  if (!words.isEmpty())
  {
    this->scrollToTop(); // the first hit
  }
}
