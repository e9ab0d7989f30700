// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Parallel.h"

#include <cstdlib>
#include <cstring>

namespace camaron
{
//------------------------------------------------------------------------------
bool NeedsThreads()
{
  // GetBackend first makes VTK read the environment.
  const char* backend = vtkSMPTools::GetBackend();
  return backend && std::strcmp(backend, "Sequential") == 0 &&
    !std::getenv("VTK_SMP_BACKEND_IN_USE") && !vtkSMPTools::IsParallelScope();
}
}
