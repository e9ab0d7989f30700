// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InspectionTables.h"

#include "InspectionArrays.h"

#include "Elements/ElementCriteria.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkMapper.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

#include "OpenGL.h"

namespace camaron
{
//------------------------------------------------------------------------------
void InspectionTables::UpdateTables(bool isPicking)
{
  this->Mesh->Update();
  this->IsListed = this->Style.DrawsFaces() && !this->Style.IsWholeSurface();
  if (this->Style.What == Figure::Isosurfaces)
  {
    vtkDataArray* array = this->Grid->GetPointData()->GetArray(this->Style.IsosurfaceArray.c_str());
    this->Isosurface.Update(*this->Mesh, array, this->Style.IsosurfaceValues);
    this->NumberOfTriangles = this->Isosurface.GetNumberOfTriangles();
  }
  else if (this->Style.What == Figure::Cap)
  {
    this->Cut.Update(*this->Mesh, this->Style);
    this->NumberOfTriangles = 4 * this->Cut.GetNumberOfTetrahedra();
  }
  else if (this->IsListed)
  {
    this->Visible.Update(*this->Mesh, this->Style);
    this->NumberOfTriangles = this->Visible.GetNumberOfTriangles();
  }
  else
  {
    this->Mesh->NeedFaces(false);
    this->Mesh->NeedPoints();
    this->Mesh->NeedMarks();
    this->NumberOfTriangles = this->Mesh->GetNumberOfOuterTriangles();
  }
  if (this->Style.MovesCells())
  {
    this->Mesh->NeedCentroids();
  }
  if (isPicking)
  {
    this->Mesh->NeedOwners();
  }
  this->Levels.Update(this->Style.Isolines
      ? this->Grid->GetPointData()->GetArray(this->Style.IsolineArray.c_str())
      : nullptr);
}

//------------------------------------------------------------------------------
// Uses the normals of the mesh, as Surface does, or computes those of its outer faces.
void InspectionTables::UpdateNormals(vtkProperty* property)
{
  const bool isOwn = this->Style.Smooth || this->Style.What == Figure::PointNormals;
  vtkDataArray* given = isOwn ? nullptr : this->Grid->GetPointData()->GetNormals();
  const bool isLit = property->GetInterpolation() != VTK_FLAT;
  if (this->Style.What == Figure::PointNormals || (isLit && (this->Style.Smooth || given)))
  {
    this->Normals.Update(*this->Mesh, given);
  }
  else
  {
    this->Normals.Release();
  }
}

//------------------------------------------------------------------------------
// Colors and opacities of the blocks; null if all blocks look like the mesh.
vtkFloatArray* InspectionTables::GetLooks() const
{
  const bool isAlike = !this->Grid || this->Style.Glass || this->Style.DrawsNormals();
  return isAlike ? nullptr
                 : vtkFloatArray::SafeDownCast(this->Grid->GetFieldData()->GetArray(LeafLooksName));
}

//------------------------------------------------------------------------------
void InspectionTables::UpdateLooks()
{
  vtkFloatArray* looks = this->GetLooks();
  if (looks && looks != this->UploadedLooks)
  {
    this->Looks.Upload(looks->GetPointer(0), looks->GetNumberOfTuples());
  }
  this->UploadedLooks = looks;
  if (looks)
  {
    this->Mesh->NeedLeaves();
  }
}

//------------------------------------------------------------------------------
InspectionStyle InspectionTables::GetStyleOfPicture(vtkMapper* mapper, bool ofPoints) const
{
  InspectionStyle style = this->Style;
  style.HasLooks = this->UploadedLooks != nullptr;
  style.HasNegatives = this->Mesh->FirstNegatives.IsUploaded();
  style.Isolines = style.Isolines && !this->Levels.IsEmpty();
  style.SmoothAngle = style.Smooth ? style.SmoothAngle : 180; // keep all normals of the mesh
  style.Smooth = style.What == Figure::Faces && !this->Normals.IsEmpty();
  if (ofPoints)
  {
    style.Edges = style.Isolines = style.Smooth = false;
    style.Switches.clear();
  }
  if (style.ValuesToEmphasize == Emphasis::Unacceptable)
  {
    const Criterion* criterion =
      FindAnyCriterion(mapper->GetArrayName() ? mapper->GetArrayName() : "");
    if (criterion && criterion->HasAcceptableRange())
    {
      std::copy_n(criterion->Acceptable, 2, style.AcceptableRange.begin());
    }
    else
    {
      style.ValuesToEmphasize = Emphasis::Nothing;
    }
  }
  if (!style.Brushes.empty())
  { // the values are those of BrushedCells, for colors, too
    style.ValuesToEmphasize = Emphasis::InsideRange;
    style.Dimming = 0; // the others keep the colors of the legend
    style.AcceptableRange = { { 1, 1 } };
    style.ColorBy = style.ColorsByDistance() ? style.ColorBy : Coloring::TransferFunction;
  }
  const bool areOfColors = this->HasCellValues && !this->Values.IsEmpty() &&
    (style.ValuesToEmphasize == Emphasis::Nothing ||
      style.ValuesToEmphasize == Emphasis::Unacceptable);
  style.ColorLimits = areOfColors && !ofPoints ? this->ColorLimits : Unlimited;
  if (this->Values.IsEmpty())
  {
    style.ValuesToEmphasize = Emphasis::Nothing;
    style.ColorBy = style.ColorsByDistance() ? style.ColorBy : Coloring::TransferFunction;
  }
  else if (style.ColorBy == Coloring::TwoColors && !style.CustomColorRange)
  {
    std::copy_n(mapper->GetLookupTable()->GetRange(), 2, style.ColorRange.begin());
  }
  return style;
}

//------------------------------------------------------------------------------
void InspectionTables::Attach(
  vtkShaderProgram* program, const char* name, const TextureBuffer& table)
{
  if (program->IsUniformUsed(name))
  {
    const int unit = this->Units->Allocate();
    this->UsedUnits.push_back(unit);
    table.Bind(unit);
    program->SetUniformi(name, unit);
  }
}

//------------------------------------------------------------------------------
void InspectionTables::Detach(vtkOpenGLState* state)
{
  for (const int unit : this->UsedUnits)
  {
    this->Units->Free(unit);
  }
  this->UsedUnits.clear();
  state->ResetGLActiveTexture();
}

//------------------------------------------------------------------------------
void InspectionTables::Release()
{
  if (this->OwnsMesh)
  {
    this->Mesh->Release();
  }
  this->Visible.Release();
  this->Isosurface.Release();
  this->Cut.Release();
  this->Colors.Release();
  this->Normals.Release();
  this->Values.Release();
  this->Levels.Release();
  this->Looks.Release();
  this->UploadedLooks = nullptr;
  if (this->VertexArray)
  {
    glDeleteVertexArrays(1, &this->VertexArray);
    this->VertexArray = 0;
  }
}
}
