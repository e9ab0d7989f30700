// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeUniforms.h
 * @brief The uniforms of InShape.glsl for a shape.
 */
#ifndef camaron_ShapeUniforms_h
#define camaron_ShapeUniforms_h

#include "InspectionStyle.h"

#include <array> // for the numbers

namespace camaron
{
struct ShapeUniforms
{
  /**
   * @param middle origin of the coordinates in the shaders
   */
  ShapeUniforms(const ConvexShape& shape, const std::array<double, 3>& middle);

  int NumberOfPlanes;
  float Planes[ConvexShape::MaxPlanes][4] = {};
  float ToUnitSphere[16]; ///< by columns
};
}

#endif
