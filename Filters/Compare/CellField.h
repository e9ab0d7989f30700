// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellField.h
 * @brief A field of a simulation as one value per cell.
 *
 * Fields with several components contribute their magnitude. The value of a point field in a cell
 * is the mean of the values at the points of the cell. It depends neither on the partition of the
 * mesh nor on the order of the points.
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
  /// Collective. Throws std::invalid_argument on all processes if no process has the array.
  CellField(
    const ElementBlocks& blocks, const std::string& name, bool isOfPoints, Reducer& reducer);

  /// For every block one value per cell; empty for blocks without the array.
  const std::vector<std::vector<double>>& Get() const { return this->Values; }

  /// Whether some values on this process are integers that double cannot represent.
  bool HasRests() const { return this->Rests; }

private:
  bool Rests = false;
  std::vector<std::vector<double>> Values;
};
}

#endif
