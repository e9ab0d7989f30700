// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FaceOrientation
 * @brief Orients the faces of polyhedra for formats in which the cells of a face are on either side
 * of it.
 *
 * Polyhedra whose faces are oriented consistently, inward or outward, keep their faces, as do all
 * other cells. The faces of others are oriented consistently, and outward. So it is with every cell
 * of a mesh if a reader gives a face to both of its cells without reversing it.
 */
#ifndef camaron_FaceOrientation_h
#define camaron_FaceOrientation_h

#include "Mesh/MeshTopology.h"
#include "Scan/ScanError.h"

#include <vector> // for flags

namespace camaron
{
class FaceOrientation
{
public:
  /// Orients the polyhedra of a mesh, which must stay alive.
  explicit FaceOrientation(const MeshTopology& topology);

  /// Whether a cell of a face traverses it inward of itself where the first cell traverses it
  /// outward; false for the first cell itself, unless it was reversed.
  bool IsReversed(Index face, vtkIdType cell) const;

  /// Polyhedra with edges that do not belong to two faces; they keep their faces.
  const Tally& GetOpenCells() const { return this->Open; }

private:
  const FacetTable& Faces;
  ///@{
  /// For the first, and the second, cell of each face, if any was reversed.
  std::vector<unsigned char> ReversedInFirst, ReversedInSecond;
  ///@}
  Tally Open;
};
}

#endif
