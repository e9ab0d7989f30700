// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqWorstCard.h"

#include "CardTools.h"
#include "CellTypeNames.h"
#include "MeshCamera.h"
#include "NumberText.h"
#include "pqInspectedMesh.h"
#include "pqMeshDisplay.h"
#include "pqMeshFilters.h"
#include "pqMeshQuestions.h"
#include "pqMeshSelection.h"

#include "pqScopedOverrideCursor.h"
#include "pqUndoStack.h"

#include "vtkBoundingBox.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>
#include <optional>

namespace
{
using camaron::PanelTable;

// Six rows; column 4, the centers, takes what the others leave.
constexpr camaron::TableShape WideCenters{ 6, 4 };

//------------------------------------------------------------------------------
QString SpellCenter(const PanelTable& table, int row)
{
  QStringList numbers;
  for (const char* axis : { "X", "Y", "Z" })
  {
    constexpr int digits = 3;
    const double number = table.number(row, axis);
    numbers << (std::isnan(number) ? QString("NaN") : camaron::ShortNumber(number, digits));
  }
  return numbers.join(", ");
}

//------------------------------------------------------------------------------
QString SpellSize(const PanelTable& table, int row)
{
  constexpr int digits = 3;
  return camaron::ShortNumber(table.number(row, "Size"), digits);
}

//------------------------------------------------------------------------------
QString SpellType(const PanelTable& table, int row)
{
  return camaron::CellTypeName(table.text(row, "CellType"));
}

//------------------------------------------------------------------------------
camaron::Location GetLocation(const PanelTable& table, int row)
{
  camaron::Location location;
  location.Center[0] = table.number(row, "X");
  location.Center[1] = table.number(row, "Y");
  location.Center[2] = table.number(row, "Z");
  const double size = table.number(row, "Size");
  location.Size = std::isfinite(size) ? size : 0;
  return location;
}
}

//------------------------------------------------------------------------------
pqWorstCard::pqWorstCard(pqInspectorState* state, QWidget* parent)
  : Superclass("Worst", tr("Worst"), true, state, parent)
  , Rows(camaron::Make<QComboBox>(this->content(), "Rows"))
  , Number(camaron::Make<QSpinBox>(this->content(), "Number"))
  , Cells(new pqTableModel(
      { pqTableModel::ShowColumn(tr("#"), "Rank"), pqTableModel::ShowColumn(tr("Id"), "Id"),
        pqTableModel::ShowColumn(tr("Value"), "Value"), { tr("Type"), SpellType, false },
        { tr("Center"), SpellCenter, false }, { tr("Size"), SpellSize } },
      this))
  , Places(new pqTableModel(
      { pqTableModel::ShowColumn(tr("#"), "Rank"), pqTableModel::ShowColumn(tr("Number"), "Count"),
        pqTableModel::ShowColumn(tr("Worst"), "WorstValue"),
        pqTableModel::ShowColumn(tr("Id"), "WorstId"), { tr("Center"), SpellCenter, false },
        { tr("Size"), SpellSize } },
      this))
  , CellTable(camaron::MakeTable(this->content(), "Cells", this->Cells, WideCenters))
  , PlaceTable(camaron::MakeTable(this->content(), "Places", this->Places, WideCenters))
  , Summary(camaron::MakeText(this->content(), "Summary"))
{
  QHBoxLayout* tools = this->addRow();
  tools->addWidget(this->Rows);
  tools->addWidget(this->Number);
  tools->addStretch();
  this->Keys = { { Qt::Key_P, [this] { this->step(-1); } },
    { Qt::Key_N, [this] { this->step(1); } }, { Qt::Key_O, [this] { this->Open->toggle(); } },
    { Qt::Key_A, [this] { this->showListed(); } },
    { Qt::Key_B, [this] { this->display()->camera().flyBack(); } },
    { Qt::Key_S, [this] { this->selectListed(); } } };
  this->OfRows << this->addTool(tools, "Previous", tr("Previous (P)"), this->Keys[Qt::Key_P]);
  this->OfRows << this->addTool(tools, "Next", tr("Next (N)"), this->Keys[Qt::Key_N]);
  this->Open = this->addTool(tools, "OpenMesh",
    tr("Open the mesh around the element: its neighbors with edges, everything else as glass (O)"));
  this->OfRows << this->addTool(tools, "ShowListed",
    tr("Select everything listed, and draw only this, inside the glass shell of the mesh (A)"),
    this->Keys[Qt::Key_A]);
  this->Back = this->addTool(tools, "Back",
    tr("Back: restore camera and display as they were before (B)"), this->Keys[Qt::Key_B]);
  this->OfRows << this->addTool(
    tools, "SelectListed", tr("Select what is listed (S)"), this->Keys[Qt::Key_S]);
  this->Keys[Qt::Key_Up] = this->Keys[Qt::Key_P];
  this->Keys[Qt::Key_Down] = this->Keys[Qt::Key_N];
  this->Cells->setRowColor(
    [this](const PanelTable& table, int row)
    {
      return this->isJudged(table, row) ? QColor()
                                        : this->palette().color(QPalette::PlaceholderText);
    });
  this->Open->setCheckable(true);
  this->Open->setChecked(true);
  this->Rows->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  this->Rows->addItem(tr("Worst cells"));
  this->Rows->addItem(tr("Bad places"));
  this->Rows->setItemData(
    1, tr("Connected groups of elements outside the limits"), Qt::ToolTipRole);
  constexpr int most = 1000, usual = 20;
  this->Number->setRange(1, most);
  this->Number->setValue(usual);
  this->Number->setKeyboardTracking(false);
  this->Number->setToolTip(tr("Number of rows"));
  this->contentLayout()->addWidget(this->CellTable);
  this->contentLayout()->addWidget(this->PlaceTable);
  this->contentLayout()->addWidget(this->Summary);
  this->PlaceTable->hide();

  for (QTableView* table : { this->CellTable, this->PlaceTable })
  {
    table->installEventFilter(this);
    for (const auto signal : { &QTableView::clicked, &QTableView::activated })
    {
      QObject::connect(
        table, signal, this, [this](const QModelIndex& index) { this->goToRow(index.row()); });
    }
  }
  QObject::connect(this->Open, &QToolButton::toggled, this,
    [this]
    {
      this->state()->setOpensMesh(this->Open->isChecked());
      const QModelIndex current = this->shownTable()->currentIndex();
      if (current.isValid() && this->display()->camera().canFlyBack())
      {
        this->goToRow(current.row());
      }
    });
  QObject::connect(
    this->display(), &pqMeshDisplay::displayChanged, this, &pqWorstCard::refreshBack);
  QObject::connect(this->filters(), &pqMeshFilters::evaluating, this,
    [this](double seconds)
    {
      this->Cells->setTable({});
      this->Places->setTable({});
      this->Summary->setText(camaron::SpellWork(seconds));
      this->repaint(); // while it computes, nothing else does
    });
  QObject::connect(
    this->Rows, &QComboBox::currentIndexChanged, this, &pqWorstCard::refreshWhenVisible);
  QObject::connect(this->Number, &QSpinBox::valueChanged, this, &pqWorstCard::refreshWhenVisible);
  QObject::connect(
    state, &pqInspectorState::criterionChanged, this, &pqWorstCard::refreshWhenVisible);
  QObject::connect(
    state, &pqInspectorState::elementsChanged, this, &pqWorstCard::refreshWhenVisible);
  QObject::connect(state, &pqInspectorState::limitsChanged, this,
    [this]
    {
      if (this->showsPlaces())
      {
        this->refreshWhenVisible();
      }
      else if (!this->Cells->table().isEmpty()) // which of them are judged
      {
        this->showSummary();
        this->CellTable->viewport()->update();
      }
    });
}

//------------------------------------------------------------------------------
bool pqWorstCard::showsPlaces() const
{
  return this->Rows->currentIndex() == 1;
}

//------------------------------------------------------------------------------
bool pqWorstCard::isJudged(const PanelTable& table, int row) const
{
  const camaron::CriterionInfo* info = this->questions()->criterion(this->state()->criterion());
  return this->state()->userLimits() || !info || !info->hasRange() || info->Element != "Cell" ||
    table.integer(row, "Judged") != 0;
}

//------------------------------------------------------------------------------
QTableView* pqWorstCard::shownTable() const
{
  return this->showsPlaces() ? this->PlaceTable : this->CellTable;
}

//------------------------------------------------------------------------------
void pqWorstCard::refresh()
{
  const pqScopedOverrideCursor waiting(Qt::WaitCursor);
  const QString name = this->state()->criterion();
  const camaron::CriterionInfo* info = this->questions()->criterion(name);
  const QString elements =
    this->state()->awaitsElements() ? tr("elements") : this->mesh()->elements();
  this->Rows->setItemText(0, tr("Worst %1").arg(elements));
  PanelTable table;
  const bool isComputed = this->mayCompute(!name.isEmpty());
  const bool hasLimits = (info && info->hasRange()) || this->state()->userLimits();
  if (isComputed && this->showsPlaces() && hasLimits)
  {
    table = this->questions()->regions(name, this->Number->value(), this->state()->userLimits());
  }
  else if (isComputed && !this->showsPlaces())
  {
    table = this->questions()->worst(name, this->Number->value());
  }
  (this->showsPlaces() ? this->Places : this->Cells)->setTable(table);
  this->CellTable->setVisible(!this->showsPlaces());
  this->PlaceTable->setVisible(this->showsPlaces());
  this->refreshBack();
  for (QToolButton* tool : std::as_const(this->OfRows))
  {
    camaron::SetEnabled(tool, !table.isEmpty(), tr("Nothing is listed."));
  }
  const QString label = info ? info->Label : name;
  if (!table.isEmpty())
  {
    this->showSummary();
    return;
  }
  this->Summary->setText(this->filters()->isEvaluating() ? camaron::SpellWork()
      : name.isEmpty() ? tr("Evaluate a criterion to see its worst %1.").arg(elements)
      : !isComputed    ? QString()
      : this->showsPlaces() && !hasLimits
      ? tr("%1 has no acceptable range: set limits in the card Histogram.").arg(label)
      : this->showsPlaces() ? tr("No %1 are outside the limits of %2.").arg(elements, label)
                            : tr("Neither large nor small values of %1 are worse.").arg(label));
}

//------------------------------------------------------------------------------
void pqWorstCard::showSummary()
{
  const QString name = this->state()->criterion();
  const camaron::CriterionInfo* info = this->questions()->criterion(name);
  const PanelTable& table = this->Cells->table();
  bool isPartlyJudged = false;
  for (int row = 0; row < table.size() && !this->showsPlaces(); ++row)
  {
    isPartlyJudged = isPartlyJudged || !this->isJudged(table, row);
  }
  QString text = tr("By %1").arg(info ? info->Label : name);
  if (isPartlyJudged)
  {
    text += tr(". Gray: not judged, the acceptable range is for %1").arg(info->AcceptableFor);
  }
  this->Summary->setText(text);
}

//------------------------------------------------------------------------------
void pqWorstCard::step(int rows)
{
  QTableView* table = this->shownTable();
  const QModelIndex current = table->currentIndex();
  const int count = table->model()->rowCount();
  const int row = current.isValid() ? current.row() + rows : (rows > 0 ? 0 : count - 1);
  if (row >= 0 && row < count)
  {
    this->goToRow(row);
  }
}

//------------------------------------------------------------------------------
void pqWorstCard::goToRow(int row)
{
  QTableView* view = this->shownTable();
  view->selectRow(row);
  view->setCurrentIndex(view->model()->index(row, 0));
  const PanelTable& table = (this->showsPlaces() ? this->Places : this->Cells)->table();
  const QString idColumn = this->showsPlaces() ? "WorstId" : "Id";
  camaron::Location location = GetLocation(table, row);
  location.Id = table.text(row, idColumn);
  location.IdSpace = table.text(row, "IdSpace");
  if (this->showsPlaces())
  {
    location.GroupArray = this->state()->criterion();
    location.GroupLimits = this->state()->userLimits();
  }
  this->display()->camera().flyTo(location, this->state()->opensMesh());
  this->state()->showElement(table.integer(row, idColumn), table.text(row, "IdSpace"));
}

//------------------------------------------------------------------------------
void pqWorstCard::refreshBack()
{
  camaron::SetEnabled(this->Back, this->display()->camera().canFlyBack(),
    tr("There is nothing to go back to: choose a row first."));
}

//------------------------------------------------------------------------------
void pqWorstCard::selectListed()
{
  const pqScopedOverrideCursor waiting(Qt::WaitCursor);
  const QString array = this->state()->criterion();
  if (!this->showsPlaces())
  {
    this->selection()->selectBy(
      "Worst N", { { "Array", array }, { "NumberOfWorst", this->Number->value() } });
  }
  else
  {
    const PanelTable& places = this->Places->table();
    QStringList ids;
    for (int row = 0; row < places.size(); ++row)
    {
      ids << places.text(row, "WorstId");
    }
    this->selection()->selectPlaces(
      ids, places.text(0, "IdSpace"), array, this->state()->userLimits());
  }
}

//------------------------------------------------------------------------------
void pqWorstCard::showListed()
{
  const PanelTable& table = (this->showsPlaces() ? this->Places : this->Cells)->table();
  vtkBoundingBox bounds;
  for (int row = 0; row < table.size(); ++row)
  {
    const camaron::Location location = GetLocation(table, row);
    if (location.isFinite())
    {
      vtkBoundingBox box(location.Center[0], location.Center[0], location.Center[1],
        location.Center[1], location.Center[2], location.Center[2]);
      box.Inflate(location.Size / 2);
      bounds.AddBox(box);
    }
  }
  const pqScopedUndoSet undo(tr("Show What Is Listed"));
  this->selectListed();
  std::optional<camaron::Location> all;
  if (bounds.IsValid() && std::isfinite(bounds.GetDiagonalLength()))
  {
    all.emplace();
    bounds.GetCenter(all->Center);
    all->Size = bounds.GetDiagonalLength();
  }
  this->display()->camera().showSelected(all);
}

//------------------------------------------------------------------------------
bool pqWorstCard::eventFilter(QObject* watched, QEvent* event)
{
  // ParaView's views have shortcuts with the same letters.
  const bool isShortcut = event->type() == QEvent::ShortcutOverride;
  if (isShortcut || event->type() == QEvent::KeyPress)
  {
    auto* key = static_cast<QKeyEvent*>(event);
    const auto action = this->Keys.constFind(key->key());
    if (action != this->Keys.cend() &&
      !(key->modifiers() & (Qt::ControlModifier | Qt::AltModifier)))
    {
      isShortcut ? event->accept() : (*action)();
      return true;
    }
  }
  return this->Superclass::eventFilter(watched, event);
}
