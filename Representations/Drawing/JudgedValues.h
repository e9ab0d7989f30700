// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::JudgedValues
 * @brief Values of a criterion, with others for cells to which its acceptable range does not apply,
 * so that these cells are never emphasized, or have a color of their own.
 */
#ifndef camaron_JudgedValues_h
#define camaron_JudgedValues_h

#include "InspectionMesh.h" // for versions of arrays

#include "vtkDataArray.h"    // for the values
#include "vtkSmartPointer.h" // for the values
#include "vtkType.h"         // for vtkMTimeType

#include <cmath>    // for NaN
#include <cstdint>  // for shapes
#include <optional> // for marks
#include <vector>   // for shapes

class vtkUnstructuredGrid;

namespace camaron
{
class JudgedValues
{
public:
  /// What values become so that a color map tells the cells apart.
  struct Marks
  {
    double Others; ///< of cells to which the range does not apply
    double Least;  ///< the lowest value of the others, so that none has the color of Others

    bool operator==(const Marks& marks) const
    {
      const bool areNaN = std::isnan(this->Others) && std::isnan(marks.Others);
      return (areNaN || this->Others == marks.Others) && this->Least == marks.Least;
    }
  };

  /**
   * Returns @a values of the cells of @a grid with marks, or, without these, with a value inside of
   * the acceptable range for cells to which it does not apply. Undefined values remain. Returns @a
   * values itself if the range applies to all cells or does not exist.
   */
  vtkDataArray* Update(
    vtkDataArray* values, vtkUnstructuredGrid* grid, const std::optional<Marks>& marks = {});

private:
  void UpdateShapes(vtkUnstructuredGrid* grid);

  vtkSmartPointer<vtkDataArray> Values, Judged;
  vtkMTimeType Time = 0;
  std::optional<Marks> Marked;
  DataVersion Cells; // whose shapes are known
  std::vector<std::uint16_t> Shapes;
};
}

#endif
