// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::InwardFaces
 * @brief Finds the inward faces of a cell, regardless of their orientation in the mesh.
 *
 * Connected faces are oriented consistently, then outward by the volume that they enclose, or
 * inward if they bound a void; for a cell that is not closed, each connected part separately.
 * Holds scratch memory: use one object per thread.
 */
#ifndef camaron_InwardFaces_h
#define camaron_InwardFaces_h

#include "Base/LocalNumbers.h"
#include "Mesh/CellTopology.h"
#include "Mesh/MeshView.h"

#include <vector> // for scratch

namespace camaron
{
class ClosedShell;

class InwardFaces
{
public:
  explicit InwardFaces(const MeshView& mesh)
    : Mesh(mesh)
  {
  }

  /// Starts a new cell.
  void Clear();
  void AddFace(const vtkIdType* points, vtkIdType size);
  /// For every face, in the order in which they were added, 1 if its given orientation is inward,
  /// else 0.
  const std::vector<unsigned char>& Find();

private:
  void AddTriangles(int face, ClosedShell& shell) const;

  const MeshView& Mesh;
  std::vector<vtkIdType> Ids;
  std::vector<int> Offsets, Numbers;
  LocalNumbers Numbering;
  CellTopology Topology;
  std::vector<unsigned char> AreInward;
};
}

#endif
