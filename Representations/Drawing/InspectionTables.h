// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::InspectionTables
 * @brief The tables that a vtkMeshInspectionMapper draws from, and which of them a picture needs.
 *
 * Those of the mesh are shared with the mappers of the same representation. All methods but the
 * constant ones want the context of the window current.
 */
#ifndef camaron_InspectionTables_h
#define camaron_InspectionTables_h

#include "CutTetrahedra.h"
#include "InspectionColors.h"
#include "InspectionMesh.h"
#include "InspectionStyle.h"
#include "InspectionValues.h"
#include "Isosurfaces.h"
#include "JudgedValues.h"
#include "PointNormals.h"
#include "TextureBuffer.h"
#include "VisibleTriangles.h"

#include "vtkSmartPointer.h" // for the grid

#include <memory> // for the shared mesh
#include <vector> // for texture units

class vtkFloatArray;
class vtkMapper;
class vtkOpenGLState;
class vtkProperty;
class vtkShaderProgram;
class vtkTextureUnitManager;
class vtkUnstructuredGrid;

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
  bool IsListed = false; ///< the triangles to draw are those in the table of Visible
  std::size_t NumberOfTriangles = 0;

  InspectionColors Colors;
  PointNormals Normals;
  InspectionValues Values; ///< of the array that colors
  JudgedValues Judged;
  bool HasCellValues = false;
  InspectionValues Levels;                           ///< of isolines
  TextureBuffer Looks{ TextureBuffer::Row::Float4 }; ///< of blocks
  vtkSmartPointer<vtkFloatArray> UploadedLooks;

  unsigned int VertexArray = 0;
  vtkTextureUnitManager* Units = nullptr;

  /// @throw std::exception when the graphics card cannot hold or make a table
  void UpdateTables(bool isPicking);
  void UpdateNormals(vtkProperty* property);
  vtkFloatArray* GetLooks() const;
  void UpdateLooks();
  /// What of the style is possible with the arrays that there are.
  InspectionStyle GetStyleOfPicture(vtkMapper* mapper, bool ofPoints) const;
  void Attach(vtkShaderProgram* program, const char* name, const TextureBuffer& table);
  void Detach(vtkOpenGLState* state);
  void Release();

private:
  std::vector<int> UsedUnits;
};
}

#endif
