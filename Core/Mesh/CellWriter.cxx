// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CellWriter.h"

#include "Mesh/CellShape.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
//------------------------------------------------------------------------------
void CellWriter::SetCells(vtkUnstructuredGrid* grid) const
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
}
