// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::LinesAndVertices
 * @brief The lines and vertices of a mesh, which have no faces, for VTK's own mapper.
 *
 * They use all points of the mesh, so point arrays are shared. A cut (an exact cut by centroid) and
 * the choice of cells hide the same cells as elsewhere. Curves are divided as edges of faces are;
 * new points have the id of the nearest node.
 */
#ifndef camaron_LinesAndVertices_h
#define camaron_LinesAndVertices_h

#include "InspectionStyle.h"

#include "vtkNew.h"          // for the cells
#include "vtkPolyData.h"     // for the cells
#include "vtkSmartPointer.h" // for the grid
#include "vtkType.h"         // for times and ids

#include <vector> // for ids

class vtkUnstructuredGrid;

namespace camaron
{
class MeshView;

class LinesAndVertices
{
public:
  /// The cells of the mesh (or null) that this style draws; updated if anything has changed.
  vtkPolyData* Update(vtkUnstructuredGrid* grid, const InspectionStyle& style);

private:
  void Find(const InspectionStyle& style);
  bool IsDrawn(const MeshView& mesh, vtkIdType cell, const InspectionStyle& style) const;

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
