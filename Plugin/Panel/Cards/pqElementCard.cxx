// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqElementCard.h"

#include "CardTools.h"
#include "CellTypeNames.h"
#include "MeshCamera.h"
#include "NumberText.h"
#include "PanelColors.h"
#include "pqInspectedMesh.h"
#include "pqMeshDisplay.h"
#include "pqMeshQuestions.h"
#include "pqMeshSelection.h"

#include "pqScopedOverrideCursor.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpressionValidator>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>

namespace
{
using camaron::PanelTable;

// Eight rows; the names, in lines of 20 characters, take what the values leave.
constexpr camaron::TableShape WideNames{ 8, 0, 20 };

//------------------------------------------------------------------------------
// Such as "intersecting edges".
QString SpellStatus(qint64 status, const pqMeshQuestions& questions)
{
  const PanelTable& bits = questions.statusBits();
  QStringList defects;
  for (int row = 0; row < bits.size(); ++row)
  {
    if (status & bits.integer(row, "Bit"))
    {
      defects << bits.text(row, "Description");
    }
  }
  return defects.isEmpty() ? pqElementCard::tr("valid") : defects.join(", ");
}

//------------------------------------------------------------------------------
// A row per array of the element: criteria that fail or warn, others in the order of the registry,
// other arrays, and last criteria without a value.
PanelTable Transpose(
  const PanelTable& element, const QStringList& bad, const pqInspectorState& state)
{
  const pqMeshQuestions& questions = *state.services().Questions;
  PanelTable rows;
  rows.Columns = QStringList{ "Label", "Value", "Unit", "Verdict" };
  QStringList columns = questions.evaluated();
  for (const QString& column : element.Columns)
  {
    const QStringList place = { "Id", "Block", "CellType", "X", "Y", "Z" };
    if (!columns.contains(column) && !place.contains(column) && !column.startsWith("vtk"))
    {
      columns << column;
    }
  }
  QVector<QVector<QVariant>> failing, warning, others, undefined;
  for (const QString& column : std::as_const(columns))
  {
    const camaron::CriterionInfo* info = questions.criterion(column);
    const bool isHint = info && info->IsHint && !state.userLimitsOf(column);
    const QString verdict = !info || !bad.contains(column) ? "" : isHint ? "warn" : "fail";
    const QVariant value = column == "CellStatus"
      ? QVariant(SpellStatus(element.integer(0, column), questions))
      : element.value(0, column);
    const bool isUndefined = value.userType() == QMetaType::Double && std::isnan(value.toDouble());
    (isUndefined            ? undefined
        : verdict == "fail" ? failing
        : verdict == "warn" ? warning
                            : others)
      << QVector<QVariant>{ info ? info->Label : column, value,
           info ? camaron::GetUnitSuffix(info->Unit) : QString(), verdict };
  }
  rows.Rows = failing + warning + others + undefined;
  return rows;
}

//------------------------------------------------------------------------------
QString SpellValue(const PanelTable& table, int row)
{
  const QVariant value = table.value(row, "Value");
  const QString text = value.userType() == QMetaType::Double
    ? camaron::ShortNumber(value.toDouble())
    : value.toString();
  return text.isEmpty() ? QString("–") : text + table.text(row, "Unit");
}
}

//------------------------------------------------------------------------------
pqElementCard::pqElementCard(pqInspectorState* state, QWidget* parent)
  : Superclass("Element", tr("Element"), false, state, parent)
  , Id(camaron::Make<QLineEdit>(this->content(), "Id"))
  , Summary(camaron::MakeText(this->content(), "Summary"))
  , Values(new pqTableModel(
      { pqTableModel::ShowColumn(tr("Criterion"), "Label", false), { tr("Value"), SpellValue } },
      this))
  , Table(camaron::MakeTable(this->content(), "Values", this->Values, WideNames))
  , Neighbors(camaron::MakeText(this->content(), "Neighbors", true))
{
  this->Values->setRowColor(
    [this](const PanelTable& table, int row)
    {
      const QString verdict = table.text(row, "Verdict");
      const camaron::PanelColors colors(this->palette());
      return verdict == "fail" ? colors.Fails : verdict == "warn" ? colors.Warns : QColor();
    });
  this->Id->setPlaceholderText(tr("Id"));
  this->Id->setValidator(
    new QRegularExpressionValidator(QRegularExpression("\\s*-?\\d{1,19}\\s*"), this->Id));
  QHBoxLayout* tools = this->addRow();
  tools->addWidget(this->Id);
  this->Select = this->addTool(tools, "SelectCell", tr("Select this element"),
    [this]
    {
      this->selection()->selectBy(
        "By id", { { "Ids", this->Wanted }, { "IdSpace", this->IdSpace } });
    });
  this->Copy =
    this->addTool(tools, "CopyIds", tr("Copy the ids of the element and its neighbors"), [this]
      { QApplication::clipboard()->setText(this->Wanted + ' ' + this->NeighborIds.join(' ')); });
  this->contentLayout()->addWidget(this->Summary);
  this->contentLayout()->addWidget(this->Table);
  this->contentLayout()->addWidget(this->Neighbors);
  QObject::connect(this->Id, &QLineEdit::returnPressed, this, &pqElementCard::goToText);
  QObject::connect(state, &pqInspectorState::elementChosen, this, &pqElementCard::showElement);
  QObject::connect(
    state, &pqInspectorState::limitsChanged, this, &pqElementCard::refreshWhenVisible);
  QObject::connect(
    this->selection(), &pqMeshSelection::elementPicked, this, &pqElementCard::showPicked);
  QObject::connect(this->Neighbors, &QLabel::linkActivated, this,
    [this](const QString& id) { this->goTo(id.toLongLong()); });
}

//------------------------------------------------------------------------------
void pqElementCard::goToText()
{
  bool isId = false;
  const QString text = this->Id->text().trimmed();
  const qint64 id = text.toLongLong(&isId);
  if (isId)
  {
    this->goTo(id);
  }
  else
  {
    this->Summary->setText(
      tr("There is no %1 with the id %2.").arg(this->mesh()->elements(1), text));
  }
}

//------------------------------------------------------------------------------
void pqElementCard::goTo(qint64 id)
{
  this->state()->showElement(id, this->mesh()->idSpace());
  this->display()->camera().flyTo(
    this->questions()->locate(id, this->mesh()->idSpace()), this->state()->opensMesh());
}

//------------------------------------------------------------------------------
void pqElementCard::showPicked()
{
  if (this->isVisible() && (this->isOpen() || this->state()->mayCompute()))
  {
    const QString id = this->questions()->selectedId();
    if (!id.isEmpty())
    {
      this->showElement(id.toLongLong(), this->mesh()->idSpace());
      this->reveal();
    }
  }
}

//------------------------------------------------------------------------------
void pqElementCard::showElement(qint64 id, const QString& idSpace)
{
  this->IdSpace = idSpace;
  this->Wanted = QString::number(id);
  this->Id->setText(this->Wanted);
  this->WantedIn = this->mesh()->meshVersion();
  this->refreshWhenVisible();
}

//------------------------------------------------------------------------------
void pqElementCard::refresh()
{
  camaron::ElementInfo found;
  if (this->mesh()->meshVersion() != this->WantedIn)
  { // the id is one of another mesh
    this->Wanted.clear();
    this->Id->clear();
  }
  if (!this->Wanted.isEmpty() && this->mesh()->port())
  {
    const pqScopedOverrideCursor waiting(Qt::WaitCursor);
    found = this->questions()->element(this->Wanted.toLongLong(), this->IdSpace,
      this->state()->userRanges(this->mesh()->elementType()));
  }
  const PanelTable& element = found.Values;
  const bool isFound = !element.isEmpty();
  this->Table->setVisible(!this->Wanted.isEmpty()); // stays for an id that is not found
  for (QToolButton* tool : { this->Select, this->Copy })
  {
    camaron::SetEnabled(tool, isFound, tr("No element is shown."));
  }
  if (!isFound)
  {
    this->Values->setTable({});
    camaron::ShowText(this->Neighbors, QString());
    this->Summary->setText(this->Wanted.isEmpty()
        ? tr("Pick an element in the view, choose a row of Worst, or type an id.")
        : tr("There is no %1 with the id %2.").arg(this->mesh()->elements(1), this->Wanted));
    return;
  }
  const auto number = [&](const char* axis)
  {
    constexpr int digits = 4;
    const QString text = camaron::ShortNumber(element.number(0, axis), digits);
    return text.isEmpty() ? QString("NaN") : text;
  };
  QString noun = this->mesh()->elements(1);
  noun[0] = noun[0].toUpper();
  this->Summary->setText(tr("%1 %2: %3 at %4, %5, %6")
      .arg(noun, this->Wanted, camaron::CellTypeName(element.text(0, "CellType")), number("X"),
        number("Y"), number("Z")));
  this->Values->setTable(Transpose(element, found.Failing, *this->state()));
  this->NeighborIds = found.Neighbors;
  this->showNeighbors();
}

//------------------------------------------------------------------------------
void pqElementCard::recolor()
{
  if (this->Copy->isEnabled())
  {
    this->showNeighbors();
  }
}

//------------------------------------------------------------------------------
void pqElementCard::showNeighbors()
{
  QStringList links;
  const QString color = this->palette().color(QPalette::Link).name();
  for (const QString& id : std::as_const(this->NeighborIds))
  {
    links << QString("<a href=\"%1\" style=\"color:%2\">%1</a>").arg(id, color);
  }
  camaron::ShowText(this->Neighbors,
    links.isEmpty() ? tr("No neighbors") : tr("Neighbors: %1").arg(links.join(", ")));
}
