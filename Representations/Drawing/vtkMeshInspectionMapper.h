// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshInspectionMapper
 * @brief Draws an unstructured grid with all that a Mesh Inspection offers, straight from its
 * topology.
 *
 * The input is a vtkUnstructuredGrid (SetInputDataObject), not a vtkPolyData: no surface is
 * extracted and no vertices are uploaded. The shaders read the tables of a camaron::InspectionMesh;
 * VTK's own templates around them give lights, materials, depth peeling and picking. What is drawn
 * how is a camaron::InspectionStyle.
 *
 * Cells and points are picked by their ids in the input, or by those that vtkInspectionMesh gave
 * them. Needs OpenGL 3.2; where the graphics card cannot, VTK's filters make a surface of what is
 * to be seen, and VTK draws it.
 */
#ifndef vtkMeshInspectionMapper_h
#define vtkMeshInspectionMapper_h

#include "vtkOpenGLPolyDataMapper.h"

#include <memory> // for the implementation

namespace camaron
{
class InspectionMesh;
struct InspectionStyle;
}

class vtkMeshInspectionMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkMeshInspectionMapper* New();
  vtkTypeMacro(vtkMeshInspectionMapper, vtkOpenGLPolyDataMapper);

  /// What to draw. Comparing styles is cheap: set it before every picture.
  void SetStyle(const camaron::InspectionStyle& style);
  /// What of the style counts for the bounds, before the rest is known.
  void SetReach(double explodeFactor, double normalLength);

  /// Draws the mesh of another mapper, from the same tables. It must have the same input.
  void ShareMesh(vtkMeshInspectionMapper* other);
  /// The tables, for what else is drawn of them.
  std::shared_ptr<camaron::InspectionMesh> GetMesh() const;
  /// What was drawn last, and what had to be looked at for it when that changes with the camera.
  std::size_t GetNumberOfTriangles(bool changesWithCamera) const;
  /// Whether there are none, because the graphics card has no part in it.
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

  void UpdateValues();
  /// Corners of faces as points, in the picture or for a selection.
  bool DrawsPoints(const vtkOpenGLHelper& helper) const
  {
    return this->PointPicking || &helper == &this->Primitives[PrimitivePoints];
  }
  void Draw(vtkRenderer* renderer, vtkActor* actor, int primitive, unsigned int mode,
    std::size_t numberOfVertices);

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
