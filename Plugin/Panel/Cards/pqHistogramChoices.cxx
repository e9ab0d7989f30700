// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The choices above the histogram.
#include "pqHistogramCard.h"
#include "pqHistogramPlot.h"
#include "pqInspectedMesh.h"
#include "pqMeshQuestions.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

//------------------------------------------------------------------------------
void pqHistogramCard::makeToolBar()
{
  QHBoxLayout* choices = this->addRow();
  choices->addWidget(this->Criterion, 2);
  choices->addWidget(this->Group, 1);
  this->Criterion->setToolTip(tr("Criterion or cell array whose distribution is shown"));
  this->Group->setToolTip(
    tr("Stack the bars by cell type, block, or an array of integers or texts"));
  for (QComboBox* box : { this->Criterion, this->Group })
  {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(8);
  }

  QHBoxLayout* tools = this->addRow();
  QToolButton* logValues = this->addTool(tools, "LogValues", tr("Logarithmic axis of values"));
  QToolButton* logCounts = this->addTool(tools, "LogCounts",
    tr("Logarithmic axis of counts. Groups are lines at their own counts, because heights do not "
       "add "
       "up on it."));
  QToolButton* cumulative = this->addTool(tools, "Cumulative", tr("Cumulative curve"));
  for (QToolButton* tool : { logValues, logCounts, cumulative })
  {
    tool->setCheckable(true);
  }
  this->Outline = this->addTool(tools, "Outline", tr("Outline of another mesh behind the bars"));
  this->CopyRule = this->addTool(tools, "CopyRule",
    tr("Copy the range as a rule for `camaron check`, and add it to the Check card"),
    [this] { this->copyRule(); });
  tools->addStretch();
  tools->addWidget(new QLabel(tr("Bins"), this->content()));
  tools->addWidget(this->Bins);
  constexpr int maximum = 1000;
  this->Bins->setRange(1, maximum);
  this->Bins->setValue(this->Request.Bins);
  this->Bins->setKeyboardTracking(false);
  this->Bins->setToolTip(tr("Number of bins; integer criteria have a bin per value"));
  this->Outline->setPopupMode(QToolButton::InstantPopup);
  this->Outline->setMenu(new QMenu(this->Outline));

  QObject::connect(this->Criterion, &QComboBox::currentIndexChanged, this,
    [this] { this->state()->chooseCriterion(this->Criterion->currentData().toString()); });
  QObject::connect(this->Group, &QComboBox::currentIndexChanged, this,
    [this]
    {
      const QStringList chosen = this->Group->currentData().toStringList();
      this->Request.GroupBy = chosen.value(0);
      this->Request.GroupArray = chosen.value(1);
      this->showDistribution();
    });
  QObject::connect(this->Bins, &QSpinBox::valueChanged, this,
    [this](int bins)
    {
      this->Request.Bins = bins;
      this->showDistribution();
    });
  QObject::connect(logValues, &QToolButton::toggled, this,
    [this](bool on)
    {
      this->Request.Logarithmic = on;
      this->Request.Range.reset();
      this->showDistribution();
    });
  QObject::connect(
    logCounts, &QToolButton::toggled, this->Plot, &pqHistogramPlot::setLogarithmicCounts);
  QObject::connect(cumulative, &QToolButton::toggled, this->Plot, &pqHistogramPlot::setCumulative);
  QObject::connect(
    this->Outline->menu(), &QMenu::aboutToShow, this, &pqHistogramCard::fillOutlines);
}

//------------------------------------------------------------------------------
void pqHistogramCard::fillCriteria()
{
  const QSignalBlocker blocker(this->Criterion);
  this->Criterion->clear();
  if (this->state()->awaitsElements())
  {
    return;
  }
  for (const QString& name : this->questions()->evaluated())
  {
    const camaron::CriterionInfo* info = this->questions()->criterion(name);
    this->Criterion->addItem(info ? info->Label : name, name);
    if (info)
    {
      this->Criterion->setItemData(this->Criterion->count() - 1, info->toolTip(), Qt::ToolTipRole);
    }
  }
  const QStringList others = this->questions()->otherArrays();
  if (this->Criterion->count() > 0 && !others.isEmpty())
  {
    this->Criterion->insertSeparator(this->Criterion->count());
  }
  for (const QString& name : others)
  {
    this->Criterion->addItem(name, name);
    this->Criterion->setItemData(
      this->Criterion->count() - 1, tr("Cell array of the mesh"), Qt::ToolTipRole);
  }
  this->Criterion->setCurrentIndex(this->Criterion->findData(this->state()->criterion()));
}

//------------------------------------------------------------------------------
void pqHistogramCard::fillGroups()
{
  const QSignalBlocker blocker(this->Group);
  const QStringList before = { this->Request.GroupBy, this->Request.GroupArray };
  this->Group->clear();
  this->Group->addItem(tr("All %1").arg(this->mesh()->elements()), QStringList{ "None", "" });
  this->Group->addItem(tr("By cell type"), QStringList{ "Cell type", "" });
  if (this->questions()->summary().Blocks > 0)
  {
    this->Group->addItem(tr("By block"), QStringList{ "Block", "" });
  }
  for (const QString& array : this->questions()->groupArrays())
  {
    this->Group->addItem(tr("By %1").arg(array), QStringList{ "Cell array", array });
  }
  const int place = this->Group->findData(before);
  this->Group->setCurrentIndex(qMax(place, 0));
  if (place < 0)
  {
    this->Request.GroupBy = "None";
    this->Request.GroupArray.clear();
  }
}

//------------------------------------------------------------------------------
void pqHistogramCard::fillOutlines()
{
  QMenu* menu = this->Outline->menu();
  menu->clear();
  const auto add = [&](const QString& label, pqOutputPort* source)
  {
    QAction* action = menu->addAction(label);
    action->setCheckable(true);
    action->setChecked(source == this->OutlineSource);
    QObject::connect(action, &QAction::triggered, this,
      [this, source = QPointer<pqOutputPort>(source)]
      {
        this->OutlineSource = source;
        this->showOutline();
      });
  };
  add(tr("None"), nullptr);
  for (const auto& [name, port] : this->questions()->otherMeshes(this->state()->criterion()))
  {
    add(name, port);
  }
}
