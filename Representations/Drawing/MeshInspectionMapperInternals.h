// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshInspectionMapperInternals.h
 * @brief Members of vtkMeshInspectionMapper in addition to its tables.
 */
#ifndef camaron_MeshInspectionMapperInternals_h
#define camaron_MeshInspectionMapperInternals_h

#include "InspectionTables.h"
#include "ProcessorDrawing.h"
#include "RenderModes.h"
#include "vtkMeshInspectionMapper.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <map>
#include <string>

class vtkMeshInspectionMapper::Internals : public camaron::InspectionTables
{
public:
  vtkNew<vtkPolyData> Placeholder;
  camaron::RenderModeCode Code;
  std::map<vtkOpenGLHelper*, std::string> ShaderKeys;

  camaron::ProcessorDrawing Processor;
  vtkSmartPointer<vtkUnstructuredGrid>
    RefusedGrid; ///< a mesh that the graphics card could not draw
  vtkMTimeType RefusedTime = 0;
  bool IsOnProcessor() const
  {
    return this->Style.OnProcessor ||
      (this->Grid && this->Grid == this->RefusedGrid &&
        this->Grid->GetMTime() == this->RefusedTime);
  }
};

#endif
