// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RenderModes.h"

#include "Shaders.h"
#include "ShapeConversion.h"

#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
void SetNothing(vtkShaderProgram*, const RenderContext&) {}

//------------------------------------------------------------------------------
void SetRange(vtkShaderProgram* program, const char* name, const Range& range, double origin)
{
  // Unbounded ends become the largest float.
  constexpr double largest = std::numeric_limits<float>::max();
  const float ends[2] = { static_cast<float>(std::max(range[0] - origin, -largest)),
    static_cast<float>(std::min(range[1] - origin, largest)) };
  program->SetUniform2f(name, ends);
}

//------------------------------------------------------------------------------
void SetRamp(vtkShaderProgram* program, const RenderContext& context)
{
  float distance[4];
  std::copy(context.Distance.begin(), context.Distance.end(), distance);
  program->SetUniform4f("distanceRamp", distance);
  program->SetUniform3f("lowColor", context.Style.LowColor.data());
  program->SetUniform3f("highColor", context.Style.HighColor.data());
  program->SetUniform3f("undefinedColor", context.Style.UndefinedColor.data());
  SetRange(program, "rampRange", context.Style.ColorRange, context.ValueOrigin);
}

//------------------------------------------------------------------------------
void SetViewport(vtkShaderProgram* program, const RenderContext& context)
{
  const int* viewport = context.Viewport;
  const float origin[2] = { static_cast<float>(viewport[0]), static_cast<float>(viewport[1]) };
  const float size[2] = { static_cast<float>(viewport[2]), static_cast<float>(viewport[3]) };
  program->SetUniform2f("viewportOrigin", origin);
  program->SetUniform2f("viewportSize", size);
}

//------------------------------------------------------------------------------
void SetWireframe(vtkShaderProgram* program, const RenderContext& context)
{
  SetViewport(program, context);
  program->SetUniformf("edgeWidth", static_cast<float>(context.Property->GetLineWidth()));
  program->SetUniform3f("edgesColor", context.Property->GetEdgeColor());
  program->SetUniformf("edgesOpacity", static_cast<float>(context.Property->GetEdgeOpacity()));
  program->SetUniformf("partsOfEdge", static_cast<float>(1 << context.Style.SubdivisionLevel));
  program->SetUniformi("hasFaces", context.Style.Faces ? 1 : 0);
  program->SetUniformi("edgesOfSelectedOnly", context.Style.EdgesOfSelectedOnly ? 1 : 0);
}

//------------------------------------------------------------------------------
void SetNormalLines(vtkShaderProgram* program, const RenderContext& context)
{
  SetViewport(program, context);
  program->SetUniformf("normalLength", static_cast<float>(context.Style.NormalLength));
  program->SetUniformf("normalWidth", static_cast<float>(context.Property->GetLineWidth()));
}

//------------------------------------------------------------------------------
void SetIsolines(vtkShaderProgram* program, const RenderContext& context)
{
  const InspectionStyle& style = context.Style;
  program->SetUniformf(
    "isolineFirst", static_cast<float>(style.IsolineFirst - context.LevelOrigin));
  program->SetUniformf("isolineSpacing", static_cast<float>(style.IsolineSpacing));
  program->SetUniformf("isolineWidth", static_cast<float>(style.IsolineWidth));
  program->SetUniform3f("isolineColor", style.IsolineColor.data());
}
}

//------------------------------------------------------------------------------
void SetShape(vtkShaderProgram* program, const RenderContext& context)
{
  const ShapeUniforms shape(context.Style.ExactShape, context.Middle);
  program->SetUniformi("numberOfPlanes", shape.NumberOfPlanes);
  program->SetUniform4fv("planes", ConvexShape::MaxPlanes, shape.Planes);
  program->SetUniformMatrix4x4("toUnitSphere", const_cast<float*>(shape.ToUnitSphere));
  program->SetUniformi("keepInside", context.Style.KeepInside ? 1 : 0);
}

//------------------------------------------------------------------------------
void SetCap(vtkShaderProgram* program, const RenderContext& context)
{
  float eye[4];
  std::copy(context.Eye.begin(), context.Eye.end(), eye);
  program->SetUniform4f("eye", eye);
  program->SetUniformf("faceClearance", static_cast<float>(context.Style.ExactShape.FaceClearance));
  SetShape(program, context);
}

//------------------------------------------------------------------------------
const std::vector<RenderMode>& GetRenderModes()
{
  using Style = InspectionStyle;
  using Context = RenderContext;
  static const std::string cutExactly = std::string(InShapeGLSL) + CutExactlyGLSL;
  static const std::string negatives = std::string(PlaceGLSL) + NegativesGLSL;
  static const std::string cap = std::string(InShapeGLSL) + InputsGLSL + CapGLSL;
  static const std::vector<RenderMode> modes = {
    { [](const Style& style)
      {
        return style.CutsExactly() && !style.Glass && style.What != Figure::Cap &&
          style.What != Figure::Isosurfaces;
      },
      "HAS_POSITION", cutExactly.c_str(), "cutExactly();", false, &SetShape },
    { [](const Style& style) { return style.HasNegatives && !style.DrawsFaces(); }, "HAS_NEGATIVES",
      negatives.c_str(), "leaveOutside();", false, &SetNothing },
    { [](const Style&) { return true; }, nullptr, PropertyGLSL,
      "property(ambientColor, diffuseColor, opacity);", false, &SetNothing },
    { [](const Style& style) { return style.HasLooks; }, "HAS_LOOKS", BlocksGLSL,
      "blocks(ambientColor, diffuseColor, opacity);", false, &SetNothing },
    { [](const Style& style) { return style.ColorBy == Coloring::TwoColors && !style.Glass; },
      nullptr, RampGLSL, "ramp(ambientColor, diffuseColor, opacity);", false, &SetRamp },
    { [](const Style& style) { return style.ColorsByDistance() && !style.Glass; }, "HAS_DISTANCE",
      RampGLSL, "ramp(ambientColor, diffuseColor, opacity);", false, &SetRamp },
    { [](const Style& style)
      { return style.ValuesToEmphasize != Emphasis::Nothing && !style.Glass; }, nullptr,
      EmphasisGLSL, "emphasis(ambientColor, diffuseColor, opacity);", false,
      [](vtkShaderProgram* program, const Context& context)
      {
        SetRange(program, "acceptableRange", context.Style.AcceptableRange, context.ValueOrigin);
        program->SetUniformi(
          "emphasizesInside", context.Style.ValuesToEmphasize == Emphasis::InsideRange ? 1 : 0);
        program->SetUniformf("dimming", static_cast<float>(context.Style.Dimming));
        float accent[4];
        std::copy(context.Style.Accent.begin(), context.Style.Accent.end(), accent);
        program->SetUniform4f("accent", accent);
      } },
    { [](const Style& style) { return style.IsOn("ColorCutFaces") && !style.Glass; }, nullptr,
      CutFacesGLSL, "cutFaces(ambientColor, diffuseColor, opacity);", false,
      [](vtkShaderProgram* program, const Context& context)
      { program->SetUniform3f("cutColor", context.Style.CutColor.data()); } },
    { [](const Style& style) { return style.Isolines && !style.Glass; }, "HAS_ISOLINES",
      IsolinesGLSL, "isolines(ambientColor, diffuseColor, opacity);", false, &SetIsolines },
    { [](const Style& style) { return style.Edges && !style.Glass && !style.DrawsEdgesAlone(); },
      "HAS_LINES", WireframeGLSL, "wireframe(ambientColor, diffuseColor, opacity);", false,
      &SetWireframe },
    { [](const Style& style) { return style.ColorLimits != Unlimited; }, "HAS_LIMITS", "", "",
      false,
      [](vtkShaderProgram* program, const Context& context)
      {
        SetViewport(program, context);
        SetRange(program, "colorLimits", context.Style.ColorLimits, context.ValueOrigin);
      } },
    { [](const Style& style) { return style.DrawsEdgesAlone(); }, "ARE_EDGES", EdgesAloneGLSL,
      "edgesAlone(ambientColor, diffuseColor);", false, &SetWireframe },
    { [](const Style& style) { return style.Smooth; }, "HAS_NORMALS", SmoothGLSL,
      "smoothNormals(normalVCVSOutput);", true,
      [](vtkShaderProgram* program, const Context& context)
      {
        const double cosine = std::cos(vtkMath::RadiansFromDegrees(context.Style.SmoothAngle));
        program->SetUniformf("smoothCosine", static_cast<float>(cosine));
      } },
    { [](const Style& style) { return style.Glass; }, nullptr, GlassGLSL,
      "glass(opacity, normalVCVSOutput, vertexVC.xyz);", true,
      [](vtkShaderProgram* program, const Context& context)
      { program->SetUniformf("glassStrength", static_cast<float>(context.Style.GlassStrength)); } },
    { [](const Style& style) { return style.DrawsNormals(); }, nullptr, "", "", false,
      &SetNormalLines },
    // After the modes whose inputs it computes.
    { [](const Style& style) { return style.What == Figure::Cap; }, "IS_CAP", cap.c_str(), "",
      false, &SetCap },
  };
  return modes;
}

//------------------------------------------------------------------------------
RenderModeCode GetRenderModeCode(const InspectionStyle& style, bool hasLight)
{
  RenderModeCode code;
  code.Declarations = ValuesGLSL;
  for (const RenderMode& mode : GetRenderModes())
  {
    if (!mode.IsOn(style) || (mode.NeedsNormal && !hasLight))
    {
      continue;
    }
    if (mode.Define)
    {
      code.Defines += std::string("#define ") + mode.Define + "\n";
    }
    code.Declarations += mode.Source;
    (mode.NeedsNormal ? code.NormalCalls : code.ColorCalls) += std::string("  ") + mode.Call + "\n";
  }
  return code;
}
}
