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
// Setters that change a member: property, type, member, and its value from that of the property.
#define CAMARON_SETTER(Property, Type, Member, Value)                                              \
  void vtkMeshInspectionRepresentation::Set##Property(Type value)                                  \
  {                                                                                                \
    this->Change(this->Internal->Member, Value);                                                   \
  }
CAMARON_SETTER(ColorMissingArraysWithNanColor, bool, ColorMissingArraysWithNanColor, value)
CAMARON_SETTER(DrawWith, int, Style.OnProcessor, value == 1)
CAMARON_SETTER(DrawFaces, bool, Style.Faces, value)
CAMARON_SETTER(DrawEdges, bool, Style.Edges, value)
CAMARON_SETTER(EdgesOf, int, Style.EdgesOfSelectedOnly, value == 1)
CAMARON_SETTER(GlassShell, bool, GlassShell, value)
CAMARON_SETTER(GlassStrength, double, Style.GlassStrength, value)
CAMARON_SETTER(FacesToDraw, int, Style.FacesToDraw, static_cast<DrawnFaces>(value))
CAMARON_SETTER(CellsToDraw, int, Style.CellsToDraw, static_cast<DrawnCells>(value))
CAMARON_SETTER(ShrinkFactor, double, Style.ShrinkFactor, value)
CAMARON_SETTER(ExplodeFactor, double, Style.ExplodeFactor, value)
CAMARON_SETTER(CutBy, int, Style.Cut, static_cast<camaron::CutBy>(value))
CAMARON_SETTER(CutKeep, int, Style.KeepInside, value == 1)
CAMARON_SETTER(CutMoves, int, CutMoves, value)
CAMARON_SETTER(ColorCutFaces, bool, Style.CutFaces, value)
CAMARON_SETTER(Coloring, int, Style.ColorBy, static_cast<Coloring>(value))
CAMARON_SETTER(CustomColorRange, bool, Style.CustomColorRange, value)
CAMARON_SETTER(Emphasis, int, Style.ValuesToEmphasize, static_cast<camaron::Emphasis>(value))
CAMARON_SETTER(Dimming, double, Style.Dimming, value)
CAMARON_SETTER(SmoothShading, bool, Style.Smooth, value)
CAMARON_SETTER(SmoothAngle, double, Style.SmoothAngle, value)
CAMARON_SETTER(DrawPoints, bool, Style.Points, value)
CAMARON_SETTER(DrawNormals, int, NormalsOf, value)
CAMARON_SETTER(NormalLength, double, NormalLength, value)
CAMARON_SETTER(NumberOfIds, int, Ids.MaxLabels, value)
CAMARON_SETTER(DrawIsolines, bool, Style.Isolines, value)
CAMARON_SETTER(IsolineFirst, double, Style.IsolineFirst, value)
CAMARON_SETTER(IsolineSpacing, double, Style.IsolineSpacing, value)
CAMARON_SETTER(IsolineWidth, double, Style.IsolineWidth, value)
CAMARON_SETTER(DrawIsosurfaces, bool, DrawIsosurfaces, value)
#undef CAMARON_SETTER

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetBlockColorsDistinctValues(int number)
{
  static_cast<vtkInspectionMesh*>(this->GeometryFilter)->SetBlockColorsDistinctValues(number);
  this->MarkModified();
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetCutColor(double red, double green, double blue)
{
  this->Change(this->Internal->Style.CutColor, Color{ { red, green, blue } });
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
void vtkMeshInspectionRepresentation::SetColorRange(double low, double high)
{
  this->Change(this->Internal->Style.ColorRange, Range{ { low, high } });
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetAcceptableRange(double low, double high)
{
  this->Change(this->Internal->Style.AcceptableRange, Range{ { low, high } });
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetNormalColor(double red, double green, double blue)
{
  this->Internal->LineProperty->SetColor(red, green, blue);
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
