// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshInspectionInternals.h
 * @brief What a vtkMeshInspectionRepresentation has: its properties, and what it draws beside the mesh.
 */
#ifndef camaron_MeshInspectionInternals_h
#define camaron_MeshInspectionInternals_h

#include "InspectionBlocks.h"
#include "InspectionStyle.h"
#include "LabelStyle.h"
#include "LinesAndVertices.h"
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

#include <array>
#include <string>

class vtkDataObject;
class vtkRenderer;
class vtkUnstructuredGrid;

namespace camaron
{
/// What the shape that cuts goes with.
enum CutMoves
{
  WithMesh, ///< its coordinates are those of the data
  WithView  ///< it stays where it is in the picture while the camera turns
};
}

class vtkMeshInspectionRepresentation::Internals
{
public:
  /// Something beside the mesh that is drawn of it, from the same tables.
  struct Companion
  {
    vtkNew<vtkActor> Actor;
    vtkNew<vtkMeshInspectionMapper> Mapper;

    void Initialize(vtkMeshInspectionMapper* ofMesh, vtkProperty* property)
    {
      this->Mapper->ShareMesh(ofMesh);
      this->Actor->SetMapper(this->Mapper);
      this->Actor->SetProperty(property);
      this->Actor->VisibilityOff();
    }
    void Show(const camaron::InspectionStyle& style, vtkDataObject* mesh, vtkActor* ofMesh)
    {
      this->Mapper->SetStyle(style);
      this->Mapper->SetInputDataObject(mesh);
      this->Actor->SetUserMatrix(ofMesh->GetMatrix());
      if (this->Actor->GetMTime() < ofMesh->GetMTime())
      {
        this->Actor->Modified(); // it does not see that its matrix changed
      }
    }
  };

  camaron::InspectionStyle Style;
  std::array<double, 6> LocalBounds = { { 1, -1, 1, -1, 1, -1 } }; ///< of the points here that are somewhere
  camaron::InspectionBlocks Blocks;
  vtkNew<vtkCompositeDataDisplayAttributes> BlockAttributes;
  bool ColorMissingArraysWithNanColor = false;
  bool GlassShell = false;
  int CutMoves = camaron::WithMesh;
  vtkSmartPointer<vtkImplicitFunction> CutFunction;
  std::string LastShapeError;
  bool WarnedOfRayTracing = false;
  // Where the camera looked when the shape was last fixed in the view.
  vtkNew<vtkMatrix4x4> FixedView;
  bool HasFixedView = false;

  int NormalsOf = 0;           ///< 1: faces, 2: vertices
  double NormalLength = 0.03; ///< as a part of the diagonal of the bounds
  Companion Lines;
  vtkNew<vtkProperty> LineProperty;

  bool DrawIsosurfaces = false;
  Companion Isosurfaces;
  Companion Cap; ///< of an exact cut

  Companion Shell;
  vtkNew<vtkProperty> ShellProperty;

  /// Cells without faces, which VTK draws.
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
  /// Those that show cells.
  std::array<vtkActor*, 3> GetPickableActors()
  {
    return { { this->Isosurfaces.Actor, this->Cap.Actor, this->WireActor } };
  }
  void UpdateShape(vtkMeshInspectionRepresentation* self, vtkActor* actor, vtkRenderer* renderer);
  void ShowWires(const camaron::InspectionStyle& style, vtkUnstructuredGrid* mesh, vtkActor* ofMesh);
};

#endif
