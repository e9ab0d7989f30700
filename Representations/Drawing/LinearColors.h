// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::LinearColors
 * @brief A color map that is linear in RGB between its points, such as those of criteria.
 *
 * Gives the colors of VTK's GetColor in a tenth of the time.
 */
#ifndef camaron_LinearColors_h
#define camaron_LinearColors_h

#include "InspectionStyle.h"

#include <array>  // for colors
#include <vector> // for the points

class vtkColorTransferFunction;

namespace camaron
{
/// The values that a color map of vtkQualityColors shows as acceptable; unlimited if it shows none
/// as bad, as other color maps.
Range FindAcceptableRange(vtkColorTransferFunction* map);

class LinearColors
{
public:
  /// Whether a map is of this type.
  static bool IsLinear(vtkColorTransferFunction* map);

  explicit LinearColors(vtkColorTransferFunction* map);

  /// Writes the color of a value: red, green, blue, and an alpha of 255.
  void Map(double value, unsigned char rgba[4]) const;

private:
  using Color = std::array<double, 3>;
  std::vector<double> Values; ///< of the points, ascending
  std::vector<Color> Colors;
  Color Undefined, Below;
};
}

#endif
