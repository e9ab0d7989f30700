// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqReportCard.h"

#include "CardTools.h"
#include "pqInspectedMesh.h"
#include "pqMeshFilters.h"
#include "pqMeshQuestions.h"

#include "pqScopedOverrideCursor.h"

#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
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
  , Folder(camaron::Make<QLineEdit>(this->content(), "ReportFolder"))
  , Browse(camaron::Make<QToolButton>(this->content(), "BrowseReport"))
  , Save(camaron::Make<QPushButton>(this->content(), "SaveReport", tr("Save Report")))
{
  auto* grid = new QGridLayout;
  const auto addButton =
    [&](const char* name, const QString& label, const QString& tip, const auto& action)
  {
    auto* button = camaron::Make<QPushButton>(this->content(), name, label);
    button->setToolTip(tip);
    QObject::connect(button, &QPushButton::clicked, this, action);
    const auto place = static_cast<int>(this->Buttons.size());
    grid->addWidget(button, place / 2, place % 2);
    this->Buttons << button;
  };
  addButton("Statistics", tr("Show Statistics"),
    tr("Table of minimum, maximum, mean, quantiles and counts of all evaluated criteria"),
    [this] { this->showTable(Statistics, "SpreadSheetView"); });
  addButton("Chart", tr("Show as Chart"),
    tr("ParaView's bar chart of the histogram of the current criterion"),
    [this] { this->showTable(Histogram, "XYBarChartView"); });
  addButton("WorstTable", tr("Show Worst Cells"),
    tr("Table of the worst cells of all evaluated criteria"),
    [this] { this->showTable(Worst, "SpreadSheetView"); });
  addButton("SaveTables", tr("Save Tables..."),
    tr("Writes statistics, histograms and worst cells as CSV files"),
    [this] { this->saveTables(); });
  this->Message->setOpenExternalLinks(true);
  this->contentLayout()->addLayout(grid);
  QHBoxLayout* report = this->addRow();
  report->addWidget(this->Folder, 1);
  report->addWidget(this->Browse);
  report->addWidget(this->Save);
  this->Browse->setText("...");
  this->Browse->setToolTip(tr("Choose a folder for the report"));
  this->Save->setToolTip(
    tr("Writes an HTML page with statistics, histograms, worst cells, pictures, "
       "and the verdicts on the rules of Check and the ranges that you set; "
       "and the same numbers as JSON and CSV"));
  QObject::connect(this->Folder, &QLineEdit::returnPressed, this, &pqReportCard::saveReport);
  QObject::connect(this->Save, &QPushButton::clicked, this, &pqReportCard::saveReport);
  QObject::connect(this->Browse, &QToolButton::clicked, this, &pqReportCard::browse);
  this->contentLayout()->addWidget(this->Hint);
  this->contentLayout()->addWidget(this->Message);
  camaron::ShowText(this->Hint, tr("Evaluate criteria to report on them."));
  camaron::ShowText(this->Message, QString());
}

//------------------------------------------------------------------------------
void pqReportCard::refresh()
{
  const bool hasValues = !this->questions()->evaluated().isEmpty();
  for (QPushButton* button : this->Buttons)
  {
    button->setEnabled(hasValues);
  }
  const bool isOfCells = this->mesh()->elementType() == "Cell";
  const bool canSave = hasValues && isOfCells && this->filters()->canSaveReport();
  this->Folder->setEnabled(canSave);
  this->Browse->setEnabled(canSave);
  camaron::SetEnabled(this->Save, canSave,
    hasValues && !isOfCells ? tr("Reports are about cells: choose them in the card Criteria.")
                            : QString());
  const QFileInfo folder(this->filters()->reportFolder());
  this->Folder->setPlaceholderText(folder.fileName());
  this->Folder->setToolTip(tr("Folder of this computer for the report, a new one or that of an "
                              "earlier report; a name without a path is one in %1")
      .arg(folder.path()));
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
  this->filters()->showStatistics(
    table == Histogram ? QStringList(this->state()->criterion()) : this->questions()->evaluated(),
    table, viewType);
}

//------------------------------------------------------------------------------
void pqReportCard::saveTables()
{
  // A dialog for folders takes no name of a new one.
  const QString path = camaron::AskForPath(this, "SaveTablesDialog",
    tr("Folder for Statistics, Histogram and Worst Cells: a New Name, or a Table in It"),
    this->mesh()->server(), tr("Folders and tables (*)"), pqFileDialog::AnyFile);
  if (!path.isEmpty())
  {
    camaron::ShowText(this->Message, this->filters()->saveTables(path));
    this->reveal();
  }
}

//------------------------------------------------------------------------------
void pqReportCard::saveReport()
{
  const QFileInfo usual(this->filters()->reportFolder());
  const QString typed = this->Folder->text().trimmed();
  const QString folder = usual.dir().absoluteFilePath(typed.isEmpty() ? usual.fileName() : typed);
  const pqScopedOverrideCursor waiting(Qt::WaitCursor);
  const QString error = this->filters()->saveReport(folder, this->state()->reportRequest());
  const QString path = QDir(folder).filePath("report.html");
  camaron::ShowText(this->Message,
    error.isEmpty()
      ? tr("Written: <a href=\"%1\">%2</a>")
          .arg(QUrl::fromLocalFile(path).toString(QUrl::FullyEncoded), path.toHtmlEscaped())
      : error.toHtmlEscaped());
  this->reveal(); // the message may be below the edge of the panel
}

//------------------------------------------------------------------------------
void pqReportCard::browse()
{
  const QString folder = camaron::AskForPath(this, "BrowseReportDialog",
    tr("Folder for the Report"), nullptr, QString(), pqFileDialog::Directory);
  if (!folder.isEmpty())
  {
    this->Folder->setText(folder);
  }
}
