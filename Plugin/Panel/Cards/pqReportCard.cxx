// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqReportCard.h"

#include "CardTools.h"
#include "pqInspectedMesh.h"
#include "pqInspectorState.h"

#include "pqScopedOverrideCursor.h"

#include <QDir>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QUrl>
#include <QVBoxLayout>

namespace
{
enum Table // outputs of Quality Statistics
{
  Statistics,
  Histogram,
  Worst
};
}

//------------------------------------------------------------------------------
pqReportCard::pqReportCard(pqInspectorState* state, QWidget* parent)
  : Superclass("Report", tr("Report"), false, state, parent)
  , Hint(camaron::MakeText(this->content(), "Hint"))
  , Message(camaron::MakeText(this->content(), "Message"))
{
  this->addButton("Statistics", tr("Show Statistics"),
    tr("Table of minimum, maximum, mean, quantiles and counts of all evaluated criteria"),
    &pqReportCard::showStatistics);
  this->addButton("Chart", tr("Show as Chart"),
    tr("ParaView's bar chart of the histogram of the current criterion"), &pqReportCard::showChart);
  this->addButton("WorstTable", tr("Show Worst Cells"),
    tr("Table of the worst cells of all evaluated criteria"), &pqReportCard::showWorst);
  this->addButton("SaveTables", tr("Save Tables..."),
    tr("Writes statistics, histograms and worst cells as CSV files"), &pqReportCard::saveTables);
  this->addButton("SaveReport", tr("Save Report..."),
    tr("Writes an HTML page with statistics, histograms, worst cells and pictures, and the same "
       "numbers as JSON and CSV, to a folder of this computer"),
    &pqReportCard::saveReport);
  this->Message->setOpenExternalLinks(true);
  auto* grid = new QGridLayout;
  for (int i = 0; i < this->Buttons.size(); ++i)
  {
    grid->addWidget(this->Buttons[i], i / 2, i % 2);
  }
  this->contentLayout()->addLayout(grid);
  this->contentLayout()->addWidget(this->Hint);
  this->contentLayout()->addWidget(this->Message);
  camaron::ShowText(this->Hint, tr("Evaluate criteria to report on them."));
  camaron::ShowText(this->Message, QString());
}

//------------------------------------------------------------------------------
void pqReportCard::addButton(
  const char* name, const QString& label, const QString& tip, void (pqReportCard::*action)())
{
  auto* button = new QPushButton(label, this->content());
  button->setObjectName(name);
  button->setToolTip(tip);
  QObject::connect(button, &QPushButton::clicked, this, action);
  this->Buttons << button;
}

//------------------------------------------------------------------------------
void pqReportCard::refresh()
{
  const bool hasValues = !this->mesh()->evaluated().isEmpty();
  for (QPushButton* button : this->Buttons)
  {
    button->setEnabled(hasValues);
  }
  this->Buttons.last()->setEnabled(hasValues && this->mesh()->canSaveReport());
  this->Hint->setVisible(!hasValues);
  if (this->mesh()->meshVersion() != this->MessageOf)
  {
    this->MessageOf = this->mesh()->meshVersion();
    camaron::ShowText(this->Message, QString());
  }
}

//------------------------------------------------------------------------------
void pqReportCard::showTable(int table, const char* viewType)
{
  const pqScopedOverrideCursor waiting(Qt::WaitCursor);
  this->mesh()->showStatistics(
    table == Histogram ? QStringList(this->state()->criterion()) : this->mesh()->evaluated(), table,
    viewType);
}

//------------------------------------------------------------------------------
void pqReportCard::showStatistics()
{
  this->showTable(Statistics, "SpreadSheetView");
}

//------------------------------------------------------------------------------
void pqReportCard::showChart()
{
  this->showTable(Histogram, "XYBarChartView");
}

//------------------------------------------------------------------------------
void pqReportCard::showWorst()
{
  this->showTable(Worst, "SpreadSheetView");
}

//------------------------------------------------------------------------------
void pqReportCard::saveTables()
{
  const QString folder = camaron::AskForPath(this, "SaveTablesDialog",
    tr("Folder for Statistics, Histogram and Worst Cells"), this->mesh()->server(), QString(),
    camaron::PathKind::Folder);
  if (!folder.isEmpty())
  {
    camaron::ShowText(this->Message, this->mesh()->saveTables(folder));
  }
}

//------------------------------------------------------------------------------
void pqReportCard::saveReport()
{
  const QString folder = camaron::AskForPath(this, "SaveReportDialog", tr("Folder for the Report"),
    nullptr, QString(), camaron::PathKind::Folder);
  if (folder.isEmpty())
  {
    return;
  }
  const pqScopedOverrideCursor waiting(Qt::WaitCursor);
  const QString error = this->mesh()->saveReport(folder);
  const QString path = QDir(folder).filePath("report.html");
  camaron::ShowText(this->Message,
    error.isEmpty()
      ? tr("Written: <a href=\"%1\">%2</a>")
          .arg(QUrl::fromLocalFile(path).toString(QUrl::FullyEncoded), path.toHtmlEscaped())
      : error.toHtmlEscaped());
}
