// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Files that the panel writes.
#include "pqInspectedMesh.h"

#include "ErrorMessages.h"
#include "ProxyValues.h"
#include "PythonReport.h"
#include "ServerConnection.h"
#include "ThresholdSelection.h"

#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServer.h"
#include "pqUndoStack.h"

#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMWriterFactory.h"

#include <QDir>
#include <QFileInfo>
#include <QSaveFile>

#include <algorithm>
#include <string>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
// Contents of an OpenFOAM cellSet or pointSet.
QByteArray FormatSet(const QStringList& ids, const QString& name, bool isOfPoints)
{
  return QString("FoamFile\n{\n    version     2.0;\n    format      ascii;\n"
                 "    class       %1;\n    location    \"constant/polyMesh/sets\";\n"
                 "    object      %2;\n}\n\n%3\n(\n%4\n)\n")
    .arg(isOfPoints ? "pointSet" : "cellSet", name)
    .arg(ids.size())
    .arg(ids.join('\n'))
    .toUtf8();
}

//------------------------------------------------------------------------------
// The reason not to write a file: data of a source was read from it. Empty if there is none.
QString RefuseInput(vtkSMProxy* source, const QString& path)
{
  const auto inputs = vtkSmartPointer<vtkSMProxy>::Take(
    source ? source->GetSessionProxyManager()->NewProxy("misc", "InputFiles") : nullptr);
  if (!inputs)
  {
    return QString();
  }
  vtkSMPropertyHelper(inputs, "Source").Set(source);
  inputs->UpdateVTKObjects();
  vtkSMPropertyHelper(inputs, "Targets").Set(path.toUtf8().constData());
  inputs->UpdateVTKObjects();
  camaron::UpdateInformation(inputs);
  const QString replaced = vtkSMPropertyHelper(inputs, "Replaced").GetAsString();
  return replaced.isEmpty()
    ? QString()
    : pqInspectedMesh::tr("%1: the mesh was read from this file: choose another name").arg(path);
}

//------------------------------------------------------------------------------
// Arguments that are empty are left out.
void TraceReport(const pqOutputPort* mesh, const QStringList& criteria,
  const camaron::CheckRequest& rules, const QString& folder)
{
  if (mesh->getPortNumber() != 0)
  {
    return; // arguments of traced functions are proxies, not their outputs
  }
  const QByteArray path = folder.toUtf8();
  std::vector<std::string> names, lines;
  for (const QString& name : criteria)
  {
    names.push_back(name.toStdString());
  }
  for (const QString& line : rules.Rules.split('\n', Qt::SkipEmptyParts))
  {
    lines.push_back(line.toStdString());
  }
  { // each item ends at the end of its block: while one exists, ParaView traces no other
    SM_SCOPED_TRACE(TraceText).arg("import camaron");
  }
  // The expression that makes a trace item must have all arguments.
#define CAMARON_TRACE                                                                              \
  SM_SCOPED_TRACE(CallFunction)                                                                    \
    .arg("camaron.inspect")                                                                        \
    .arg(mesh->getSourceProxy())                                                                   \
    .arg(path.constData())                                                                         \
    .arg("with_mesh", false)
  const QByteArray tolerate = rules.Tolerate.toUtf8();
  if (!lines.empty() && !names.empty())
  {
    CAMARON_TRACE.arg("criteria", names).arg("rules", lines).arg("tolerate", tolerate.constData());
  }
  else if (!lines.empty())
  {
    CAMARON_TRACE.arg("rules", lines).arg("tolerate", tolerate.constData());
  }
  else if (!names.empty())
  {
    CAMARON_TRACE.arg("criteria", names);
  }
  else
  {
    CAMARON_TRACE;
  }
#undef CAMARON_TRACE
}
}

//------------------------------------------------------------------------------
QString pqInspectedMesh::write(vtkSMSourceProxy* source, int port, const QString& path) const
{
  const pqScopedUndoExclude pause;
  if (!this->Helpers.update(source))
  {
    return tr("ParaView is busy; try again.");
  }
  const QString refusal = RefuseInput(source, path);
  if (!refusal.isEmpty())
  {
    return refusal;
  }
  const camaron::HelperFilters::Question question(this->Helpers);
  vtkSMWriterFactory* factory = vtkSMProxyManager::GetProxyManager()->GetWriterFactory();
  const auto writer = vtkSmartPointer<vtkSMSourceProxy>::Take(vtkSMSourceProxy::SafeDownCast(
    factory->CreateWriter(path.toUtf8().constData(), source, static_cast<unsigned>(port))));
  if (!writer)
  {
    return tr("%1: no writer of this server writes such files").arg(path);
  }
  constexpr int exactDigits = 17;
  camaron::SetProperty(writer, "Precision", exactDigits); // of tables
  const camaron::ErrorMessages errors;
  writer->UpdateVTKObjects();
  writer->UpdatePipeline(camaron::HelperFilters::time());
  const QString error = errors.first();
  // VTK's own writers say no more than that an algorithm failed.
  return error.startsWith("Algorithm ") ? tr("%1 cannot be written").arg(path) : error;
}

//------------------------------------------------------------------------------
QString pqInspectedMesh::writeText(const QString& path, const QByteArray& content) const
{
  const QString refusal = RefuseInput(this->Port ? this->Port->getSourceProxy() : nullptr, path);
  if (!refusal.isEmpty())
  {
    return refusal;
  }
  QSaveFile file(path);
  return file.open(QIODevice::WriteOnly) && file.write(content) == content.size() && file.commit()
    ? QString()
    : tr("%1 cannot be written: %2").arg(path, file.errorString());
}

//------------------------------------------------------------------------------
QString pqInspectedMesh::saveTables(const QString& folder) const
{
  const pqScopedUndoExclude pause;
  vtkSMSourceProxy* statistics = this->filterHelper("QualityStatistics", "Files");
  if (!statistics)
  {
    return tr("There is no mesh.");
  }
  const QStringList arrays = this->evaluated();
  camaron::SetProperties(statistics, { { "Arrays", QVariantList(arrays.begin(), arrays.end()) } });
  const QStringList names = { "statistics.csv", "histogram.csv", "worst.csv" };
  for (int port = 0; port < names.size(); ++port)
  {
    const QString error = this->write(statistics, port, QDir(folder).filePath(names[port]));
    if (!error.isEmpty())
    {
      return error;
    }
  }
  return tr("Written: %1").arg(names.join(", "));
}

//------------------------------------------------------------------------------
bool pqInspectedMesh::canSaveReport() const
{
  return this->Port && camaron::CanWriteReport();
}

//------------------------------------------------------------------------------
QString pqInspectedMesh::reportFolder() const
{
  if (!this->MeshPort)
  {
    return QString();
  }
  const QString name = QFileInfo(this->MeshPort->getSource()->getSMName()).completeBaseName();
  const bool isLocal = this->server() && !this->server()->isRemote();
  QString file;
  for (const char* name : { "FileName", "FileNames" })
  {
    const QVariant files = camaron::GetProperty(this->MeshPort->getSourceProxy(), name);
    const QString first = files.toList().value(0, files).toString();
    file = isLocal && file.isEmpty() ? first : file;
  }
  const QFileInfo folder(QFileInfo(file).absolutePath());
  return QDir(!file.isEmpty() && folder.isWritable() ? folder.filePath() : QDir::homePath())
    .filePath(name + "-report");
}

//------------------------------------------------------------------------------
QString pqInspectedMesh::saveReport(const QString& folder, const camaron::CheckRequest& rules) const
{
  const pqOutputPort* cells = this->CellsPort;
  if (!cells)
  {
    return tr("There is no mesh.");
  }
  const pqScopedUndoExclude pause;
  // An Element Quality has its own criteria.
  const bool isEvaluation = camaron::IsFilter(cells->getSource(), "ElementQuality");
  const QStringList criteria = isEvaluation ? QStringList() : this->evaluated();
  TraceReport(cells, criteria, rules, folder);
  SM_SCOPED_TRACE(BlockTraceItems); // Python uses further filters
  return camaron::WriteReport(
    cells->getSourceProxy(), cells->getPortNumber(), criteria, rules, folder);
}

//------------------------------------------------------------------------------
QString pqInspectedMesh::exportSelection(
  const QString& path, bool onServer, const QString& criterion) const
{
  const pqScopedUndoExclude pause;
  vtkSMSourceProxy* active = this->Port ? this->Port->getSelectionInput() : nullptr;
  if (!active)
  {
    return tr("Nothing is selected.");
  }
  const bool isOfPoints = this->selection().IsOfPoints;
  vtkSMSourceProxy* selected = this->marked("Current", isOfPoints ? "Points" : "Cells");
  const QFileInfo file(path);
  const QString extension = file.suffix().toLower();
  const bool isSet = extension.isEmpty() && file.dir().dirName() == "sets";
  const bool isOfIds = !onServer && (extension == "txt" || isSet);
  if (!onServer && !isOfIds)
  {
    return extension.isEmpty()
      ? tr("%1: an OpenFOAM set must be in a folder named \"sets\"").arg(path)
      : tr("%1: lists of ids are .txt files").arg(path);
  }
  vtkSMSourceProxy* table = this->filterHelper("SelectionTable", "Export", selected);
  const camaron::CriterionInfo* info = this->criterion(criterion);
  const bool isSorted = extension == "csv" && !isOfPoints; // points have no values of cells
  camaron::SetProperties(table,
    { { "SortBy", isSorted ? criterion : QString() },
      { "Descending", info && info->Better < 0 ? 1 : 0 } });
  if (extension == "csv")
  {
    return this->write(table, 0, path);
  }
  if (isSet && this->summary().Blocks > 1) // ids count over all blocks
  {
    return tr("%1: a set contains elements of one mesh, and this one has several blocks").arg(path);
  }
  if (isSet && this->elementType() != "Cell")
  {
    return tr("%1: the ids of %2 here are not those of OpenFOAM; sets contain cells or points")
      .arg(path, this->elements());
  }
  if (isOfIds)
  {
    const camaron::PanelTable rows = this->Helpers.fetch(table, 0, true);
    QVector<qint64> numbers;
    for (int row = 0; row < rows.size(); ++row)
    {
      numbers << rows.integer(row, "Id");
    }
    std::sort(numbers.begin(), numbers.end());
    QStringList ids;
    for (const qint64 id : numbers)
    {
      ids << QString::number(id);
    }
    return this->writeText(path,
      isSet             ? FormatSet(ids, file.fileName(), isOfPoints)
        : ids.isEmpty() ? QByteArray()
                        : (ids.join('\n') + '\n').toUtf8());
  }
  vtkSMSourceProxy* extraction = this->filterHelper("ExtractSelection", "Export");
  vtkSMPropertyHelper(extraction, "Selection").Set(active, 0);
  return this->write(extraction, 0, path);
}
