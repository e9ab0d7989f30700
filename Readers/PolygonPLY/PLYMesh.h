// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PLYMesh
 * @brief Builds a grid from the elements of a PLY file.
 *
 * First all elements are located; then the cells are read, which determine the points and cells of
 * a piece; then everything else, directly into the arrays of the grid.
 */
#ifndef camaron_PLYMesh_h
#define camaron_PLYMesh_h

#include "Intake/Pieces/PieceRequest.h"
#include "PLYArrays.h"
#include "PLYParts.h"

class vtkUnstructuredGrid;

namespace camaron
{
struct FaceMesh;

class PLYMesh
{
public:
  PLYMesh(const PLYHeader& header, const PieceRequest& request, vtkUnstructuredGrid* grid)
    : Header(header)
    , Request(request)
    , Grid(grid)
  {
  }

  /// Every call starts anew; false with the error in the scanner of the rows or in Error.
  bool Read(TableScanner& scanner, RowLayout layout, const Progress& progress);

  Warnings Messages;
  ScanError Error; ///< does not name the file

private:
  PLYPart* FindPart(PLYRole role);
  bool ReadCells(const Progress& progress);
  bool ReadPolyhedra(const Progress& progress);
  vtkIdType NumberFaces(
    const FaceMesh& mesh, const std::vector<PLYPart*>& faceParts, vtkIdType numberOfCells);
  bool ReadCellArrays(const std::vector<PLYPart*>& parts, vtkIdType tuples,
    const TableTargets& targets, PLYArrays& arrays, const Progress& progress);
  bool ReadOthers(const Progress& progress);
  bool ShapeLists(PLYPart& part, const Progress& progress);
  void WarnOfCells(const std::vector<PLYPart*>& parts);

  const PLYHeader& Header;
  PieceRequest Request;
  vtkUnstructuredGrid* Grid;
  std::vector<PLYPart> Parts;
};
}

#endif
