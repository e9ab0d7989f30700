// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellField.h
 * @brief A field of a simulation as one value per cell.
 *
 * Of several components it is the magnitude that counts. A field of points has in a cell the mean
 * of the values at its points, or the length of its gradient there: that of the linear function
 * with the least squares of differences at the points. Both depend on the cell alone, so not on how
 * the mesh is split, nor on the order of its points. Planar cells have the gradient along them;
 * where the points of a cell do not span a line the gradient is NaN.
 */
#ifndef camaron_CellField_h
#define camaron_CellField_h

#include "ElementBlocks.h"

#include <string> // for the name
#include <vector> // for values

namespace camaron
{
class CellField
{
public:
  /**
   * Collective. @a takesGradient: only of fields of points. Throws std::invalid_argument, on all
   * processes alike, where no process has the array.
   */
  CellField(const ElementBlocks& blocks, const std::string& name, bool isOfPoints,
    bool takesGradient, Reducer& reducer);

  /// Of every block; empty where it has no such array.
  const std::vector<std::vector<double>>& Get() const { return this->Values; }

  /// Whether it has integers that no double is, on this process.
  bool HasRests() const { return this->Rests; }

private:
  bool Rests = false;
  std::vector<std::vector<double>> Values;
};
}

#endif
