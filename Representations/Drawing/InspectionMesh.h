// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::InspectionMesh
 * @brief The mesh of a Mesh Inspection in graphics memory, shared by its mappers.
 *
 * Each table is created when it is first needed: a mesh that is drawn whole only uploads its outer
 * faces. Tables remain until the mesh changes. All Need... methods require that the context of the
 * window is current.
 */
#ifndef camaron_InspectionMesh_h
#define camaron_InspectionMesh_h

#include "TextureBuffer.h"

#include "vtkSmartPointer.h" // for the grid
#include "vtkType.h"         // for vtkMTimeType

#include <array>   // for bounds
#include <cstdint> // for counts
#include <memory>  // for facets
#include <utility> // for the key
#include <vector>  // for the key

class vtkDataArray;
class vtkObject;
class vtkUnstructuredGrid;

namespace camaron
{
struct CellsToDraw;
class SubdividedFacets;

/// The arrays of a grid that mark ghost cells and outer faces.
CellsToDraw GetCellsToDraw(vtkUnstructuredGrid* grid);

/// Bounds of the points that cells use and whose coordinates are finite; 1, -1 if there are none.
std::array<double, 6> GetCellBounds(vtkUnstructuredGrid* grid);

/// Arrays and when they changed last; it keeps them, so that no other array can take their place.
using DataVersion = std::vector<std::pair<vtkSmartPointer<vtkObject>, vtkMTimeType>>;

/// The version of what GetCellBounds looks at.
DataVersion GetCellBoundsVersion(vtkUnstructuredGrid* grid);

class InspectionMesh
{
public:
  /// The mesh to draw, or null. Tables of another mesh are released by the next Need... call.
  void SetGrid(vtkUnstructuredGrid* grid) { this->Grid = grid; }
  /// The faces of its curved cells, if it has the points for them; may be null.
  void SetSubdividedFacets(std::shared_ptr<const SubdividedFacets> facets)
  {
    this->Subdivided = std::move(facets);
  }
  const SubdividedFacets* GetSubdividedFacets() const { return this->Subdivided.get(); }
  /// Points of the mesh without those that subdivide curved faces, which follow.
  vtkIdType GetNumberOfNodes() const;
  vtkUnstructuredGrid* GetGrid() const { return this->Grid; }

  /// Checks whether the mesh has changed. Call it before each frame.
  void Update();
  /// A number that increases whenever tables become invalid.
  int GetVersion() const { return this->Version; }

  ///@{
  /// Create a table unless it exists. Throw std::length_error if the mesh is too large for it.
  void NeedFaces(bool inner);
  void NeedPoints();
  void NeedMarks();
  void NeedCentroids();
  void NeedConnectivity();
  void NeedOwners();
  void NeedLeaves();
  void NeedTetrahedra();
  ///@}

  std::uint32_t GetNumberOfOuterTriangles() const { return this->NumberOfOuterTriangles; }
  /// Origin of the coordinates in the tables. Coordinates relative to the middle of the mesh fit
  /// better into float.
  const std::array<double, 3>& GetMiddle() const { return this->Middle; }

  TextureBuffer Points{ TextureBuffer::Row::Float4 };
  TextureBuffer Triangles{ TextureBuffer::Row::UInt4 };
  TextureBuffer Faces{ TextureBuffer::Row::UInt2 };
  TextureBuffer Marks{ TextureBuffer::Row::Byte }; ///< bits: 1 ghost, 2 hidden, 4 selected
  TextureBuffer Centroids{ TextureBuffer::Row::Float4 };
  TextureBuffer CellOffsets{ TextureBuffer::Row::UInt };
  TextureBuffer CellPoints{ TextureBuffer::Row::UInt };
  TextureBuffer Owners{ TextureBuffer::Row::UInt2 }; ///< process and block of each cell
  TextureBuffer Leaves{
    TextureBuffer::Row::UInt
  }; ///< row of each cell's block in the table of looks
  /// Four points per row. Bits 30 and 31 of the first three are the edges; bit 30 of the fourth
  /// marks a negative tetrahedron, see CellTetrahedra.h.
  TextureBuffer Tetrahedra{ TextureBuffer::Row::UInt4 };
  TextureBuffer CellsOfTetrahedra{ TextureBuffer::Row::UInt };
  ///@{
  /// Missing if no cell has negative tetrahedra, see CellTetrahedra.h. Each box has two rows.
  TextureBuffer FirstNegatives{ TextureBuffer::Row::UInt2 };
  TextureBuffer NegativeBoxes{ TextureBuffer::Row::Float4 };
  ///@}
  /// The first tetrahedron of each block of cells, see CellTetrahedra.h.
  const std::vector<std::uint32_t>& GetTetrahedronBlocks() const { return this->Blocks; }

  void Release();

private:
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  std::shared_ptr<const SubdividedFacets> Subdivided, OfTables;
  DataVersion Geometry;
  DataVersion Selected;
  int Version = 0;
  bool HasInnerFaces = false;
  std::uint32_t NumberOfOuterTriangles = 0;
  std::vector<std::uint32_t> Blocks;
  std::array<double, 3> Middle = { { 0, 0, 0 } };
};
}

#endif
