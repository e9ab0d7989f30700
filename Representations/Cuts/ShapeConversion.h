// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeConversion.h
 * @brief From ParaView's implicit functions, which have widgets, to the shapes that the shaders
 * know.
 */
#ifndef camaron_ShapeConversion_h
#define camaron_ShapeConversion_h

#include "InspectionStyle.h"

#include <array>  // for bounds
#include <string> // for errors

class vtkImplicitFunction;
class vtkMatrix4x4;

namespace camaron
{
/**
 * The inside (where the function is negative) of a vtkSphere, vtkPlane, vtkBox or vtkPlanes, or of
 * a vtkImplicitBoolean intersection of those with planes.
 * @return an empty text, or what is wrong with the function
 */
std::string ConvertShape(vtkImplicitFunction* function, ConvexShape& shape);

/// The shape in other coordinates, from which @a toShape leads to those it is in.
ConvexShape TransformShape(const ConvexShape& shape, vtkMatrix4x4* toShape);

/**
 * The shape a hair's breadth away from where it is, for cuts through cells: never in the faces of
 * cells that lie in it, as those of a symmetric mesh do in the plane through its middle.
 *
 * A plane goes towards what is kept, so that it is the kept cells that one sees on it, and those
 * that only touch it go whole. If all of the mesh is kept by a plane that touches it, the plane
 * goes the other way: faces stay what they are. A sphere has no faces in it; it grows, so that it
 * has the points on it.
 * @param size of the mesh as it is drawn: the diagonal of its bounds
 * @param bounds of the mesh; 1, -1: unknown
 */
ConvexShape MakeExactShape(
  const ConvexShape& shape, bool keepInside, double size, const std::array<double, 6>& bounds);
}

#endif
