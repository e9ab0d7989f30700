// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Setters of the properties of vtkMeshInspectionRepresentation.
#include "MeshInspectionInternals.h"
#include "vtkInspectionMesh.h"

#include <algorithm>

using namespace camaron;

namespace
{
// Limits as in the XML, in points. VTK takes minutes to render larger digits.
constexpr int MinIdSize = 4;
constexpr int MaxIdSize = 72;
}

//==============================================================================
template <typename Value>
void vtkMeshInspectionRepresentation::Change(Value& member, const Value& value)
{
  if (!(member == value))
  {
    member = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetBlockColorsDistinctValues(int number)
{
  static_cast<vtkInspectionMesh*>(this->GeometryFilter)->SetBlockColorsDistinctValues(number);
  this->MarkModified();
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetColorMissingArraysWithNanColor(bool on)
{
  this->Change(this->Internal->ColorMissingArraysWithNanColor, on);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetDrawWith(int what)
{
  this->Change(this->Internal->Style.OnProcessor, what == 1);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetDrawFaces(bool on)
{
  this->Change(this->Internal->Style.Faces, on);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetDrawEdges(bool on)
{
  this->Change(this->Internal->Style.Edges, on);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetEdgesOf(int which)
{
  this->Change(this->Internal->Style.EdgesOfSelectedOnly, which == 1);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetGlassShell(bool on)
{
  this->Change(this->Internal->GlassShell, on);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetGlassStrength(double strength)
{
  this->Change(this->Internal->Style.GlassStrength, strength);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetFacesToDraw(int which)
{
  this->Change(this->Internal->Style.WallsToDraw, static_cast<Walls>(which));
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetCellsToDraw(int which)
{
  this->Change(this->Internal->Style.CellsToDraw, static_cast<Chosen>(which));
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetShrinkFactor(double factor)
{
  this->Change(this->Internal->Style.ShrinkFactor, factor);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetExplodeFactor(double factor)
{
  this->Change(this->Internal->Style.ExplodeFactor, factor);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetCutBy(int which)
{
  this->Change(this->Internal->Style.Cut, static_cast<camaron::CutBy>(which));
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetCutKeep(int which)
{
  this->Change(this->Internal->Style.KeepInside, which == 1);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetCutMoves(int with)
{
  this->Change(this->Internal->CutMoves, with);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetColorCutFaces(bool on)
{
  this->Change(this->Internal->Style.CutFaces, on);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetCutColor(double red, double green, double blue)
{
  this->Change(this->Internal->Style.CutColor, Color{ { red, green, blue } });
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetColoring(int by)
{
  this->Change(this->Internal->Style.ColorBy, static_cast<Coloring>(by));
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetHeightDirection(double x, double y, double z)
{
  this->Change(this->Internal->Style.HeightDirection, std::array<double, 3>{ { x, y, z } });
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetLowColor(double red, double green, double blue)
{
  this->Change(this->Internal->Style.LowColor, Color{ { red, green, blue } });
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetHighColor(double red, double green, double blue)
{
  this->Change(this->Internal->Style.HighColor, Color{ { red, green, blue } });
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetNullColor(double red, double green, double blue)
{
  this->Change(this->Internal->Style.NullColor, Color{ { red, green, blue } });
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetCustomColorRange(bool on)
{
  this->Change(this->Internal->Style.CustomColorRange, on);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetColorRange(double low, double high)
{
  this->Change(this->Internal->Style.ColorRange, Range{ { low, high } });
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetEmphasis(int which)
{
  this->Change(this->Internal->Style.ValuesToEmphasize, static_cast<camaron::Emphasis>(which));
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetAcceptableRange(double low, double high)
{
  this->Change(this->Internal->Style.AcceptableRange, Range{ { low, high } });
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetDimming(double amount)
{
  this->Change(this->Internal->Style.Dimming, amount);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetSmoothShading(bool on)
{
  this->Change(this->Internal->Style.Smooth, on);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetSmoothAngle(double degrees)
{
  this->Change(this->Internal->Style.SmoothAngle, degrees);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetDrawPoints(bool on)
{
  this->Change(this->Internal->Style.Points, on);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetDrawNormals(int of)
{
  this->Change(this->Internal->NormalsOf, of);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetNormalLength(double part)
{
  this->Change(this->Internal->NormalLength, part);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetNormalColor(double red, double green, double blue)
{
  this->Internal->LineProperty->SetColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetNumberOfIds(int number)
{
  this->Change(this->Internal->Ids.MaxLabels, number);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetIdSize(int points)
{
  this->Change(this->Internal->Ids.FontSize, std::clamp(points, MinIdSize, MaxIdSize));
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetDrawPointIds(bool on)
{
  this->Change(this->Internal->Ids.Shows[static_cast<int>(LabelKind::Point)], on);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetPointIdColor(double red, double green, double blue)
{
  this->Change(
    this->Internal->Ids.Colors[static_cast<int>(LabelKind::Point)], Color{ { red, green, blue } });
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetDrawEdgeIds(bool on)
{
  this->Change(this->Internal->Ids.Shows[static_cast<int>(LabelKind::Edge)], on);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetEdgeIdColor(double red, double green, double blue)
{
  this->Change(
    this->Internal->Ids.Colors[static_cast<int>(LabelKind::Edge)], Color{ { red, green, blue } });
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetDrawFaceIds(bool on)
{
  this->Change(this->Internal->Ids.Shows[static_cast<int>(LabelKind::Face)], on);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetFaceIdColor(double red, double green, double blue)
{
  this->Change(
    this->Internal->Ids.Colors[static_cast<int>(LabelKind::Face)], Color{ { red, green, blue } });
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetDrawCellIds(bool on)
{
  this->Change(this->Internal->Ids.Shows[static_cast<int>(LabelKind::Cell)], on);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetCellIdColor(double red, double green, double blue)
{
  this->Change(
    this->Internal->Ids.Colors[static_cast<int>(LabelKind::Cell)], Color{ { red, green, blue } });
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetDrawIsolines(bool on)
{
  this->Change(this->Internal->Style.Isolines, on);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetIsolineFirst(double value)
{
  this->Change(this->Internal->Style.IsolineFirst, value);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetIsolineSpacing(double spacing)
{
  this->Change(this->Internal->Style.IsolineSpacing, spacing);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetIsolineWidth(double pixels)
{
  this->Change(this->Internal->Style.IsolineWidth, pixels);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetIsolineColor(double red, double green, double blue)
{
  this->Change(this->Internal->Style.IsolineColor, Color{ { red, green, blue } });
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetGlassColor(double red, double green, double blue)
{
  this->Internal->ShellProperty->SetColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetCutShape(vtkImplicitFunction* shape)
{
  this->Internal->CutFunction = shape;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetDrawIsosurfaces(bool on)
{
  this->Change(this->Internal->DrawIsosurfaces, on);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetIsosurfaceArray(int, int, int, int, const char* name)
{
  this->Change(this->Internal->Style.IsosurfaceArray, std::string(name ? name : ""));
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetNumberOfIsosurfaceValues(int number)
{
  this->Internal->Style.IsosurfaceValues.resize(std::max(number, 0));
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetIsosurfaceValue(int index, double value)
{
  std::vector<double>& values = this->Internal->Style.IsosurfaceValues;
  if (index >= 0 && index < static_cast<int>(values.size()))
  {
    this->Change(values[index], value);
  }
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetIsolineArray(int, int, int, int, const char* name)
{
  this->Change(this->Internal->Style.IsolineArray, std::string(name ? name : ""));
}
