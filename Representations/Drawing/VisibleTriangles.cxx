// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VisibleTriangles.h"

#include "InspectionMesh.h"
#include "Shaders.h"
#include "ShapeConversion.h"

#include "vtkUnstructuredGrid.h"

namespace camaron
{
//------------------------------------------------------------------------------
void VisibleTriangles::Update(InspectionMesh& mesh, const InspectionStyle& style)
{
  const bool hasCut = style.CutsCells();
  DrawnFaces faces = style.FacesToDraw;
  if (style.MovesCells()) // both sides of a face are visible
  {
    faces = faces == DrawnFaces::Interior ? DrawnFaces::InteriorOfBoth : DrawnFaces::Complete;
  }
  mesh.NeedFaces(true);
  mesh.NeedPoints();
  mesh.NeedMarks();
  if (style.Cut == CutBy::Centroid)
  {
    mesh.NeedCentroids();
  }
  else if (hasCut)
  {
    mesh.NeedConnectivity();
  }
  Request request;
  request.Version = mesh.GetVersion();
  request.FacesToDraw = faces;
  request.CellsToDraw = style.CellsToDraw;
  request.BordersAreOpen = style.BordersAreOpen;
  if (hasCut)
  {
    request.Cut = style.Cut;
    request.KeepInside = style.KeepInside;
    request.Shape = style.Shape;
  }
  if (request == this->Last && this->Table.IsUploaded())
  {
    return;
  }
  const std::string keepCells = std::string("#version 150\n") + InShapeGLSL + KeepCellsVS;
  constexpr const char* purpose = "cut cells";
  this->CellProgram.Build(purpose, keepCells.c_str(), nullptr, "keep");
  this->TriangleProgram.Build(purpose, VisibleTrianglesVS, VisibleTrianglesGS, "visible");
  this->KeepCells(mesh, style);

  const std::size_t numberOfTriangles = mesh.Triangles.GetNumberOfRows();
  const std::size_t capacity =
    (faces == DrawnFaces::Surface || faces == DrawnFaces::Interior ? 1 : 2) * numberOfTriangles;
  this->Table.Resize(capacity);
  this->TriangleProgram.Use();
  this->TriangleProgram.SetTable("triangleTable", mesh.Triangles, 0);
  this->TriangleProgram.SetTable("faceTable", mesh.Faces, 1);
  this->TriangleProgram.SetTable("keepTable", this->Keep, 2);
  this->TriangleProgram.SetUniform("bordersAreOpen", style.BordersAreOpen ? 1 : 0);
  this->TriangleProgram.SetUniform("facesToDraw", static_cast<int>(faces));
  this->NumberOfTriangles = this->TriangleProgram.Run(numberOfTriangles, this->Table);
  this->Last = request;
}

//------------------------------------------------------------------------------
void VisibleTriangles::KeepCells(InspectionMesh& mesh, const InspectionStyle& style)
{
  const std::size_t numberOfCells = mesh.Marks.GetNumberOfRows();
  this->Keep.Resize(numberOfCells);
  const FeedbackProgram& program = this->CellProgram;
  program.Use();
  program.SetTable("markTable", mesh.Marks, 0);
  program.SetTable("pointTable", mesh.Points, 1);
  // Tables that this cut does not need may be missing; others of the same type replace them.
  const bool hasCentroids = mesh.Centroids.IsUploaded();
  const bool hasConnectivity = mesh.CellOffsets.IsUploaded();
  program.SetTable("centroidTable", hasCentroids ? mesh.Centroids : mesh.Points, 2);
  program.SetTable("cellOffsetTable", hasConnectivity ? mesh.CellOffsets : mesh.Marks, 3);
  program.SetTable("cellPointTable", hasConnectivity ? mesh.CellPoints : mesh.Marks, 4);
  program.SetUniform("cutBy", style.CutsCells() ? static_cast<int>(style.Cut) : 0);
  program.SetUniform("keepInside", style.KeepInside ? 1 : 0);
  program.SetUniform("cellsToDraw", static_cast<int>(style.CellsToDraw));
  program.SetShape(ShapeUniforms(style.Shape, mesh.GetMiddle()));
  program.Run(numberOfCells, this->Keep);
}

//------------------------------------------------------------------------------
void VisibleTriangles::Release()
{
  this->CellProgram.Release();
  this->TriangleProgram.Release();
  this->Keep.Release();
  this->Table.Release();
  this->NumberOfTriangles = 0;
}
}
