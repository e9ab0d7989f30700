// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CutTetrahedra.h"

#include "InspectionMesh.h"
#include "Shaders.h"
#include "ShapeConversion.h"

#include "Drawing/CellTetrahedra.h"
#include "Mesh/MeshView.h"

#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// A linear function on a box: its value at the center, and the largest change from there to a
// corner.
struct Linear
{
  Linear(const double* row, const std::array<double, 6>& box)
    : AtMiddle(row[3])
  {
    for (int i = 0; i < 3; ++i)
    {
      this->AtMiddle += row[i] * (0.5 * box[2 * i] + 0.5 * box[2 * i + 1]);
      this->Change += std::abs(row[i]) * (0.5 * box[2 * i + 1] - 0.5 * box[2 * i]);
    }
  }
  double AtMiddle;
  double Change = 0;
};

//------------------------------------------------------------------------------
// False if the box is certainly on one side. Boxes that the less exact shaders may see on another
// side count as crossed.
bool MayCross(const ConvexShape& shape, const std::array<double, 6>& box)
{
  constexpr double Slack = 1 + 1e-3;
  if (box[0] > box[1])
  {
    return false;
  }
  bool isInside = true;
  for (const std::array<double, 4>& plane : shape.Planes)
  {
    const Linear height(plane.data(), box);
    if (height.AtMiddle > Slack * height.Change)
    {
      return false;
    }
    isInside = isInside && height.AtMiddle < -Slack * height.Change;
  }
  if (!shape.Planes.empty())
  {
    return !isInside;
  }
  double nearest = 0, farthest = 0;
  for (int row = 0; row < 3; ++row)
  {
    const Linear x(&shape.ToUnitSphere[4 * row], box);
    const double middle = std::abs(x.AtMiddle);
    const double change = Slack * x.Change;
    nearest += middle > change ? (middle - change) * (middle - change) : 0;
    farthest += (middle + change) * (middle + change);
  }
  return nearest <= Slack && farthest >= 1 / Slack;
}
}

//------------------------------------------------------------------------------
void CutTetrahedra::Update(InspectionMesh& mesh, const InspectionStyle& style)
{
  mesh.NeedMarks();
  mesh.NeedPoints();
  mesh.NeedTetrahedra();
  Request request;
  request.Version = mesh.GetVersion();
  request.CellsToDraw = style.CellsToDraw;
  request.CellsMove = style.MovesCells();
  request.Shape = style.ExactShape;
  if (request == this->Last && this->Table.IsUploaded())
  {
    return;
  }
  const std::string vertex = std::string("#version 150\n") + InShapeGLSL + CutTetrahedraVS;
  this->Program.Build("cut cells", vertex.c_str(), CutTetrahedraGS, "cut");
  if (request.Version != this->Last.Version)
  {
    this->BlockBounds = FindBlockBounds(MeshView(mesh.GetGrid()), mesh.GetSubdividedFacets());
  }
  this->Program.Use();
  this->Program.SetTable("tetrahedronTable", mesh.Tetrahedra, 0);
  this->Program.SetTable("cellOfTetrahedronTable", mesh.CellsOfTetrahedra, 1);
  this->Program.SetTable("markTable", mesh.Marks, 2);
  this->Program.SetTable("pointTable", mesh.Points, 3);
  this->Program.SetUniform("cellsToDraw", static_cast<int>(style.CellsToDraw));
  this->Program.SetUniform("cellsMove", request.CellsMove ? 1 : 0);
  this->Program.SetShape(ShapeUniforms(style.ExactShape, mesh.GetMiddle()));
  this->NumberOfTetrahedra = this->Program.RunToEnd(this->Table,
    [&]
    {
      this->Program.DrawBlocks(mesh.GetTetrahedronBlocks(), [&](std::size_t block)
        { return request.CellsMove || MayCross(style.ExactShape, this->BlockBounds[block]); });
    });
  this->Last = request;
}

//------------------------------------------------------------------------------
void CutTetrahedra::Release()
{
  this->Program.Release();
  this->Table.Release();
  this->BlockBounds = {};
  this->Last = {};
  this->NumberOfTetrahedra = 0;
}
}
