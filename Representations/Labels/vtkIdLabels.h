// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkIdLabels
 * @brief Draws ids of the elements of a Mesh Inspection into the view, see camaron::LabelChoice.
 *
 * The labels are chosen for every frame. They are not an overlay, but have a depth directly in
 * front of the mesh: objects in front of the mesh hide them, and images of several processes are
 * composited with them. They cannot be picked.
 *
 * The mapper's input describes the labels in field arrays with one row per label: LabelKinds (see
 * camaron::LabelKind), LabelIds, LabelPlaces (coordinates of the data) and LabelPixels (left,
 * bottom, width, height of the digits).
 */
#ifndef vtkIdLabels_h
#define vtkIdLabels_h

#include "vtkOpenGLActor.h"

#include <memory> // for the implementation

class vtkDataObject;
class vtkMeshInspectionMapper;
class vtkRenderer;

namespace camaron
{
struct InspectionStyle;
struct LabelStyle;
}

class vtkIdLabels : public vtkOpenGLActor
{
public:
  static vtkIdLabels* New();
  vtkTypeMacro(vtkIdLabels, vtkOpenGLActor);

  /// The mapper and actor of the mesh whose elements are labeled.
  void SetMesh(vtkMeshInspectionMapper* mapper, vtkActor* actor);
  /// Call this before each frame.
  void Show(
    const camaron::LabelStyle& labels, const camaron::InspectionStyle& style, vtkDataObject* grid);
  /// The renderer that draws the labels, or null.
  void SetRenderer(vtkRenderer* renderer);
  /// Whether the cells of a piece are still together, as before delivery.
  void SetHasPieces(bool has);

  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  /**
   * Bounds of the mesh with space for labels around it, because images of several processes are
   * only composited inside the bounds. They are in use only during rendering, so that cameras fit
   * the mesh alone.
   */
  double* GetBounds() override;
  bool GetUseBounds() override;

protected:
  vtkIdLabels();
  ~vtkIdLabels() override;

private:
  vtkIdLabels(const vtkIdLabels&) = delete;
  void operator=(const vtkIdLabels&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
