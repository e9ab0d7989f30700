// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkIdLabels
 * @brief Draws ids of the elements of a Mesh Inspection into the picture, see camaron::LabelChoice.
 *
 * The labels are chosen anew for every picture. They are no overlay but have a depth, right in
 * front of the mesh: what is before the mesh covers them, and pictures of several processes are
 * composed with them. They cannot be picked.
 *
 * The mapper's input tells what is written, one row for each label, in field arrays: LabelKinds
 * (see camaron::LabelKind), LabelIds, LabelPlaces (coordinates of the data) and LabelPixels (left,
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

  /// Whose elements are labeled.
  void SetMesh(vtkMeshInspectionMapper* mapper, vtkActor* actor);
  /// To be called before each picture.
  void Show(
    const camaron::LabelStyle& labels, const camaron::InspectionStyle& style, vtkDataObject* grid);
  /// Where it is drawn, or null.
  void SetRenderer(vtkRenderer* renderer);
  /// Whether the cells of a piece of the mesh are together, as they were before they were
  /// delivered.
  void SetHasPieces(bool has);

  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  /**
   * Of the mesh with room for labels around it: outside of them, pictures of several processes are
   * not composed. In use only while a picture is drawn, so that cameras look at the mesh alone.
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
