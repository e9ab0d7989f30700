// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeshInspectionRepresentation
 * @brief ParaView's representation "Mesh Inspection": draws a mesh with all its cells on the
 * graphics card.
 *
 * It inherits everything from Surface (colors, lights, opacity, transform, picking). Unlike
 * Surface, it delivers the whole mesh to where it is drawn, so cuts, shrunk cells and glass need no
 * new data. Further actors, such as the glass shell, normals and isosurfaces, share the tables of
 * the mesh. vtkMeshInspectionMapper draws, and MeshInspection.xml documents the properties.
 */
#ifndef vtkMeshInspectionRepresentation_h
#define vtkMeshInspectionRepresentation_h

#include "vtkGeometryRepresentationWithFaces.h"

#include <memory> // for the implementation

class vtkImplicitFunction;
class vtkUnstructuredGrid;

class vtkMeshInspectionRepresentation : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkMeshInspectionRepresentation* New();
  vtkTypeMacro(vtkMeshInspectionRepresentation, vtkGeometryRepresentationWithFaces);

  ///@{
  /// MeshInspection.xml documents the properties with these names.
  void SetDrawWith(int what);
  void SetDrawFaces(bool on);
  void SetDrawEdges(bool on);
  void SetEdgesOf(int which);
  void SetGlassShell(bool on);
  void SetGlassStrength(double strength);
  void SetGlassColor(double red, double green, double blue);
  void SetFacesToDraw(int which);
  void SetCellsToDraw(int which);
  void SetShrinkFactor(double factor);
  void SetExplodeFactor(double factor);
  void SetCutBy(int which);
  void SetCutKeep(int which);
  void SetCutMoves(int with);
  void SetCutShape(vtkImplicitFunction* shape);
  void SetCutColor(double red, double green, double blue);
  void SetColoring(int by);
  void SetHeightDirection(double x, double y, double z);
  void SetLowColor(double red, double green, double blue);
  void SetHighColor(double red, double green, double blue);
  void SetUndefinedColor(double red, double green, double blue);
  void SetCustomColorRange(bool on);
  void SetColorRange(double low, double high);
  void SetEmphasis(int which);
  void SetAcceptableRange(double low, double high);
  void SetDimming(double amount);
  /// Of the faces of curved cells; ParaView's property of all surfaces.
  void SetNonlinearSubdivisionLevel(int level);
  void SetSmoothShading(bool on);
  void SetSmoothAngle(double degrees);
  void SetDrawPoints(bool on);
  void SetDrawNormals(int of);
  void SetNormalLength(double part);
  void SetNormalColor(double red, double green, double blue);
  void SetDrawPointIds(bool on);
  void SetDrawEdgeIds(bool on);
  void SetDrawFaceIds(bool on);
  void SetDrawCellIds(bool on);
  void SetNumberOfIds(int number);
  void SetIdSize(int points);
  void SetPointIdColor(double red, double green, double blue);
  void SetEdgeIdColor(double red, double green, double blue);
  void SetFaceIdColor(double red, double green, double blue);
  void SetCellIdColor(double red, double green, double blue);
  void SetDrawIsosurfaces(bool on);
  void SetIsosurfaceArray(int, int, int, int association, const char* name);
  void SetNumberOfIsosurfaceValues(int number);
  void SetIsosurfaceValue(int index, double value);
  void SetDrawIsolines(bool on);
  void SetIsolineArray(int, int, int, int association, const char* name);
  void SetIsolineFirst(double value);
  void SetIsolineSpacing(double spacing);
  void SetIsolineWidth(double pixels);
  void SetIsolineColor(double red, double green, double blue);
  void SetBlockColorsDistinctValues(int number);
  ///@}
  void SetColorMissingArraysWithNanColor(bool on) override;

  /// Any mode that needs nothing else, by the name of its property; see RenderModes.cxx.
  void SetSwitch(const char* property, bool on);

  /// A color that is mixed into emphasized values, and its share from 0 to 1. Default: magenta, 0.
  void SetAccent(double red, double green, double blue, double share);
  void SetNumberOfBrushes(int number);
  void SetBrush(int index, const char* array, double low, double high, bool selects);

  vtkDataObject* GetRenderedDataObject(int port) override;
  void SetVisibility(bool visible) override;
  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkMeshInspectionRepresentation();
  ~vtkMeshInspectionRepresentation() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;
  bool NeedsOrderedCompositing() override;

private:
  vtkMeshInspectionRepresentation(const vtkMeshInspectionRepresentation&) = delete;
  void operator=(const vtkMeshInspectionRepresentation&) = delete;

  template <typename Value>
  void Change(Value& member, const Value& value);
  class Internals;
  void UpdateReach();
  void GiveSamples(vtkInformation* inInfo, bool withCoarseMesh);
  void MakeCoarseMesh(vtkInformation* inInfo);
  bool DrawsCoarseMesh(vtkInformation* inInfo);
  bool IsTooMuchToMove(vtkDataObject* whole);
  vtkUnstructuredGrid* UpdateMesh(vtkInformation* inInfo, bool isCoarse);
  void FollowCamera(vtkObject* renderer, unsigned long event, void*);
  void UpdateStyles(vtkRenderer* ofPicture);

  std::unique_ptr<Internals> Internal;
};

#endif
