// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Parallel.h"

#include <cstdlib>
#include <cstring>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Several MPI ranks on a machine already share its cores. MPI launchers set environment variables.
bool IsOneOfManyRanks()
{
  for (const char* name : { "OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MPI_LOCALNRANKS", "SLURM_NTASKS" })
  {
    const char* value = std::getenv(name);
    if (value && std::atoi(value) > 1)
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
bool NeedsThreads()
{
  static const bool allowed = !std::getenv("VTK_SMP_BACKEND_IN_USE") && !IsOneOfManyRanks();
  const char* backend = vtkSMPTools::GetBackend();
  return allowed && backend && std::strcmp(backend, "Sequential") == 0 &&
    !vtkSMPTools::IsParallelScope();
}
}
