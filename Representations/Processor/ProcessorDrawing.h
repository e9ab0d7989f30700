// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ProcessorDrawing
 * @brief Draws a Mesh Inspection as an ordinary surface, with VTK's own mapper.
 */
#ifndef camaron_ProcessorDrawing_h
#define camaron_ProcessorDrawing_h

#include "ProcessorSurface.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkOpenGLPolyDataMapper.h"

namespace camaron
{
class ProcessorDrawing
{
public:
  vtkPolyData* GetSurface(vtkUnstructuredGrid* grid, const InspectionStyle& style)
  {
    return this->Surface.Update(grid, style);
  }
  /// The mapper, for selections and for releasing graphics memory.
  vtkOpenGLPolyDataMapper* GetMapper() { return this->Mapper; }

  /**
   * @param actor provides position, transform and properties of the surface
   * @param coloring provides the colors
   */
  void Draw(vtkRenderer* renderer, vtkActor* actor, vtkMapper* coloring, vtkUnstructuredGrid* grid,
    const InspectionStyle& style);

private:
  ProcessorSurface Surface;
  vtkNew<vtkOpenGLPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor; ///< with edges according to the style
  vtkMTimeType PropertyTime = 0;
};
}

#endif
