// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGhostRequests.h"

#include "vtkObjectFactory.h"
#include "vtkProcessModule.h"

vtkStandardNewMacro(vtkGhostRequests);

//------------------------------------------------------------------------------
void vtkGhostRequests::SetLayers(int layers)
{
  vtkProcessModule::SetDefaultMinimumGhostLevelsToRequestForUnstructuredPipelines(layers);
}
