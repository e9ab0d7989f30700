// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellWriter
 * @brief Builds the cells of a grid one by one, polyhedra with their faces.
 *
 * Add the points of a cell, then the points of each of its faces, if its type lists them.
 */
#ifndef camaron_CellWriter_h
#define camaron_CellWriter_h

#include "Mesh/CellShape.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm> // for std::any_of

namespace camaron
{
class CellWriter
{
public:
  void AddPoint(vtkIdType point) { this->Cells.Add(point); }
  void AddFacePoint(vtkIdType point) { this->Faces.Add(point); }
  void EndFace() { this->CellFaces.Add(this->Faces.End()); }
  void EndCell(unsigned char type)
  {
    this->Cells.End();
    this->CellFaces.End();
    this->Types->InsertNextValue(type);
  }
  /// Sets the cells of a grid, without points.
  void SetCells(vtkUnstructuredGrid* grid) const
  {
    const unsigned char* types = this->Types->GetPointer(0);
    const bool hasFaces = std::any_of(types, types + this->Types->GetNumberOfValues(),
      [](unsigned char type) { return GetCellShape(type).ListsFaces; });
    if (hasFaces)
    {
      grid->SetPolyhedralCells(
        this->Types, this->Cells.Get(), this->CellFaces.Get(), this->Faces.Get());
    }
    else
    {
      grid->SetCells(this->Types, this->Cells.Get());
    }
  }

private:
  /// Lists of ids in the layout of a vtkCellArray.
  class Lists
  {
  public:
    Lists() { this->Offsets->InsertNextValue(0); }
    void Add(vtkIdType item) { this->Items->InsertNextValue(item); }
    /// Returns the index of the list.
    vtkIdType End() { return this->Offsets->InsertNextValue(this->Items->GetNumberOfValues()) - 1; }
    vtkSmartPointer<vtkCellArray> Get() const
    {
      auto cells = vtkSmartPointer<vtkCellArray>::New();
      cells->SetData(this->Offsets, this->Items);
      return cells;
    }

  private:
    vtkNew<vtkTypeInt64Array> Offsets, Items;
  };

  Lists Cells, Faces, CellFaces;
  vtkNew<vtkUnsignedCharArray> Types;
};
}

#endif
