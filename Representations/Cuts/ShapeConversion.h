// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeConversion.h
 * @brief Converts ParaView's implicit functions, which have widgets, to the shapes of the shaders,
 * and these to uniforms.
 */
#ifndef camaron_ShapeConversion_h
#define camaron_ShapeConversion_h

#include "InspectionStyle.h"

#include <array>  // for numbers
#include <string> // for errors

class vtkImplicitFunction;
class vtkMatrix4x4;

namespace camaron
{
/// The uniforms of InShape.glsl for a shape.
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

/**
 * Converts the inside (where the function is negative) of a vtkSphere, vtkPlane, vtkBox or
 * vtkPlanes, or of a vtkImplicitBoolean intersection of those with planes.
 *
 * @return an empty text, or an error message about the function
 */
std::string ConvertShape(vtkImplicitFunction* function, ConvexShape& shape);

/// The shape in other coordinates; @a toShape transforms these to the coordinates of @a shape.
ConvexShape TransformShape(const ConvexShape& shape, vtkMatrix4x4* toShape);

/**
 * The shape moved by a tiny distance, for cuts through cells, so that it never coincides with faces
 * of cells, such as the symmetry plane of a mesh.
 *
 * A plane moves towards the side that is kept, so that the cap shows kept cells and removes cells
 * that only touch the plane. If the whole mesh is on the kept side of a plane that touches it, the
 * plane moves the other way, so that the faces there remain. A sphere contains no faces; it grows,
 * so that points on it are inside.
 *
 * @param size of the drawn mesh: the diagonal of its bounds
 * @param bounds of the mesh; 1, -1: unknown
 */
ConvexShape MakeExactShape(
  const ConvexShape& shape, bool keepInside, double size, const std::array<double, 6>& bounds);
}

#endif
