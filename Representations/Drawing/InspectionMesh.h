// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::InspectionMesh
 * @brief The mesh of a Mesh Inspection in graphics memory, shared by its mappers.
 *
 * Tables are made when somebody first needs them: a mesh that is shown whole has only its outer
 * faces there. They stay until the mesh changes. All Need... methods want the context of the window
 * current.
 */
#ifndef camaron_InspectionMesh_h
#define camaron_InspectionMesh_h

#include "TextureBuffer.h"

#include "vtkSmartPointer.h" // for the grid
#include "vtkType.h"         // for vtkMTimeType

#include <array>   // for bounds
#include <cstdint> // for counts
#include <utility> // for the key
#include <vector>  // for the key

class vtkDataArray;
class vtkObject;
class vtkUnstructuredGrid;

namespace camaron
{
struct CellsToDraw;

/// What the arrays of a grid say of its cells.
CellsToDraw GetCellsToDraw(vtkUnstructuredGrid* grid);

/// Bounds of the points that are neither NaN nor infinite; 1, -1 if there are none.
std::array<double, 6> GetFiniteBounds(vtkUnstructuredGrid* grid);

class InspectionMesh
{
public:
  ~InspectionMesh();

  /// The mesh to draw or null. Tables of another one are given back by the next Need...
  void SetGrid(vtkUnstructuredGrid* grid) { this->Grid = grid; }
  vtkUnstructuredGrid* GetGrid() const { return this->Grid; }

  /// Checks whether the mesh changed; to be called before each picture.
  void Update();
  /// Goes up whenever tables become invalid.
  int GetVersion() const { return this->Version; }

  ///@{
  /// Makes sure that a table is there. Throws std::length_error when the mesh is too large for it.
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
  /// What coordinates in the tables are relative to: float has few digits.
  const std::array<double, 3>& GetMiddle() const { return this->Middle; }

  TextureBuffer Points{ TextureBuffer::Row::Float4 };
  TextureBuffer Triangles{ TextureBuffer::Row::UInt4 };
  TextureBuffer Faces{ TextureBuffer::Row::UInt2 };
  TextureBuffer Marks{ TextureBuffer::Row::Byte }; ///< bits: 1 ghost, 2 hidden, 4 selected
  TextureBuffer Centroids{ TextureBuffer::Row::Float4 };
  TextureBuffer CellOffsets{ TextureBuffer::Row::UInt };
  TextureBuffer CellPoints{ TextureBuffer::Row::UInt };
  TextureBuffer Owners{ TextureBuffer::Row::UInt2 }; ///< process and block of a cell
  TextureBuffer Leaves{
    TextureBuffer::Row::UInt
  }; ///< the block of a cell, as a row of how blocks look
  /// Points; bits 30 and 31 of the first three: the edges; bit 30 of the fourth: it is negative,
  /// see CellTetrahedra.h.
  TextureBuffer Tetrahedra{ TextureBuffer::Row::UInt4 };
  TextureBuffer CellsOfTetrahedra{ TextureBuffer::Row::UInt };
  ///@{
  /// Not there if no cell has any, see CellTetrahedra.h. A box has two rows.
  TextureBuffer FirstNegatives{ TextureBuffer::Row::UInt2 };
  TextureBuffer NegativeBoxes{ TextureBuffer::Row::Float4 };
  ///@}
  /// Where those of a block of cells begin, see CellTetrahedra.h.
  const std::vector<std::uint32_t>& GetTetrahedronBlocks() const { return this->Blocks; }

  void Release();

private:
  using Version_t = std::vector<std::pair<vtkSmartPointer<vtkObject>, vtkMTimeType>>;
  static Version_t GetVersionOf(const std::vector<vtkObject*>& arrays);

  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  Version_t Geometry;
  Version_t Selected;
  int Version = 0;
  bool HasInnerFaces = false;
  std::uint32_t NumberOfOuterTriangles = 0;
  std::vector<std::uint32_t> Blocks;
  std::array<double, 3> Middle = { { 0, 0, 0 } };
};
}

#endif
