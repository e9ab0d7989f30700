// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Sanitized.h
 * @brief How much a test does under AddressSanitizer, where it runs some ten times slower and once
 * more.
 */
#ifndef camaron_Sanitized_h
#define camaron_Sanitized_h

namespace camaron
{
namespace testing
{
#if defined(__SANITIZE_ADDRESS__)
constexpr bool IsSanitized = true;
#else
constexpr bool IsSanitized = false;
#endif

/// How often a test repeats with other random input: an eighth of @a times under a sanitizer.
constexpr int Often(int times)
{
  return IsSanitized ? times / 8 : times;
}
}
}

#endif
