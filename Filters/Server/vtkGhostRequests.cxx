// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGhostRequests.h"

#include "vtkObjectFactory.h"
#include "vtkProcessModule.h"

vtkStandardNewMacro(vtkGhostRequests);

//------------------------------------------------------------------------------
void vtkGhostRequests::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Layers: " << this->GetLayers() << '\n';
}

//------------------------------------------------------------------------------
void vtkGhostRequests::SetLayers(int layers)
{
  vtkProcessModule::SetDefaultMinimumGhostLevelsToRequestForUnstructuredPipelines(layers);
}

//------------------------------------------------------------------------------
int vtkGhostRequests::GetLayers() const
{
  return vtkProcessModule::GetDefaultMinimumGhostLevelsToRequestForUnstructuredPipelines();
}
