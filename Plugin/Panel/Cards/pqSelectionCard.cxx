// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqSelectionCard.h"

#include "CardTools.h"
#include "NumberText.h"
#include "PanelColors.h"
#include "pqInspectedMesh.h"
#include "pqMeshFilters.h"
#include "pqMeshQuestions.h"
#include "pqMeshSelection.h"

#include "pqScopedOverrideCursor.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListView>
#include <QListWidget>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

namespace
{
constexpr int MostSteps = 20; // to go back

//------------------------------------------------------------------------------
// Shows no more digits than the number has.
class PercentBox : public QDoubleSpinBox
{
public:
  using QDoubleSpinBox::QDoubleSpinBox;

  QString textFromValue(double value) const override
  {
    return this->locale().toString(value, 'g', QLocale::FloatingPointShortest);
  }
};
}

//------------------------------------------------------------------------------
pqSelectionCard::pqSelectionCard(pqInspectorState* state, QWidget* parent)
  : Superclass("Selection", tr("Selection"), false, state, parent)
  , Summary(camaron::MakeText(this->content(), "Summary"))
  , Adjacency(camaron::Make<QComboBox>(this->content(), "Adjacency"))
  , WorstPercent(camaron::Make<PercentBox>(this->content(), "WorstPercent"))
  , Status(new QMenu(this))
  , History(new QMenu(this))
  , Steps(camaron::Make<QListWidget>(this->content(), "Steps"))
  , Message(camaron::MakeText(this->content(), "Message"))
{
  this->contentLayout()->addWidget(this->Summary);
  this->makeTools();
  this->Steps->setToolTip(tr("Steps of the selection; double-click one to go back to it"));
  const int height = this->Steps->fontMetrics().height() + 4;
  constexpr int visibleSteps = 4;
  this->Steps->setFixedHeight(visibleSteps * height);
  this->contentLayout()->addWidget(this->Steps);
  this->contentLayout()->addWidget(this->Message);
  QObject::connect(this->Steps, &QListWidget::itemActivated, this,
    [this](QListWidgetItem* item) { this->goBackTo(item->data(Qt::UserRole).toInt()); });
  QObject::connect(this->selection(), &pqMeshSelection::selectionChanged, this,
    &pqSelectionCard::refreshWhenVisible);
  QObject::connect(
    state, &pqInspectorState::criterionChanged, this, &pqSelectionCard::refreshWhenVisible);
  QObject::connect(this->Status, &QMenu::aboutToShow, this, &pqSelectionCard::fillStatus);
}

//------------------------------------------------------------------------------
void pqSelectionCard::makeTools()
{
  QHBoxLayout* tools = this->addRow();
  const auto addStep = [&](const char* name, const QString& tip, const auto& select)
  {
    this->OfSelection << this->addTool(tools, name, tip,
      [select]
      {
        const pqScopedOverrideCursor waiting(Qt::WaitCursor);
        select();
      });
  };
  const auto addLayer = [this](const char* strategy)
  {
    this->selection()->selectBy(
      strategy, { { "Adjacency", this->Adjacency->currentData() }, { "NumberOfLayers", 1 } });
  };
  addStep("Grow", tr("Grow the selection by a layer of neighbors"), [=] { addLayer("Expand"); });
  addStep("Shrink", tr("Remove the outer layer of the selection"), [=] { addLayer("Shrink"); });
  this->Adjacency->addItem(tr("across faces"), "Face");
  this->Adjacency->addItem(tr("across edges"), "Edge");
  this->Adjacency->addItem(tr("at vertices"), "Vertex");
  this->Adjacency->setToolTip(
    tr("Elements that are neighbors for growing and shrinking; cells of surfaces are "
       "neighbors across edges instead of faces"));
  tools->addWidget(this->Adjacency);
  addStep("Connected", tr("Everything connected to the selection"),
    [this]
    {
      this->selection()->selectBy("Connected", { { "Adjacency", this->Adjacency->currentData() } });
    });
  addStep(
    "Invert", tr("Invert the selection"), [this] { this->selection()->selectBy("Invert", {}); });
  addStep("ClearSelection", tr("Clear the selection"), [this] { this->selection()->clear(); });
  tools->addStretch();
  QToolButton* history =
    this->addTool(tools, "History", tr("Earlier selections: brushes, steps and those in views"));
  history->setMenu(this->History);
  history->setPopupMode(QToolButton::InstantPopup);
  QObject::connect(this->History, &QMenu::aboutToShow, this, &pqSelectionCard::fillHistory);

  QHBoxLayout* more = this->addRow();
  constexpr double most = 100;
  this->WorstPercent->setRange(0, most);
  this->WorstPercent->setValue(1);
  this->WorstPercent->setDecimals(3);
  this->WorstPercent->setSuffix(tr("\u00a0% worst"));
  this->WorstPercent->setToolTip(tr("Percentage of the elements with the worst values of the "
                                    "current criterion"));
  more->addWidget(this->WorstPercent);
  this->SelectWorst =
    this->addTool(more, "SelectWorst", tr("Select the worst elements by the current criterion"),
      [this]
      {
        this->selection()->selectBy("Worst percentage",
          { { "Array", this->state()->criterion() },
            { "WorstPercentage", this->WorstPercent->value() } });
      });
  QToolButton* status = this->addTool(more, "SelectStatus", tr("Select cells with a defect"));
  status->setMenu(this->Status);
  status->setPopupMode(QToolButton::InstantPopup);
  more->addStretch();
  this->OfSelection << this->addTool(more, "ExportTable",
    tr("Export the selected elements as a table or a mesh"),
    [this] { this->exportSelection(true); });
  this->OfSelection << this->addTool(more, "ExportIds",
    tr("Export the ids: a list, or an OpenFOAM set"), [this] { this->exportSelection(false); });
}

//------------------------------------------------------------------------------
void pqSelectionCard::refresh()
{
  const camaron::SelectionInfo info = this->selection()->info();
  const QString elements = info.IsOfPoints ? tr("points") : this->mesh()->elements();
  for (QToolButton* tool : std::as_const(this->OfSelection))
  {
    camaron::SetEnabled(tool, info.Count > 0, tr("Nothing is selected."));
  }
  const camaron::CriterionInfo* criterion =
    this->questions()->criterion(this->state()->criterion());
  camaron::SetEnabled(this->SelectWorst, criterion && criterion->Better != 0,
    criterion ? tr("Neither large nor small values of %1 are worse.").arg(criterion->Label)
              : tr("Evaluate a criterion first."));
  this->Summary->setText(info.Count == 0
      ? tr("Nothing is selected.")
      : tr("<b>%1</b> of %2 %3 selected (%4)")
          .arg(camaron::GroupedInteger(info.Count), camaron::GroupedInteger(info.Total), elements,
            camaron::FormatPercent(double(info.Count), double(info.Total)).toHtmlEscaped()));
  // Neighbors across "faces" of polygons are those across edges.
  const bool isSurface = this->questions()->isSurface();
  this->Adjacency->setItemText(0, isSurface ? tr("across edges") : tr("across faces"));
  qobject_cast<QListView*>(this->Adjacency->view())->setRowHidden(1, isSurface);
  if (isSurface && this->Adjacency->currentIndex() == 1)
  {
    this->Adjacency->setCurrentIndex(0);
  }
  const auto steps = this->selection()->steps();
  this->Steps->clear();
  const int count = static_cast<int>(steps.size());
  for (int i = qMax(0, count - MostSteps); i < count; ++i)
  {
    auto* item = new QListWidgetItem(QString("%1. %2").arg(i + 1).arg(steps[i].first), this->Steps);
    item->setData(Qt::UserRole, steps[i].second);
  }
  this->Steps->scrollToBottom();
  this->Message->setVisible(!this->Message->text().isEmpty());
}

//------------------------------------------------------------------------------
void pqSelectionCard::fillStatus()
{
  const pqScopedOverrideCursor waiting(Qt::WaitCursor);
  this->Status->clear();
  const auto defects = this->questions()->validity().Defects;
  for (const auto& defect : defects)
  {
    QAction* action = this->Status->addAction(
      QString("%1 × %2").arg(camaron::GroupedInteger(defect.Count), defect.Label));
    QObject::connect(action, &QAction::triggered, this,
      [this, name = defect.Name] { this->selection()->selectDefect(name); });
  }
  if (defects.isEmpty())
  {
    this->Status->addAction(tr("All %1 are valid").arg(this->mesh()->elements()))
      ->setEnabled(false);
  }
}

//------------------------------------------------------------------------------
void pqSelectionCard::fillHistory()
{
  this->History->clear();
  const QStringList past = this->selection()->past();
  for (int place = 0; place < past.size(); ++place)
  {
    QObject::connect(this->History->addAction(past[place]), &QAction::triggered, this,
      [this, place] { this->selection()->reselect(place); });
  }
  if (past.isEmpty())
  {
    this->History->addAction(tr("Nothing has been selected"))->setEnabled(false);
  }
}

//------------------------------------------------------------------------------
void pqSelectionCard::goBackTo(int step)
{
  if (step != pqMeshSelection::Present)
  {
    camaron::ShowText(this->Message, this->selection()->undoTo(step).toHtmlEscaped());
  }
}

//------------------------------------------------------------------------------
void pqSelectionCard::exportSelection(bool onServer)
{
  const QString path = camaron::AskForPath(this, "ExportSelection", tr("Export Selection"),
    onServer ? this->mesh()->server() : nullptr,
    onServer ? tr("Table (*.csv);;Mesh (*.vtu *.vtpc *.visf)")
      : this->mesh()->elementType() == "Cell"
      ? tr("Ids, one per line (*.txt);;OpenFOAM set (*)")
      : tr("Ids, one per line (*.txt)"), // OpenFOAM numbers faces differently
    pqFileDialog::AnyFile);
  if (!path.isEmpty())
  {
    const pqScopedOverrideCursor waiting(Qt::WaitCursor);
    const QString error =
      this->filters()->exportSelection(path, onServer, this->state()->criterion());
    camaron::ShowText(this->Message, error.isEmpty() ? tr("Written: %1").arg(path) : error);
  }
}
