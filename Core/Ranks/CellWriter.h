// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellWriter
 * @brief Makes a grid of cells of a mesh and of cells that other processes have sent.
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

/// A cell of another piece, in the words of its message.
struct AddedCell
{
  std::int64_t Id;
  PieceAt From;
  unsigned char Type, Ghosts;
  const std::int64_t* Lists; ///< its points, then its faces: numbers, each after how many follow
  const double* Values;
  std::size_t Message;
};

class CellWriter
{
public:
  void AddOwn(const MeshView& mesh, vtkIdType cell);
  /// @a points: the numbers that the points of its message have here.
  void AddAdded(const AddedCell& cell, const std::vector<vtkIdType>& points);
  /// Without points yet.
  vtkSmartPointer<vtkUnstructuredGrid> Get() const;

private:
  /// Lists of points as a vtkCellArray has them.
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
