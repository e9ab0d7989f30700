// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellMeshFileWriter.h"

//------------------------------------------------------------------------------
void vtkCellMeshFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UnsupportedCells: " << this->UnsupportedCells << "\n";
}
