// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Validity, elements, regions, verdicts, and numbers of selected elements.
#include "pqMeshQuestions.h"

#include "CellTypeNames.h"
#include "ErrorMessages.h"
#include "MarkedElements.h"
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

#include <QRegularExpression>

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

//------------------------------------------------------------------------------
// Cells by "Cell type", or by the value of a criterion ("Cell array"), which is evaluated for this
// if the mesh lacks it.
QVector<camaron::ValidityInfo::NamedCount> CountGroups(
  const pqInspectedMesh& mesh, const QString& array, const QString& groupBy)
{
  camaron::HelperFilters& helpers = mesh.helpers();
  const camaron::HelperFilters::Properties properties = { { "Arrays", array },
    { "NumberOfBins", 1 }, { "NumberOfWorst", 0 }, { "GroupBy", groupBy },
    { "GroupArray", array } };
  // One filter for each grouping, which answers again without computing.
  const QByteArray key = (array + groupBy).toLatin1();
  const camaron::Helper statistics = mesh.cellArrays().contains(array)
    ? helpers.filter("QualityStatistics", mesh.cellsPort(), key, properties)
    : helpers.filter("QualityStatistics",
        helpers.filter("ElementQuality", mesh.cellsPort(), array.toLatin1(),
          { { "Criteria", QVariantList{ array, "1" } } }),
        key, properties);
  const PanelTable table = helpers.fetch(statistics, 0);
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
// The shapes of the cells by their topology, as types of VTK such as "Hexahedron", also for
// polyhedra that have it.
QStringList FindShapes(const pqInspectedMesh& mesh)
{
  static const QMap<QString, QString> names = { { "5", "Triangle" }, { "7", "Polygon" },
    { "9", "Quad" }, { "10", "Tetra" }, { "12", "Hexahedron" }, { "13", "Wedge" },
    { "14", "Pyramid" }, { "42", "Polyhedron" } }; // VTK's types for the families
  QStringList shapes;
  for (const auto& family : CountGroups(mesh, "CellFamilyId", "Cell array"))
  {
    shapes += names.contains(family.Name) ? QStringList(names[family.Name]) : QStringList();
  }
  return shapes;
}
}

//------------------------------------------------------------------------------
camaron::ValidityInfo pqMeshQuestions::validity() const
{
  camaron::ValidityInfo info;
  info.Types = CountGroups(*this->Mesh, "CellStatus", "Cell type");
  const auto values = CountGroups(*this->Mesh, "CellStatus", "Cell array");
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
bool pqMeshQuestions::isSurface() const
{
  const QStringList present = this->Mesh->isSmall() ? FindShapes(*this->Mesh) : QStringList();
  const QStringList polygons = { "Triangle", "Quad", "Polygon" };
  return !present.isEmpty() &&
    std::all_of(present.begin(), present.end(),
      [&](const QString& shape) { return polygons.contains(shape); });
}

//------------------------------------------------------------------------------
QMap<QString, QString> pqMeshQuestions::unfitPresets() const
{
  const QStringList present = FindShapes(*this->Mesh);
  static const QRegularExpression order("Quadratic|Cubic|HigherOrder|Lagrange|Bezier|Parametric");
  const auto types = CountGroups(*this->Mesh, "CellFamilyId", "Cell type");
  const bool isLinear = !present.isEmpty() &&
    std::none_of(
      types.begin(), types.end(), [](const auto& type) { return type.Name.contains(order); });
  // The size of a cell says nothing about its shape.
  const QStringList sizes = { "Area", "Volume" };
  const auto fits = [&](const QString& criterion, const QString& shapes)
  {
    const camaron::CriterionInfo* info = this->criterion(criterion);
    return info && !sizes.contains(criterion) &&
      std::any_of(present.begin(), present.end(),
        [&](const QString& shape)
        {
          return camaron::IsAmong(shape, info->AppliesTo) &&
            (shapes.isEmpty() || camaron::IsAmong(shape, shapes));
        });
  };
  const auto isCurved = [&](const QString& criterion)
  {
    const camaron::CriterionInfo* info = this->criterion(criterion);
    return info && info->IsCurved;
  };
  QMap<QString, QString> unfit;
  for (const camaron::PresetInfo& preset : this->presets())
  {
    bool isFit = present.isEmpty();
    for (int i = 0; i < preset.Criteria.size(); ++i)
    {
      isFit = isFit || fits(preset.Criteria[i], preset.Shapes[i]);
    }
    if (!isFit)
    {
      unfit[preset.Name] = tr("Not for the cells of this mesh");
    }
    else if (isLinear && std::all_of(preset.Criteria.begin(), preset.Criteria.end(), isCurved))
    {
      unfit[preset.Name] = tr("Only for cells of second or higher order");
    }
  }
  return unfit;
}

//------------------------------------------------------------------------------
camaron::Location pqMeshQuestions::locate(qint64 id, const QString& idSpace) const
{
  camaron::Location location;
  location.Id = QString::number(id);
  location.IdSpace = idSpace;
  std::fill(std::begin(location.Center), std::end(location.Center),
    std::numeric_limits<double>::quiet_NaN());
  const camaron::Helper element = camaron::ExtractElements(*this->Mesh, location, "Target");
  if (this->Mesh->helpers().update(element))
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
  camaron::HelperFilters& helpers = this->Mesh->helpers();
  const camaron::Helper selected = camaron::MarkElements(*this->Mesh, "Current", "Cells");
  return helpers.fetch(helpers.filter("SelectionTable", selected, "Picked"), 0, true).text(0, "Id");
}

//------------------------------------------------------------------------------
camaron::PanelTable pqMeshQuestions::regions(
  const QString& array, int number, const camaron::Limits& limits) const
{
  QMap<QString, QVariant> properties = { { "Array", array }, { "NumberOfRegions", number } };
  camaron::AddLimits(properties, limits);
  camaron::HelperFilters& helpers = this->Mesh->helpers();
  return helpers.fetch(
    helpers.filter("QualityRegions", this->Mesh->cellsPort(), "", properties), 0);
}

//------------------------------------------------------------------------------
camaron::CheckResult pqMeshQuestions::check(const camaron::CheckRequest& request) const
{
  camaron::CheckResult result;
  QMap<QString, QVariant> properties = request.Options;
  properties.insert({ { "Rules", request.Rules }, { "Preset", "None" },
    { "Tolerate", request.Tolerate }, { "NumberOfWorst", 0 } });
  const camaron::Helper check =
    this->Mesh->helpers().filter("CheckQuality", this->Mesh->cellsPort(), "", properties);
  if (!check)
  {
    return result;
  }
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
