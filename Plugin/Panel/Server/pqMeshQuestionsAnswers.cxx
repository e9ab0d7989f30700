// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Validity, elements, regions, verdicts, and numbers of selected elements.
#include "pqMeshQuestions.h"

#include "CellTypeNames.h"
#include "ErrorMessages.h"
#include "ProxyValues.h"
#include "ThresholdSelection.h"
#include "pqInspectedMesh.h"

#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServer.h"

#include "vtkBoundingBox.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace
{
using camaron::PanelTable;

//------------------------------------------------------------------------------
// Problems of rules: line and text.
PanelTable GetProblems(vtkSMSourceProxy* check)
{
  PanelTable problems;
  problems.Columns = QStringList{ "Line", "Text" };
  vtkSMProperty* property = check->GetProperty("Problems");
  if (property)
  {
    camaron::UpdateInformation(check, property);
    vtkSMPropertyHelper values(property);
    // source, line and reason of each
    for (unsigned i = 0; i + 2 < values.GetNumberOfElements(); i += 3)
    {
      problems.Rows << QVector<QVariant>{ QString(values.GetAsString(i + 1)).toLongLong(),
        QString::fromUtf8(values.GetAsString(i + 2)) };
    }
  }
  return problems;
}
}

//------------------------------------------------------------------------------
QVector<camaron::ValidityInfo::NamedCount> pqMeshQuestions::countGroups(
  const QString& array, const QString& groupBy) const
{
  const bool isEvaluated = this->Mesh->cellArrays().contains(array);
  const camaron::Helper quality =
    isEvaluated ? nullptr : this->cellsHelper("ElementQuality", array.toLatin1());
  if (quality)
  {
    camaron::SetProperties(quality, { { "Criteria", QVariantList{ array, "1" } } });
  }
  // One filter for each grouping, which answers again without computing.
  const QByteArray key = (array + groupBy).toLatin1();
  const camaron::Helper statistics = quality ? this->filterHelper("QualityStatistics", key, quality)
                                             : this->cellsHelper("QualityStatistics", key);
  if (!statistics)
  {
    return {};
  }
  camaron::SetProperties(statistics,
    { { "Arrays", array }, { "NumberOfBins", 1 }, { "NumberOfWorst", 0 }, { "GroupBy", groupBy },
      { "GroupArray", array } });
  const PanelTable table = this->Mesh->helpers().fetch(statistics, 0);
  QVector<camaron::ValidityInfo::NamedCount> groups;
  for (int row = 0; row < table.size(); ++row)
  {
    const QString group = table.text(row, "Group");
    if (group != camaron::AllCells)
    {
      const qint64 count = table.integer(row, "Count");
      groups << camaron::ValidityInfo::NamedCount{ group, camaron::CellTypeName(group, count),
        count };
    }
  }
  return groups;
}

//------------------------------------------------------------------------------
camaron::ValidityInfo pqMeshQuestions::validity() const
{
  camaron::ValidityInfo info;
  info.Types = this->countGroups("CellStatus", "Cell type");
  const auto values = this->countGroups("CellStatus", "Cell array");
  const PanelTable& bits = this->statusBits();
  for (int row = 0; row < bits.size(); ++row)
  {
    camaron::ValidityInfo::NamedCount defect{ bits.text(row, "Name"), bits.text(row, "Description"),
      0, bits.integer(row, "Invalid") != 0 };
    for (const auto& value : values)
    {
      defect.Count += (value.Name.toLongLong() & bits.integer(row, "Bit")) != 0 ? value.Count : 0;
    }
    if (defect.Count > 0)
    {
      info.Defects << defect;
    }
  }
  return info;
}

//------------------------------------------------------------------------------
QStringList pqMeshQuestions::shapes() const
{
  static const QMap<QString, QString> names = { { "5", "Triangle" }, { "7", "Polygon" },
    { "9", "Quad" }, { "10", "Tetra" }, { "12", "Hexahedron" }, { "13", "Wedge" },
    { "14", "Pyramid" }, { "42", "Polyhedron" } }; // VTK's types for the families
  QStringList shapes;
  for (const auto& family : this->countGroups("CellFamilyId", "Cell array"))
  {
    shapes += names.contains(family.Name) ? QStringList(names[family.Name]) : QStringList();
  }
  return shapes;
}

//------------------------------------------------------------------------------
bool pqMeshQuestions::isSurface() const
{
  const QStringList present = this->Mesh->isSmall() ? this->shapes() : QStringList();
  const QStringList polygons = { "Triangle", "Quad", "Polygon" };
  return !present.isEmpty() &&
    std::all_of(present.begin(), present.end(),
      [&](const QString& shape) { return polygons.contains(shape); });
}

//------------------------------------------------------------------------------
camaron::PanelTable pqMeshQuestions::elementWithNeighbors(qint64 id, const QString& idSpace) const
{
  const camaron::Helper one = this->filterHelper(camaron::SelectName, "Element");
  if (!one)
  {
    return {};
  }
  camaron::SetProperties(one,
    { { "Strategy", "By id" }, { "Ids", QString::number(id) }, { "IdSpace", idSpace },
      { "Quiet", 1 } }); // an id that does not exist is told in the card
  const camaron::Helper layer = this->filterHelper(camaron::SelectName, "Neighbors", one);
  const QString adjacency = this->Mesh->elementType() == "Edge" ? "Vertex" : "Face";
  camaron::SetProperties(layer, { { "Strategy", "Expand" }, { "Adjacency", adjacency } });
  PanelTable rows =
    this->Mesh->helpers().fetch(this->filterHelper("SelectionTable", "Element", one), 0, true);
  const PanelTable neighbors =
    this->Mesh->helpers().fetch(this->filterHelper("SelectionTable", "Neighbors", layer), 0, true);
  for (int row = 0; row < neighbors.size(); ++row)
  {
    if (neighbors.integer(row, "Id") != rows.integer(0, "Id"))
    {
      rows.append({ neighbors.Columns, { neighbors.Rows[row] } });
    }
  }
  return rows;
}

//------------------------------------------------------------------------------
camaron::Location pqMeshQuestions::locate(qint64 id, const QString& idSpace) const
{
  camaron::Location location;
  location.Id = QString::number(id);
  location.IdSpace = idSpace;
  std::fill(std::begin(location.Center), std::end(location.Center),
    std::numeric_limits<double>::quiet_NaN());
  const camaron::Helper element = this->extracted(location, "Target");
  if (element && this->Mesh->helpers().update(element))
  {
    const vtkBoundingBox box(element->GetDataInformation(0)->GetBounds());
    if (box.IsValid())
    {
      box.GetCenter(location.Center);
      location.Size = box.GetDiagonalLength();
    }
  }
  return location;
}

//------------------------------------------------------------------------------
QString pqMeshQuestions::selectedId() const
{
  const camaron::Helper selected = this->marked("Current", "Cells");
  return selected ? this->Mesh->helpers()
                      .fetch(this->filterHelper("SelectionTable", "Picked", selected), 0, true)
                      .text(0, "Id")
                  : QString();
}

//------------------------------------------------------------------------------
QStringList pqMeshQuestions::failing(
  qint64 id, const QString& idSpace, const QStringList& ranges) const
{
  camaron::Location location;
  location.Id = QString::number(id);
  location.IdSpace = idSpace;
  const camaron::Helper element = this->extracted(location, "Judged");
  const camaron::Helper statistics = this->filterHelper("QualityStatistics", "Judged", element);
  camaron::DistributionRequest request;
  request.Bins = 1;
  request.Ranges = ranges;
  QStringList names;
  if (element && statistics)
  {
    for (const camaron::Distribution& judged :
      this->fetchDistributions(statistics, this->evaluated(), request, false))
    {
      names += judged.failing() > 0 ? QStringList(judged.Array) : QStringList();
    }
  }
  return names;
}

//------------------------------------------------------------------------------
camaron::PanelTable pqMeshQuestions::regions(
  const QString& array, int number, const camaron::Limits& limits) const
{
  const camaron::Helper regions = this->cellsHelper("QualityRegions");
  if (!regions)
  {
    return {};
  }
  QMap<QString, QVariant> properties = { { "Array", array }, { "NumberOfRegions", number } };
  camaron::AddLimits(properties, limits);
  camaron::SetProperties(regions, properties);
  return this->Mesh->helpers().fetch(regions, 0);
}

//------------------------------------------------------------------------------
camaron::CheckResult pqMeshQuestions::check(const camaron::CheckRequest& request) const
{
  camaron::CheckResult result;
  const camaron::Helper check = this->cellsHelper("CheckQuality");
  if (!check)
  {
    return result;
  }
  camaron::SetProperties(check, request.Options);
  camaron::SetProperties(check,
    { { "Rules", request.Rules }, { "Preset", "None" }, { "Tolerate", request.Tolerate },
      { "NumberOfWorst", 0 } });
  result.Problems = GetProblems(check);
  if (result.Problems.isEmpty())
  {
    const camaron::ErrorMessages errors;
    result.Verdicts = this->Mesh->helpers().fetch(check, 0);
    result.Error = errors.first();
  }
  for (int row = 0; row < result.Verdicts.size(); ++row)
  { // the worst of them
    const QStringList order = { "empty", "pass", "warn", "fail" };
    const QString verdict = result.Verdicts.text(row, "Verdict");
    if (order.indexOf(verdict) > order.indexOf(result.Verdict))
    {
      result.Verdict = verdict;
    }
  }
  return result;
}

//------------------------------------------------------------------------------
QMap<QString, QVariant> pqMeshQuestions::evaluationOptions() const
{
  pqOutputPort* cells = this->Mesh->cellsPort();
  QMap<QString, QVariant> options;
  if (!cells)
  {
    return options;
  }
  const char* const evaluator = "ElementQuality";
  pqPipelineSource* source = cells->getSource();
  vtkSMProxy* proxy = camaron::IsFilter(source, evaluator)
    ? source->getProxy()
    : this->Mesh->server()->proxyManager()->GetPrototypeProxy("filters", evaluator);
  for (const char* name : { "TrustFaceOrientation", "DegeneracyTolerance", "ConvexityTolerance",
         "PlanarityTolerance", "ConnectBlocks" })
  {
    options[name] = camaron::GetProperty(proxy, name);
  }
  return options;
}

//------------------------------------------------------------------------------
camaron::Helper pqMeshQuestions::marked(const QString& strategy, const QString& elements) const
{
  // One for each, which marks again without computing.
  const QByteArray key = "Marked" + (strategy + elements).toLatin1();
  const camaron::Helper select = this->filterHelper(camaron::SelectName, key);
  if (select)
  {
    camaron::SetProperty(select, "Strategy", strategy);
    camaron::SetProperty(select, "ElementType", elements);
    vtkSMPropertyHelper input(select, "Selection");
    vtkSMSourceProxy* selection = this->Mesh->selection();
    if (input.GetAsProxy() != selection) // else the filter would mark them once more
    {
      input.RemoveAllValues();
      if (selection)
      {
        input.Set(selection, 0);
      }
    }
    select->UpdateVTKObjects();
  }
  return select;
}

//------------------------------------------------------------------------------
qint64 pqMeshQuestions::count(const QString& strategy, const QString& elements) const
{
  const camaron::Helper select = this->marked(strategy, elements);
  if (!select || !this->Mesh->helpers().update(select))
  {
    return 0;
  }
  vtkSMProperty* number = select->GetProperty("NumberOfSelectedElements");
  camaron::UpdateInformation(select, number);
  return vtkSMPropertyHelper(number).GetAsIdType();
}

//------------------------------------------------------------------------------
camaron::Helper pqMeshQuestions::extracted(const camaron::Location& location, const char* key) const
{
  const camaron::Helper selected = this->cellsHelper(camaron::SelectName, key);
  const camaron::Helper extraction = this->cellsHelper("ExtractSelection", key);
  if (!selected || !extraction)
  {
    return nullptr;
  }
  const bool isOfPlace = !location.GroupArray.isEmpty();
  QMap<QString, QVariant> properties = isOfPlace
    ? camaron::GrowToPlace(location.GroupArray, location.GroupLimits)
    : QMap<QString, QVariant>();
  properties["Strategy"] = QString(isOfPlace ? "Connected to ids" : "By id");
  properties["Ids"] = location.Id;
  properties["IdSpace"] = location.IdSpace;
  camaron::SetProperties(selected, properties);
  vtkSMPropertyHelper(extraction, "Selection").Set(selected, 1);
  extraction->UpdateVTKObjects();
  return extraction;
}
