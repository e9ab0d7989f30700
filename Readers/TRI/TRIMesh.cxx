// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TRIMesh.h"

#include "Intake/CellMesh/CellGrid.h"

#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

namespace camaron
{
//------------------------------------------------------------------------------
void TRIMesh::Finish(const PieceRequest& request, bool hasMore, vtkUnstructuredGrid* grid,
  Warnings& warnings, const Progress& progress)
{
  if (request.Piece == 0)
  {
    this->Piece.WarnOfRepeatedPoints(this->Cells, warnings, progress, "triangle", "triangles");
    if (hasMore)
    {
      warnings.Add("there is more data after the end of the mesh");
    }
  }
  FillGrid(this->Cells, this->Piece, this->Points, grid);
  if (this->Components)
  {
    this->Components->SetName("Component");
    grid->GetCellData()->AddArray(this->Components);
  }
  if (this->Scalars)
  {
    this->Scalars->SetName("Scalars");
    grid->GetPointData()->AddArray(this->Scalars);
  }
}
}
