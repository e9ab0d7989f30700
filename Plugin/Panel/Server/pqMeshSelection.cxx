// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The active selection of the inspected mesh.
#include "pqMeshSelection.h"

#include "NumberText.h"
#include "ProxyValues.h"
#include "ThresholdSelection.h"
#include "pqInspectedMesh.h"
#include "pqMeshFilters.h"
#include "pqMeshQuestions.h"

#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqSelectionManager.h"
#include "pqUndoStack.h"

#include "vtkSMPropertyHelper.h"
#include "vtkSMSelectionHelper.h"
#include "vtkSMSourceProxy.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <limits>
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
}

//------------------------------------------------------------------------------
pqMeshSelection::pqMeshSelection(
  pqInspectedMesh* mesh, pqMeshQuestions* questions, pqMeshFilters* filters, QObject* parent)
  : QObject(parent)
  , Mesh(mesh)
  , Questions(questions)
  , Filters(filters)
{
  this->SelectionTimer.setSingleShot(true);
  this->SelectionTimer.setInterval(0);
  const auto tellLater = [this] { this->SelectionTimer.start(); };
  QObject::connect(&this->SelectionTimer, &QTimer::timeout, this,
    [this, tellLater]
    {
      if (this->Mesh->isComputing() || this->Mesh->willBeFound())
      {
        tellLater();
        return;
      }
      this->rememberSelection();
      Q_EMIT this->selectionChanged();
    });
  if (pqSelectionManager* manager = camaron::GetSelectionManager())
  {
    QObject::connect(manager, &pqSelectionManager::selectionChanged, this, tellLater);
  }
  QObject::connect(mesh, &pqInspectedMesh::portChanged, this, tellLater);
  QObject::connect(mesh, &pqInspectedMesh::meshChanged, this, &pqMeshSelection::restoreSelection);
  QObject::connect(mesh, &pqInspectedMesh::aboutToRemove, this,
    [this](pqPipelineSource* source)
    {
      this->Past.removeIf([source](const camaron::PastSelection& past)
        { return !past.Port || past.Port->getSource() == source; });
      if (this->Mesh->port() && this->Mesh->port()->getSource() == source)
      {
        this->IsStepRemoved = camaron::IsFilter(source, camaron::SelectName);
      }
    });
  QObject::connect(mesh, &pqInspectedMesh::forgotten, this,
    [this]
    {
      this->Past.clear();
      this->Brushed = {};
      this->SelectionBefore = {};
    });
}

//------------------------------------------------------------------------------
camaron::SelectionInfo pqMeshSelection::info() const
{
  camaron::SelectionInfo info;
  vtkSMSourceProxy* selected =
    this->Mesh->port() ? this->Mesh->port()->getSelectionInput() : nullptr;
  if (!this->Mesh->port())
  {
    return info;
  }
  const camaron::MeshSummary summary = this->Questions->summary();
  info.Total = summary.Cells;
  if (!selected || vtkSMPropertyHelper(selected, "Input").GetNumberOfElements() == 0)
  {
    return info;
  }
  info.IsOfPoints = camaron::IsOfPoints(selected);
  // ParaView's own count would include ghosts.
  const QString elements = info.IsOfPoints ? "Points" : "Cells";
  info.Count = this->Questions->count("Current", elements);
  info.Total = info.IsOfPoints ? summary.Points : summary.Cells;
  return info;
}

//------------------------------------------------------------------------------
bool pqMeshSelection::selectValues(const QString& array,
  const QVector<QPair<double, double>>& ranges, int specials, camaron::Combination combination)
{
  pqSelectionManager* manager = camaron::GetSelectionManager();
  if (!this->Mesh->port() || !manager)
  {
    return false;
  }
  if (ranges.isEmpty() && specials == 0)
  {
    const bool clears =
      combination == camaron::Combination::Replace && this->Mesh->port()->getSelectionInput();
    if (clears)
    {
      this->clear();
    }
    return clears;
  }
  vtkSMSourceProxy* before = this->Mesh->port()->getSelectionInput();
  if (!before && // nothing to take away from
    (combination == camaron::Combination::Subtract ||
      combination == camaron::Combination::Intersect))
  {
    return false;
  }
  if (before && camaron::IsOfPoints(before)) // which cells do not combine with
  {
    combination = camaron::Combination::Replace;
  }
  // Thresholds neither select undefined values nor intersect.
  const bool isUndefined = (specials & camaron::HistogramBrush::Undefined) != 0;
  if (isUndefined || combination == camaron::Combination::Intersect)
  {
    this->selectValuesBySteps(array, ranges, specials, combination);
    return true;
  }
  const camaron::CriterionInfo* info = this->Questions->criterion(array);
  camaron::PastSelection brush;
  brush.Text = ranges.isEmpty()
    ? tr("%1 infinite").arg(info ? info->Label : array)
    : tr("%1 from %2 to %3")
        .arg(info ? info->Label : array, camaron::ShortNumber(ranges.front().first),
          camaron::ShortNumber(ranges.back().second));
  if (combination != camaron::Combination::Replace)
  {
    brush.Text =
      (combination == camaron::Combination::Add ? tr("Added: ") : tr("Subtracted: ")) + brush.Text;
  }
  camaron::BrushedValues values{ array, {}, combination };
  std::vector<double>& thresholds = values.Thresholds;
  for (const QPair<double, double>& range : ranges)
  {
    thresholds.insert(thresholds.end(), { range.first, range.second });
  }
  if (specials & camaron::HistogramBrush::Infinite)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    thresholds.insert(thresholds.end(), { -infinity, -infinity, infinity, infinity });
  }
  brush.Brushes = combination == camaron::Combination::Replace ? QVector<camaron::BrushedValues>()
                                                               : this->brushes();
  {
    const pqScopedUndoExclude pause;
    const auto selection =
      camaron::MakeThresholdSelection(this->Mesh->port()->getSource(), array, thresholds, false);
    if (before && combination == camaron::Combination::Add)
    {
      vtkSMSelectionHelper::AddSelection(before, selection);
    }
    else if (before && combination == camaron::Combination::Subtract)
    {
      vtkSMSelectionHelper::SubtractSelection(before, selection);
    }
    this->Mesh->port()->setSelectionInput(selection, 0);
    manager->select(this->Mesh->port());
  }

  camaron::TraceThresholds(
    this->Mesh->port(), values, false, "select the cells brushed in the histogram");
  if (combination == camaron::Combination::Replace || !brush.Brushes.isEmpty())
  {
    brush.Brushes << values;
  }
  this->Brushed = brush;
  return true;
}

//------------------------------------------------------------------------------
void pqMeshSelection::clear()
{
  if (pqSelectionManager* manager = camaron::GetSelectionManager())
  {
    const pqScopedUndoExclude pause;
    manager->clearSelection();
    if (this->Mesh->port() &&
      this->Mesh->port()->getSelectionInput()) // that of a script, which the manager does not know
    {
      manager->clearSelection(this->Mesh->port());
    }
  }
}

//------------------------------------------------------------------------------
QString pqMeshSelection::exportTo(
  const QString& path, bool onServer, const QString& criterion) const
{
  vtkSMSourceProxy* active = this->Mesh->port() ? this->Mesh->port()->getSelectionInput() : nullptr;
  if (!active)
  {
    return tr("Nothing is selected.");
  }
  const bool isOfPoints = this->info().IsOfPoints;
  const camaron::Helper selected =
    this->Questions->marked("Current", isOfPoints ? "Points" : "Cells");
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
  const camaron::Helper table = this->Questions->filterHelper("SelectionTable", "Export", selected);
  const camaron::CriterionInfo* info = this->Questions->criterion(criterion);
  const bool isSorted = extension == "csv" && !isOfPoints; // points have no values of cells
  camaron::SetProperties(table,
    { { "SortBy", isSorted ? criterion : QString() },
      { "Descending", info && info->Better < 0 ? 1 : 0 } });
  if (extension == "csv")
  {
    return this->Filters->write(table, 0, path);
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
    return this->Filters->writeText(path,
      isSet             ? FormatSet(ids, file.fileName(), isOfPoints)
        : ids.isEmpty() ? QByteArray()
                        : (ids.join('\n') + '\n').toUtf8());
  }
  const camaron::Helper extraction = this->Questions->filterHelper("ExtractSelection", "Export");
  vtkSMPropertyHelper(extraction, "Selection").Set(active, 0);
  return this->Filters->write(extraction, 0, path);
}
