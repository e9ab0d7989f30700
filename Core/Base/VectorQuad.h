// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VectorQuad.h
 * @brief SIMD: four numbers or vectors at a time, if processor and compiler support them.
 *
 * As VectorPair.h, with the same result in each lane. Only for functions marked
 * CAMARON_WITH_QUADS, which may only be called if UsesVectorQuads is set.
 */
#ifndef camaron_VectorQuad_h
#define camaron_VectorQuad_h

#include "Base/VectorPair.h"

// Clang rejects such vectors as arguments of functions compiled for generic processors, even if
// inlined.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#define CAMARON_HAS_QUADS 1
/// Inline functions called by these functions are inlined into them, and so use AVX2, too.
#define CAMARON_WITH_QUADS __attribute__((target("avx2"), flatten))

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi" // the calling convention of quads does not matter, because
                                         // they are never passed
namespace camaron
{
using Quad = double __attribute__((vector_size(4 * sizeof(double))));

inline Quad Sqrt(const Quad& a)
{
  const Pair low = Sqrt(Pair{ a[0], a[1] }), high = Sqrt(Pair{ a[2], a[3] });
  return Quad{ low[0], low[1], high[0], high[1] };
}

inline Quad TurnSign(const Quad& a, const Quad& sign)
{
  using Bits = long long __attribute__((vector_size(4 * sizeof(long long))));
  constexpr Quad zero = {}, signs = { -0.0, -0.0, -0.0, -0.0 };
  return (Quad)((Bits)a ^ ((Bits)(sign < zero) & (Bits)signs));
}
}
#pragma GCC diagnostic pop
#else
#define CAMARON_WITH_QUADS
namespace camaron
{
using Quad = Pair; // UsesVectorQuads is not set
}
#endif

namespace camaron
{
inline bool HasVectorQuads()
{
#if defined(CAMARON_HAS_QUADS)
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

/// Whether the processor has AVX2. Tests disable it.
inline bool UsesVectorQuads = HasVectorQuads();
}

#endif
