// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LinesAndVertices.h"

#include "InspectionArrays.h"
#include "ProcessorDrawing.h"

#include "Mesh/MeshView.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <iterator>

namespace camaron
{
namespace
{
bool IsVertex(int type)
{
  return type == VTK_VERTEX || type == VTK_POLY_VERTEX;
}

/// Types that list the two ends first, then the points between them.
bool IsCurve(int type)
{
  return type == VTK_QUADRATIC_EDGE || type == VTK_CUBIC_LINE || type == VTK_LAGRANGE_CURVE ||
    type == VTK_BEZIER_CURVE;
}

bool IsLine(int type)
{
  return type == VTK_LINE || type == VTK_POLY_LINE || IsCurve(type);
}

//------------------------------------------------------------------------------
void AddCells(vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& ids, vtkCellArray* cells)
{
  vtkNew<vtkIdList> points;
  for (const vtkIdType id : ids)
  {
    grid->GetCellPoints(id, points);
    if (IsCurve(grid->GetCellType(id)) && points->GetNumberOfIds() > 2)
    {
      vtkIdType* begin = points->GetPointer(0);
      std::rotate(begin + 1, begin + 2, begin + points->GetNumberOfIds());
    }
    cells->InsertNextCell(points);
  }
}

}

//------------------------------------------------------------------------------
vtkPolyData* LinesAndVertices::Update(vtkUnstructuredGrid* grid, const InspectionStyle& style)
{
  if (!grid)
  {
    this->Grid = nullptr;
    this->Cells->Initialize();
    return this->Cells;
  }
  const vtkMTimeType timeOfFields = grid->GetFieldData()->GetMTime();
  const bool isSameMesh = grid == this->Grid && grid->GetMTime() == this->Time;
  const InspectionStyle& last = this->Style;
  if (isSameMesh && timeOfFields == this->TimeOfFields && last.Cut == style.Cut &&
    last.KeepInside == style.KeepInside && last.CellsToDraw == style.CellsToDraw &&
    (style.Cut == CutBy::Nothing || last.Shape == style.Shape))
  {
    return this->Cells;
  }
  if (!isSameMesh)
  {
    this->Grid = grid;
    this->Time = grid->GetMTime();
    this->Vertices.clear();
    this->Lines.clear();
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      const int type = grid->GetCellType(cell);
      if (IsVertex(type) || IsLine(type))
      {
        (IsVertex(type) ? this->Vertices : this->Lines).push_back(cell);
      }
    }
  }
  this->TimeOfFields = timeOfFields;
  this->Style = style;
  this->Find(style);
  return this->Cells;
}

//------------------------------------------------------------------------------
void LinesAndVertices::Find(const InspectionStyle& style)
{
  this->Cells->Initialize();
  std::vector<vtkIdType> drawn[2];
  const MeshView mesh(this->Grid);
  const std::vector<vtkIdType>* all[2] = { &this->Vertices, &this->Lines };
  for (int i = 0; i < 2; ++i)
  {
    std::copy_if(all[i]->begin(), all[i]->end(), std::back_inserter(drawn[i]),
      [&](vtkIdType cell) { return this->IsDrawn(mesh, cell, style); });
  }
  if (drawn[0].empty() && drawn[1].empty())
  {
    return;
  }
  vtkNew<vtkCellArray> vertices, lines;
  AddCells(this->Grid, drawn[0], vertices);
  AddCells(this->Grid, drawn[1], lines);
  this->Cells->SetPoints(this->Grid->GetPoints());
  this->Cells->SetVerts(vertices);
  this->Cells->SetLines(lines);
  this->Cells->GetPointData()->ShallowCopy(this->Grid->GetPointData());
  AddIds(this->Cells->GetPointData(), PointIdsName, this->Grid->GetNumberOfPoints());

  // vtkPolyData stores vertices first, then lines.
  vtkNew<vtkCellData> ofMesh;
  ofMesh->ShallowCopy(this->Grid->GetCellData());
  AddIds(ofMesh, CellIdsName, this->Grid->GetNumberOfCells());
  vtkCellData* data = this->Cells->GetCellData();
  data->CopyAllOn();
  data->CopyAllocate(ofMesh, static_cast<vtkIdType>(drawn[0].size() + drawn[1].size()));
  vtkIdType to = 0;
  for (const std::vector<vtkIdType>& ids : drawn)
  {
    for (const vtkIdType from : ids)
    {
      data->CopyData(ofMesh, from, to++);
    }
  }
}

//------------------------------------------------------------------------------
bool LinesAndVertices::IsDrawn(
  const MeshView& mesh, vtkIdType cell, const InspectionStyle& style) const
{
  vtkCellData* data = this->Grid->GetCellData();
  vtkUnsignedCharArray* ghosts = this->Grid->GetCellGhostArray();
  constexpr int unseen = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  if (ghosts && (ghosts->GetValue(cell) & unseen))
  {
    return false;
  }
  vtkDataArray* leaves = data->GetArray(LeavesName);
  vtkDataArray* hidden = this->Grid->GetFieldData()->GetArray(HiddenLeavesName);
  if (leaves && hidden &&
    hidden->GetComponent(static_cast<vtkIdType>(leaves->GetComponent(cell, 0)), 0) != 0)
  {
    return false;
  }
  vtkDataArray* selected = data->GetArray(SelectedArrayName);
  const bool isSelected = selected && selected->GetComponent(cell, 0) != 0;
  if (style.CellsToDraw != DrawnCells::All &&
    isSelected != (style.CellsToDraw == DrawnCells::Selected))
  {
    return false;
  }
  return style.Cut == CutBy::Nothing ||
    IsCellInShape(mesh, cell, style.Cut, style.Shape) == style.KeepInside;
}
}
