// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/VectorQuad.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool HasVectorQuads()
{
#if defined(CAMARON_HAS_QUADS)
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}
}

bool UsesVectorQuads = HasVectorQuads();
}
