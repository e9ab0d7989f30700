// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GridArrays.h
 * @brief The arrays of a vtkUnstructuredGrid, for GridBuilder to fill.
 */
#ifndef camaron_GridArrays_h
#define camaron_GridArrays_h

#include "Base/Buffer.h"
#include "Intake/FaceMesh/FaceMeshPiece.h"
#include "Mesh/FacetTable.h" // for Index

#include "vtkCellArray.h"         // for cells
#include "vtkTypeInt32Array.h"    // for indices
#include "vtkTypeInt64Array.h"    // for indices
#include "vtkUnsignedCharArray.h" // for types
#include "vtkUnstructuredGrid.h"  // for the grid

#include <type_traits> // for the type of indices
#include <vector>      // for faces

namespace camaron
{
/// Sets the points of @a grid; afterwards, @a mesh uses those of the grid. False if they cannot be
/// read any more, or if stopped.
bool TakePoints(
  FaceMesh& mesh, const FaceMeshPiece& piece, vtkUnstructuredGrid* grid, const Progress& progress);

/// Adds global ids and ghost arrays to a piece of a mesh.
void AddPieceIds(
  const FaceMeshPiece& piece, const PieceRequest& request, vtkUnstructuredGrid* grid);

/// Number of entries that items need in the arrays of the grid, or where their entries begin.
struct Extent
{
  vtkIdType Points = 0;
  vtkIdType PolyhedronFaces = 0;
  vtkIdType PolyhedronFacePoints = 0;
  vtkIdType Faces = 0; // of all 3D cells
  Extent& operator+=(const Extent& other)
  {
    this->Points += other.Points;
    this->PolyhedronFaces += other.PolyhedronFaces;
    this->PolyhedronFacePoints += other.PolyhedronFacePoints;
    this->Faces += other.Faces;
    return *this;
  }
  /// Whether @a more entries fit before @a end.
  bool HasRoom(const Extent& more, const Extent& end) const
  {
    return this->Points + more.Points <= end.Points && this->Faces + more.Faces <= end.Faces &&
      this->PolyhedronFaces + more.PolyhedronFaces <= end.PolyhedronFaces &&
      this->PolyhedronFacePoints + more.PolyhedronFacePoints <= end.PolyhedronFacePoints;
  }
};

/// Arrays of a grid; Id is the type of all indices.
template <typename Id>
struct Arrays
{
  using IdArray =
    typename std::conditional<sizeof(Id) == 4, vtkTypeInt32Array, vtkTypeInt64Array>::type;
  Buffer<unsigned char> Types;
  Buffer<Id> Offsets, Connectivity;
  Buffer<Id> FaceOffsets, FaceConnectivity, LocationOffsets, Locations;
  LargeVector<Index> CellFaces;

  Arrays(vtkIdType items, const Extent& total, bool provideFaces)
    : Types(items)
    , Offsets(items + 1)
    , Connectivity(total.Points)
  {
    this->Offsets[items] = static_cast<Id>(total.Points);
    if (total.PolyhedronFaces > 0)
    {
      this->FaceOffsets = Buffer<Id>(total.PolyhedronFaces + 1);
      this->FaceOffsets[total.PolyhedronFaces] = static_cast<Id>(total.PolyhedronFacePoints);
      this->FaceConnectivity = Buffer<Id>(total.PolyhedronFacePoints);
      this->LocationOffsets = Buffer<Id>(items + 1);
      this->LocationOffsets[items] = static_cast<Id>(total.PolyhedronFaces);
      this->Locations = Buffer<Id>(total.PolyhedronFaces);
    }
    if (provideFaces)
    {
      this->CellFaces.resize(static_cast<std::size_t>(total.Faces), 0);
    }
  }

  static vtkSmartPointer<vtkCellArray> MakeCells(Buffer<Id>& offsets, Buffer<Id>& connectivity)
  {
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    const auto offsetArray = offsets.template TakeArray<IdArray>();
    const auto idArray = connectivity.template TakeArray<IdArray>();
    cells->SetData(offsetArray.Get(), idArray.Get());
    return cells;
  }

  void MoveTo(vtkUnstructuredGrid* grid)
  {
    const bool polyhedra = this->Locations.size() > 0;
    const auto types = this->Types.template TakeArray<vtkUnsignedCharArray>();
    const auto cells = MakeCells(this->Offsets, this->Connectivity);
    if (polyhedra)
    {
      const auto faces = MakeCells(this->FaceOffsets, this->FaceConnectivity);
      const auto locations = MakeCells(this->LocationOffsets, this->Locations);
      grid->SetPolyhedralCells(types, cells, locations, faces);
    }
    else
    {
      grid->SetPolyhedralCells(types, cells, nullptr, nullptr); // because SetCells would search for
                                                                // polyhedra
    }
  }
};
}

#endif
