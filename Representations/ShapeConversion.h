// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShapeConversion.h
 * @brief From ParaView's implicit functions, which have widgets, to the shapes that the shaders know.
 */
#ifndef camaron_ShapeConversion_h
#define camaron_ShapeConversion_h

#include "InspectionStyle.h"

#include <string> // for errors

class vtkImplicitFunction;
class vtkMatrix4x4;

namespace camaron
{
/**
 * The inside (where the function is negative) of a vtkSphere, vtkPlane, vtkBox or vtkPlanes, or of a
 * vtkImplicitBoolean intersection of those with planes.
 * @return an empty text, or what is wrong with the function
 */
std::string ConvertShape(vtkImplicitFunction* function, ConvexShape& shape);

/// The shape in other coordinates, from which @a toShape leads to those it is in.
ConvexShape TransformShape(const ConvexShape& shape, vtkMatrix4x4* toShape);
}

#endif
