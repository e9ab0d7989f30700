// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/CellWriter.h"

#include "Mesh/CellShape.h"

#include "vtkUnstructuredGrid.h"

namespace camaron
{
//------------------------------------------------------------------------------
bool ListsFaces(unsigned char type)
{
  return GetCellShape(type).ListsFaces;
}

//------------------------------------------------------------------------------
void CellWriter::AddOwn(const MeshView& mesh, vtkIdType cell)
{
  const auto add = [this](Lists& lists, const IndexRange& points)
  {
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      lists.Add(points[i]);
    }
    return lists.Close();
  };
  const unsigned char type = mesh.GetCellType(cell);
  add(this->Cells, mesh.GetCellPoints(cell));
  if (ListsFaces(type))
  {
    const IndexRange faces = mesh.GetPolyhedronFaces(cell);
    for (vtkIdType f = 0; f < faces.Size; ++f)
    {
      this->CellFaces.Add(add(this->Faces, mesh.GetPolyhedronFacePoints(faces[f])));
    }
  }
  this->Close(type);
}

//------------------------------------------------------------------------------
void CellWriter::AddAdded(const AddedCell& cell, const std::vector<vtkIdType>& points)
{
  const std::int64_t* item = cell.Lists;
  const auto add = [&](Lists& lists)
  {
    for (const std::int64_t* last = item + 1 + *item; ++item != last;)
    {
      lists.Add(points[static_cast<std::size_t>(*item)]);
    }
    return lists.Close();
  };
  add(this->Cells);
  if (ListsFaces(cell.Type))
  {
    const std::int64_t numberOfFaces = *item++;
    for (std::int64_t f = 0; f < numberOfFaces; ++f)
    {
      this->CellFaces.Add(add(this->Faces));
    }
  }
  this->Close(cell.Type);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> CellWriter::Get() const
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  if (this->HasFaces)
  {
    grid->SetPolyhedralCells(
      this->Types, this->Cells.Get(), this->CellFaces.Get(), this->Faces.Get());
  }
  else
  {
    grid->SetCells(this->Types, this->Cells.Get());
  }
  return grid;
}

//------------------------------------------------------------------------------
void CellWriter::Close(unsigned char type)
{
  this->CellFaces.Close();
  this->Types->InsertNextValue(type);
  this->HasFaces = this->HasFaces || ListsFaces(type);
}
}
