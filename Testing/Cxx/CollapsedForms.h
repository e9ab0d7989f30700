// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CollapsedForms.h
 * @brief Cells of higher order written with coincident corners, and what remains of them.
 */
#ifndef camaron_CollapsedForms_h
#define camaron_CollapsedForms_h

#include "TestMeshes.h"

#include "vtkCell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace camaron
{
namespace testing
{
/// A cell and what remains of it where corners coincide.
struct Collapse
{
  int Type, Size;
  std::vector<int> Corners; // of what remains, for each corner of the cell
  int Remaining, RemainingSize;
};

/// The weights of the corners of a linear cell.
inline std::vector<double> MixCorners(std::size_t corners, const double* at)
{
  const double r = at[0], s = at[1], t = at[2];
  const std::array<double, 4> quad = { (1 - r) * (1 - s), r * (1 - s), r * s, (1 - r) * s };
  const std::array<double, 3> triangle = { 1 - r - s, r, s };
  std::vector<double> weights;
  const auto add = [&](const auto& some, double factor)
  {
    for (const double weight : some)
    {
      weights.push_back(factor * weight);
    }
  };
  switch (corners)
  {
    case 4:
      add(quad, 1);
      break;
    case 5:
      add(quad, 1 - t);
      weights.push_back(t);
      break;
    case 6:
      add(triangle, 1 - t);
      add(triangle, t);
      break;
    default:
      add(quad, 1 - t);
      add(quad, t);
  }
  return weights;
}

/// A random cell, and the same one with coincident corners, whose nodes are where VTK's
/// interpolation of the former puts them; nodes at the same place are one point.
inline std::array<Grid, 2> MakeCollapsed(const Collapse& how, double noise, std::mt19937& random)
{
  std::uniform_real_distribution<double> offset(-noise, noise);
  const bool isSurface = how.Corners.size() == 4;
  Points nodes(how.RemainingSize);
  std::vector<double> parametric;
  {
    const Grid any = MakeCell(how.Remaining, nodes);
    const double* const places = any->GetCell(0)->GetParametricCoords();
    parametric.assign(places, places + 3 * nodes.size());
  }
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    for (int k = 0; k < (isSurface ? 2 : 3); ++k)
    {
      nodes[i][k] = parametric[3 * i + k] + offset(random);
    }
  }
  const Grid remaining = MakeCell(how.Remaining, nodes);
  const Grid any = MakeCell(how.Type, Points(how.Size));
  const double* const places = any->GetCell(0)->GetParametricCoords();
  std::vector<vtkIdType> ids;
  std::vector<double> weights(nodes.size());
  Points points;
  for (int node = 0; node < how.Size; ++node)
  {
    const std::vector<double> mixed = MixCorners(how.Corners.size(), places + 3 * node);
    std::array<double, 3> at = {};
    double atApex = 0;
    for (std::size_t i = 0; i < mixed.size(); ++i)
    {
      const bool isApex = how.Remaining == VTK_QUADRATIC_PYRAMID && how.Corners[i] == 4;
      atApex += isApex ? mixed[i] : 0;
      for (int k = 0; k < 3; ++k)
      {
        at[k] += mixed[i] * (isApex && k < 2 ? 0 : parametric[3 * how.Corners[i] + k]);
      }
    }
    for (int k = 0; k < 2; ++k)
    {
      at[k] = atApex < 1 ? at[k] / (1 - atApex) : 0.5;
    }
    remaining->GetCell(0)->InterpolateFunctions(at.data(), weights.data());
    Point place = {};
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        place[k] += weights[i] * nodes[i][k];
      }
    }
    const auto known = std::find_if(points.begin(), points.end(),
      [&](const Point& point)
      {
        return std::abs(point[0] - place[0]) + std::abs(point[1] - place[1]) +
          std::abs(point[2] - place[2]) <
          1e-9;
      });
    ids.push_back(known - points.begin());
    if (known == points.end())
    {
      points.push_back(place);
    }
  }
  return { remaining, MakeGrid(points, { { how.Type, ids } }) };
}
}
}

#endif
