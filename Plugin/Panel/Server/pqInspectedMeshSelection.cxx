// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The active selection of the inspected mesh.
#include "pqInspectedMesh.h"

#include "NumberText.h"
#include "ProxyValues.h"
#include "ThresholdSelection.h"

#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqSelectionManager.h"

#include "vtkDataObject.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSelectionHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTrace.h"
#include "vtkSelectionNode.h"

#include <limits>
#include <vector>

namespace
{
constexpr const char* SelectName = "SelectElements";

//------------------------------------------------------------------------------
// Modifier of paraview.selection; nullptr for one that does not exist there.
const char* GetModifier(camaron::Combination combination)
{
  switch (combination)
  {
    case camaron::Combination::Add:
      return "ADD";
    case camaron::Combination::Subtract:
      return "SUBTRACT";
    default:
      return nullptr;
  }
}

}

//------------------------------------------------------------------------------
vtkSMSourceProxy* pqInspectedMesh::marked(const QString& strategy, const QString& elements) const
{
  vtkSMSourceProxy* select = this->filterHelper(SelectName, "Marked");
  if (select)
  {
    camaron::SetProperty(select, "Strategy", strategy);
    camaron::SetProperty(select, "ElementType", elements);
    vtkSMPropertyHelper input(select, "Selection");
    vtkSMSourceProxy* selection = this->Port->getSelectionInput();
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
qint64 pqInspectedMesh::count(const QString& strategy, const QString& elements) const
{
  const camaron::UndoPause pause;
  vtkSMSourceProxy* select = this->marked(strategy, elements);
  if (!select)
  {
    return 0;
  }
  select->UpdatePipeline(this->time());
  vtkSMProperty* number = select->GetProperty("NumberOfSelectedElements");
  select->UpdatePropertyInformation(number);
  return vtkSMPropertyHelper(number).GetAsIdType();
}

//------------------------------------------------------------------------------
camaron::SelectionInfo pqInspectedMesh::selection() const
{
  camaron::SelectionInfo info;
  vtkSMSourceProxy* selected = this->Port ? this->Port->getSelectionInput() : nullptr;
  if (!this->Port)
  {
    return info;
  }
  const camaron::MeshSummary summary = this->summary();
  info.Total = summary.Cells;
  if (!selected || vtkSMPropertyHelper(selected, "Input").GetNumberOfElements() == 0)
  {
    return info;
  }
  vtkSMProxy* first = vtkSMPropertyHelper(selected, "Input").GetAsProxy(0);
  info.IsOfPoints = first->GetProperty("FieldType")
    ? vtkSMPropertyHelper(first, "FieldType").GetAsInt() == vtkSelectionNode::POINT
    : vtkSMPropertyHelper(first, "ElementType", true).GetAsInt() == vtkDataObject::POINT;
  // ParaView's own count would include ghosts.
  const QString elements = info.IsOfPoints ? "Points" : "Cells";
  info.Count = this->count("Current", elements);
  info.Total = info.IsOfPoints ? summary.Points : summary.Cells;
  return info;
}

//------------------------------------------------------------------------------
void pqInspectedMesh::selectValues(const QString& array,
  const QVector<QPair<double, double>>& ranges, int specials, camaron::Combination combination)
{
  pqSelectionManager* manager = camaron::GetSelectionManager();
  if (!this->Port || !manager)
  {
    return;
  }
  if (ranges.isEmpty() && specials == 0)
  {
    if (combination == camaron::Combination::Replace)
    {
      this->clearSelection();
    }
    return;
  }
  // Thresholds neither select undefined values nor intersect.
  const bool isUndefined = (specials & camaron::HistogramBrush::Undefined) != 0;
  if (isUndefined || combination == camaron::Combination::Intersect)
  {
    this->selectValuesBySteps(array, ranges, specials, combination);
    return;
  }
  const camaron::CriterionInfo* info = this->criterion(array);
  this->BrushText = ranges.isEmpty()
    ? tr("%1 infinite").arg(info ? info->Label : array)
    : tr("%1 from %2 to %3")
        .arg(info ? info->Label : array, camaron::ShortNumber(ranges.front().first),
          camaron::ShortNumber(ranges.back().second));
  if (combination != camaron::Combination::Replace)
  {
    this->BrushText =
      (combination == camaron::Combination::Add ? tr("Added: ") : tr("Subtracted: ")) +
      this->BrushText;
  }
  std::vector<double> thresholds;
  for (const QPair<double, double>& range : ranges)
  {
    thresholds.insert(thresholds.end(), { range.first, range.second });
  }
  if (specials & camaron::HistogramBrush::Infinite)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    thresholds.insert(thresholds.end(), { -infinity, -infinity, infinity, infinity });
  }
  {
    const camaron::UndoPause pause;
    const auto selection =
      camaron::MakeThresholdSelection(this->Port->getSource(), array, thresholds, false);
    vtkSMSourceProxy* before = this->Port->getSelectionInput();
    if (before && combination == camaron::Combination::Add)
    {
      vtkSMSelectionHelper::AddSelection(before, selection);
    }
    else if (before && combination == camaron::Combination::Subtract)
    {
      vtkSMSelectionHelper::SubtractSelection(before, selection);
    }
    this->Port->setSelectionInput(selection, 0);
    manager->select(this->Port);
  }

  // The expression that makes a trace item must have all arguments.
#define CAMARON_TRACE                                                                              \
  SM_SCOPED_TRACE(CallFunction)                                                                    \
    .arg("SelectThresholds")                                                                       \
    .arg("Thresholds", thresholds)                                                                 \
    .arg("ArrayName", array.toUtf8().constData())                                                  \
    .arg("FieldType", "CELL")                                                                      \
    .arg("Source", this->Port->getSourceProxy())                                                   \
    .arg("comment", "select the cells brushed in the histogram")
  if (const char* modifier = GetModifier(combination))
  {
    CAMARON_TRACE.arg("Modifier", modifier);
  }
  else
  {
    CAMARON_TRACE;
  }
#undef CAMARON_TRACE
}

//------------------------------------------------------------------------------
void pqInspectedMesh::clearSelection()
{
  if (pqSelectionManager* manager = camaron::GetSelectionManager())
  {
    const camaron::UndoPause pause;
    manager->clearSelection();
  }
}
