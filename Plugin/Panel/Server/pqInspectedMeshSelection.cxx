// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The active selection of the inspected mesh.
#include "pqInspectedMesh.h"

#include "NumberText.h"
#include "ProxyValues.h"
#include "ServerConnection.h"
#include "ThresholdSelection.h"

#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqSelectionManager.h"
#include "pqUndoStack.h"

#include "vtkDataObject.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSelectionHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSelectionNode.h"

#include <limits>
#include <vector>

namespace
{
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

//------------------------------------------------------------------------------
// Whether a selection is one of points; of nothing or cells otherwise.
bool IsOfPoints(vtkSMSourceProxy* selection)
{
  vtkSMPropertyHelper input(selection, "Input");
  vtkSMProxy* first = input.GetNumberOfElements() > 0 ? input.GetAsProxy(0) : nullptr;
  if (!first)
  {
    return false;
  }
  return first->GetProperty("FieldType")
    ? vtkSMPropertyHelper(first, "FieldType").GetAsInt() == vtkSelectionNode::POINT
    : vtkSMPropertyHelper(first, "ElementType", true).GetAsInt() == vtkDataObject::POINT;
}
}

//------------------------------------------------------------------------------
vtkSMSourceProxy* pqInspectedMesh::marked(const QString& strategy, const QString& elements) const
{
  // One for each, which marks again without computing.
  const QByteArray key = "Marked" + (strategy + elements).toLatin1();
  vtkSMSourceProxy* select = this->filterHelper(camaron::SelectName, key);
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
  const pqScopedUndoExclude pause;
  vtkSMSourceProxy* select = this->marked(strategy, elements);
  if (!select || !this->Helpers.update(select))
  {
    return 0;
  }
  vtkSMProperty* number = select->GetProperty("NumberOfSelectedElements");
  camaron::UpdateInformation(select, number);
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
  info.IsOfPoints = IsOfPoints(selected);
  // ParaView's own count would include ghosts.
  const QString elements = info.IsOfPoints ? "Points" : "Cells";
  info.Count = this->count("Current", elements);
  info.Total = info.IsOfPoints ? summary.Points : summary.Cells;
  return info;
}

//------------------------------------------------------------------------------
bool pqInspectedMesh::selectValues(const QString& array,
  const QVector<QPair<double, double>>& ranges, int specials, camaron::Combination combination)
{
  pqSelectionManager* manager = camaron::GetSelectionManager();
  if (!this->Port || !manager)
  {
    return false;
  }
  if (ranges.isEmpty() && specials == 0)
  {
    const bool clears =
      combination == camaron::Combination::Replace && this->Port->getSelectionInput();
    if (clears)
    {
      this->clearSelection();
    }
    return clears;
  }
  vtkSMSourceProxy* before = this->Port->getSelectionInput();
  if (before && IsOfPoints(before)) // which cells do not combine with
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
  const camaron::CriterionInfo* info = this->criterion(array);
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
    const pqScopedUndoExclude pause;
    const auto selection =
      camaron::MakeThresholdSelection(this->Port->getSource(), array, thresholds, false);
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

  camaron::TraceThresholds(this->Port, array, thresholds, false, GetModifier(combination),
    "select the cells brushed in the histogram");
  if (combination == camaron::Combination::Replace)
  {
    brush.Array = array;
    brush.Thresholds = thresholds;
  }
  this->Brushed = brush;
  return true;
}

//------------------------------------------------------------------------------
void pqInspectedMesh::clearSelection()
{
  if (pqSelectionManager* manager = camaron::GetSelectionManager())
  {
    const pqScopedUndoExclude pause;
    manager->clearSelection();
    if (this->Port &&
      this->Port->getSelectionInput()) // that of a script, which the manager does not know
    {
      manager->clearSelection(this->Port);
    }
  }
}

//------------------------------------------------------------------------------
void pqInspectedMesh::showSelectionThrough()
{
  vtkSMSourceProxy* selection =
    this->Port && this->IsFollowing ? this->Port->getSelectionInput() : nullptr;
  pqDataRepresentation* shown = selection ? this->representation() : nullptr;
  const bool isHidden = !shown || !shown->isVisible() || IsOfPoints(selection) ||
    this->display("CellsToDraw").toInt() != 0; // selected or other cells are drawn alone
  if (isHidden)
  {
    this->Shining.hide();
    return;
  }
  const auto port = static_cast<unsigned>(this->Port->getPortNumber());
  this->Shining.show(this->view(), this->Port->getSourceProxy()->GetSelectionOutput(port),
    { { "Color", this->display("SelectionColor") } });
}
