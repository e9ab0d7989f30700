// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curved/LinearEquations.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace camaron
{
//------------------------------------------------------------------------------
DenseMatrix SolveEquations(DenseMatrix a, DenseMatrix b)
{
  constexpr double Smallest = 1e-9; // pivot
  const std::size_t size = a.size();
  for (std::size_t i = 0; i < size; ++i)
  {
    std::size_t pivot = i;
    for (std::size_t row = i + 1; row < size; ++row)
    {
      pivot = std::abs(a[row][i]) > std::abs(a[pivot][i]) ? row : pivot;
    }
    if (std::abs(a[pivot][i]) < Smallest)
    {
      return {};
    }
    std::swap(a[i], a[pivot]);
    std::swap(b[i], b[pivot]);
    for (std::size_t row = 0; row < size; ++row)
    {
      const double factor = row == i ? 0 : a[row][i] / a[i][i];
      for (std::size_t column = i; factor != 0 && column < size; ++column)
      {
        a[row][column] -= factor * a[i][column];
      }
      for (std::size_t column = 0; factor != 0 && column < b[i].size(); ++column)
      {
        b[row][column] -= factor * b[i][column];
      }
    }
  }
  for (std::size_t i = 0; i < size; ++i)
  {
    for (double& value : b[i])
    {
      value /= a[i][i];
    }
  }
  return b;
}
}
