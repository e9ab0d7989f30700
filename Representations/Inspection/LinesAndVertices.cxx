// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LinesAndVertices.h"

#include "CurvedMesh.h"
#include "InspectionArrays.h"
#include "ProcessorDrawing.h"

#include "Mesh/MeshView.h"

#include "vtkCell.h"
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
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

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
vtkSmartPointer<vtkUnstructuredGrid> WithPointIds(vtkUnstructuredGrid* grid)
{
  auto copy = vtkSmartPointer<vtkUnstructuredGrid>::New();
  copy->ShallowCopy(grid);
  AddIds(copy->GetPointData(), PointIdsName, grid->GetNumberOfPoints());
  return copy;
}

//------------------------------------------------------------------------------
// Cells as lists of points. Those of curves have new ones, after the points of the grid.
class LineBuilder
{
public:
  LineBuilder(vtkUnstructuredGrid* grid, int level)
    : Grid(grid)
    , NumberOfParts(1 << std::clamp(level, 0, SubdividedFacets::MaxLevel))
  {
  }

  void Add(const std::vector<vtkIdType>& ids, vtkCellArray* cells)
  {
    vtkNew<vtkIdList> points, line;
    for (const vtkIdType id : ids)
    {
      this->Grid->GetCellPoints(id, points);
      if (!IsCurve(this->Grid->GetCellType(id)) || points->GetNumberOfIds() < 2)
      {
        cells->InsertNextCell(points);
        continue;
      }
      vtkCell* const curve = this->Grid->GetCell(id);
      line->Reset();
      line->InsertNextId(points->GetId(0));
      for (int part = 1; part < this->NumberOfParts; ++part)
      {
        line->InsertNextId(
          this->AddPoint(id, curve, static_cast<double>(part) / this->NumberOfParts));
      }
      line->InsertNextId(points->GetId(1));
      cells->InsertNextCell(line);
    }
  }

  /// The grid with the new points.
  vtkSmartPointer<vtkUnstructuredGrid> GetGrid() const
  {
    if (this->NewPoints.empty())
    {
      return this->Grid;
    }
    return AddPoints(this->Grid, static_cast<vtkIdType>(this->NewPoints.size()),
      [this](vtkIdType point) -> SubdividedFacets::Stencil
      {
        const NewPoint& made = this->NewPoints[static_cast<std::size_t>(point)];
        return { made.Cell, made.Nodes.data(), made.Weights.data(),
          static_cast<int>(made.Nodes.size()) };
      });
  }

private:
  struct NewPoint
  {
    vtkIdType Cell;
    std::vector<int> Nodes;
    std::vector<double> Weights;
  };

  vtkIdType AddPoint(vtkIdType id, vtkCell* curve, double part)
  {
    constexpr double Rounding = 1e-12;
    NewPoint made{ id, {},
      std::vector<double>(static_cast<std::size_t>(curve->GetNumberOfPoints())) };
    made.Nodes.resize(made.Weights.size());
    std::iota(made.Nodes.begin(), made.Nodes.end(), 0);
    // VTK's cubic lines run from -1 to 1.
    const double at[3] = { curve->GetCellType() == VTK_CUBIC_LINE ? 2 * part - 1 : part, 0, 0 };
    curve->InterpolateFunctions(at, made.Weights.data());
    const auto node = std::max_element(made.Weights.begin(), made.Weights.end());
    const bool isAtNode = std::count_if(made.Weights.begin(), made.Weights.end(),
                            [](double weight) { return std::abs(weight) > Rounding; }) == 1;
    if (isAtNode)
    {
      return curve->GetPointId(static_cast<int>(node - made.Weights.begin()));
    }
    this->NewPoints.push_back(std::move(made));
    return this->Grid->GetNumberOfPoints() + static_cast<vtkIdType>(this->NewPoints.size()) - 1;
  }

  vtkUnstructuredGrid* Grid;
  int NumberOfParts;
  std::vector<NewPoint> NewPoints;
};
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
    last.SubdivisionLevel == style.SubdivisionLevel &&
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
  const vtkSmartPointer<vtkUnstructuredGrid> grid = WithPointIds(this->Grid);
  LineBuilder builder(grid, style.SubdivisionLevel);
  builder.Add(drawn[0], vertices);
  builder.Add(drawn[1], lines);
  const vtkSmartPointer<vtkUnstructuredGrid> withPoints = builder.GetGrid();
  this->Cells->SetPoints(withPoints->GetPoints());
  this->Cells->SetVerts(vertices);
  this->Cells->SetLines(lines);
  this->Cells->GetPointData()->ShallowCopy(withPoints->GetPointData());

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
