// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RenderModes.h
 * @brief The table of render modes: functions that change the color of a pixel.
 *
 * A mode is a GLSL file with one function, and a row in this table. All modes that are on are
 * applied in table order, after VTK's code for materials and before its code for lights, so any
 * modes can be combined.
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
/// The values from which modes compute their uniforms.
struct RenderContext
{
  const InspectionStyle& Style;
  vtkProperty* Property;
  const std::array<double, 4>& Distance; ///< height or depth, see GetDistanceRamp
  const int* Viewport;                   ///< x, y, width, height in pixels
  const std::array<double, 3>& Middle;   ///< origin of coordinates in shaders
  const std::array<double, 4>&
    Eye;              ///< relative to Middle; a position (w is 1) or a direction (w is 0)
  double ValueOrigin; ///< origin of values in shaders, those that are mapped to colors
  double LevelOrigin; ///< origin of the values for isolines
};

/// A row of the table of render modes.
struct RenderMode
{
  /// Whether the mode is on.
  bool (*IsOn)(const InspectionStyle& style);
  /// Defined in all shaders if the mode is on; null: nothing.
  const char* Define;
  /// The GLSL file for the fragment shader, and the call of its function.
  const char* Source;
  const char* Call;
  /// The call needs the normal, which exists only if there is light.
  bool NeedsNormal;
  void (*SetUniforms)(vtkShaderProgram* program, const RenderContext& context);
};

/// All modes, in the order in which they are applied.
const std::vector<RenderMode>& GetRenderModes();

/// The code of all modes that are on, by its position in the shaders.
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
