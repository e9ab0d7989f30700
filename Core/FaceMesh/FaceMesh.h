// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceMesh.h
 * @brief A mesh as some formats give it: points, faces as lists of points, cells as lists of faces.
 */
#ifndef camaron_FaceMesh_h
#define camaron_FaceMesh_h

#include "Scan/IdLists.h"
#include "Scan/PieceRequest.h"

namespace camaron
{
/// Float coordinates where they are, usually in a mapped file of either byte order.
struct FloatPoints
{
  const char* Data = nullptr;
  vtkIdType Count = 0;
  bool Swap = false;
  void Get(vtkIdType id, double x[3]) const
  {
    const char* place = this->Data + 12 * id;
    x[0] = Load<float>(place, this->Swap);
    x[1] = Load<float>(place + 4, this->Swap);
    x[2] = Load<float>(place + 8, this->Swap);
  }
};

struct FaceMesh
{
  FloatPoints Points;
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
