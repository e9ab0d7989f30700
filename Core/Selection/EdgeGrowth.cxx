// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Growth over edges in a mesh without other pieces.
#include "Mesh/CellFacets.h"
#include "Mesh/MeshTopology.h"
#include "Selection/Growth.h"

#include <algorithm>
#include <utility>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
/// The points and edges of one cell.
class EdgesOfCell
{
public:
  explicit EdgesOfCell(const MeshView& mesh)
    : Mesh(mesh)
    , Facets(mesh)
    , OtherFacets(mesh)
    , Owner(mesh.GetNumberOfPoints(), -1)
  {
  }

  void Load(Index cell)
  {
    this->Edges.clear();
    this->Points.clear();
    this->Facets.ForEachEdge(cell,
      [&](vtkIdType a, vtkIdType b)
      {
        if (a != b)
        {
          this->Edges.push_back(std::minmax(a, b));
          for (const vtkIdType point : { a, b })
          {
            if (this->Owner[point] != cell)
            {
              this->Owner[point] = cell;
              this->Points.push_back(point);
            }
          }
        }
      });
    std::sort(this->Edges.begin(), this->Edges.end());
    this->Cell = cell;
  }

  /// The ends of its edges.
  const std::vector<vtkIdType>& GetPoints() const { return this->Points; }

  /// Whether another cell has one of the edges.
  bool Touches(Index other)
  {
    vtkIdType common = 0;
    for (const vtkIdType point : this->Mesh.GetCellPoints(other))
    {
      common += this->IsOwn(point);
    }
    bool touches = false;
    if (common > 1)
    {
      this->OtherFacets.ForEachEdge(other,
        [&](vtkIdType a, vtkIdType b)
        {
          touches = touches ||
            (a != b && this->IsOwn(a) && this->IsOwn(b) &&
              std::binary_search(this->Edges.begin(), this->Edges.end(),
                std::pair<vtkIdType, vtkIdType>(std::minmax(a, b))));
        });
    }
    return touches;
  }

private:
  bool IsOwn(vtkIdType point) const { return this->Owner[point] == this->Cell; }

  const MeshView& Mesh;
  CellFacets Facets, OtherFacets;
  Index Cell = -1;
  std::vector<Index> Owner; // of each point the last cell that has it
  std::vector<vtkIdType> Points;
  std::vector<std::pair<vtkIdType, vtkIdType>> Edges;
};
}

//------------------------------------------------------------------------------
void GrowOverEdges(const LinkedPiece& piece, int numberOfLayers,
  const std::vector<unsigned char>& allowed, std::vector<unsigned char>& marks)
{
  std::vector<Index> front, next;
  for (std::size_t cell = 0; cell < marks.size(); ++cell)
  {
    if (marks[cell])
    {
      front.push_back(static_cast<Index>(cell));
    }
  }
  if (front.empty())
  {
    return;
  }
  const PointCells& around = piece.Topology->GetPointCells();
  EdgesOfCell edges(piece.Topology->GetMesh());
  for (int layer = 0; layer < numberOfLayers && !front.empty(); ++layer)
  {
    next.clear();
    for (const Index cell : front)
    {
      edges.Load(cell);
      for (const vtkIdType point : edges.GetPoints())
      {
        for (vtkIdType i = around.Offsets[point]; i < around.Offsets[point + 1]; ++i)
        {
          const Index other = around.Cells[i];
          if (!marks[other] && allowed[other] && !piece.IsCopy(other) && edges.Touches(other))
          {
            marks[other] = 1;
            next.push_back(other);
          }
        }
      }
    }
    front.swap(next);
  }
}
}
