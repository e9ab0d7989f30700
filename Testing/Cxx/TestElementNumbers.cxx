// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elements/ElementNumbers.h"
#include "Elements/MeshElements.h"
#include "TestMeshes.h"

#include "vtkAppendFilter.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

using namespace camaron;
using namespace camaron::testing;

namespace
{
struct ListedElements
{
  vtkNew<vtkPolyData> Faces, Edges;

  explicit ListedElements(vtkDataSet* mesh)
  {
    const MeshTopology topology(mesh);
    const ElementContext context(mesh, topology, EvaluationOptions(), 0.0, {});
    for (vtkPolyData* elements : { this->Faces.Get(), this->Edges.Get() })
    {
      elements->SetPoints(vtkPointSet::SafeDownCast(mesh)->GetPoints());
    }
    MakeFaces(context, {}, this->Faces);
    MakeEdges(context, {}, this->Edges);
  }
};

// Every face and every edge of the cells is found under the number that it has in `elements`.
void ExpectNumbers(vtkDataSet* mesh, const ElementNumbers& numbers, const ListedElements& elements,
  vtkIdType firstCell = 0, vtkIdType firstPoint = 0)
{
  vtkNew<vtkIdList> cells;
  for (vtkIdType face = 0; face < elements.Faces->GetNumberOfCells(); ++face)
  {
    vtkNew<vtkIdList> points;
    elements.Faces->GetCellPoints(face, points);
    mesh->GetCellNeighbors(-1, points, cells);
    const vtkIdType last = points->GetNumberOfIds() - 1;
    const vtkIdType three[3] = { firstPoint + points->GetId(1), firstPoint + points->GetId(last),
      firstPoint + points->GetId(0) };
    EXPECT_GE(cells->GetNumberOfIds(), 1);
    for (vtkIdType i = 0; i < cells->GetNumberOfIds(); ++i)
    {
      EXPECT_EQ(numbers.GetFace(firstCell + cells->GetId(i), three), face);
    }
  }
  EXPECT_GT(elements.Edges->GetNumberOfCells(), 0);
  for (vtkIdType edge = 0; edge < elements.Edges->GetNumberOfCells(); ++edge)
  {
    vtkNew<vtkIdList> points;
    elements.Edges->GetCellPoints(edge, points);
    EXPECT_EQ(numbers.GetEdge(firstPoint + points->GetId(1), firstPoint + points->GetId(0)), edge);
  }
}
}

//------------------------------------------------------------------------------
// A label would name another face or edge than the output of Mesh Elements.
TEST(ElementNumbers, AreThoseOfMeshElements)
{
  for (const bool asPolyhedra : { false, true })
  {
    const Grid grid = MakeHexahedra(3, 2, 2, asPolyhedra);
    ExpectNumbers(grid, ElementNumbers(grid, nullptr), ListedElements(grid));
  }
}

//------------------------------------------------------------------------------
// Points that are no edge or face.
TEST(ElementNumbers, AreNoneForOthers)
{
  const Grid grid = MakeHexahedra(3, 2, 2, false);
  const ElementNumbers numbers(grid, nullptr);
  EXPECT_EQ(numbers.GetEdge(0, grid->GetNumberOfPoints() - 1), ElementNumbers::None);
  const vtkIdType corners[3] = { 0, 1, grid->GetNumberOfPoints() - 1 };
  EXPECT_EQ(numbers.GetFace(0, corners), ElementNumbers::None);
}

//------------------------------------------------------------------------------
// What only ghosts have is not in the output of Mesh Elements, and shifts what follows.
TEST(ElementNumbers, PassOverGhosts)
{
  const Grid grid = MakeHexahedra(3, 2, 2, false);
  const vtkIdType numberOfFaces = ListedElements(grid).Faces->GetNumberOfCells();
  vtkUnsignedCharArray* ghosts = grid->AllocateCellGhostArray();
  ghosts->SetValue(0, vtkDataSetAttributes::DUPLICATECELL);
  ghosts->SetValue(5, vtkDataSetAttributes::DUPLICATECELL);
  const ListedElements elements(grid);
  EXPECT_LT(elements.Faces->GetNumberOfCells(), numberOfFaces);
  const ElementNumbers numbers(grid, ghosts->GetPointer(0));
  ExpectNumbers(grid, numbers, elements);
}

//------------------------------------------------------------------------------
// Blocks or pieces that were put together: numbers begin anew in each.
TEST(ElementNumbers, OfPieces)
{
  const Grid first = MakeHexahedra(3, 2, 2, false), second = MakeHexahedra(1, 4, 2, true);
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(first);
  append->AddInputData(second);
  append->Update();
  const vtkIdType firstCell = first->GetNumberOfCells(), firstPoint = first->GetNumberOfPoints();
  const ElementNumbers numbers(append->GetOutput(), nullptr, { 0, firstCell });
  ExpectNumbers(first, numbers, ListedElements(first));
  ExpectNumbers(second, numbers, ListedElements(second), firstCell, firstPoint);
}

//------------------------------------------------------------------------------
// Cells of a surface are its faces, but not beside cells with a volume.
TEST(ElementNumbers, OfPolygons)
{
  const Points points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } }, { { 0, 1, 0 } },
    { { 0, 0, 1 } } };
  const Grid surface = MakeGrid(points,
    { { VTK_LINE, { 0, 1 } }, { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_QUAD, { 0, 2, 3, 4 } } });
  ExpectNumbers(surface, ElementNumbers(surface, nullptr), ListedElements(surface));
  const vtkIdType corners[3] = { 0, 1, 2 };
  EXPECT_EQ(ElementNumbers(surface, nullptr).GetFace(1, corners), 0);
  const Grid mixed =
    MakeGrid(points, { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TETRA, { 0, 1, 2, 4 } } });
  EXPECT_EQ(ElementNumbers(mixed, nullptr).GetFace(0, corners), ElementNumbers::None);
  EXPECT_NE(ElementNumbers(mixed, nullptr).GetFace(1, corners), ElementNumbers::None);
}
