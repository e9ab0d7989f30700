// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CardTools.h"

#include "PanelIcons.h"

#include "pqFileDialog.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QToolButton>

namespace camaron
{
//------------------------------------------------------------------------------
QTableView* MakeTable(QWidget* parent, const char* name, pqTableModel* model, int visibleRows)
{
  auto* view = new QTableView(parent);
  view->setObjectName(name);
  view->setModel(model);
  view->setSelectionBehavior(QAbstractItemView::SelectRows);
  view->setSelectionMode(QAbstractItemView::SingleSelection);
  view->setEditTriggers(QAbstractItemView::NoEditTriggers);
  view->setWordWrap(false);
  view->setShowGrid(false);
  view->setAlternatingRowColors(true);
  view->verticalHeader()->hide();
  const int height = view->fontMetrics().height() + 4;
  view->verticalHeader()->setDefaultSectionSize(height);
  view->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  view->horizontalHeader()->setStretchLastSection(true);
  view->horizontalHeader()->setHighlightSections(false);
  view->setMinimumHeight((visibleRows + 2) * height);
  view->setMaximumHeight((visibleRows + 2) * height);
  return view;
}

//------------------------------------------------------------------------------
QToolButton* MakeTool(QWidget* parent, const char* name, const QString& tip)
{
  auto* button = new QToolButton(parent);
  button->setObjectName(name);
  button->setIcon(PanelIcon(name, parent->palette()));
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setAutoRaise(true);
  return button;
}

//------------------------------------------------------------------------------
QLabel* MakeText(QWidget* parent, const char* name)
{
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextBrowserInteraction);
  return label;
}

//------------------------------------------------------------------------------
QString AskForPath(QWidget* parent, const char* name, const QString& title, pqServer* server,
  const QString& filters, PathKind kind)
{
  pqFileDialog dialog(server, parent, title, QString(), filters, false);
  dialog.setObjectName(name);
  dialog.setFileMode(kind == PathKind::NewFile ? pqFileDialog::AnyFile
      : kind == PathKind::ExistingFile         ? pqFileDialog::ExistingFile
                                               : pqFileDialog::Directory);
  return dialog.exec() == QDialog::Accepted ? dialog.getSelectedFiles().value(0) : QString();
}

//------------------------------------------------------------------------------
QString SpellPercent(double part, double whole)
{
  constexpr int digits = 3;
  return whole > 0 ? QString("%1 %").arg(100 * part / whole, 0, 'g', digits) : QString("0 %");
}
}
