// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ProcessorSurface
 * @brief The visible faces of a Mesh Inspection as an ordinary surface, created by VTK's filters.
 *
 * Used where the shaders cannot draw: if tables do not fit on the graphics card, and for ray
 * tracing. The same cells and faces are visible, but each change of a cut needs a new surface.
 */
#ifndef camaron_ProcessorSurface_h
#define camaron_ProcessorSurface_h

#include "InspectionStyle.h"

#include "vtkSmartPointer.h" // for data
#include "vtkType.h"         // for vtkMTimeType

#include <string> // for the array
#include <vector> // for values

class vtkPolyData;
class vtkUnstructuredGrid;

namespace camaron
{
class MeshView;

/// Whether a cell is inside a shape by its vertices, or else (also for exact cuts) by its centroid.
bool IsCellInShape(const MeshView& mesh, vtkIdType cell, CutBy how, const ConvexShape& shape);

class ProcessorSurface
{
public:
  /**
   * The surface, created again if the mesh or a relevant part of the style has changed. Its cells
   * and points have the arrays of ids (InspectionArrays.h). Empty for figures that only shaders
   * draw.
   */
  vtkPolyData* Update(vtkUnstructuredGrid* grid, const InspectionStyle& style);

private:
  struct Request
  {
    vtkSmartPointer<vtkUnstructuredGrid> Grid;
    vtkMTimeType Time = 0;
    InspectionStyle Style;
    bool operator==(const Request& other) const;
  };

  Request Last;
  vtkSmartPointer<vtkPolyData> Surface;
};
}

#endif
