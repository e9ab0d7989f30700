// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ProcessorSurface
 * @brief What a Mesh Inspection shows as an ordinary surface, made by VTK's filters.
 *
 * For where the shaders cannot draw: tables that are too small, ray tracing. The same cells and
 * faces are seen, but a moving cut costs a new surface each time.
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
class ProcessorSurface
{
public:
  /**
   * Brings the surface up to date: made anew when the mesh or what of the style it depends on
   * changed. Its cells and points have the arrays of ids (InspectionArrays.h). Empty for figures
   * that only shaders draw.
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
