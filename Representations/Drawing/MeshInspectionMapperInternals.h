// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshInspectionMapperInternals.h
 * @brief Members of vtkMeshInspectionMapper in addition to its tables.
 */
#ifndef camaron_MeshInspectionMapperInternals_h
#define camaron_MeshInspectionMapperInternals_h

#include "InspectionMesh.h"
#include "InspectionTables.h"
#include "ProcessorDrawing.h"
#include "RenderModes.h"
#include "vtkMeshInspectionMapper.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <map>
#include <string>
#include <utility>

class vtkMeshInspectionMapper::Internals : public camaron::InspectionTables
{
public:
  vtkNew<vtkPolyData> Placeholder;
  camaron::RenderModeCode Code;
  std::map<vtkOpenGLHelper*, std::string> ShaderKeys;

  vtkSmartPointer<vtkUnsignedCharArray> CellColors;
  std::array<vtkMTimeType, 2> TimesOfCellColors = { { 0, 0 } }; ///< of values and color map

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

  /// Of the cells; computed when they have changed, as each frame asks several times.
  const std::array<double, 6>& GetBounds()
  {
    camaron::DataVersion version;
    if (this->Grid && this->Grid->GetNumberOfCells() > 0)
    {
      version = camaron::GetCellBoundsVersion(this->Grid);
    }
    if (this->BoundsVersion != version)
    {
      this->Bounds = camaron::GetCellBounds(this->Grid);
      this->BoundsVersion = std::move(version);
    }
    return this->Bounds;
  }

private:
  std::array<double, 6> Bounds = { { 1, -1, 1, -1, 1, -1 } };
  camaron::DataVersion BoundsVersion;
};

#endif
