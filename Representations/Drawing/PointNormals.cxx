// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointNormals.h"

#include "InspectionMesh.h"

#include "Drawing/DrawableFaces.h"
#include "Mesh/MeshTopology.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkMath.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <vector>

namespace camaron
{
namespace
{
using Row = std::array<float, 4>;

Row ToRow(const double normal[3])
{
  return { { static_cast<float>(normal[0]), static_cast<float>(normal[1]),
    static_cast<float>(normal[2]), 0.0f } };
}

//------------------------------------------------------------------------------
// Includes the faces of ghost cells, so that lighting has no seams between processes.
std::vector<Row> MakeNormals(const InspectionMesh& mesh)
{
  vtkUnstructuredGrid* const grid = mesh.GetGrid();
  const MeshTopology topology(grid);
  const MeshView& view = topology.GetMesh();
  CellsToDraw cells = GetCellsToDraw(grid);
  cells.Subdivided = mesh.GetSubdividedFacets();
  std::vector<unsigned char> hidden;
  if (cells.Ghosts)
  {
    hidden.assign(cells.Ghosts, cells.Ghosts + grid->GetNumberOfCells());
    for (unsigned char& bits : hidden)
    {
      bits &= vtkDataSetAttributes::HIDDENCELL;
    }
    cells.Ghosts = hidden.data();
  }
  const DrawableFaces faces = MakeDrawableFaces(topology, cells, FacesToDraw::Outer);
  std::vector<std::array<double, 3>> sums(view.GetNumberOfPoints(), { { 0, 0, 0 } });
  for (const auto& triangle : faces.Triangles)
  {
    double x[3][3], normal[3];
    for (int i = 0; i < 3; ++i)
    {
      view.GetPoint(triangle[i], x[i]);
    }
    for (int k = 0; k < 3; ++k)
    {
      x[1][k] -= x[0][k];
      x[2][k] -= x[0][k];
    }
    vtkMath::Cross(x[1], x[2], normal);
    for (int i = 0; i < 3; ++i)
    {
      vtkMath::Add(sums[triangle[i]].data(), normal, sums[triangle[i]].data());
    }
  }
  std::vector<Row> rows(sums.size());
  for (std::size_t point = 0; point < rows.size(); ++point)
  {
    vtkMath::Normalize(sums[point].data());
    rows[point] = ToRow(sums[point].data());
  }
  return rows;
}

//------------------------------------------------------------------------------
std::vector<Row> CopyNormals(vtkDataArray* given)
{
  std::vector<Row> rows(given->GetNumberOfTuples());
  for (std::size_t point = 0; point < rows.size(); ++point)
  {
    double normal[3];
    given->GetTuple(static_cast<vtkIdType>(point), normal);
    rows[point] = ToRow(normal);
  }
  return rows;
}
}

//------------------------------------------------------------------------------
void PointNormals::Update(const InspectionMesh& mesh, vtkDataArray* given)
{
  const vtkMTimeType time = given ? given->GetMTime() : 0;
  if (!this->IsEmpty() && this->Version == mesh.GetVersion() && this->Given == given &&
    this->Time == time)
  {
    return;
  }
  const std::vector<Row> rows = given ? CopyNormals(given) : MakeNormals(mesh);
  this->Normals.Upload(rows.data(), rows.size());
  this->Version = mesh.GetVersion();
  this->Given = given;
  this->Time = time;
}

//------------------------------------------------------------------------------
void PointNormals::Release()
{
  this->Normals.Release();
  this->Given = nullptr;
  this->Version = -1;
}
}
