// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellMesh.h
 * @brief A mesh as most formats store it: cells of known types as lists of points.
 */
#ifndef camaron_CellMesh_h
#define camaron_CellMesh_h

#include "Base/Buffer.h"
#include "Base/Progress.h"
#include "Scan/ScanError.h"

#include "vtkCellType.h" // for the types of cells

#include <cstdint>  // for integers of known size
#include <optional> // for what is perhaps known

namespace camaron
{
/**
 * Cells are in the order of the file, their points in VTK's order for their type. If all cells
 * have the same type, Types is empty and CommonType is set; if all have the same number of points,
 * Offsets is empty and CommonSize is set.
 */
struct CellMesh
{
  vtkIdType NumberOfPoints = 0;
  vtkIdType NumberOfCells = 0;
  unsigned char CommonType = VTK_EMPTY_CELL;
  std::int32_t CommonSize = 0;
  Buffer<unsigned char> Types;       ///< one per cell, or empty
  Buffer<std::int32_t> Offsets;      ///< one per cell and one more, or empty
  Buffer<std::int32_t> Connectivity; ///< point indices
  std::optional<Tally> Repeating;    ///< cells with a repeated point, if they have been counted

  CellMesh() = default;
  /// Cells of one type with @a size points each; their points must be filled in.
  CellMesh(vtkIdType numberOfPoints, vtkIdType numberOfCells, unsigned char type, std::int32_t size)
    : NumberOfPoints(numberOfPoints)
    , NumberOfCells(numberOfCells)
    , CommonType(type)
    , CommonSize(size)
    , Connectivity(numberOfCells * size)
  {
  }

  unsigned char GetType(vtkIdType cell) const
  {
    return this->Types.size() > 0 ? this->Types[cell] : this->CommonType;
  }
  vtkIdType GetBegin(vtkIdType cell) const
  {
    return this->Offsets.size() > 0 ? this->Offsets[cell] : cell * this->CommonSize;
  }
  vtkIdType GetSize(vtkIdType cell) const
  {
    return this->Offsets.size() > 0 ? this->Offsets[cell + 1] - this->Offsets[cell]
                                    : this->CommonSize;
  }
  const std::int32_t* GetPoints(vtkIdType cell) const
  {
    return this->Connectivity.data() + this->GetBegin(cell);
  }
};

/// One VTK_VERTEX per point.
CellMesh MakeCloud(vtkIdType numberOfPoints);

/**
 * Finds cells with a repeated point among consecutive cells.
 * @param points of all of them
 * @param offsets of them and one more, or nullptr if all have the same size
 * @param first index of the first cell
 */
void FindRepeatedPoints(const std::int32_t* points, const std::int32_t* offsets, std::int32_t size,
  vtkIdType first, vtkIdType count, Tally& repeating);
}

#endif
