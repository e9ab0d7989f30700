// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CountOf.h
 * @brief Counts in messages, in the singular or the plural.
 */
#ifndef camaron_CountOf_h
#define camaron_CountOf_h

#include "vtkType.h" // for vtkIdType

#include <string>      // for messages
#include <string_view> // for words

namespace camaron
{
/// "1 node" or "12 nodes".
inline std::string CountOf(vtkIdType count, std::string_view one, std::string_view many)
{
  return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}
}

#endif
