// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceMesh.h
 * @brief A mesh as some formats give it: points, faces as lists of points, cells as lists of faces.
 */
#ifndef camaron_FaceMesh_h
#define camaron_FaceMesh_h

#include "Base/Buffer.h"
#include "Scan/IdLists.h"
#include "Scan/PieceRequest.h"

#include <functional> // for points that are read later

namespace camaron
{
/**
 * Coordinates of type float or double where they are, usually in a mapped file of either byte
 * order.
 */
struct PointSource
{
  const char* Data = nullptr;
  vtkIdType Count = 0;
  bool IsDouble = false;
  bool Swap = false;
  std::ptrdiff_t Stride = 0; ///< bytes from point to point
  const IdSet* Kept =
    nullptr; ///< if given, numbered, only its members are there, one after the other

  PointSource() = default;
  /// @a stride is that of points that follow each other directly if it is not given.
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

  /// Coordinates of a point; zeros if there is no such point, any if it is not kept.
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
  /// The coordinates as they are, of a source of all points: Real is double if IsDouble, else
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
  /// The memory of Points if it is the mesh's own; the grid takes it over where it can.
  Buffer<float> Floats;
  Buffer<double> Doubles;
  ///@}
  /**
   * If given, Points has only their number so far, as those of a piece are read when it is known
   * which they are: fills the coordinates, in single precision, of the members of a numbered set,
   * one after the other; false if they are no longer there, or if stopped.
   */
  std::function<bool(const IdSet& points, float* coordinates, const Progress& progress)> ReadPoints;
  IdLists Faces;
  IdLists Cells;

  /// Faces that some cell has; only if there are cells.
  IdSet FacesOfCells;
  /// Points that some face has; only if a piece of the mesh is asked for.
  IdSet PointsOfFaces;
  /// Whether there are faces without points, which are in no grid.
  bool HasEmptyFaces = false;
};
}

#endif
