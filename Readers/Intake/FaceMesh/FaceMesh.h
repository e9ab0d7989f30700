// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceMesh.h
 * @brief A mesh as some formats store it: points, faces as lists of points, cells as lists of
 * faces.
 */
#ifndef camaron_FaceMesh_h
#define camaron_FaceMesh_h

#include "Base/Buffer.h"
#include "Intake/Pieces/PieceRequest.h"
#include "Intake/Rows/IdLists.h"

#include <functional> // for points that are read later

namespace camaron
{
/**
 * Coordinates of type float or double in place, usually in a memory-mapped file of either byte
 * order.
 */
struct PointSource
{
  const char* Data = nullptr;
  vtkIdType Count = 0;
  bool IsDouble = false;
  bool Swap = false;
  std::ptrdiff_t Stride = 0; ///< bytes between points
  const IdSet* Kept =
    nullptr; ///< optional: only the members of this numbered set are stored, one after the other

  PointSource() = default;
  /// @param stride by default, that of contiguous points
  PointSource(
    const char* data, vtkIdType count, bool isDouble, bool swap = false, std::ptrdiff_t stride = 0)
    : Data(data)
    , Count(count)
    , IsDouble(isDouble)
    , Swap(swap)
    , Stride(stride > 0 ? stride
          : isDouble    ? 24
                        : 12)
  {
  }

  /// Coordinates of a point; zeros for an invalid id, arbitrary if the point is not stored.
  void Get(vtkIdType id, double x[3]) const
  {
    id = this->Kept ? this->Kept->GetNumber(id) : id;
    if (static_cast<std::uint64_t>(id) >= static_cast<std::uint64_t>(this->Count))
    {
      x[0] = x[1] = x[2] = 0;
      return;
    }
    const char* place = this->Data + this->Stride * id;
    if (this->IsDouble)
    {
      Load3<double>(place, this->Swap, x);
    }
    else
    {
      Load3<float>(place, this->Swap, x);
    }
  }
  /// The unconverted coordinates, for a source of all points: Real is double if IsDouble, else
  /// float.
  template <typename Real>
  void GetAs(vtkIdType id, Real x[3]) const
  {
    Load3<Real>(this->Data + this->Stride * id, this->Swap, x);
  }

private:
  template <typename Real, typename Value>
  static void Load3(const char* place, bool swap, Value x[3])
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      x[c] = Load<Real>(place + c * sizeof(Real), swap);
    }
  }
};

struct FaceMesh
{
  PointSource Points;
  ///@{
  /// The memory of Points if the mesh owns it; the grid takes it over if possible.
  Buffer<float> Floats;
  Buffer<double> Doubles;
  ///@}
  /**
   * If set, Points only has their number, because the points of a piece are read when they are
   * known: passes the single-precision coordinates of the members of a set, or of all points
   * without a set, in any order, from any thread; false if they no longer exist, or if stopped.
   */
  using PutPoint = std::function<void(vtkIdType point, const float* coordinates)>;
  std::function<bool(const IdSet* points, const PutPoint& put, const Progress& progress)>
    ReadPoints;
  IdLists Faces;
  IdLists Cells;
  ///@{
  /// The memory of these lists if the mesh owns it.
  Buffer<std::int32_t> FaceWords;
  Buffer<std::int32_t> CellWords;
  ///@}

  ///@{
  /**
   * Of formats that name the cells on both sides of every face, two ids each, -1 for none. By the
   * right-hand rule, the normal of a face points into the first cell; in 2D, this is on the left of
   * an edge. So an inverted cell stays inverted.
   */
  bool HasSides = false;
  Buffer<std::int32_t> Sides;
  /// Declared types of cells, or VTK_EMPTY_CELL if unknown; only together with Sides.
  Buffer<unsigned char> Types;
  /// 2 if faces are edges, and cells are polygons.
  int Dimension = 3;
  ///@}

  /// Faces that belong to a cell; only if there are cells.
  IdSet FacesOfCells;
  /// Points that belong to a face; only if a piece of the mesh is requested.
  IdSet PointsOfFaces;
  /// Whether there are faces without points, which grids omit.
  bool HasEmptyFaces = false;

  ///@{
  /// What to expect of the lists Faces and Cells. Scanning or opening them then fills the sets
  /// above, so the mesh must not move in between.
  IdLists::Expectation ExpectFaces(vtkIdType numberOfPoints, const PieceRequest& request)
  {
    IdLists::Expectation expected;
    expected.List = "face";
    expected.Id = "point";
    expected.Limit = numberOfPoints;
    expected.FindsRepeating = true;
    if (request.NumberOfPieces > 1)
    {
      this->PointsOfFaces = IdSet(numberOfPoints);
      expected.Used = &this->PointsOfFaces;
      expected.AccessAll = false; // those of a piece are located when it is known
    }
    return expected;
  }
  IdLists::Expectation ExpectCells(vtkIdType numberOfFaces)
  {
    IdLists::Expectation expected;
    expected.List = "cell";
    expected.Id = "face";
    expected.Limit = numberOfFaces;
    expected.AccessAll = false; // they are visited in order
    this->FacesOfCells = IdSet(numberOfFaces);
    expected.Used = &this->FacesOfCells;
    return expected;
  }
  ///@}
};
}

#endif
