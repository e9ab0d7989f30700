// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CurvedMesh
 * @brief A mesh with new points on its curved faces, as it is drawn.
 *
 * Made after the mesh has been delivered to where it is drawn, because only cells with their nodes
 * travel.
 */
#ifndef camaron_CurvedMesh_h
#define camaron_CurvedMesh_h

#include "Drawing/SubdividedFacets.h"

#include "vtkSmartPointer.h" // for the grids
#include "vtkType.h"         // for the time
#include "vtkUnstructuredGrid.h"

#include <functional> // for new points
#include <memory>     // for the facets
#include <string>     // for the warning

namespace camaron
{
/// A grid with the same cells, and with @a added new points, which have interpolated values, or of
/// integers those of the nearest node.
vtkSmartPointer<vtkUnstructuredGrid> AddPoints(vtkUnstructuredGrid* grid, vtkIdType added,
  const std::function<SubdividedFacets::Stencil(vtkIdType)>& getStencil);

class CurvedMesh
{
public:
  /// The grid to draw: the given one, or one with new points. The same until the grid or the level
  /// changes, or more is drawn than before.
  vtkUnstructuredGrid* Update(vtkUnstructuredGrid* grid, int level, SubdividedFacets::Extent drawn);
  /// Of the last update; may be null.
  const std::shared_ptr<const SubdividedFacets>& GetFacets() const { return this->Facets; }
  /// That a lower level is drawn than asked for, if not said before; else empty.
  std::string GetNewWarning();

private:
  vtkSmartPointer<vtkUnstructuredGrid> Given, Drawn;
  vtkMTimeType Time = 0;
  int Level = -1, WarnedOfLevel = -1;
  SubdividedFacets::Extent Extent = SubdividedFacets::Extent::Boundary;
  std::shared_ptr<const SubdividedFacets> Facets;
};
}

#endif
