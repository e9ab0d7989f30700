// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellShapes.h"

#include "Base/Parallel.h"
#include "Cell/CellGeometry.h"
#include "Cell/Shapes.h"
#include "Mesh/CellShape.h"
#include "Mesh/MeshView.h"
#include "MeshInput.h"

#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <array>

namespace camaron
{
namespace
{
constexpr int MaxSimpleFaces = 6; // polyhedra with more faces are general polyhedra
using ShapesOfTypes = std::array<unsigned, 256>;

//------------------------------------------------------------------------------
const ShapesOfTypes& GetShapesOfTypes()
{
  static const ShapesOfTypes shapes = []
  {
    ShapesOfTypes result = {};
    for (int type = 0; type < 256; ++type)
    {
      const CellShape& shape = GetCellShape(static_cast<unsigned char>(type));
      if (shape.Dimension == 2)
      {
        const int corners = shape.NumberOfCorners;
        result[type] = Polygons |
          (corners == 3      ? Triangles
              : corners == 4 ? Quadrilaterals
                             : NoShapes);
      }
      else if (shape.Dimension == 3)
      {
        result[type] = Polyhedra |
          (shape.ListsFaces
              ? NoShapes
              : FindSimpleShape(CellGeometry::GetTopologyOfType(static_cast<unsigned char>(type))));
      }
    }
    return result;
  }();
  return shapes;
}

//------------------------------------------------------------------------------
// Whether the type of a cell is not sufficient to find its shape.
bool DependsOnTopology(const MeshView& mesh, vtkIdType cell, const CellShape& shape)
{
  return shape.ListsFaces ? mesh.GetPolyhedronFaces(cell).Size <= MaxSimpleFaces
                          : shape.Dimension == 2 && shape.NumberOfCorners == 0;
}
}

//------------------------------------------------------------------------------
std::vector<std::uint16_t> FindCellShapes(vtkDataSet* data)
{
  const ShapesOfTypes& ofTypes = GetShapesOfTypes();
  std::vector<std::uint16_t> shapes(data->GetNumberOfCells());
  const auto numberOfCells = static_cast<vtkIdType>(shapes.size());
  if (!vtkUnstructuredGrid::SafeDownCast(data) && !vtkPolyData::SafeDownCast(data))
  {
    for (vtkIdType cell = 0; cell < numberOfCells; ++cell)
    {
      shapes[cell] = static_cast<std::uint16_t>(ofTypes[data->GetCellType(cell) & 255]);
    }
    return shapes;
  }
  const vtkSmartPointer<vtkDataSet> owner = AsMesh(data);
  const MeshView mesh(owner);
  const EvaluationOptions options;
  constexpr vtkIdType grain = 1 << 13;
  ParallelFor(numberOfCells, grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      CellGeometry geometry;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const unsigned char type = mesh.GetCellType(cell);
        unsigned found = ofTypes[type];
        if (DependsOnTopology(mesh, cell, GetCellShape(type)))
        {
          geometry.Load(mesh, cell, options);
          found = geometry.GetShapes();
        }
        shapes[cell] = static_cast<std::uint16_t>(found);
      }
    });
  return shapes;
}

//------------------------------------------------------------------------------
bool BlockShapes::Judge(BlockValues& values, const std::optional<AcceptableRange>& range)
{
  if (!range || (range->Shapes & AnyCell) || this->Blocks.GetKind() != ElementKind::Cells)
  {
    return false;
  }
  if (this->Shapes.empty())
  {
    for (const ElementBlock& block : this->Blocks.Get())
    {
      this->Shapes.push_back(FindCellShapes(block.Data));
    }
  }
  values.SetShapes(this->Shapes, range->Shapes);
  return true;
}
}
