// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellWriter
 * @brief Builds a grid from cells of a mesh and cells received from other ranks.
 */
#ifndef camaron_CellWriter_h
#define camaron_CellWriter_h

#include "Mesh/MeshView.h"
#include "Ranks/SharedPoints.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <cstdint> // for messages
#include <vector>  // for points

class vtkUnstructuredGrid;

namespace camaron
{
/// Whether cells of a type list their faces; see CellShape.
bool ListsFaces(unsigned char type);

/// A cell of another piece, as encoded in its message.
struct AddedCell
{
  std::int64_t Id;
  PieceAt From;
  unsigned char Type, Ghosts;
  const std::int64_t* Lists; ///< its points, then its faces, as point numbers, each list preceded
                             ///< by its size
  const double* Values;
  std::size_t Message;
};

class CellWriter
{
public:
  void AddOwn(const MeshView& mesh, vtkIdType cell);
  /// @param points maps point numbers of the message to points of this grid
  void AddAdded(const AddedCell& cell, const std::vector<vtkIdType>& points);
  /// The grid, without points.
  vtkSmartPointer<vtkUnstructuredGrid> Get() const;

private:
  /// Lists of points in the layout of a vtkCellArray.
  class Lists
  {
  public:
    Lists() { this->Offsets->InsertNextValue(0); }
    void Add(vtkIdType item) { this->Items->InsertNextValue(item); }
    vtkIdType Close()
    {
      this->Offsets->InsertNextValue(this->Items->GetNumberOfValues());
      return this->Offsets->GetNumberOfValues() - 2;
    }
    vtkSmartPointer<vtkCellArray> Get() const
    {
      auto cells = vtkSmartPointer<vtkCellArray>::New();
      cells->SetData(this->Offsets, this->Items);
      return cells;
    }

  private:
    vtkNew<vtkTypeInt64Array> Offsets, Items;
  };

  void Close(unsigned char type);

  Lists Cells, Faces, CellFaces;
  vtkNew<vtkUnsignedCharArray> Types;
  bool HasFaces = false;
};
}

#endif
