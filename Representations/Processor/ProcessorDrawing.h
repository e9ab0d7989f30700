// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ProcessorDrawing
 * @brief Draws a Mesh Inspection as an ordinary surface, with VTK's own mapper.
 */
#ifndef camaron_ProcessorDrawing_h
#define camaron_ProcessorDrawing_h

#include "ProcessorSurface.h"

#include "vtkNew.h"

class vtkActor;
class vtkMapper;
class vtkOpenGLPolyDataMapper;
class vtkRenderer;

namespace camaron
{
class ProcessorDrawing
{
public:
  ProcessorDrawing();
  ~ProcessorDrawing();

  vtkPolyData* GetSurface(vtkUnstructuredGrid* grid, const InspectionStyle& style)
  {
    return this->Surface.Update(grid, style);
  }
  /// What draws it, for selections and for giving back what it has on the graphics card.
  vtkOpenGLPolyDataMapper* GetMapper() { return this->Mapper; }

  /// @param actor whose place and looks the surface has
  /// @param coloring whose colors it has
  void Draw(vtkRenderer* renderer, vtkActor* actor, vtkMapper* coloring, vtkUnstructuredGrid* grid,
    const InspectionStyle& style);

private:
  ProcessorSurface Surface;
  vtkNew<vtkOpenGLPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor; ///< with edges as the style has them
  vtkMTimeType PropertyTime = 0;
};
}

#endif
