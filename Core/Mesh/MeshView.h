// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MeshView
 * @brief Reads points and cells of a vtkUnstructuredGrid or vtkPolyData without virtual calls.
 *
 * A view is cheap to create and to copy: it references the arrays of the mesh, keeps them alive,
 * and copies only what VTK stores in an unusual form (points that are neither float nor double
 * tuples, implicit cell offsets). All methods are const and thread-safe. They do not check what
 * they read: use CheckCells (MeshCheck.h) once for a mesh of unknown origin.
 *
 * Cells of a vtkPolyData are numbered as in VTK: vertices, lines, polygons, strips.
 */
#ifndef camaron_MeshView_h
#define camaron_MeshView_h

#include "Base/Vector.h" // for positions

#include "vtkCellType.h"     // for the VTK_* cell types
#include "vtkSmartPointer.h" // for members
#include "vtkType.h"         // for vtkIdType

#include <array>   // for the blocks of cells
#include <cstdint> // for the index types of VTK's cell arrays
#include <vector>  // for used points

class vtkCellArray;
class vtkDataArray;
class vtkDataSet;
class vtkUnsignedCharArray;

namespace camaron
{
/// Read-only array of 32-bit or 64-bit indices.
struct IndexArray
{
  const std::int32_t* Values32 = nullptr;
  const std::int64_t* Values64 = nullptr;
  vtkIdType operator[](vtkIdType i) const
  {
    return this->Values32 ? this->Values32[i] : this->Values64[i];
  }
};

/// A range of consecutive entries of an IndexArray, such as the points of one cell.
struct IndexRange
{
  IndexArray Values;
  vtkIdType Begin = 0;
  vtkIdType Size = 0;
  vtkIdType operator[](vtkIdType i) const { return this->Values[this->Begin + i]; }

  struct Iterator
  {
    const IndexRange& Range;
    vtkIdType I;
    vtkIdType operator*() const { return this->Range[this->I]; }
    void operator++() { ++this->I; }
    bool operator!=(const Iterator& other) const { return this->I != other.I; }
  };
  Iterator begin() const { return { *this, 0 }; }
  Iterator end() const { return { *this, this->Size }; }
};

/// Lists of indices with offsets, as in a vtkCellArray.
struct IndexLists
{
  IndexArray Offsets;
  IndexArray Values;
  vtkIdType NumberOfLists = 0;
  vtkSmartPointer<vtkDataArray> OffsetsOwner, ValuesOwner;

  IndexLists() = default;
  explicit IndexLists(vtkCellArray* cells);
  IndexRange operator[](vtkIdType list) const
  {
    const vtkIdType begin = this->Offsets[list];
    return { this->Values, begin, this->Offsets[list + 1] - begin };
  }
  /// Including values that belong to no list.
  vtkIdType GetNumberOfValues() const;
};

class MeshView
{
public:
  MeshView() = default;
  /// @a mesh must be a vtkUnstructuredGrid or a vtkPolyData; any other, or nullptr, gives an empty
  /// view.
  explicit MeshView(vtkDataSet* mesh);

  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; }
  vtkIdType GetNumberOfCells() const { return this->NumberOfCells; }

  /// Whether coordinates are stored as float; GetPoint returns double in any case.
  bool HasFloatPoints() const { return this->PointsFloat != nullptr; }
  void GetPoint(vtkIdType id, double x[3]) const
  {
    if (this->PointsFloat)
    {
      const float* p = this->PointsFloat + 3 * id;
      x[0] = p[0], x[1] = p[1], x[2] = p[2];
    }
    else
    {
      const double* p = this->PointsDouble + 3 * id;
      x[0] = p[0], x[1] = p[1], x[2] = p[2];
    }
  }

  Vector GetPoint(vtkIdType id) const
  {
    double x[3];
    this->GetPoint(id, x);
    return { x[0], x[1], x[2] };
  }
  /// Order of points by coordinates, then by id, which is the same on all ranks.
  bool IsBefore(vtkIdType a, vtkIdType b) const;
  /// The first one of at least one point, in this order.
  vtkIdType FindFirstPoint(const vtkIdType* points, vtkIdType size) const;
  /// For every point, whether a cell uses it, except for hidden cells (VTK_EMPTY_CELL). Point ids
  /// out of range are ignored.
  std::vector<bool> FindUsedPoints() const;

  /// Calls @a visit once with the array of all coordinates: const float* or const double*.
  template <typename Visit>
  void VisitCoordinates(Visit&& visit) const
  {
    this->PointsFloat ? visit(this->PointsFloat) : visit(this->PointsDouble);
  }

  /// VTK's type of the cell, e.g. VTK_TETRA.
  unsigned char GetCellType(vtkIdType cell) const
  {
    return this->Types ? this->Types[cell] : this->GetPolyDataCellType(cell);
  }
  /// Whether @a count cells from @a first on are all of a type; false for polygonal data, which has
  /// no array of types.
  bool AreOfType(unsigned char type, vtkIdType first, int count) const
  {
    if (!this->Types)
    {
      return false;
    }
    unsigned char difference = 0;
    for (int i = 0; i < count; ++i)
    {
      difference |= this->Types[first + i] ^ type;
    }
    return difference == 0;
  }
  /// Point ids in VTK's order; for a polyhedron its distinct points in no particular order.
  IndexRange GetCellPoints(vtkIdType cell) const
  {
    int block = 0;
    while (cell >= this->FirstCells[block + 1])
    {
      ++block;
    }
    return this->Blocks[block][cell - this->FirstCells[block]];
  }

  ///@{
  /// Of higher-order cells: degrees by VTK's attribute, 0 without; whether points have different
  /// weights.
  std::array<int, 3> GetDegrees(vtkIdType cell) const
  {
    return this->Degrees ? this->ReadDegrees(cell) : std::array<int, 3>();
  }
  bool IsRational(vtkIdType cell) const { return this->Weights && this->HaveOtherWeights(cell); }
  ///@}

  ///@{
  /**
   * GetPolyhedronFaces returns the faces of a cell whose type lists them (CellShape::ListsFaces)
   * as indices for GetPolyhedronFacePoints, which returns the points of a face. Empty for a convex
   * point set without its hull.
   */
  IndexRange GetPolyhedronFaces(vtkIdType cell) const
  {
    return this->FaceLocations.NumberOfLists > 0 ? this->FaceLocations[cell] : IndexRange();
  }
  IndexRange GetPolyhedronFacePoints(vtkIdType face) const { return this->Faces[face]; }
  bool HasPolyhedra() const { return this->Faces.NumberOfLists > 0; }
  ///@}

  ///@{
  /// What is stored: the points of cells (of a vtkPolyData: vertices, lines, polygons, strips), the
  /// points of faces, and the faces of cells. CheckCells makes sure that this is consistent; no
  /// other method does.
  const std::array<IndexLists, 4>& GetCellLists() const { return this->Blocks; }
  const IndexLists& GetFaceLists() const { return this->Faces; }
  const IndexLists& GetFaceLocations() const { return this->FaceLocations; }
  /// 0 for a vtkPolyData, where the type follows from the number of points.
  vtkIdType GetNumberOfTypes() const;
  ///@}

private:
  unsigned char GetPolyDataCellType(vtkIdType cell) const;
  std::array<int, 3> ReadDegrees(vtkIdType cell) const;
  bool HaveOtherWeights(vtkIdType cell) const;

  vtkIdType NumberOfPoints = 0;
  vtkIdType NumberOfCells = 0;
  const float* PointsFloat = nullptr;
  const double* PointsDouble = nullptr;
  vtkSmartPointer<vtkDataArray> PointsOwner;
  const unsigned char* Types = nullptr;
  vtkSmartPointer<vtkUnsignedCharArray> TypesOwner;
  std::array<IndexLists, 4> Blocks;
  std::array<vtkIdType, 5> FirstCells = { { 0, 0, 0, 0, 0 } };
  IndexLists Faces;
  IndexLists FaceLocations;
  vtkSmartPointer<vtkDataArray> Degrees, Weights; // of higher-order cells, of points
};
}

#endif
