// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReferenceShapes.h
 * @brief Cells whose criteria are known from closed forms and an independent program.
 */
#ifndef camaron_ReferenceShapes_h
#define camaron_ReferenceShapes_h

#include "TestMeshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace camaron
{
namespace testing
{
struct ReferenceShape
{
  const char* Name;
  Grid Standard; ///< as a cell of a fixed VTK type; null if there is none
  Grid Polyhedron;
  std::map<std::string, double> Expected;
};

/// Faces of the convex hull of a few points, outward, found by trying every plane.
inline Faces MakeConvexFaces(const Points& points)
{
  const auto minus = [](const Point& a, const Point& b)
  { return Point{ a[0] - b[0], a[1] - b[1], a[2] - b[2] }; };
  const auto cross = [](const Point& a, const Point& b)
  {
    return Point{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  };
  const auto dot = [](const Point& a, const Point& b)
  { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  Faces faces;
  std::vector<std::vector<vtkIdType>> known;
  const vtkIdType n = static_cast<vtkIdType>(points.size());
  for (vtkIdType i = 0; i < n; ++i)
  {
    for (vtkIdType j = 0; j < n; ++j)
    {
      for (vtkIdType k = 0; k < n; ++k)
      {
        const Point u = minus(points[j], points[i]);
        Point normal = cross(u, minus(points[k], points[i]));
        const double length = std::sqrt(dot(normal, normal));
        if (length < 1e-6)
        {
          continue;
        }
        std::vector<vtkIdType> on;
        bool outside = false;
        for (vtkIdType p = 0; p < n; ++p)
        {
          const double height = dot(normal, minus(points[p], points[i])) / length;
          outside = outside || height > 1e-6;
          if (std::abs(height) <= 1e-6)
          {
            on.push_back(p);
          }
        }
        if (outside || std::find(known.begin(), known.end(), on) != known.end())
        {
          continue;
        }
        known.push_back(on);
        Point center = { 0, 0, 0 };
        for (const vtkIdType p : on)
        {
          for (int x = 0; x < 3; ++x)
          {
            center[x] += points[p][x] / static_cast<double>(on.size());
          }
        }
        const Point v = cross(normal, u);
        const auto angle = [&](vtkIdType p)
        {
          const Point d = minus(points[p], center);
          return std::atan2(dot(d, v) / length, dot(d, u));
        };
        std::sort(on.begin(), on.end(),
          [&](vtkIdType a, vtkIdType b) { return angle(a) < angle(b); });
        faces.push_back(on);
      }
    }
  }
  return faces;
}

/// The table of polyhedra: columns of expected values in this order.
inline const std::vector<ReferenceShape>& GetReferenceShapes()
{
  static const std::vector<ReferenceShape> shapes = []
  {
    const char* columns[] = { "Volume", "SurfaceArea", "VertexCount", "EdgeCount", "FaceCount",
      "EdgeLengthRatio", "MinFaceAngle", "MaxFaceAngle", "MinDihedralAngle", "MaxDihedralAngle",
      "MinSolidAngle", "MaxSolidAngle", "IsoperimetricQuotient", "CellAspectRatio" };
    std::vector<ReferenceShape> result;
    const auto add = [&](const char* name, const Points& points, int type, const Faces& faces,
                       const std::vector<double>& values)
    {
      ReferenceShape shape = { name, nullptr, nullptr, {} };
      if (type)
      {
        std::vector<vtkIdType> ids(points.size());
        for (std::size_t i = 0; i < ids.size(); ++i)
        {
          ids[i] = static_cast<vtkIdType>(i);
        }
        shape.Standard = MakeGrid(points, { { type, ids } });
        shape.Polyhedron = ToPolyhedra(shape.Standard);
      }
      else
      {
        shape.Polyhedron = MakePolyhedron(points, faces);
      }
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        shape.Expected[columns[i]] = values[i];
      }
      result.push_back(shape);
    };
    const auto addHull = [&](const char* name, const Points& points, const std::vector<double>& values)
    { add(name, points, 0, MakeConvexFaces(points), values); };
    const auto box = [](double x, double y, double z) -> Points
    {
      return { { 0, 0, 0 }, { x, 0, 0 }, { x, y, 0 }, { 0, y, 0 }, { 0, 0, z }, { x, 0, z },
        { x, y, z }, { 0, y, z } };
    };
    const double h = std::sqrt(3.0) / 2;

    add("unit cube", box(1, 1, 1), VTK_HEXAHEDRON, {},
      { 1, 6, 8, 12, 6, 1, 90, 90, 90, 90, 1.570796327, 1.570796327, 0.5235987756, 1 });
    // Placed so that its axis is z, as CellAspectRatio depends on the axes.
    add("regular tetrahedron",
      { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, h, 0 }, { 0.5, h / 3, std::sqrt(2.0 / 3) } }, VTK_TETRA, {},
      { 0.1178511302, 1.732050808, 4, 6, 4, 1, 60, 60, 70.52877937, 70.52877937, 0.5512855984,
        0.5512855984, 0.302299894, 1.656876046348 });
    add("right-corner tetrahedron", { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, VTK_TETRA,
      {}, { 0.1666666667, 2.366025404, 4, 6, 4, 0.7071067812, 45, 90, 54.73561032, 90, 0.3398369095,
            1.570796327, 0.2371874264, 1.650963624 });
    add("square pyramid",
      { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { .5, .5, std::sqrt(0.5) } }, VTK_PYRAMID,
      {}, { 0.2357022604, 2.732050808, 5, 8, 5, 1, 60, 90, 54.73561032, 109.4712206, 0.6796738189,
            1.359347638, 0.3081155051, 2.828427124746 });
    add("right triangular prism",
      { { 0, 0, 0 }, { .5, h, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, { .5, h, 1 }, { 1, 0, 1 } }, VTK_WEDGE, {},
      { 0.4330127019, 3.866025404, 6, 9, 5, 1, 60, 90, 60, 90, 1.047197551, 1.047197551,
        0.3669944826, 2.309401076759 });
    const double r = std::sqrt(0.5);
    addHull("regular octahedron",
      { { r, 0, 0 }, { -r, 0, 0 }, { 0, r, 0 }, { 0, -r, 0 }, { 0, 0, r }, { 0, 0, -r } },
      { 0.4714045208, 3.464101615, 6, 12, 8, 1, 60, 60, 109.4712206, 109.4712206, 1.359347638,
        1.359347638, 0.6045997881, 1.650963624 });
    {
      const double phi = (1 + std::sqrt(5.0)) / 2, s = phi / 2; // edge 2 / phi, scaled to 1
      Points points;
      for (const double a : { -1.0, 1.0 })
      {
        for (const double b : { -1.0, 1.0 })
        {
          points.push_back({ 0, s * a / phi, s * b * phi });
          points.push_back({ s * a / phi, s * b * phi, 0 });
          points.push_back({ s * a * phi, 0, s * b / phi });
          for (const double c : { -1.0, 1.0 })
          {
            points.push_back({ s * a, s * b, s * c });
          }
        }
      }
      addHull("regular dodecahedron", points,
        { 7.663118961, 20.64572881, 20, 30, 12, 1, 108, 108, 116.5650512, 116.5650512, 2.961739154,
          2.961739154, 0.7546973993, 1.218468246 });
    }
    {
      Points points; // permutations of (0, 1, 2), edge sqrt(2), scaled to 1
      const double s = std::sqrt(0.5);
      for (const double a : { -1.0, 1.0 })
      {
        for (const double b : { -2.0, 2.0 })
        {
          for (int zero = 0; zero < 3; ++zero)
          {
            for (int swap = 0; swap < 2; ++swap)
            {
              Point point = { 0, 0, 0 };
              point[(zero + 1 + swap) % 3] = s * a;
              point[(zero + 2 - swap) % 3] = s * b;
              points.push_back(point);
            }
          }
        }
      }
      addHull("truncated octahedron", points,
        { 11.3137085, 26.78460969, 24, 36, 14, 1, 90, 120, 109.4712206, 125.2643897, 3.141592654,
          3.141592654, 0.7533666252, 1.38897592 });
    }
    Points sheared = box(1, 1, 1);
    for (Point& point : sheared)
    {
      point[0] += point[2];
    }
    add("sheared hex", sheared, VTK_HEXAHEDRON, {},
      { 1, 6.828427125, 8, 12, 6, 0.7071067812, 45, 135, 45, 135, 0.7853981634, 2.35619449,
        0.3552142149, 2 });
    add("box", box(4, 2, 1), VTK_HEXAHEDRON, {},
      { 8, 28, 8, 12, 6, 0.25, 90, 90, 90, 90, 1.570796327, 1.570796327, 0.3297298412, 4 });
    const double e = 0.01;
    add("flat sliver", { { 1, 0, e }, { -1, 0, e }, { 0, 1, -e }, { 0, -1, -e } }, VTK_TETRA, {},
      { 0.01333333333, 4.00079992, 4, 6, 4, 0.7071774883, 45.00572843, 89.98854314, 1.620299344,
        177.7084743, 0.01656444889, 0.01656444889, 0.000313970864, 100 });
    {
      Points points = MakeRegularPolygon(6, 0);
      const Points top = MakeRegularPolygon(6, 1);
      points.insert(points.end(), top.begin(), top.end());
      add("hexagonal prism", points, VTK_HEXAGONAL_PRISM, {},
        { 2.598076211, 11.19615242, 12, 18, 8, 1, 90, 120, 90, 120, 2.094395102, 2.094395102,
          0.5439384252, 1.5 });
    }
    add("L-prism",
      { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 }, { 0, 0, 1 },
        { 2, 0, 1 }, { 2, 1, 1 }, { 1, 1, 1 }, { 1, 2, 1 }, { 0, 2, 1 } },
      0,
      { { 5, 4, 3, 2, 1, 0 }, { 6, 7, 8, 9, 10, 11 }, { 0, 1, 7, 6 }, { 1, 2, 8, 7 }, { 2, 3, 9, 8 },
        { 3, 4, 10, 9 }, { 4, 5, 11, 10 }, { 5, 0, 6, 11 } },
      { 3, 14, 12, 18, 8, 0.5, 90, 270, 90, 270, 1.570796327, 4.71238898, 0.3709460713, 1.5 });
    Points warped = box(1, 1, 1);
    warped[6][2] = 1.5;
    add("warped hex", warped, VTK_HEXAHEDRON, {},
      { 1.125, 6.588222469, 8, 12, 6, 0.6666666667, 63.43494882, 116.5650512, 76.0472636, 104.0362435,
        0.7297276562, 2.034443936, 0.5005559761, 1.25 });

    // Smallest pyramid, smallest flatness, isotropy.
    const std::map<std::string, std::vector<double>> more = {
      { "unit cube", { 0.1666666667, 1, 1 } },
      { "regular tetrahedron", { 0.02946278255, 1, 1 } },
      { "right-corner tetrahedron", { 0.04166666667, 1, 0.5 } },
      { "square pyramid", { 0.04419417382, 1, 0.3935860058 } },
      { "right triangular prism", { 0.07216878365, 1, 0.5925925926 } },
      { "regular octahedron", { 0.0589255651, 1, 1 } },
      { "regular dodecahedron", { 0.6385932467, 1, 1 } },
      { "truncated octahedron", { 0.4714045208, 1, 1 } },
      { "sheared hex", { 0.1666666667, 1, 0.421875 } },
      { "box", { 1.333333333, 1, 0.1865889213 } },
      { "flat sliver", { 0.003333333333, 1, 1.078705036e-06 } },
      { "hexagonal prism", { 0.2886751346, 1, 0.4424214838 } },
      { "L-prism", { 0.05555555556, 1, 0.648 } },
      { "warped hex", { 0.1728109282, 0.9746721852, 0.953175612 } },
    };
    for (ReferenceShape& shape : result)
    {
      const std::vector<double>& values = more.at(shape.Name);
      shape.Expected["MinFacePyramidVolume"] = values[0];
      shape.Expected["MinFaceFlatness"] = values[1];
      shape.Expected["CellIsotropy"] = values[2];
      shape.Expected["Openness"] = 0;
    }
    return result;
  }();
  return shapes;
}

inline const ReferenceShape& FindReferenceShape(const std::string& name)
{
  for (const ReferenceShape& shape : GetReferenceShapes())
  {
    if (name == shape.Name)
    {
      return shape;
    }
  }
  throw std::invalid_argument("no shape " + name);
}
}
}

#endif
