// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellSizes
 * @brief How many points the cells of a mesh can have, by their types.
 *
 * Most types have a fixed number. Polygons, polyhedra and the like can have any; those with too few
 * to enclose something are defects that criteria report. The number of points of a Lagrange or
 * Bezier cell follows from its order; VTK reads orders that differ by direction from the cell array
 * of the attribute HigherOrderDegrees, otherwise the order is the same in all directions.
 */
#ifndef camaron_CellSizes_h
#define camaron_CellSizes_h

#include "vtkSmartPointer.h" // for the member
#include "vtkType.h"         // for vtkIdType

#include <array>  // for all types
#include <string> // for messages

class vtkDataArray;
class vtkDataSet;

namespace camaron
{
class CellSizes
{
public:
  explicit CellSizes(vtkDataSet* mesh);

  /// The number of points of every cell of a type, or one of these.
  static constexpr int AnySize = 0, ///< as in a polygon, or a type without known vertices
    SomeSizes = -1;                 ///< CanBe knows them
  int Get(unsigned char type) const { return this->Sizes[type]; }

  /// Whether a cell of this type can have so many points. Thread-safe.
  bool CanBe(vtkIdType cell, unsigned char type, vtkIdType size) const;

  /// The numbers that a cell can have, such as "8", "4, 10, 15, 20, 35, ..." or "12 for its degrees
  /// 1, 2 and 1".
  std::string Describe(vtkIdType cell, unsigned char type) const;

  /// Whether cells of a type have degrees of their own.
  bool DependOnCell(unsigned char type) const;

private:
  bool GetDegrees(vtkIdType cell, unsigned char type, std::array<vtkIdType, 3>& degrees) const;

  std::array<int, 256> Sizes;
  vtkSmartPointer<vtkDataArray> Degrees;
};
}

#endif
