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
        std::sort(
          on.begin(), on.end(), [&](vtkIdType a, vtkIdType b) { return angle(a) < angle(b); });
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
    const auto addHull =
      [&](const char* name, const Points& points, const std::vector<double>& values)
    { add(name, points, 0, MakeConvexFaces(points), values); };
    const auto box = [](double x, double y, double z) -> Points
    {
      return { { 0, 0, 0 }, { x, 0, 0 }, { x, y, 0 }, { 0, y, 0 }, { 0, 0, z }, { x, 0, z },
        { x, y, z }, { 0, y, z } };
    };
    const double h = std::sqrt(3.0) / 2;

    add("unit cube", box(1, 1, 1), VTK_HEXAHEDRON, {},
      { 1, 6, 8, 12, 6, 1, 90, 90, 90, 90, 1.570796326795, 1.570796326795, 0.5235987755983, 1 });
    // Placed so that its axis is z, as CellAspectRatio depends on the axes.
    add("regular tetrahedron",
      { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, h, 0 }, { 0.5, h / 3, std::sqrt(2.0 / 3) } }, VTK_TETRA,
      {},
      { 0.1178511301978, 1.732050807569, 4, 6, 4, 1, 60, 60, 70.52877936551, 70.52877936551,
        0.5512855984325, 0.5512855984325, 0.302299894039, 1.656876046348 });
    add("right-corner tetrahedron", { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
      VTK_TETRA, {},
      { 0.1666666666667, 2.366025403784, 4, 6, 4, 0.7071067811865, 45, 90, 54.73561031725, 90,
        0.3398369094541, 1.570796326795, 0.2371874263989, 1.650963624447 });
    add("square pyramid",
      { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { .5, .5, std::sqrt(0.5) } },
      VTK_PYRAMID, {},
      { 0.2357022603955, 2.732050807569, 5, 8, 5, 1, 60, 90, 54.73561031725, 109.4712206345,
        0.6796738189082, 1.359347637816, 0.3081155050795, 2.828427124746 });
    add("right triangular prism",
      { { 0, 0, 0 }, { .5, h, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, { .5, h, 1 }, { 1, 0, 1 } }, VTK_WEDGE,
      {},
      { 0.4330127018922, 3.866025403784, 6, 9, 5, 1, 60, 90, 60, 90, 1.047197551197, 1.047197551197,
        0.3669944826134, 2.309401076759 });
    const double r = std::sqrt(0.5);
    addHull("regular octahedron",
      { { r, 0, 0 }, { -r, 0, 0 }, { 0, r, 0 }, { 0, -r, 0 }, { 0, 0, r }, { 0, 0, -r } },
      { 0.471404520791, 3.464101615138, 6, 12, 8, 1, 60, 60, 109.4712206345, 109.4712206345,
        1.359347637816, 1.359347637816, 0.6045997880781, 1.650963624447 });
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
        { 7.663118960625, 20.64572880707, 20, 30, 12, 1, 108, 108, 116.5650511771, 116.5650511771,
          2.961739153797, 2.961739153797, 0.7546973993374, 1.218468245681 });
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
        { 11.31370849898, 26.78460969083, 24, 36, 14, 1, 90, 120, 109.4712206345, 125.2643896828,
          3.14159265359, 3.14159265359, 0.7533666251662, 1.388975920472 });
    }
    Points sheared = box(1, 1, 1);
    for (Point& point : sheared)
    {
      point[0] += point[2];
    }
    add("sheared hex", sheared, VTK_HEXAHEDRON, {},
      { 1, 6.828427124746, 8, 12, 6, 0.7071067811865, 45, 135, 45, 135, 0.7853981633974,
        2.356194490192, 0.355214214888, 2 });
    add("box", box(4, 2, 1), VTK_HEXAHEDRON, {},
      { 8, 28, 8, 12, 6, 0.25, 90, 90, 90, 90, 1.570796326795, 1.570796326795, 0.3297298411931,
        4 });
    const double e = 0.01;
    add("flat sliver", { { 1, 0, e }, { -1, 0, e }, { 0, 1, -e }, { 0, -1, -e } }, VTK_TETRA, {},
      { 0.01333333333333, 4.000799920016, 4, 6, 4, 0.7071774883295, 45.0057284323, 89.98854313539,
        1.620299343852, 177.7084743236, 0.01656444888994, 0.01656444888994, 0.0003139708640036,
        100 });
    {
      Points points = MakeRegularPolygon(6, 0);
      const Points top = MakeRegularPolygon(6, 1);
      points.insert(points.end(), top.begin(), top.end());
      add("hexagonal prism", points, VTK_HEXAGONAL_PRISM, {},
        { 2.598076211353, 11.19615242271, 12, 18, 8, 1, 90, 120, 90, 120, 2.094395102393,
          2.094395102393, 0.5439384251534, 1.5 });
    }
    add("L-prism",
      { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 }, { 0, 0, 1 },
        { 2, 0, 1 }, { 2, 1, 1 }, { 1, 1, 1 }, { 1, 2, 1 }, { 0, 2, 1 } },
      0,
      { { 5, 4, 3, 2, 1, 0 }, { 6, 7, 8, 9, 10, 11 }, { 0, 1, 7, 6 }, { 1, 2, 8, 7 },
        { 2, 3, 9, 8 }, { 3, 4, 10, 9 }, { 4, 5, 11, 10 }, { 5, 0, 6, 11 } },
      { 3, 14, 12, 18, 8, 0.5, 90, 270, 90, 270, 1.570796326795, 4.712388980385, 0.3709460713422,
        1.5 });
    Points warped = box(1, 1, 1);
    warped[6][2] = 1.5;
    add("warped hex", warped, VTK_HEXAHEDRON, {},
      { 1.125, 6.588222468893, 8, 12, 6, 0.6666666666667, 63.43494882292, 116.5650511771,
        76.04726360446, 104.0362434679, 0.729727656227, 2.034443935796, 0.5005559761431, 1.25 });

    // Smallest pyramid, smallest flatness, isotropy.
    const std::map<std::string, std::vector<double>> more = {
      { "unit cube", { 0.1666666666667, 1, 1 } },
      { "regular tetrahedron", { 0.02946278254944, 1, 1 } },
      { "right-corner tetrahedron", { 0.04166666666667, 1, 0.5 } },
      { "square pyramid", { 0.04419417382416, 1, 0.3935860058309 } },
      { "right triangular prism", { 0.0721687836487, 1, 0.5925925925926 } },
      { "regular octahedron", { 0.05892556509888, 1, 1 } },
      { "regular dodecahedron", { 0.6385932467187, 1, 1 } },
      { "truncated octahedron", { 0.471404520791, 1, 1 } },
      { "sheared hex", { 0.1666666666667, 1, 0.421875 } },
      { "box", { 1.333333333333, 1, 0.1865889212828 } },
      { "flat sliver", { 0.003333333333333, 1, 1.078705036109e-06 } },
      { "hexagonal prism", { 0.2886751345948, 1, 0.4424214838416 } },
      { "L-prism", { 0.05555555555556, 1, 0.648 } },
      { "warped hex", { 0.1728109282122, 0.9746721852373, 0.9531756119562 } },
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
