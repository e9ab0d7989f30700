// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::InspectionTables
 * @brief Members of vtkMeshInspectionMapper: the tables that it draws from, and which of them a
 * frame needs.
 *
 * Tables of the mesh are shared by the mappers of a representation. All methods that are not const
 * require that the context of the window is current.
 */
#ifndef camaron_InspectionTables_h
#define camaron_InspectionTables_h

#include "BrushedCells.h"
#include "CutTetrahedra.h"
#include "InspectionColors.h"
#include "InspectionMesh.h"
#include "InspectionStyle.h"
#include "InspectionValues.h"
#include "Isosurfaces.h"
#include "JudgedValues.h"
#include "PointNormals.h"
#include "ProcessorDrawing.h"
#include "RenderModes.h"
#include "TextureBuffer.h"
#include "VisibleTriangles.h"

#include "vtkNew.h"               // for the placeholder
#include "vtkPolyData.h"          // for the placeholder
#include "vtkSmartPointer.h"      // for the grid
#include "vtkUnsignedCharArray.h" // for colors
#include "vtkUnstructuredGrid.h"  // for its bounds

#include <array>   // for bounds
#include <map>     // for keys of shaders
#include <memory>  // for the shared mesh
#include <string>  // for keys of shaders
#include <utility> // for std::move
#include <vector>  // for texture units

class vtkFloatArray;
class vtkMapper;
class vtkOpenGLHelper;
class vtkOpenGLState;
class vtkProperty;
class vtkShaderProgram;
class vtkTextureUnitManager;

namespace camaron
{
class InspectionTables
{
public:
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  InspectionStyle Style;
  std::shared_ptr<InspectionMesh> Mesh = std::make_shared<InspectionMesh>();
  bool OwnsMesh = true;
  VisibleTriangles Visible;
  Isosurfaces Isosurface;
  CutTetrahedra Cut;
  bool IsListed = false; ///< draw the triangles listed in the table of Visible
  std::size_t NumberOfTriangles = 0;

  InspectionColors Colors;
  PointNormals Normals;
  InspectionValues Values;    ///< of the array that is mapped to colors
  JudgedValues Judged;        ///< the same for Emphasis
  JudgedValues ColoredValues; ///< the same for the color map
  BrushedCells Brushed;
  bool HasCellValues = false;
  Range ColorLimits = Unlimited;                     ///< see InspectionStyle
  InspectionValues Levels;                           ///< values for isolines
  TextureBuffer Looks{ TextureBuffer::Row::Float4 }; ///< colors and opacities of blocks
  vtkSmartPointer<vtkFloatArray> UploadedLooks;

  unsigned int VertexArray = 0;
  vtkTextureUnitManager* Units = nullptr;

  vtkNew<vtkPolyData> Placeholder;
  RenderModeCode Code;
  std::map<vtkOpenGLHelper*, std::string> ShaderKeys;

  vtkSmartPointer<vtkUnsignedCharArray> CellColors;
  std::array<vtkMTimeType, 2> TimesOfCellColors = { { 0, 0 } }; ///< of values and color map

  ProcessorDrawing Processor;
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
    DataVersion version;
    if (this->Grid && this->Grid->GetNumberOfCells() > 0)
    {
      version = GetCellBoundsVersion(this->Grid);
    }
    if (this->BoundsVersion != version)
    {
      this->Bounds = GetCellBounds(this->Grid);
      this->BoundsVersion = std::move(version);
    }
    return this->Bounds;
  }

  /// @throw std::exception if the graphics card cannot create or store a table
  void UpdateTables(bool isPicking);
  /// Creates the normals of points if the style or the lighting needs them.
  void UpdateNormals(vtkProperty* property);
  vtkFloatArray* GetLooks() const;
  /// Uploads the colors and opacities of blocks if they have changed.
  void UpdateLooks();
  /// The style without modes whose arrays are missing. @a ofPoints: for points, which have no
  /// edges.
  InspectionStyle GetStyleOfPicture(vtkMapper* mapper, bool ofPoints) const;
  /// Binds a table to a free texture unit if the program uses the sampler @a name.
  void Attach(vtkShaderProgram* program, const char* name, const TextureBuffer& table);
  /// Frees the texture units.
  void Detach(vtkOpenGLState* state);
  void Release();

private:
  std::vector<int> UsedUnits;
  std::array<double, 6> Bounds = { { 1, -1, 1, -1, 1, -1 } };
  DataVersion BoundsVersion;
};
}

#endif
