// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::OutputMesh
 * @brief The points and cells that a writer writes, and their origin in the input.
 *
 * Created by ConvertCells. If a format supports all cells of the input, this is a view of the
 * input and nothing is copied. Otherwise it has its own cells; those of type VTK_POLYHEDRON have
 * the faces of their input cell (CellFacets, with GetPointOf for the ids). All methods are
 * thread-safe.
 */
#ifndef camaron_OutputMesh_h
#define camaron_OutputMesh_h

#include "Intake/Ids/IdSet.h"
#include "Mesh/MeshView.h"

#include "vtkDataArray.h"         // for moving the view
#include "vtkUnsignedCharArray.h" // for moving the view

#include <vector> // for cells

namespace camaron
{
class OutputMesh
{
public:
  OutputMesh() = default;
  /// All cells of a vtkUnstructuredGrid or vtkPolyData.
  explicit OutputMesh(vtkDataSet* mesh)
    : Input(mesh)
    , NumberOfPoints(this->Input.GetNumberOfPoints())
    , NumberOfCells(this->Input.GetNumberOfCells())
  {
  }

  const MeshView& GetInput() const { return this->Input; }

  ///@{
  /// Whether points, or cells, are exactly those of the input, so arrays can be written unchanged.
  bool HasInputPoints() const { return this->SamePoints; }
  bool HasInputCells() const { return this->SameCells; }
  ///@}

  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; }
  bool HasFloatPoints() const { return this->Input.HasFloatPoints(); }
  void GetPoint(vtkIdType point, double x[3]) const
  {
    this->Input.GetPoint(this->GetInputPoint(point), x);
  }
  /// The input point of a point.
  vtkIdType GetInputPoint(vtkIdType point) const
  {
    return this->SamePoints ? point : this->InputPoints[point];
  }
  /// The point of an input point, which must be used by a cell here.
  vtkIdType GetPointOf(vtkIdType inputPoint) const
  {
    return this->SamePoints ? inputPoint : this->KeptPoints.GetNumber(inputPoint);
  }

  vtkIdType GetNumberOfCells() const { return this->NumberOfCells; }
  unsigned char GetCellType(vtkIdType cell) const
  {
    return this->SameCells ? this->Input.GetCellType(cell) : this->Types[cell];
  }
  IndexRange GetCellPoints(vtkIdType cell) const
  {
    if (this->SameCells)
    {
      return this->Input.GetCellPoints(cell);
    }
    const vtkIdType begin = this->Offsets[cell];
    IndexRange range;
    range.Values.Values64 = this->Connectivity.data();
    range.Begin = begin;
    range.Size = this->Offsets[cell + 1] - begin;
    return range;
  }
  /// The input cell that a cell is, or is a part of.
  vtkIdType GetInputCell(vtkIdType cell) const
  {
    return this->SameCells ? cell : this->InputCells[cell];
  }
  /// Whether the cells are one vertex per point, in order, as read from a file without cells.
  bool IsCloud() const;
  /// Number of cells of a type.
  vtkIdType Count(unsigned char type) const;

private:
  friend class OutputMeshBuilder;

  MeshView Input;
  vtkIdType NumberOfPoints = 0;
  vtkIdType NumberOfCells = 0;
  bool SamePoints = true;
  bool SameCells = true;
  std::vector<unsigned char> Types;
  std::vector<std::int64_t> Offsets; ///< one entry more than cells
  std::vector<std::int64_t> Connectivity;
  std::vector<std::int64_t> InputCells;
  std::vector<std::int32_t> InputPoints;
  IdSet KeptPoints;
};
}

#endif
