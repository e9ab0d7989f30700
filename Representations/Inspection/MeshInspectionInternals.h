// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshInspectionInternals.h
 * @brief Members of vtkMeshInspectionRepresentation: its properties, and the objects drawn in
 * addition to the mesh.
 */
#ifndef camaron_MeshInspectionInternals_h
#define camaron_MeshInspectionInternals_h

#include "CoarseMeshDemand.h"
#include "CurvedMesh.h"
#include "InspectionBlocks.h"
#include "InspectionStyle.h"
#include "LabelStyle.h"
#include "LinesAndVertices.h"
#include "vtkCoarseInspectionMesh.h"
#include "vtkIdLabels.h"
#include "vtkMeshInspectionMapper.h"
#include "vtkMeshInspectionRepresentation.h"

#include "vtkActor.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkImplicitFunction.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>

class vtkDataObject;
class vtkRenderer;

namespace camaron
{
/// What the shape of a cut is attached to.
enum CutMoves
{
  WithMesh, ///< the data: its coordinates are those of the mesh
  WithView  ///< the view: it stays in place on the screen while the camera moves
};
}

class vtkMeshInspectionRepresentation::Internals
{
public:
  explicit Internals(std::function<bool()> isCoarseWanted)
    : DemandForCoarse(std::move(isCoarseWanted))
  {
  }

  /// A mesh, full or coarse, that was delivered to where it is drawn.
  struct Delivered
  {
    vtkSmartPointer<vtkUnstructuredGrid>
      Blocks; ///< the joined blocks with their looks; null without blocks
    vtkNew<vtkCompositeDataDisplayAttributes> Attributes; ///< of the samples
    bool AreAttributesOld = true;

    /// True if the attributes have to be updated.
    bool Update(vtkUnstructuredGrid* mesh, vtkDataObjectTree* samples);

  private:
    vtkMTimeType TimeOfMesh = 0;
    vtkMTimeType TimeOfSamples = 0;
  };
  static constexpr int PortOfSamples = 1; ///< the mesh uses port 0

  /// The mesh, full or coarse, in the current frame.
  struct Drawn
  {
    vtkUnstructuredGrid* Mesh = nullptr;
    vtkMapper* Mapper = nullptr; ///< of its faces
    bool IsCoarse = false;
  };

  static void CopyColoring(vtkMapper* from, vtkMapper* to);
  static void FollowActor(vtkActor* actor, vtkActor* ofMesh)
  {
    actor->SetUserMatrix(ofMesh->GetMatrix());
    if (actor->GetMTime() < ofMesh->GetMTime())
    {
      actor->Modified(); // it does not notice that its matrix has changed
    }
  }

  /// An additional actor that draws from the tables of the mesh.
  struct Companion
  {
    vtkNew<vtkActor> Actor;
    vtkNew<vtkMeshInspectionMapper> Mapper, CoarseMapper;

    void Initialize(
      vtkMeshInspectionMapper* ofMesh, vtkMeshInspectionMapper* ofCoarseMesh, vtkProperty* property)
    {
      this->Mapper->ShareMesh(ofMesh);
      this->CoarseMapper->ShareMesh(ofCoarseMesh);
      this->Actor->SetMapper(this->Mapper);
      this->Actor->SetProperty(property);
      this->Actor->VisibilityOff();
    }
    void HasOneColor()
    {
      this->Mapper->ScalarVisibilityOff();
      this->CoarseMapper->ScalarVisibilityOff();
    }
    /// Draws this style, or nothing. With @a hasColorsOfMesh, it is part of the mesh: it has the
    /// same colors, and can be picked if the mesh can.
    void Show(bool isOn, const camaron::InspectionStyle& style, const Drawn& drawn,
      vtkActor* ofMesh, bool hasColorsOfMesh = false)
    {
      this->Actor->SetVisibility(isOn);
      if (!isOn)
      {
        return;
      }
      vtkMeshInspectionMapper* mapper = drawn.IsCoarse ? this->CoarseMapper : this->Mapper;
      if (hasColorsOfMesh)
      {
        CopyColoring(drawn.Mapper, mapper);
        this->Actor->SetPickable(ofMesh->GetPickable());
      }
      this->Actor->SetMapper(mapper);
      mapper->SetInputDataObject(drawn.Mesh);
      mapper->SetStyle(style);
      FollowActor(this->Actor, ofMesh);
    }
  };

  camaron::InspectionStyle Style;
  /// In place of each mesh of this process, a line across the bounds of its cells.
  vtkSmartPointer<vtkDataObject> Boxes;
  Delivered Whole, Coarse;
  camaron::CurvedMesh Curved; ///< of the whole mesh
  ///@{
  /// The one of them that is drawn.
  vtkSmartPointer<vtkUnstructuredGrid> Mesh;
  bool IsCoarse = false;
  ///@}
  unsigned long StartTag = 0; ///< of the observer of the renderer
  vtkNew<vtkCoarseInspectionMesh> MakeCoarse;
  vtkMTimeType TimeOfCoarse = 0; ///< of the full mesh from which it was created
  camaron::CoarseMeshDemand DemandForCoarse;
  bool ColorMissingArraysWithNanColor = false;
  bool GlassShell = false;
  int CutMoves = camaron::WithMesh;
  vtkSmartPointer<vtkImplicitFunction> CutFunction;
  std::string LastShapeError;
  bool WarnedOfRayTracing = false;
  /// The camera when the shape was last fixed in the view.
  vtkNew<vtkMatrix4x4> FixedView;
  bool HasFixedView = false;

  int NormalsOf = 0;          ///< 1: faces, 2: vertices
  double NormalLength = 0.03; ///< fraction of the diagonal of the bounds
  Companion Lines;
  vtkNew<vtkProperty> LineProperty;

  bool DrawIsosurfaces = false;
  Companion Isosurfaces;
  Companion Cap; ///< of an exact cut

  Companion Shell;
  vtkNew<vtkProperty> ShellProperty;

  /// Lines and vertices, which VTK draws.
  camaron::LinesAndVertices Wires;
  vtkNew<vtkActor> WireActor;
  vtkNew<vtkOpenGLPolyDataMapper> WireMapper;

  camaron::LabelStyle Ids;
  vtkNew<vtkIdLabels> IdLabels;

  std::array<vtkActor*, 5> GetActors()
  {
    return { { this->Shell.Actor, this->Lines.Actor, this->Isosurfaces.Actor, this->Cap.Actor,
      this->WireActor } };
  }
  /// The actors that show cells.
  std::array<vtkActor*, 3> GetPickableActors()
  {
    return { { this->Isosurfaces.Actor, this->Cap.Actor, this->WireActor } };
  }
  /// Number of triangles in the last frame of the full mesh.
  std::size_t CountTriangles(vtkMapper* ofMesh) const;
  double GetNormalLength(vtkUnstructuredGrid* mesh) const;
  camaron::SubdividedFacets::Extent GetExtent(vtkUnstructuredGrid* mesh) const;
  camaron::ConvexShape GetExactShape(vtkUnstructuredGrid* mesh) const;
  void UpdateShape(vtkMeshInspectionRepresentation* self, vtkActor* actor, vtkRenderer* renderer);
  void ShowWires(const camaron::InspectionStyle& style, const Drawn& drawn, vtkActor* ofMesh);
};

#endif
