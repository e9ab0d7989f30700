// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::LinesAndVertices
 * @brief The cells of a mesh that have no faces, for an ordinary mapper.
 *
 * Their points are all points of the mesh, so that arrays of points go along without a copy. A cut,
 * which for an exact one is by centroid, and the choice of cells leave out the same cells as
 * elsewhere. Curves go straight from point to point.
 */
#ifndef camaron_LinesAndVertices_h
#define camaron_LinesAndVertices_h

#include "InspectionStyle.h"

#include "vtkNew.h"          // for the cells
#include "vtkSmartPointer.h" // for the grid
#include "vtkType.h"         // for times and ids

#include <vector> // for ids

class vtkPolyData;
class vtkUnstructuredGrid;

namespace camaron
{
class LinesAndVertices
{
public:
  LinesAndVertices();
  ~LinesAndVertices();

  /// Those of the mesh (or null) that are drawn in this style, made again when anything has
  /// changed.
  vtkPolyData* Update(vtkUnstructuredGrid* grid, const InspectionStyle& style);

private:
  void Find(const InspectionStyle& style);
  bool IsDrawn(vtkIdType cell, const InspectionStyle& style) const;

  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  vtkMTimeType Time = 0;
  vtkMTimeType TimeOfFields = 0;
  InspectionStyle Style; ///< of the last update
  std::vector<vtkIdType> Vertices;
  std::vector<vtkIdType> Lines;
  vtkNew<vtkPolyData> Cells;
};
}

#endif
