// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isosurfaces.h"

#include "InspectionMesh.h"
#include "InspectionValues.h"
#include "Shaders.h"

#include "Drawing/CellTetrahedra.h"
#include "Mesh/MeshView.h"

#include "vtkDataArray.h"
#include "vtkUnstructuredGrid.h"

namespace camaron
{
//------------------------------------------------------------------------------
void Isosurfaces::Update(
  InspectionMesh& mesh, vtkDataArray* array, const std::vector<double>& isovalues)
{
  if (!array || isovalues.empty())
  {
    this->NumberOfTriangles = 0;
    this->Isovalues.clear();
    return;
  }
  mesh.NeedMarks();
  mesh.NeedPoints();
  mesh.NeedTetrahedra();
  const bool isNew = mesh.GetVersion() != this->Version || array != this->Array ||
    array->GetMTime() != this->ArrayTime;
  if (!isNew && isovalues == this->Isovalues)
  {
    return;
  }
  this->Program.Build("create isosurfaces", IsosurfaceVS, IsosurfaceGS, "corner");
  if (isNew)
  {
    this->UpdateValues(mesh, array);
  }
  this->Program.Use();
  this->Program.SetTable("tetrahedronTable", mesh.Tetrahedra, 0);
  this->Program.SetTable("cellOfTetrahedronTable", mesh.CellsOfTetrahedra, 1);
  this->Program.SetTable("markTable", mesh.Marks, 2);
  this->Program.SetTable("valueTable", this->Values, 3);
  this->NumberOfTriangles =
    this->Program.RunToEnd(this->Table, [&] { this->Draw(mesh, isovalues); }) / 3;
  this->Isovalues = isovalues;
}

//------------------------------------------------------------------------------
void Isosurfaces::UpdateValues(InspectionMesh& mesh, vtkDataArray* array)
{
  const ArrayValues values = GetArrayValues(array);
  this->Values.Upload(values.Values.data(), values.Values.size());
  this->Origin = values.Origin;
  this->BlockRanges =
    FindBlockRanges(MeshView(mesh.GetGrid()), values.Values, mesh.GetSubdividedFacets());
  this->Version = mesh.GetVersion();
  this->Array = array;
  this->ArrayTime = array->GetMTime();
}

//------------------------------------------------------------------------------
void Isosurfaces::Draw(const InspectionMesh& mesh, const std::vector<double>& isovalues) const
{
  for (const double isovalue : isovalues)
  {
    const auto value = static_cast<float>(isovalue - this->Origin);
    this->Program.SetUniform("isovalue", value);
    this->Program.DrawBlocks(mesh.GetTetrahedronBlocks(), [&](std::size_t block)
      { return this->BlockRanges[block][0] < value && this->BlockRanges[block][1] >= value; });
  }
}

//------------------------------------------------------------------------------
void Isosurfaces::Release()
{
  this->Program.Release();
  this->Values.Release();
  this->Table.Release();
  this->Array = nullptr;
  this->Isovalues.clear();
  this->NumberOfTriangles = 0;
}
}
