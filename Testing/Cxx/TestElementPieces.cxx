// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Faces, edges and vertices of meshes in pieces: each once, and none at a boundary that is not
// there.
#include "MeshElementsTesting.h"
#include "Ranks/CompletedPieces.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

using namespace camaron;
using namespace camaron::testing;

//------------------------------------------------------------------------------
// If this fails, elements between processes count twice or not at all.
TEST(ElementPieces, BelongToThePieceOfTheSmallestCell)
{
  const Grid pieces[] = { MakeRow(2), MakeRow(2) };
  double owned[3] = { 0, 0, 0 };
  for (int p = 0; p < 2; ++p)
  {
    // Cells 0 and 1 of three in the first piece, 1 and 2 in the second; cell 1 belongs to the
    // first.
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName("GlobalCellIds");
    ids->InsertNextValue(p);
    ids->InsertNextValue(p + 1);
    pieces[p]->GetCellData()->SetGlobalIds(ids);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->InsertNextValue(p == 1 ? vtkDataSetAttributes::DUPLICATECELL : 0);
    ghosts->InsertNextValue(0);
    pieces[p]->GetCellData()->AddArray(ghosts);
    const Elements elements(pieces[p]);
    vtkPolyData* sets[] = { elements.Faces, elements.Edges };
    for (int k = 0; k < 2; ++k)
    {
      for (vtkIdType i = 0; i < sets[k]->GetNumberOfCells(); ++i)
      {
        owned[k] += Get(sets[k], vtkDataSetAttributes::GhostArrayName(), i) == 0;
      }
    }
  }
  EXPECT_EQ(owned[0], 16);
  EXPECT_EQ(owned[1], 28);
}

//------------------------------------------------------------------------------
// Cubes of a block of 2 x 2 x 2, each a piece of its own that knows nothing of the others. If this
// fails, elements between pieces count twice, or lie at the boundary of the mesh.
TEST(ElementPieces, OfPiecesWithoutGhosts)
{
  const double pi = std::acos(-1.0);
  const Grid block = MakeHexahedra(2, 2, 2, false);
  const auto take = [&](const std::vector<vtkIdType>& cubes, const std::vector<vtkIdType>& ids)
  {
    std::vector<Grid> grids;
    for (const vtkIdType cube : cubes)
    {
      Points points;
      vtkCell* cell = block->GetCell(cube);
      for (vtkIdType i = 0; i < 8; ++i)
      {
        double x[3];
        cell->GetPoints()->GetPoint(i, x);
        points.push_back({ x[0], x[1], x[2] });
      }
      grids.push_back(MakeGrid(points, { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } } }));
      grids.back() = cube % 2 ? ToPolyhedra(grids.back()) : grids.back();
    }
    std::vector<std::unique_ptr<MeshTopology>> topologies;
    std::vector<LinkedPiece> pieces(grids.size());
    for (std::size_t i = 0; i < grids.size(); ++i)
    {
      topologies.push_back(std::make_unique<MeshTopology>(grids[i]));
      pieces[i].Data = grids[i];
      pieces[i].Topology = topologies.back().get();
      pieces[i].CellIds = ids.empty() ? nullptr : &ids[i];
    }
    Reducer alone;
    const auto meshes = CompletePieces(pieces, {}, alone);
    std::vector<std::unique_ptr<Elements>> elements;
    for (std::size_t i = 0; i < grids.size(); ++i)
    {
      elements.push_back(
        std::make_unique<Elements>(meshes[i], 0, ElementSource{ grids[i], OfPolyhedra }));
      EXPECT_EQ(elements.back()->Faces->GetNumberOfPoints(), 8);
      EXPECT_EQ(elements.back()->Vertices->GetNumberOfCells(), 8);
    }
    return elements;
  };
  const auto sum = [&](const auto& elements, vtkNew<vtkPolyData> Elements::* set, const char* name)
  {
    double result = 0;
    for (const auto& piece : elements)
    {
      vtkPolyData* data = (*piece).*set;
      for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
      {
        const bool isOwn = Get(data, vtkDataSetAttributes::GhostArrayName(), i) == 0;
        result += isOwn ? name ? Get(data, name, i) : 1 : 0;
      }
    }
    return result;
  };
  for (const std::vector<vtkIdType>& ids :
    { std::vector<vtkIdType>(), std::vector<vtkIdType>{ 70, 10, 20, 60, 30, 50, 80, 40 } })
  {
    const auto all = take({ 0, 1, 2, 3, 4, 5, 6, 7 }, ids);
    EXPECT_EQ(sum(all, &Elements::Faces, nullptr), 36);
    EXPECT_EQ(sum(all, &Elements::Faces, "IsBoundary"), 24);
    EXPECT_EQ(sum(all, &Elements::Faces, "FaceCellCount"), 8 * 6);
    EXPECT_EQ(sum(all, &Elements::Edges, nullptr), 54);
    EXPECT_EQ(sum(all, &Elements::Edges, "IsBoundary"), 48);
    EXPECT_EQ(sum(all, &Elements::Edges, "EdgeCellCount"), 8 * 12);
    EXPECT_EQ(sum(all, &Elements::Edges, "EdgeFaceCount"), 36 * 4);
    EXPECT_NEAR(sum(all, &Elements::Edges, "EdgeAngleSum"), 8 * 12 * 90, 1e-9);
    EXPECT_EQ(sum(all, &Elements::Vertices, nullptr), 27);
    EXPECT_EQ(sum(all, &Elements::Vertices, "IsBoundary"), 26);
    EXPECT_EQ(sum(all, &Elements::Vertices, "VertexCellCount"), 8 * 8);
    EXPECT_EQ(sum(all, &Elements::Vertices, "VertexEdgeCount"), 54 * 2);
    EXPECT_EQ(sum(all, &Elements::Vertices, "VertexFaceCount"), 36 * 4);
    EXPECT_EQ(sum(all, &Elements::Vertices, "PointRegionCount"), 27);
    EXPECT_NEAR(sum(all, &Elements::Vertices, "VertexAngleSum"), 8 * 8 * pi / 2, 1e-9);
    // Inner faces of the first cube belong to it, or to those of smaller ids.
    std::multiset<double> neighbors, owners;
    for (vtkIdType face = 0; face < 6; ++face)
    {
      neighbors.insert(Get(all[0]->Faces, "NeighborCell", face));
      owners.insert(Get(all[0]->Faces, "OwnerCell", face));
      const bool isBoundary = Get(all[0]->Faces, "IsBoundary", face) != 0;
      const bool isGhost = Get(all[0]->Faces, vtkDataSetAttributes::GhostArrayName(), face) != 0;
      EXPECT_EQ(isGhost, !isBoundary && !ids.empty());
      EXPECT_EQ(std::isnan(Get(all[0]->Faces, "NonOrthogonality", face)), isBoundary);
    }
    const bool hasIds = !ids.empty();
    using Set = std::multiset<double>;
    EXPECT_EQ(neighbors, hasIds ? Set({ -1, -1, -1, 70, 70, 70 }) : Set({ -1, -1, -1, 1, 2, 4 }));
    EXPECT_EQ(owners, hasIds ? Set({ 10, 20, 30, 70, 70, 70 }) : Set({ 0, 0, 0, 0, 0, 0 }));
  }
  // Pieces that share no more than an edge, or a point.
  const auto edge = take({ 0, 3 }, {});
  EXPECT_EQ(sum(edge, &Elements::Edges, nullptr), 23);
  EXPECT_EQ(sum(edge, &Elements::Edges, "EdgeCellCount"), 24);
  EXPECT_EQ(sum(edge, &Elements::Vertices, "PointRegionCount"), 16);
  const auto point = take({ 0, 7 }, {});
  EXPECT_EQ(sum(point, &Elements::Vertices, nullptr), 15);
  EXPECT_EQ(sum(point, &Elements::Vertices, "PointRegionCount"), 16);
  EXPECT_EQ(sum(point, &Elements::Faces, "IsBoundary"), 12);
}

//------------------------------------------------------------------------------
// If this fails, elements of pieces have other ids than in the undivided mesh, or two have the
// same.
TEST(ElementPieces, AreNumberedAsInTheWhole)
{
  Reducer alone;
  const unsigned char ghosts[] = { vtkDataSetAttributes::DUPLICATECELL, 0 };
  const std::vector<KeyedElements> pieces = {
    { 0, { { 7, 2 }, { 3, 0 } }, nullptr },
    { 0, { { 3, 0 }, { 5, 9 } }, ghosts },
    { 1, { { 3, 0 } }, nullptr },
  };
  using Ids = std::vector<std::vector<vtkIdType>>;
  EXPECT_EQ(NumberElements(pieces, alone), Ids({ { 2, 0 }, { 0, 1 }, { 3 } }));

  constexpr std::int64_t large = std::int64_t(1) << 40;
  for (const ElementKey& key :
    { ElementKey{ 7, 2 }, ElementKey{ -1, 0 }, ElementKey{ large, large } })
  {
    std::vector<KeyedElements> wrong = pieces;
    wrong.push_back({ 0, { key }, nullptr });
    EXPECT_EQ(NumberElements(wrong, alone), Ids()) << key[0];
  }
}
