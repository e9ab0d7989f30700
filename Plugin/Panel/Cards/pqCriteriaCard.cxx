// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqCriteriaCard.h"

#include "CardTools.h"
#include "MeshColors.h"
#include "NumberText.h"
#include "pqCriteriaTree.h"
#include "pqInspectedMesh.h"
#include "pqMeshDisplay.h"
#include "pqMeshFilters.h"
#include "pqMeshQuestions.h"
#include "pqMeshSelection.h"

#include "pqScopedOverrideCursor.h"
#include "pqSearchBox.h"
#include "pqUndoStack.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSet>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <initializer_list>

namespace
{
constexpr int DelayMilliseconds = 500;  // for several ticks in a row
constexpr int PictureMilliseconds = 20; // more than ParaView waits before it draws
constexpr double LongSeconds = 5;       // worth a line
}

//------------------------------------------------------------------------------
pqCriteriaCard::pqCriteriaCard(pqInspectorState* state, QWidget* parent)
  : Superclass("Criteria", tr("Criteria"), true, state, parent)
  , Elements(camaron::Make<QComboBox>(this->content(), "Elements"))
  , Preset(camaron::Make<QComboBox>(this->content(), "Preset"))
  , Search(camaron::Make<pqSearchBox>(this->content(), "Search"))
  , Tree(camaron::Make<pqCriteriaTree>(this->content(), "Tree"))
  , Cost(camaron::MakeText(this->content(), "Cost"))
  , Evaluate(camaron::Make<QPushButton>(this->content(), "Evaluate", tr("Evaluate")))
{
  this->Elements->addItem(tr("Cells"), "Cell");
  this->Elements->addItem(tr("Faces"), "Face");
  this->Elements->addItem(tr("Edges"), "Edge");
  this->Elements->addItem(tr("Vertices"), "Vertex");
  this->Elements->setToolTip(
    tr("Elements to evaluate. Faces, edges and vertices become cells of Mesh Elements."));
  this->Preset->setToolTip(tr("Ticks the criteria of a preset"));
  this->Search->setPlaceholderText(tr("Search criteria"));
  constexpr int visibleRows = 6;
  this->Tree->setMinimumHeight(visibleRows * (this->fontMetrics().height() + 4));
  this->Evaluate->setToolTip(tr("Evaluates the ticked criteria with one filter in the pipeline"));

  QHBoxLayout* choices = this->addRow();
  choices->addWidget(this->Elements);
  choices->addWidget(this->Preset, 1);
  choices->addWidget(this->Search, 1);
  this->contentLayout()->addWidget(this->Tree);
  QHBoxLayout* bottom = this->addRow();
  bottom->addWidget(this->Cost, 1);
  bottom->addWidget(this->Evaluate);
  this->Delay.setSingleShot(true);
  this->Delay.setInterval(DelayMilliseconds);
  this->AfterPicture.setSingleShot(true);
  this->AfterPicture.setInterval(PictureMilliseconds);

  QObject::connect(&this->Delay, &QTimer::timeout, this, &pqCriteriaCard::evaluate);
  QObject::connect(this->Evaluate, &QPushButton::clicked, this, &pqCriteriaCard::evaluate);
  QObject::connect(this->Search, &pqSearchBox::textChanged, this->Tree, &pqCriteriaTree::search);
  QObject::connect(this->Tree, &pqCriteriaTree::ticksChanged, this,
    [this]
    {
      this->showPreset();
      this->onTicksChanged();
    });
  QObject::connect(this->Tree, &pqCriteriaTree::criterionChosen, this, &pqCriteriaCard::choose);
  QObject::connect(this->Tree, &pqCriteriaTree::failingChosen, this,
    [this](const QString& name)
    {
      const pqScopedOverrideCursor waiting(Qt::WaitCursor);
      this->selection()->selectOutside(name, this->state()->userLimitsOf(name));
    });
  QObject::connect(this->Elements, &QComboBox::currentIndexChanged, this,
    [this]
    {
      this->fillTree();
      this->filters()->showElements(this->elementType());
      this->state()->setElements(this->elementType());
      this->refreshWhenVisible();
    });
  QObject::connect(
    this->Preset, &QComboBox::currentIndexChanged, this, &pqCriteriaCard::tickPreset);
  QObject::connect(this->questions(), &pqMeshQuestions::registryChanged, this,
    [this]
    {
      this->Tree->clear();
      this->refreshWhenVisible();
    });
  const auto showLater = [this]
  {
    if (this->isVisible() && this->isOpen() && this->state()->mayCompute())
    {
      this->AfterPicture.start();
    }
  };
  QObject::connect(this->selection(), &pqMeshSelection::selectionChanged, this, showLater);
  QObject::connect(state, &pqInspectorState::limitsChanged, this, showLater);
  QObject::connect(&this->AfterPicture, &QTimer::timeout, this, &pqCriteriaCard::showDistributions);
  QObject::connect(state, &pqInspectorState::criterionChanged, this,
    [this] { this->Tree->setCurrentCriterion(this->state()->criterion()); });
}

//------------------------------------------------------------------------------
QString pqCriteriaCard::elementType() const
{
  return this->Elements->currentData().toString();
}

//------------------------------------------------------------------------------
void pqCriteriaCard::fillTree()
{
  camaron::FillPresets(this->Preset, tr("Preset..."), this->questions()->presets());
  this->Tree->setCriteria(this->questions()->criteria(), this->elementType());
  this->Search->setText(QString());
  this->HasUserTicks = false;
}

//------------------------------------------------------------------------------
void pqCriteriaCard::refresh()
{
  const QString type = this->mesh()->elementType();
  if (type != this->ShownType)
  { // other elements than before; until then, the user's choice awaits Evaluate
    this->ShownType = type;
    if (type != this->elementType())
    {
      const QSignalBlocker blocker(this->Elements);
      this->Elements->setCurrentIndex(this->Elements->findData(type));
      this->fillTree();
    }
    this->state()->setElements(type);
  }
  if (this->Tree->topLevelItemCount() == 0)
  {
    this->fillTree();
  }
  if (this->mesh()->meshVersion() != this->TickedMesh)
  { // the ticks were for another one
    this->TickedMesh = this->mesh()->meshVersion();
    this->HasUserTicks = false;
    this->Delay.stop();
  }
  const bool isMesh = this->mesh()->port() != nullptr;
  for (QWidget* widget : std::initializer_list<QWidget*>{ this->Tree, this->Search })
  {
    widget->setEnabled(isMesh);
  }
  this->Preset->setEnabled(isMesh && this->elementType() == "Cell");
  this->grayPresets(this->Preset);
  if (!this->HasUserTicks)
  {
    this->Tree->setTicks(this->shownCriteria());
    this->showPreset();
  }
  this->showDistributions();
  this->Tree->setCurrentCriterion(this->state()->criterion());
  this->Cost->setText(QString());
  this->showEvaluate();
}

//------------------------------------------------------------------------------
QStringList pqCriteriaCard::shownCriteria() const
{
  return this->mesh()->elementType() == this->elementType() ? this->questions()->evaluated()
                                                            : QStringList();
}

//------------------------------------------------------------------------------
void pqCriteriaCard::showDistributions()
{
  this->AfterPicture.stop();
  const QStringList evaluated = this->shownCriteria();
  camaron::DistributionRequest request;
  constexpr int bins = 40;
  request.Bins = bins;
  request.Ranges = this->state()->userRanges(this->elementType());
  QVector<camaron::Distribution> found;
  if (this->mayCompute(!evaluated.isEmpty()))
  {
    found = this->questions()->distributions(evaluated, request);
    const camaron::SelectionInfo selected = this->selection()->info();
    request.CountsSelected = selected.Count > 0 && !selected.IsOfPoints;
    const auto parts = request.CountsSelected ? this->questions()->distributions(evaluated, request)
                                              : QVector<camaron::Distribution>();
    for (int i = 0; i < std::min(found.size(), parts.size()); ++i)
    {
      // The mesh may have changed in between.
      if (found[i].Array == parts[i].Array && found[i].Histogram.Edges == parts[i].Histogram.Edges)
      {
        found[i].Histogram.Selected = parts[i].Histogram.Selected;
      }
    }
  }
  QStringList own;
  for (const QString& range : std::as_const(request.Ranges))
  {
    own << range.section(' ', 0, 0);
  }
  this->Tree->setDistributions(found, this->mesh()->elements(), own);
}

//------------------------------------------------------------------------------
void pqCriteriaCard::showPreset()
{
  const QSignalBlocker blocker(this->Preset);
  const QStringList names = this->Tree->ticks();
  const QSet<QString> ticked(names.begin(), names.end());
  int place = 0; // none of them
  for (int i = 1; i < this->Preset->count(); ++i)
  {
    const QStringList preset = this->Preset->itemData(i).toStringList();
    place = ticked == QSet<QString>(preset.begin(), preset.end()) ? i : place;
  }
  this->Preset->setCurrentIndex(place);
}

//------------------------------------------------------------------------------
void pqCriteriaCard::tickPreset()
{
  const QStringList names = this->Preset->currentData().toStringList();
  if (!names.isEmpty())
  {
    this->Tree->setTicks(names);
    this->onTicksChanged();
  }
}

//------------------------------------------------------------------------------
void pqCriteriaCard::onTicksChanged()
{
  this->HasUserTicks = true;
  const QStringList names = this->Tree->ticks();
  const double seconds =
    this->elementType() == "Cell" ? this->filters()->estimatedSeconds(names) : 0;
  this->Cost->setText(
    seconds < LongSeconds ? QString() : tr("About %1").arg(camaron::FormatDuration(seconds)));
  if (this->mesh()->isSmall() && seconds < LongSeconds && !names.isEmpty())
  {
    this->Delay.start();
  }
  this->showEvaluate();
}

//------------------------------------------------------------------------------
void pqCriteriaCard::showEvaluate()
{
  const QStringList names = this->Tree->ticks(), shown = this->shownCriteria();
  const bool isPending =
    QSet<QString>(names.begin(), names.end()) != QSet<QString>(shown.begin(), shown.end());
  this->Evaluate->setEnabled(this->mesh()->port() && !names.isEmpty());
  this->Evaluate->setVisible(this->Evaluate->isEnabled() && isPending && !this->Delay.isActive());
  this->Cost->setVisible(!this->Cost->text().isEmpty());
}

//------------------------------------------------------------------------------
void pqCriteriaCard::evaluate()
{
  if (this->mesh()->isComputing())
  {
    this->Delay.start();
    return;
  }
  this->Delay.stop();
  const pqScopedOverrideCursor waiting(Qt::WaitCursor);
  const pqScopedUndoSet undo(tr("Evaluate"));
  this->HasUserTicks = false;
  const QStringList names = this->Tree->ticks();
  if (!this->Cost->text().isEmpty())
  {
    this->Cost->setText(tr("Evaluating: ") + this->Cost->text().toLower());
    this->Cost->repaint();
  }
  this->filters()->evaluate(names, this->elementType());
  this->TickedMesh = this->mesh()->meshVersion(); // these elements
  if (!names.isEmpty())
  {
    const QString colored = this->display()->colors().array();
    // A defect that was selected has left the colors of CellStatus, in which nobody sees quality.
    const bool isOfQuality = names.contains(colored) && colored != "CellStatus";
    this->state()->chooseCriterion(isOfQuality ? colored : this->questions()->worstCriterion());
  }
}

//------------------------------------------------------------------------------
void pqCriteriaCard::choose(const QString& name)
{
  const bool isChosen = name == this->state()->criterion() && this->display()->colors().areOf(name);
  if (!isChosen && this->questions()->evaluated().contains(name))
  {
    this->state()->chooseCriterion(name);
  }
}
