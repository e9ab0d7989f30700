// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqInspectorCard.h"

#include "CardTools.h"
#include "NumberText.h"
#include "pqInspectedMesh.h"
#include "pqMeshQuestions.h"

#include "pqApplicationCore.h"
#include "pqExpanderButton.h"
#include "pqPropertiesPanel.h"
#include "pqSettings.h"

#include <QKeyEvent>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

//------------------------------------------------------------------------------
pqInspectorCard::pqInspectorCard(
  const QString& name, const QString& title, bool isOpen, pqInspectorState* state, QWidget* parent)
  : Superclass(parent)
  , State(state)
  , Button(camaron::Make<pqExpanderButton>(this, "Title"))
  , Content(camaron::Make<QWidget>(this, "Content"))
  , Layout(new QVBoxLayout(this->Content))
{
  this->setObjectName(name);
  this->Button->setText(title);
  this->Button->setAccessibleName(title);
  this->Button->setFocusPolicy(Qt::TabFocus);
  this->Button->installEventFilter(this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(pqPropertiesPanel::suggestedMargins());
  layout->setSpacing(pqPropertiesPanel::suggestedVerticalSpacing());
  layout->addWidget(this->Button);
  layout->addWidget(this->Content);
  constexpr int indent = 4;
  this->Layout->setContentsMargins(indent, 0, indent, indent);
  this->Layout->setSpacing(pqPropertiesPanel::suggestedVerticalSpacing());

  const QString key = "Camaron/MeshInspector/Open/" + name;
  pqSettings* settings = pqApplicationCore::instance()->settings();
  this->setOpen(settings->value(key, isOpen).toBool());
  this->Content->setVisible(this->isOpen());
  QObject::connect(this->Button, &pqExpanderButton::toggled, this,
    [this, settings, key](bool open)
    {
      settings->setValue(key, open);
      this->Content->setVisible(open);
      if (open)
      {
        this->refreshWhenVisible();
      }
    });
  QObject::connect(
    this->mesh(), &pqInspectedMesh::meshChanged, this, &pqInspectorCard::refreshWhenVisible);
}

//------------------------------------------------------------------------------
QHBoxLayout* pqInspectorCard::addRow()
{
  auto* row = new QHBoxLayout;
  this->Layout->addLayout(row);
  return row;
}

//------------------------------------------------------------------------------
QToolButton* pqInspectorCard::addTool(
  QHBoxLayout* row, const char* name, const QString& tip, const std::function<void()>& click)
{
  QToolButton* tool = camaron::MakeTool(this->Content, name, tip);
  row->addWidget(tool);
  if (click)
  {
    QObject::connect(tool, &QToolButton::clicked, this, click);
  }
  return tool;
}

//------------------------------------------------------------------------------
bool pqInspectorCard::mayCompute(bool hasValues)
{
  const bool asks = hasValues && !this->State->mayCompute();
  if (asks && !this->Compute)
  {
    this->Compute = camaron::Make<QPushButton>(this->Content, "Compute");
    this->Compute->setToolTip(
      tr("The mesh has more cells than the Mesh Inspector reads by itself: see its page in "
         "ParaView's settings"));
    this->Layout->insertWidget(0, this->Compute);
    QObject::connect(
      this->Compute, &QPushButton::clicked, this->State, &pqInspectorState::allowComputing);
    QObject::connect(
      this->State, &pqInspectorState::computingAllowed, this, &pqInspectorCard::refreshWhenVisible);
  }
  if (this->Compute)
  {
    this->Compute->setText(tr("Compute for %1 %2")
        .arg(
          camaron::GroupedInteger(this->questions()->summary().Cells), this->mesh()->elements()));
    this->Compute->setVisible(asks);
  }
  return hasValues && !asks;
}

//------------------------------------------------------------------------------
void pqInspectorCard::grayPresets(QComboBox* presets) const
{
  const bool isKnown =
    this->mesh()->port() && this->mesh()->elementType() == "Cell" && this->State->mayCompute();
  camaron::GrayPresets(
    presets, isKnown ? this->questions()->unfitPresets() : QMap<QString, QString>());
}

//------------------------------------------------------------------------------
bool pqInspectorCard::isOpen() const
{
  return this->Button->checked();
}

//------------------------------------------------------------------------------
void pqInspectorCard::setOpen(bool open)
{
  this->Button->setChecked(open);
}

//------------------------------------------------------------------------------
void pqInspectorCard::reveal()
{
  this->setOpen(true);
  // Posted, so that it follows the layout.
  QMetaObject::invokeMethod(
    this,
    [this]
    {
      for (QWidget* parent = this->parentWidget(); parent; parent = parent->parentWidget())
      {
        if (auto* area = qobject_cast<QScrollArea*>(parent))
        {
          area->ensureWidgetVisible(this);
          return;
        }
      }
    },
    Qt::QueuedConnection);
}

//------------------------------------------------------------------------------
void pqInspectorCard::refreshWhenVisible()
{
  this->IsStale = !(this->isVisible() && this->isOpen());
  if (!this->IsStale)
  {
    this->refresh();
  }
}

//------------------------------------------------------------------------------
bool pqInspectorCard::eventFilter(QObject* watched, QEvent* event)
{
  const bool isOfTitle = watched == this->Button;
  if (isOfTitle && (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut))
  {
    QFont font = this->font();
    font.setUnderline(event->type() == QEvent::FocusIn);
    this->Button->setFont(font);
  }
  if (isOfTitle && event->type() == QEvent::KeyPress)
  {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter)
    {
      this->Button->toggle();
      return true;
    }
  }
  return this->Superclass::eventFilter(watched, event);
}

//------------------------------------------------------------------------------
void pqInspectorCard::showEvent(QShowEvent* event)
{
  this->Superclass::showEvent(event);
  if (this->IsStale)
  {
    this->refreshWhenVisible();
  }
}

//------------------------------------------------------------------------------
void pqInspectorCard::changeEvent(QEvent* event)
{
  this->Superclass::changeEvent(event);
  if (event->type() == QEvent::PaletteChange)
  { // posted, so that all widgets of the card have the palette
    QMetaObject::invokeMethod(this, [this] { this->recolor(); }, Qt::QueuedConnection);
  }
}
