// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Tables that the server computes.
#include "pqMeshQuestions.h"

#include "CellTypeNames.h"
#include "MarkedElements.h"
#include "ProxyValues.h"
#include "pqInspectedMesh.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"

#include "vtkSMSourceProxy.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace
{
using camaron::PanelTable;

//------------------------------------------------------------------------------
// The properties of Quality Statistics for a request.
QMap<QString, QVariant> ToProperties(
  const QStringList& arrays, const camaron::DistributionRequest& request)
{
  const QPair<double, double> range = request.Range.value_or(qMakePair(0.0, 1.0));
  return { { "Arrays", QVariantList(arrays.begin(), arrays.end()) },
    { "NumberOfBins", request.Bins },
    { "HistogramScale", request.Logarithmic ? "Logarithmic" : "Linear" },
    { "HistogramRange", request.Range ? "Custom" : "All elements" },
    { "CustomRange", QVariantList{ range.first, range.second } },
    { "BinEdges", QVariantList(request.Edges.begin(), request.Edges.end()) },
    { "Preset", request.Preset }, { "Ranges", request.Ranges.join('\n') },
    { "OnlySelected", request.CountsSelected }, { "GroupBy", request.GroupBy },
    { "GroupArray", request.GroupArray },
    { "CurveValues", QVariantList(request.CurveValues.begin(), request.CurveValues.end()) },
    { "CurvePoints", request.CurvePoints }, { "NumberOfWorst", 0 }, { "Quantiles", QVariantList() },
    { "Moments", 0 } };
}

//------------------------------------------------------------------------------
// The statistics of the group of all cells.
camaron::Distribution ReadStatistics(const PanelTable& table, int row)
{
  camaron::Distribution result;
  result.Array = table.text(row, "Criterion");
  result.Count = table.integer(row, "Count");
  result.Undefined = table.integer(row, "UndefinedCount");
  result.Applicable = table.integer(row, "ApplicableCount");
  result.Judged = table.integer(row, "JudgedCount");
  result.JudgedUndefined = table.integer(row, "JudgedUndefinedCount");
  result.Below = table.integer(row, "BelowCount");
  result.Above = table.integer(row, "AboveCount");
  if (result.Judged > 0)
  {
    const double low = table.number(row, "AcceptableLow");
    const double high = table.number(row, "AcceptableHigh");
    result.Low = std::isnan(low) ? result.Low : low;
    result.High = std::isnan(high) ? result.High : high;
  }
  result.BadVolume = table.number(row, "BadVolumeFraction");
  result.Histogram.Name = result.Array;
  result.Histogram.Unit = table.text(row, "Unit");
  return result;
}

//------------------------------------------------------------------------------
// Adds a row of the histogram to the group at the end of the list, or to a new one.
void AddBin(std::vector<camaron::HistogramData::Group>& groups, std::vector<double>& edges,
  const PanelTable& table, int row)
{
  const QString label = table.text(row, "Group");
  // Blocks may have the name of the group before, but bins begin anew.
  const qint64 bin = table.integer(row, "Bin");
  const bool isNext = row > 0 && bin > table.integer(row - 1, "Bin");
  if (groups.empty() || groups.back().Label != label || !isNext)
  {
    camaron::HistogramData::Group group;
    group.Label = label;
    for (const char* column : { "Underflow", "Overflow", "InfiniteCount", "UndefinedCount" })
    {
      group.Counts.push_back(table.integer(row, column));
    }
    groups.push_back(group);
    edges.clear(); // all groups have the same
  }
  if (bin >= 0)
  {
    if (edges.empty())
    {
      edges.push_back(table.number(row, "LowerEdge"));
    }
    edges.push_back(table.number(row, "UpperEdge"));
    auto& counts = groups.back().Counts;
    constexpr int columnsBehind = 3;
    counts.insert(counts.end() - columnsBehind, table.integer(row, "Count"));
    groups.back().Judged.push_back(table.integer(row, "JudgedCount"));
  }
}

//------------------------------------------------------------------------------
// Replaces the first group, of all elements, by one of those in none of the others, if there are
// any. The bars of all groups then add up to those of all cells.
void LeaveOthers(std::vector<camaron::HistogramData::Group>& groups, const QString& elements)
{
  camaron::HistogramData::Group& others = groups.front();
  others.Label = QCoreApplication::translate("pqMeshQuestions", "other %1").arg(elements);
  for (auto group = groups.begin() + 1; group != groups.end(); ++group)
  {
    std::transform(others.Counts.begin(), others.Counts.end(), group->Counts.begin(),
      others.Counts.begin(), std::minus<>());
  }
  const bool isEmpty =
    std::all_of(others.Counts.begin(), others.Counts.end(), [](auto count) { return count == 0; });
  std::rotate(groups.begin(), groups.begin() + 1, groups.end()); // on top of the stack
  if (isEmpty)
  {
    groups.pop_back();
  }
}

//------------------------------------------------------------------------------
// What Quality Statistics computes for a request.
QVector<camaron::Distribution> FetchDistributions(const pqInspectedMesh& mesh,
  vtkSMSourceProxy* statistics, const QStringList& arrays,
  const camaron::DistributionRequest& request, bool hasWeights)
{
  QVector<camaron::Distribution> results;
  if (!statistics)
  {
    return results;
  }
  QMap<QString, QVariant> properties = ToProperties(arrays, request);
  properties["WeightArray"] = QString(hasWeights ? "Volume" : "");
  camaron::SetProperties(statistics, properties);
  const PanelTable rows = mesh.helpers().fetch(statistics, 0);
  const PanelTable bins = mesh.helpers().fetch(statistics, 1);
  const PanelTable curve = mesh.helpers().fetch(statistics, 3);
  for (int row = 0; row < rows.size(); ++row)
  {
    const bool isNew = results.isEmpty() || results.back().Array != rows.text(row, "Criterion");
    if (isNew && rows.text(row, "Group") == camaron::AllCells) // a block may have this name, too
    {
      results << ReadStatistics(rows, row);
    }
  }
  for (camaron::Distribution& result : results)
  {
    result.Histogram.Logarithmic = request.Logarithmic;
    auto& groups = result.Histogram.Groups;
    for (int row = 0; row < bins.size(); ++row)
    {
      if (bins.text(row, "Criterion") == result.Array)
      {
        AddBin(groups, result.Histogram.Edges, bins, row);
      }
    }
    for (auto& group : groups)
    {
      constexpr int many = 2;
      group.Label =
        request.GroupBy == "Cell type" ? camaron::CellTypeName(group.Label, many) : group.Label;
    }
    if (request.CountsSelected && !groups.empty())
    {
      result.Histogram.Selected = groups.front();
    }
    if (groups.size() > 1)
    {
      LeaveOthers(groups, mesh.elements());
    }
    for (int row = 0; row < curve.size(); ++row)
    {
      const double value = curve.number(row, "Value");
      auto& values = result.Cumulative.Values;
      if (curve.text(row, "Criterion") == result.Array &&
        curve.text(row, "Group") == camaron::AllCells && (values.empty() || value > values.back()))
      {
        values.push_back(value);
        result.Cumulative.Counts.push_back(curve.integer(row, "Count"));
        const double weight = curve.number(row, "WeightPercent");
        if (!std::isnan(weight))
        {
          result.Cumulative.WeightPercents.push_back(weight);
        }
      }
    }
  }
  return results;
}
}

//------------------------------------------------------------------------------
QVector<QPair<QString, pqOutputPort*>> pqMeshQuestions::otherMeshes(const QString& array) const
{
  QVector<QPair<QString, pqOutputPort*>> meshes;
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  for (auto* source :
    model->findItems<pqPipelineSource*>(pqActiveObjects::instance().activeServer()))
  {
    pqOutputPort* port = source->getOutputPort(0);
    if (port != this->Mesh->port() && camaron::MeshOutput(port).array(array))
    {
      meshes << qMakePair(source->getSMName(), port);
    }
  }
  return meshes;
}

//------------------------------------------------------------------------------
QVector<camaron::Distribution> pqMeshQuestions::distributions(
  const QStringList& arrays, const camaron::DistributionRequest& request, pqOutputPort* other) const
{
  QStringList present = arrays;
  if (!other)
  {
    const QStringList known = this->Mesh->cellArrays();
    present.removeIf([&](const QString& array) { return !known.contains(array); });
  }
  if (present.isEmpty())
  {
    return {};
  }
  constexpr const char* name = "QualityStatistics";
  // One filter for each kind of request, which answers again without computing.
  camaron::HelperFilters& helpers = this->Mesh->helpers();
  pqOutputPort* cells = this->Mesh->cellsPort();
  const camaron::Helper statistics = other ? helpers.filter(name, other, "Other")
    : request.CountsSelected
    ? helpers.filter(name, camaron::MarkElements(*this->Mesh, "Current", "Cells"), "Selected")
    : request.GroupBy == "Cell array"
    ? helpers.filter(name, this->Mesh->port(), "Groups") // perhaps of a step
    : present.size() > 1            ? helpers.filter(name, cells, "All")
    : request.Bins == 1             ? helpers.filter(name, cells, "NoBins")
    : request.CurveValues.isEmpty() ? helpers.filter(name, cells, "One")
                                    : helpers.filter(name, cells, "Curve");
  const bool hasWeights =
    !other && !request.CountsSelected && this->Mesh->cellArrays().contains("Volume");
  return FetchDistributions(*this->Mesh, statistics, present, request, hasWeights);
}

//------------------------------------------------------------------------------
camaron::PanelTable pqMeshQuestions::worst(const QString& array, int number) const
{
  camaron::HelperFilters& helpers = this->Mesh->helpers();
  return helpers.fetch(
    helpers.filter("QualityStatistics", this->Mesh->cellsPort(), "Worst",
      { { "Arrays", array }, { "NumberOfWorst", number }, { "NumberOfBins", 1 } }),
    2);
}

//------------------------------------------------------------------------------
camaron::ElementInfo pqMeshQuestions::element(
  qint64 id, const QString& idSpace, const QStringList& ranges) const
{
  camaron::HelperFilters& helpers = this->Mesh->helpers();
  camaron::ElementInfo info;
  camaron::Location location;
  location.Id = QString::number(id);
  location.IdSpace = idSpace;
  const camaron::Helper one = helpers.filter(camaron::SelectName, this->Mesh->port(), "Element",
    { { "Strategy", "By id" }, { "Ids", location.Id }, { "IdSpace", idSpace },
      { "Quiet", 1 } }); // an id that does not exist is told in the card
  info.Values = helpers.fetch(helpers.filter("SelectionTable", one, "Element"), 0, true);
  if (info.Values.isEmpty())
  {
    return info;
  }
  const QString adjacency = this->Mesh->elementType() == "Edge" ? "Vertex" : "Face";
  const camaron::Helper layer = helpers.filter(camaron::SelectName, one, "Neighbors",
    { { "Strategy", "Expand" }, { "Adjacency", adjacency } });
  const PanelTable neighbors =
    helpers.fetch(helpers.filter("SelectionTable", layer, "Neighbors"), 0, true);
  for (int row = 0; row < neighbors.size(); ++row)
  {
    if (neighbors.integer(row, "Id") != info.Values.integer(0, "Id"))
    {
      info.Neighbors << neighbors.text(row, "Id");
    }
  }
  const camaron::Helper statistics = helpers.filter(
    "QualityStatistics", camaron::ExtractElements(*this->Mesh, location, "Judged"), "Judged");
  camaron::DistributionRequest request;
  request.Bins = 1;
  request.Ranges = ranges;
  for (const camaron::Distribution& judged :
    FetchDistributions(*this->Mesh, statistics, this->evaluated(), request, false))
  {
    info.Failing += judged.failing() > 0 ? QStringList(judged.Array) : QStringList();
  }
  return info;
}
