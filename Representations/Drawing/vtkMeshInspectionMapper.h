// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshInspectionMapper
 * @brief Draws an unstructured grid with all options of Mesh Inspection, directly from its
 * topology.
 *
 * The input is a vtkUnstructuredGrid (SetInputDataObject), not a vtkPolyData: no surface is
 * extracted and no vertices are uploaded. Shaders read the tables of a camaron::InspectionMesh;
 * VTK's shader templates around them provide lights, materials, depth peeling and picking.
 * camaron::InspectionStyle defines what is drawn, and how.
 *
 * Cells and points are picked by their ids in the input, or by the ids that vtkInspectionMesh has
 * stored in it. Requires OpenGL 3.2. If the graphics card cannot draw the mesh, VTK's filters
 * extract the visible surface and VTK draws it.
 */
#ifndef vtkMeshInspectionMapper_h
#define vtkMeshInspectionMapper_h

#include "vtkOpenGLPolyDataMapper.h"

#include <memory> // for the implementation

namespace camaron
{
class InspectionMesh;
class InspectionTables;
struct InspectionStyle;
}

class vtkMeshInspectionMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkMeshInspectionMapper* New();
  vtkTypeMacro(vtkMeshInspectionMapper, vtkOpenGLPolyDataMapper);

  /// Sets what is drawn. Styles are cheap to compare: set it before every frame.
  void SetStyle(const camaron::InspectionStyle& style);
  /// Sets the parts of the style that affect the bounds, before the rest is known.
  void SetReach(double explodeFactor, double normalLength);

  /// Draws the mesh of another mapper from the same tables. Both must have the same input.
  void ShareMesh(vtkMeshInspectionMapper* other);
  /// The tables, for other objects that draw the mesh.
  std::shared_ptr<camaron::InspectionMesh> GetMesh() const;
  /// Number of triangles in the last frame. If @a changesWithCamera and cells are hidden, the
  /// number of triangles that had to be tested.
  std::size_t GetNumberOfTriangles(bool changesWithCamera) const;
  /// Whether VTK's filters draw the mesh, so that there are no tables.
  bool IsOnProcessor() const;

  using Superclass::SetInputConnection;
  using Superclass::SetInputDataObject;
  void SetInputConnection(int port, vtkAlgorithmOutput* producerOfGrid) override;
  void SetInputDataObject(int port, vtkDataObject* grid) override;
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void ProcessSelectorPixelBuffers(
    vtkHardwareSelector* selector, std::vector<unsigned int>& pixelOffsets, vtkProp* prop) override;
  bool HasOpaqueGeometry() override;
  bool HasTranslucentPolygonalGeometry() override;

protected:
  vtkMeshInspectionMapper();
  ~vtkMeshInspectionMapper() override;

  void ComputeBounds() override;
  bool GetNeedToRebuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  void BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  bool GetNeedToRebuildShaders(
    vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor) override;
  void GetShaderTemplate(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderTCoord(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderPicking(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void SetMapperShaderParameters(
    vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor) override;
  void SetCameraShaderParameters(
    vtkOpenGLHelper& helper, vtkRenderer* renderer, vtkActor* actor) override;
  void UpdateMaximumPointCellIds(vtkRenderer* renderer, vtkActor* actor) override;
  bool DrawingEdges(vtkRenderer* renderer, vtkActor* actor) override;
  bool HaveWideLines(vtkRenderer* renderer, vtkActor* actor) override;

private:
  vtkMeshInspectionMapper(const vtkMeshInspectionMapper&) = delete;
  void operator=(const vtkMeshInspectionMapper&) = delete;

  vtkUnsignedCharArray* MapCells();
  void UpdateValues();
  /// Whether vertices of faces are drawn as points, in a frame or for a selection.
  bool DrawsPoints(const vtkOpenGLHelper& helper) const
  {
    return this->PointPicking || &helper == &this->Primitives[PrimitivePoints];
  }
  void Draw(vtkRenderer* renderer, vtkActor* actor, int primitive, unsigned int mode,
    std::size_t numberOfVertices);

  std::unique_ptr<camaron::InspectionTables> Internal;
};

#endif
