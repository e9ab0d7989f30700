// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::LabelMesh
 * @brief The mesh of a Mesh Inspection for labels: positions of its elements and their ids.
 *
 * The triangles are those on the graphics card, fetched when they change. Ids are looked up on
 * demand.
 */
#ifndef camaron_LabelMesh_h
#define camaron_LabelMesh_h

#include "LabelStyle.h"

#include "Elements/ElementNumbers.h"

#include "vtkSmartPointer.h" // for the grid

#include <cstdint> // for the tables
#include <map>     // for edges
#include <memory>  // for numbers created on demand
#include <vector>  // for the tables

class vtkUnstructuredGrid;

namespace camaron
{
class InspectionMesh;
class SubdividedFacets;

using Place = std::array<double, 3>;

class LabelMesh
{
public:
  /**
   * Call this before each choice, when the tables of triangles exist and the context is current.
   *
   * @param hasPieces false if cells have left their pieces, so that numbers of faces and edges are
   * unknown
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
  /// The cell whose side of a triangle is visible. @a entry: triangle << 1 | side.
  std::uint32_t GetCell(std::uint32_t entry) const
  {
    return this->Faces[GetFace(entry)][entry & 1u];
  }
  std::uint32_t GetFace(std::uint32_t entry) const;
  bool IsGhostPoint(vtkIdType point) const;
  /// Whether the cell belongs to a hidden block.
  bool IsHidden(std::uint32_t cell) const { return (this->Marks[cell] & 2) != 0; }
  /// Whether an exact cut removes this position.
  bool IsCutAway(const Place& place) const;
  bool MovesCells() const { return this->Style.MovesCells(); }

  ///@{
  /// Positions at which elements are drawn as part of @a cell, relative to the middle of the mesh.
  Place GetPoint(vtkIdType point, vtkIdType cell) const;
  Place GetFaceCenter(std::uint32_t face, vtkIdType cell) const;
  Place GetCellCenter(vtkIdType cell) const;
  ///@}
  /// Converts such a position to coordinates of the data.
  Place AddMiddle(const Place& place) const;

  ///@{
  /// The id in the label; ElementNumbers::None if there is none.
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
  void FindCurvedEdges() const;

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
  const SubdividedFacets* Subdivided = nullptr;
  /// The ends of curved edges, by those of the part at their middle that has the label.
  using Ends = std::pair<vtkIdType, vtkIdType>;
  mutable std::map<Ends, Ends> CurvedEdges;
  mutable bool HasCurvedEdges = false;
};
}

#endif
