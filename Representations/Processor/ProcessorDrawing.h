// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ProcessorDrawing
 * @brief Draws a Mesh Inspection as an ordinary surface, with VTK's own filters and mapper.
 *
 * Used where the shaders cannot draw: if tables do not fit on the graphics card, and for ray
 * tracing. The same cells and faces are visible, but each change of a cut needs a new surface.
 */
#ifndef camaron_ProcessorDrawing_h
#define camaron_ProcessorDrawing_h

#include "InspectionStyle.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkSmartPointer.h"

class vtkPolyData;
class vtkUnstructuredGrid;

namespace camaron
{
class MeshView;

/// Whether a cell is inside a shape by its vertices, or else (also for exact cuts) by its centroid.
bool IsCellInShape(const MeshView& mesh, vtkIdType cell, CutBy how, const ConvexShape& shape);

class ProcessorDrawing
{
public:
  /**
   * The visible faces, created again if the mesh or a relevant part of the style has changed. Cells
   * and points have the arrays of ids (InspectionArrays.h). Empty for figures that only shaders
   * draw.
   */
  vtkPolyData* GetSurface(vtkUnstructuredGrid* grid, const InspectionStyle& style);
  /// The mapper, for selections and for releasing graphics memory.
  vtkOpenGLPolyDataMapper* GetMapper() { return this->Mapper; }

  /**
   * @param actor provides position, transform and properties of the surface
   * @param coloring provides the colors
   */
  void Draw(vtkRenderer* renderer, vtkActor* actor, vtkMapper* coloring, vtkUnstructuredGrid* grid,
    const InspectionStyle& style);

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
  vtkNew<vtkOpenGLPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor; ///< with edges according to the style
  vtkMTimeType PropertyTime = 0;
  bool AreEdges = false; ///< that are drawn without faces
};
}

#endif
