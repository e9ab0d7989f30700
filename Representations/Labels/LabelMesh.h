// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::LabelMesh
 * @brief What labels need to know of the mesh of a Mesh Inspection: places of its elements and
 * their ids.
 *
 * The triangles are those that the graphics card has, fetched when they change; ids are looked up
 * when they are asked for.
 */
#ifndef camaron_LabelMesh_h
#define camaron_LabelMesh_h

#include "LabelStyle.h"

#include "Elements/ElementNumbers.h"

#include "vtkSmartPointer.h" // for the grid

#include <cstdint> // for the tables
#include <memory>  // for what is made when it is needed
#include <vector>  // for the tables

class vtkUnstructuredGrid;

namespace camaron
{
class InspectionMesh;

using Place = std::array<double, 3>;

class LabelMesh
{
public:
  /**
   * To be called before each choice, when the tables of the triangles are there and the context is
   * current.
   * @param hasPieces false: cells have left their pieces, so that nobody knows the numbers of faces
   * and edges
   */
  void Update(InspectionMesh& mesh, const InspectionStyle& style, bool hasPieces);
  void Release();

  std::size_t GetNumberOfTriangles() const { return this->Triangles.size(); }
  std::size_t GetNumberOfFaces() const { return this->Faces.size(); }
  vtkIdType GetNumberOfPoints() const { return this->View.GetNumberOfPoints(); }
  vtkIdType GetNumberOfCells() const { return this->View.GetNumberOfCells(); }
  const std::array<std::uint32_t, 4>& GetTriangle(std::uint32_t triangle) const
  {
    return this->Triangles[triangle];
  }
  /// The cell from which a triangle, in an entry triangle << 1 | side, is seen.
  std::uint32_t GetCell(std::uint32_t entry) const
  {
    return this->Faces[GetFace(entry)][entry & 1u];
  }
  std::uint32_t GetFace(std::uint32_t entry) const;
  bool IsGhostPoint(vtkIdType point) const;
  /// Of a block that is not shown.
  bool IsHidden(std::uint32_t cell) const { return (this->Marks[cell] & 2) != 0; }
  /// Whether a place is where an exact cut leaves nothing.
  bool IsCutAway(const Place& place) const;
  bool MovesCells() const { return this->Style.MovesCells(); }

  ///@{
  /// Where something is drawn as a part of @a cell, from the middle of the mesh.
  Place GetPoint(vtkIdType point, vtkIdType cell) const;
  Place GetFaceCenter(std::uint32_t face, vtkIdType cell) const;
  Place GetCellCenter(vtkIdType cell) const;
  ///@}
  /// The same in the coordinates of the data.
  Place AddMiddle(const Place& place) const;

  ///@{
  /// What the label says; ElementNumbers::None: there is none.
  vtkIdType GetPointId(vtkIdType point) const;
  vtkIdType GetCellId(vtkIdType cell) const;
  vtkIdType GetEdgeId(vtkIdType a, vtkIdType b) const;
  vtkIdType GetFaceId(std::uint32_t entry) const;
  ///@}

private:
  Place Move(const Place& place, vtkIdType cell) const;
  Place GetMeanPoint(vtkIdType cell) const;
  void FindFaceCenters();
  const ElementNumbers* GetNumbers() const;

  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  MeshView View;
  int Version = -1;
  bool HasPieces = true;
  InspectionStyle Style;
  Place Middle = { { 0, 0, 0 } };
  std::vector<std::array<std::uint32_t, 4>> Triangles;
  std::vector<std::array<std::uint32_t, 2>> Faces;
  std::vector<std::array<float, 3>> FaceCenters;
  std::vector<unsigned char> Marks; ///< see InspectionMesh
  const unsigned char* PointGhosts = nullptr;
  vtkDataArray* PointIds = nullptr;
  vtkDataArray* CellIds = nullptr;
  mutable std::unique_ptr<ElementNumbers> Numbers;
};
}

#endif
