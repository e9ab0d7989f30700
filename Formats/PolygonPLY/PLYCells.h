// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PLYCells
 * @brief The cells that elements of a PLY file become: faces, strips of triangles and edges.
 */
#ifndef camaron_PLYCells_h
#define camaron_PLYCells_h

#include "CellMesh/CellMesh.h"
#include "PLYParts.h"

namespace camaron
{
class PLYCells
{
public:
  /**
   * Reads the cells of some elements, whose places in the mesh are set.
   * @param keepsEmpty whether lists without vertices become cells of type VTK_EMPTY_CELL
   * @return false if an error is set, or if stopped
   */
  bool Read(const std::vector<PLYPart*>& parts, vtkIdType numberOfPoints, bool keepsEmpty,
    const Progress& progress);

  CellMesh Mesh;
  Tally Empty;      ///< lists without vertices
  Tally Short;      ///< with one or two
  Tally Degenerate; ///< triangles of strips with a vertex twice, which join parts of a strip

private:
  struct Extent; // of a part, before the mesh is provided
  bool Measure(PLYPart& part, Extent& extent, const Progress& progress);
  bool MeasureStrips(PLYPart& part, Extent& extent, const Progress& progress);
  bool ReadEdges(PLYPart& part, std::int32_t* ids, const Progress& progress);
  void FillStrips(PLYPart& part, const Extent& extent, vtkIdType firstId);
  bool FillPart(PLYPart& part, Extent& extent, vtkIdType firstId, const Progress& progress);
  void CountFaces(PLYPart& part, Extent& extent);

  bool KeepsEmpty = false;
};

/// The lists of all cells as many formats store them: n id1 ... idn.
Buffer<std::int32_t> MakeWords(const CellMesh& mesh);
}

#endif
