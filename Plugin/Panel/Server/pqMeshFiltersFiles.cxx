// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Files that the panel writes.
#include "pqMeshFilters.h"

#include "ErrorMessages.h"
#include "MarkedElements.h"
#include "ProxyValues.h"
#include "ThresholdSelection.h"
#include "pqInspectedMesh.h"
#include "pqMeshQuestions.h"

#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServer.h"
#include "pqUndoStack.h"

#include "vtkSMDirectoryProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMWriterFactory.h"

#if CAMARON_HAS_PYTHON
#include "vtkPythonInterpreter.h"
#endif

#include <QDir>
#include <QFileInfo>
#include <QSaveFile>

#include <algorithm>
#include <string>
#include <vector>

namespace
{
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
    : pqMeshFilters::tr("%1: the mesh was read from this file: choose another name").arg(path);
}

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
// A writer of a file of this name; of ours for tables, whose columns keep their order.
vtkSmartPointer<vtkSMSourceProxy> MakeWriter(
  vtkSMSourceProxy* source, int port, const QString& path)
{
  vtkSmartPointer<vtkSMProxy> writer;
  if (QFileInfo(path).suffix().toLower() == "csv")
  {
    writer.TakeReference(
      source->GetSessionProxyManager()->NewProxy("internal_writers", "GatheredTableWriter"));
    vtkSMPropertyHelper(writer, "Input").Set(source, static_cast<unsigned>(port));
    camaron::SetProperty(writer, "FileName", path);
    constexpr int exactDigits = 17;
    camaron::SetProperty(writer, "Precision", exactDigits);
  }
  else
  {
    vtkSMWriterFactory* factory = vtkSMProxyManager::GetProxyManager()->GetWriterFactory();
    writer.TakeReference(
      factory->CreateWriter(path.toUtf8().constData(), source, static_cast<unsigned>(port)));
  }
  return vtkSMSourceProxy::SafeDownCast(writer);
}

#if CAMARON_HAS_PYTHON
//------------------------------------------------------------------------------
// Arguments that are empty are left out.
void TraceReport(const pqOutputPort* mesh, const QStringList& criteria,
  const camaron::ReportRequest& request, const QString& folder)
{
  if (mesh->getPortNumber() != 0)
  {
    return; // arguments of traced functions are proxies, not their outputs
  }
  const auto convert = [](const QStringList& texts)
  {
    std::vector<std::string> converted;
    for (const QString& text : texts)
    {
      converted.push_back(text.toStdString());
    }
    return converted;
  };
  const std::vector<std::string> rules =
    convert(request.Rules.Rules.split('\n', Qt::SkipEmptyParts));
  { // each item ends at the end of its block: while one exists, ParaView traces no other
    SM_SCOPED_TRACE(TraceText).arg("import camaron");
  }
  vtkSMTrace::TraceItem item("CallFunction");
  vtkSMTrace::TraceItemArgs arguments;
  arguments.arg("camaron.inspect")
    .arg(mesh->getSourceProxy())
    .arg(folder.toUtf8().constData())
    .arg("with_mesh", false);
  if (!criteria.isEmpty())
  {
    arguments.arg("criteria", convert(criteria));
  }
  if (!request.Ranges.isEmpty())
  {
    arguments.arg("ranges", convert(request.Ranges));
  }
  if (!rules.empty())
  {
    arguments.arg("rules", rules).arg("tolerate", request.Rules.Tolerate.toUtf8().constData());
  }
  item = arguments;
}

//------------------------------------------------------------------------------
// A text as Python code: no character of it can end the code.
QString Quote(const QString& text)
{
  return QString("bytes.fromhex('%1').decode()").arg(QString::fromLatin1(text.toUtf8().toHex()));
}

//------------------------------------------------------------------------------
QString Quote(const QStringList& texts)
{
  QStringList quoted;
  for (const QString& text : texts)
  {
    quoted << Quote(text);
  }
  return '[' + quoted.join(", ") + ']';
}

//------------------------------------------------------------------------------
// Lets the Python package write a report about these criteria, or those of the mesh if it is an
// Element Quality. Returns an error, empty if written.
QString WriteReport(const pqOutputPort* mesh, const QStringList& criteria,
  const camaron::ReportRequest& request, const QString& folder)
{
  vtkPythonInterpreter::Initialize();
  vtkNew<vtkPythonInterpreter> interpreter;
  const camaron::ErrorMessages errors(interpreter);
  const QString code = QString("from camaron import window\n"
                               "window.write_report(%1, %2, %3, %4, %5, %6, %7)\n")
                         .arg(mesh->getSourceProxy()->GetGlobalID())
                         .arg(mesh->getPortNumber())
                         .arg(Quote(criteria), Quote(request.Ranges),
                           Quote(request.Rules.Rules.split('\n', Qt::SkipEmptyParts)),
                           Quote(request.Rules.Tolerate), Quote(folder));
  const int status = vtkPythonInterpreter::RunSimpleString(code.toUtf8().constData());
  const QString error = errors.first();
  if (error.contains("No module named 'camaron'"))
  {
    return pqMeshFilters::tr(
      "Reports need the Python package camaron, which is not in PYTHONPATH.");
  }
  return status == 0 || !error.isEmpty() ? error
                                         : pqMeshFilters::tr("Python failed; see Output Messages.");
}
#endif
}

//------------------------------------------------------------------------------
QString pqMeshFilters::write(vtkSMSourceProxy* source, int port, const QString& path) const
{
  const pqScopedUndoExclude pause;
  if (!this->Mesh->helpers().update(source))
  {
    return tr("ParaView is busy; try again.");
  }
  const QString refusal = RefuseInput(source, path);
  if (!refusal.isEmpty())
  {
    return refusal;
  }
  const auto question = this->Mesh->helpers().ask();
  const auto writer = MakeWriter(source, port, path);
  if (!writer)
  {
    return tr("%1: no writer of this server writes such files").arg(path);
  }
  const camaron::ErrorMessages errors;
  writer->UpdateVTKObjects();
  writer->UpdatePipeline(camaron::HelperFilters::time());
  const QString error = errors.first();
  // VTK's own writers say no more than that an algorithm failed.
  return error.startsWith("Algorithm ") ? tr("%1 cannot be written").arg(path) : error;
}

//------------------------------------------------------------------------------
QString pqMeshFilters::writeText(const QString& path, const QByteArray& content) const
{
  const QString refusal =
    RefuseInput(this->Mesh->port() ? this->Mesh->port()->getSourceProxy() : nullptr, path);
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
QString pqMeshFilters::saveTables(const QString& path) const
{
  const QStringList arrays = this->Questions->evaluated();
  const camaron::Helper statistics = this->Mesh->helpers().filter("QualityStatistics",
    this->Mesh->port(), "Files", { { "Arrays", QVariantList(arrays.begin(), arrays.end()) } });
  if (!statistics)
  {
    return tr("There is no mesh.");
  }
  const auto folders = vtkSmartPointer<vtkSMDirectoryProxy>::Take(vtkSMDirectoryProxy::SafeDownCast(
    this->Mesh->server()->proxyManager()->NewProxy("misc", "Directory")));
  const QStringList names = { "statistics.csv", "histogram.csv", "worst.csv" };
  const QFileInfo chosen(path);
  const QString folder = names.contains(chosen.fileName()) ? chosen.path() : path;
  if (folders)
  {
    folders->MakeDirectory(folder.toUtf8().constData());
  }
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
QString pqMeshFilters::exportSelection(
  const QString& path, bool onServer, const QString& criterion) const
{
  vtkSMSourceProxy* active = this->Mesh->selection();
  if (!active)
  {
    return tr("Nothing is selected.");
  }
  const bool isOfPoints = camaron::IsOfPoints(active);
  const camaron::Helper selected =
    camaron::MarkElements(*this->Mesh, "Current", isOfPoints ? "Points" : "Cells");
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
  const camaron::CriterionInfo* info = this->Questions->criterion(criterion);
  const bool isSorted = extension == "csv" && !isOfPoints; // points have no values of cells
  const camaron::Helper table = this->Mesh->helpers().filter("SelectionTable", selected, "Export",
    { { "SortBy", isSorted ? criterion : QString() },
      { "Descending", info && info->Better < 0 ? 1 : 0 } });
  if (extension == "csv")
  {
    return this->write(table, 0, path);
  }
  if (isSet && this->Questions->summary().Blocks > 1) // ids count over all blocks
  {
    return tr("%1: a set contains elements of one mesh, and this one has several blocks").arg(path);
  }
  if (isSet && this->Mesh->elementType() != "Cell")
  {
    return tr("%1: the ids of %2 here are not those of OpenFOAM; sets contain cells or points")
      .arg(path, this->Mesh->elements());
  }
  if (isOfIds)
  {
    const camaron::PanelTable rows = this->Mesh->helpers().fetch(table, 0, true);
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
  const camaron::Helper extraction =
    this->Mesh->helpers().filter("ExtractSelection", this->Mesh->port(), "Export");
  vtkSMPropertyHelper(extraction, "Selection").Set(active, 0);
  return this->write(extraction, 0, path);
}

//------------------------------------------------------------------------------
bool pqMeshFilters::canSaveReport() const
{
  return this->Mesh->port() && CAMARON_HAS_PYTHON != 0;
}

//------------------------------------------------------------------------------
QString pqMeshFilters::reportFolder() const
{
  if (!this->Mesh->meshPort())
  {
    return QString();
  }
  const QString name =
    QFileInfo(this->Mesh->meshPort()->getSource()->getSMName()).completeBaseName();
  const bool isLocal = this->Mesh->server() && !this->Mesh->server()->isRemote();
  QString file;
  for (const char* name : { "FileName", "FileNames" })
  {
    const QVariant files = camaron::GetProperty(this->Mesh->meshPort()->getSourceProxy(), name);
    const QString first = files.toList().value(0, files).toString();
    file = isLocal && file.isEmpty() ? first : file;
  }
  const QFileInfo folder(QFileInfo(file).absolutePath());
  return QDir(!file.isEmpty() && folder.isWritable() ? folder.filePath() : QDir::homePath())
    .filePath(name + "-report");
}

//------------------------------------------------------------------------------
QString pqMeshFilters::saveReport(
  const QString& folder, const camaron::ReportRequest& request) const
{
#if CAMARON_HAS_PYTHON
  const pqOutputPort* cells = this->Mesh->cellsPort();
  if (!cells)
  {
    return tr("There is no mesh.");
  }
  const pqScopedUndoExclude pause;
  // An Element Quality has its own criteria. Named, they are judged by the ranges of this window,
  // which are not those of its preset.
  QStringList criteria = this->Questions->evaluated();
  if (camaron::IsFilter(cells->getSource(), "ElementQuality"))
  {
    criteria.clear();
    const QVariant chosen = camaron::GetProperty(cells->getSource()->getProxy(), "Preset");
    for (const camaron::PresetInfo& preset : this->Questions->presets())
    {
      criteria += preset.Name == chosen.toString() ? preset.Criteria : QStringList();
    }
  }
  TraceReport(cells, criteria, request, folder);
  SM_SCOPED_TRACE(BlockTraceItems); // Python uses further filters
  return WriteReport(cells, criteria, request, folder);
#else
  Q_UNUSED(request);
  return tr("%1: this ParaView has no Python.").arg(folder);
#endif
}
