// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DistanceRamp.h
 * @brief Height along a direction, or depth from the eye, as a fraction of a range.
 */
#ifndef camaron_DistanceRamp_h
#define camaron_DistanceRamp_h

#include "InspectionStyle.h"

class vtkMatrix4x4;

namespace camaron
{
/**
 * Coefficients (a, b, c, d) for which a x + b y + c z + d is 0 at the low end of the range and 1 at
 * the high end, for points relative to @a middle. Without a custom range, the ends are those of @a
 * bounds.
 *
 * @param toView transforms coordinates of the mesh to those of the camera, which looks along -z
 */
std::array<double, 4> GetDistanceRamp(const InspectionStyle& style, const double bounds[6],
  const std::array<double, 3>& middle, vtkMatrix4x4* toView);
}

#endif
