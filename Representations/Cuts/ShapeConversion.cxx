// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShapeConversion.h"

#include "vtkHalfSpaces.h"

#include "vtkAbstractTransform.h"
#include "vtkBox.h"
#include "vtkDataArray.h"
#include "vtkHomogeneousTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlanes.h"
#include "vtkPoints.h"
#include "vtkSphere.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
constexpr int MaxPlanes = ConvexShape::MaxPlanes;

//------------------------------------------------------------------------------
// False if the normal has no direction. Any length is allowed if its components fit into float.
bool AddPlane(const double origin[3], const double normal[3], ConvexShape& shape)
{
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  if (!(length > 0) || !std::isfinite(length))
  {
    return false;
  }
  std::array<double, 4> plane;
  plane[3] = 0;
  for (int i = 0; i < 3; ++i)
  {
    plane[i] = normal[i] / length;
    plane[3] -= plane[i] * origin[i];
  }
  shape.Planes.push_back(plane);
  return true;
}

//------------------------------------------------------------------------------
// Evaluates the plane, because ParaView's plane also has an offset and an axis, which its origin
// and normal do not include.
bool AddPlane(vtkPlane* plane, ConvexShape& shape)
{
  double origin[3];
  double normal[3];
  plane->GetOrigin(origin);
  plane->EvaluateGradient(origin, normal);
  const double value = plane->EvaluateFunction(origin);
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  for (int i = 0; i < 3 && length > 0; ++i)
  {
    origin[i] -= value / length * normal[i] / length;
  }
  return AddPlane(origin, normal, shape);
}

//------------------------------------------------------------------------------
bool AddBox(vtkBox* box, ConvexShape& shape)
{
  double bounds[6];
  box->GetBounds(bounds);
  for (int side = 0; side < 6; ++side)
  {
    double origin[3] = { 0, 0, 0 };
    double normal[3] = { 0, 0, 0 };
    origin[side / 2] = bounds[side];
    normal[side / 2] = side % 2 ? 1 : -1;
    AddPlane(origin, normal, shape);
  }
  return bounds[0] <= bounds[1] && bounds[2] <= bounds[3] && bounds[4] <= bounds[5];
}

//------------------------------------------------------------------------------
bool AddPlanes(vtkPlanes* planes, ConvexShape& shape)
{
  vtkPoints* points = planes->GetPoints();
  vtkDataArray* normals = planes->GetNormals();
  if (!points || !normals || points->GetNumberOfPoints() != normals->GetNumberOfTuples() ||
    points->GetNumberOfPoints() == 0)
  {
    return false;
  }
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    if (!AddPlane(points->GetPoint(i), normals->GetTuple(i), shape))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool SetSphere(vtkSphere* sphere, ConvexShape& shape)
{
  const double radius = sphere->GetRadius();
  double center[3];
  sphere->GetCenter(center);
  shape.ToUnitSphere = {};
  for (int i = 0; i < 3; ++i)
  {
    shape.ToUnitSphere[5 * i] = 1 / radius;
    shape.ToUnitSphere[4 * i + 3] = -center[i] / radius;
  }
  shape.ToUnitSphere[15] = 1;
  return radius > 0 && std::isfinite(radius);
}
}

//------------------------------------------------------------------------------
std::string ConvertShape(vtkImplicitFunction* function, ConvexShape& shape)
{
  auto* halfSpaces = vtkHalfSpaces::SafeDownCast(function);
  if (halfSpaces && halfSpaces->GetNumberOfNumbers() % 6 != 0)
  {
    return "Half Spaces: expected a multiple of 6 numbers, a point and a normal for each plane, "
           "found " +
      std::to_string(halfSpaces->GetNumberOfNumbers()) + ".";
  }
  ConvexShape converted;
  bool isValid = false;
  if (auto* sphere = vtkSphere::SafeDownCast(function))
  {
    isValid = SetSphere(sphere, converted);
  }
  else if (auto* box = vtkBox::SafeDownCast(function))
  {
    isValid = AddBox(box, converted);
  }
  else if (auto* plane = vtkPlane::SafeDownCast(function))
  {
    isValid = AddPlane(plane, converted);
  }
  else if (auto* planes = vtkPlanes::SafeDownCast(function))
  {
    isValid = AddPlanes(planes, converted);
  }
  else
  {
    return "Cut Shape must be a sphere, a plane, planes or a box.";
  }
  if (!isValid)
  {
    return "Cut Shape has no inside: a radius and normals must be finite and not 0.";
  }
  if (converted.Planes.size() > MaxPlanes)
  {
    return "Cut Shape can have up to " + std::to_string(MaxPlanes) + " planes, found " +
      std::to_string(converted.Planes.size()) + ".";
  }
  if (vtkAbstractTransform* transform = function->GetTransform())
  {
    auto* linear = vtkHomogeneousTransform::SafeDownCast(transform);
    if (!linear)
    {
      return "Cut Shape must be moved by a linear transform.";
    }
    linear->Update();
    converted = TransformShape(converted, linear->GetMatrix());
  }
  shape = converted;
  return "";
}

//------------------------------------------------------------------------------
ConvexShape TransformShape(const ConvexShape& shape, vtkMatrix4x4* toShape)
{
  ConvexShape transformed;
  for (const std::array<double, 4>& plane : shape.Planes)
  {
    // A plane is transformed as a row vector: plane * matrix. Normals get length 1 again, for
    // float.
    std::array<double, 4> row = {};
    for (int k = 0; k < 4; ++k)
    {
      for (int i = 0; i < 4; ++i)
      {
        row[k] += plane[i] * toShape->GetElement(i, k);
      }
    }
    const double length = std::hypot(row[0], row[1], row[2]);
    for (double& value : row)
    {
      value /= length > 0 ? length : 1;
    }
    transformed.Planes.push_back(row);
  }
  vtkMatrix4x4::Multiply4x4(
    shape.ToUnitSphere.data(), toShape->GetData(), transformed.ToUnitSphere.data());
  return transformed;
}

//------------------------------------------------------------------------------
ConvexShape MakeExactShape(
  const ConvexShape& shape, bool keepInside, double size, const std::array<double, 6>& bounds)
{
  // Coordinates in shaders are float relative to the middle of the mesh, up to half its size, which
  // rounds them by 2^-25 of the size, and heights above planes by a few times that. This distance
  // is well above, but less than a hundredth of a pixel in a view of the whole mesh. Files that
  // store float coordinates far from 0 round them more.
  const double hair = std::ldexp(size, -18);
  if (!(hair > 0) || !std::isfinite(hair))
  {
    return shape;
  }
  ConvexShape exact = shape;
  exact.FaceClearance = hair;
  for (std::array<double, 4>& plane : exact.Planes)
  {
    double height = plane[3], reach = 0;
    for (int i = 0; i < 3; ++i)
    {
      height += plane[i] * (0.5 * bounds[2 * i] + 0.5 * bounds[2 * i + 1]);
      reach += std::abs(plane[i]) * (0.5 * bounds[2 * i + 1] - 0.5 * bounds[2 * i]);
    }
    const bool keepsAll =
      bounds[0] <= bounds[1] && (keepInside ? height + reach <= hair : height - reach >= -hair);
    plane[3] += keepInside == keepsAll ? -hair : hair;
  }
  if (exact.Planes.empty())
  {
    double squares = 0;
    for (int row = 0; row < 3; ++row)
    {
      for (int k = 0; k < 3; ++k)
      {
        squares += exact.ToUnitSphere[4 * row + k] * exact.ToUnitSphere[4 * row + k];
      }
    }
    const double growth = 1 + hair * std::sqrt(squares / 3);
    std::transform(exact.ToUnitSphere.begin(), exact.ToUnitSphere.begin() + 12,
      exact.ToUnitSphere.begin(), [growth](double x) { return x / growth; });
  }
  return exact;
}

//------------------------------------------------------------------------------
ShapeUniforms::ShapeUniforms(const ConvexShape& shape, const std::array<double, 3>& middle)
  : NumberOfPlanes(std::min(static_cast<int>(shape.Planes.size()), ConvexShape::MaxPlanes))
{
  const auto atMiddle = [&](const double* row)
  {
    return static_cast<float>(
      row[3] + row[0] * middle[0] + row[1] * middle[1] + row[2] * middle[2]);
  };
  for (int i = 0; i < this->NumberOfPlanes; ++i)
  {
    const double* plane = shape.Planes[i].data();
    std::copy_n(plane, 3, this->Planes[i]);
    this->Planes[i][3] = atMiddle(plane);
  }
  for (int row = 0; row < 4; ++row)
  {
    const double* from = &shape.ToUnitSphere[4 * row];
    for (int k = 0; k < 3; ++k)
    {
      this->ToUnitSphere[4 * k + row] = static_cast<float>(from[k]);
    }
    this->ToUnitSphere[12 + row] = atMiddle(from);
  }
}
}
