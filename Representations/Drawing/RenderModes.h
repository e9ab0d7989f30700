// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RenderModes.h
 * @brief The table of what a Mesh Inspection does to the color of a pixel.
 *
 * A mode is a GLSL file with one function, and a row here. The modes that are on are applied in the
 * order of the table, between VTK's own code for materials and for lights; so any of them go
 * together.
 */
#ifndef camaron_RenderModes_h
#define camaron_RenderModes_h

#include "InspectionStyle.h"

#include <string> // for the code
#include <vector> // for the table

class vtkProperty;
class vtkShaderProgram;

namespace camaron
{
/// What the uniforms of a mode depend on.
struct RenderContext
{
  const InspectionStyle& Style;
  vtkProperty* Property;
  const std::array<double, 4>& Distance; ///< see GetDistanceRamp
  const int* Viewport;                   ///< x, y, width, height in pixels
  const std::array<double, 3>& Middle;   ///< what coordinates in shaders are relative to
  const std::array<double, 4>& Eye;      ///< there; a place (1 at the end) or a direction (0)
  double ValueOrigin; ///< what values in shaders are relative to, those behind the colors
  double LevelOrigin; ///< and those of isolines
};

struct RenderMode
{
  bool (*IsOn)(const InspectionStyle& style);
  /// Made known to all shaders when the mode is on; null: none.
  const char* Define;
  /// Of the fragment shader: the GLSL file, and the call of its function.
  const char* Source;
  const char* Call;
  /// The call needs the normal, which there is only where there is light.
  bool NeedsNormal;
  void (*SetUniforms)(vtkShaderProgram* program, const RenderContext& context);
};

const std::vector<RenderMode>& GetRenderModes();

/// Code of all modes that are on, for one place of the shaders.
struct RenderModeCode
{
  std::string Defines;
  std::string Declarations;
  std::string ColorCalls;
  std::string NormalCalls;
};
RenderModeCode GetRenderModeCode(const InspectionStyle& style, bool hasLight);
}

#endif
