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

int Number(LabelKind kind)
{
  return static_cast<int>(kind);
}

std::string Text(const char* name)
{
  return name ? name : "";
}
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
// Setters that change a member: property, parameters, member, and its value.
#define CAMARON_SETTER(Property, Parameters, Member, ...)                                          \
  void vtkMeshInspectionRepresentation::Set##Property Parameters                                   \
  {                                                                                                \
    this->Change(this->Internal->Member, __VA_ARGS__);                                             \
  }
CAMARON_SETTER(ColorMissingArraysWithNanColor, (bool value), ColorMissingArraysWithNanColor, value)
CAMARON_SETTER(DrawWith, (int value), Style.OnProcessor, value == 1)
CAMARON_SETTER(DrawFaces, (bool value), Style.Faces, value)
CAMARON_SETTER(DrawEdges, (bool value), Style.Edges, value)
CAMARON_SETTER(EdgesOf, (int value), Style.EdgesOfSelectedOnly, value == 1)
CAMARON_SETTER(GlassShell, (bool value), GlassShell, value)
CAMARON_SETTER(GlassStrength, (double value), Style.GlassStrength, value)
CAMARON_SETTER(FacesToDraw, (int value), Style.FacesToDraw, static_cast<DrawnFaces>(value))
CAMARON_SETTER(CellsToDraw, (int value), Style.CellsToDraw, static_cast<DrawnCells>(value))
CAMARON_SETTER(ShrinkFactor, (double value), Style.ShrinkFactor, value)
CAMARON_SETTER(ExplodeFactor, (double value), Style.ExplodeFactor, value)
CAMARON_SETTER(CutBy, (int value), Style.Cut, static_cast<camaron::CutBy>(value))
CAMARON_SETTER(CutKeep, (int value), Style.KeepInside, value == 1)
CAMARON_SETTER(CutMoves, (int value), CutMoves, value)
CAMARON_SETTER(CutColor, (double r, double g, double b), Style.CutColor, Color{ { r, g, b } })
CAMARON_SETTER(Coloring, (int value), Style.ColorBy, static_cast<Coloring>(value))
CAMARON_SETTER(HeightDirection, (double x, double y, double z), Style.HeightDirection,
  std::array<double, 3>{ { x, y, z } })
CAMARON_SETTER(LowColor, (double r, double g, double b), Style.LowColor, Color{ { r, g, b } })
CAMARON_SETTER(HighColor, (double r, double g, double b), Style.HighColor, Color{ { r, g, b } })
CAMARON_SETTER(
  UndefinedColor, (double r, double g, double b), Style.UndefinedColor, Color{ { r, g, b } })
CAMARON_SETTER(CustomColorRange, (bool value), Style.CustomColorRange, value)
CAMARON_SETTER(ColorRange, (double low, double high), Style.ColorRange, Range{ { low, high } })
CAMARON_SETTER(
  Emphasis, (int value), Style.ValuesToEmphasize, static_cast<camaron::Emphasis>(value))
CAMARON_SETTER(
  AcceptableRange, (double low, double high), Style.AcceptableRange, Range{ { low, high } })
CAMARON_SETTER(Dimming, (double value), Style.Dimming, value)
CAMARON_SETTER(Accent, (double r, double g, double b, double share), Style.Accent,
  std::array<double, 4>{ { r, g, b, share } })
CAMARON_SETTER(NonlinearSubdivisionLevel, (int value), Style.SubdivisionLevel, value)
CAMARON_SETTER(SmoothShading, (bool value), Style.Smooth, value)
CAMARON_SETTER(SmoothAngle, (double value), Style.SmoothAngle, value)
CAMARON_SETTER(DrawPoints, (bool value), Style.Points, value)
CAMARON_SETTER(DrawNormals, (int value), NormalsOf, value)
CAMARON_SETTER(NormalLength, (double value), NormalLength, value)
CAMARON_SETTER(NumberOfIds, (int value), Ids.MaxLabels, value)
CAMARON_SETTER(IdSize, (int value), Ids.FontSize, std::clamp(value, MinIdSize, MaxIdSize))
CAMARON_SETTER(DrawPointIds, (bool on), Ids.Shows[Number(LabelKind::Point)], on)
CAMARON_SETTER(PointIdColor, (double r, double g, double b), Ids.Colors[Number(LabelKind::Point)],
  Color{ { r, g, b } })
CAMARON_SETTER(DrawEdgeIds, (bool on), Ids.Shows[Number(LabelKind::Edge)], on)
CAMARON_SETTER(EdgeIdColor, (double r, double g, double b), Ids.Colors[Number(LabelKind::Edge)],
  Color{ { r, g, b } })
CAMARON_SETTER(DrawFaceIds, (bool on), Ids.Shows[Number(LabelKind::Face)], on)
CAMARON_SETTER(FaceIdColor, (double r, double g, double b), Ids.Colors[Number(LabelKind::Face)],
  Color{ { r, g, b } })
CAMARON_SETTER(DrawCellIds, (bool on), Ids.Shows[Number(LabelKind::Cell)], on)
CAMARON_SETTER(CellIdColor, (double r, double g, double b), Ids.Colors[Number(LabelKind::Cell)],
  Color{ { r, g, b } })
CAMARON_SETTER(DrawIsolines, (bool value), Style.Isolines, value)
CAMARON_SETTER(IsolineArray, (int, int, int, int, const char* name), Style.IsolineArray, Text(name))
CAMARON_SETTER(IsolineFirst, (double value), Style.IsolineFirst, value)
CAMARON_SETTER(IsolineSpacing, (double value), Style.IsolineSpacing, value)
CAMARON_SETTER(IsolineWidth, (double value), Style.IsolineWidth, value)
CAMARON_SETTER(
  IsolineColor, (double r, double g, double b), Style.IsolineColor, Color{ { r, g, b } })
CAMARON_SETTER(DrawIsosurfaces, (bool value), DrawIsosurfaces, value)
CAMARON_SETTER(
  IsosurfaceArray, (int, int, int, int, const char* name), Style.IsosurfaceArray, Text(name))
#undef CAMARON_SETTER

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetSwitch(const char* property, bool on)
{
  std::set<std::string> switches = this->Internal->Style.Switches;
  if (on)
  {
    switches.insert(property);
  }
  else
  {
    switches.erase(property);
  }
  this->Change(this->Internal->Style.Switches, switches);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetNormalColor(double red, double green, double blue)
{
  this->Internal->LineProperty->SetColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetGlassColor(double red, double green, double blue)
{
  this->Internal->ShellProperty->SetColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetBlockColorsDistinctValues(int number)
{
  static_cast<vtkInspectionMesh*>(this->GeometryFilter)->SetBlockColorsDistinctValues(number);
  this->MarkModified();
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetCutShape(vtkImplicitFunction* shape)
{
  this->Internal->CutFunction = shape;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetNumberOfBrushes(int number)
{
  std::vector<Brush> brushes = this->Internal->Style.Brushes;
  brushes.resize(std::max(number, 0));
  this->Change(this->Internal->Style.Brushes, brushes);
}

//------------------------------------------------------------------------------
void vtkMeshInspectionRepresentation::SetBrush(
  int index, const char* array, double low, double high, bool selects)
{
  std::vector<Brush>& brushes = this->Internal->Style.Brushes;
  if (index >= 0 && index < static_cast<int>(brushes.size()))
  {
    this->Change(brushes[index], Brush{ Text(array), { { low, high } }, selects });
  }
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
