// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RepeatedIds.h
 * @brief Whether a list contains an id more than once.
 */
#ifndef camaron_RepeatedIds_h
#define camaron_RepeatedIds_h

#include "vtkType.h" // for vtkIdType

#include <cstdint> // for ids

namespace camaron
{
/// For a list of any length.
bool HasRepeatedIdsAnywhere(const std::int32_t* ids, vtkIdType size);

/// The same, faster for three and four ids, which are by far the most frequent in large meshes.
inline bool HasRepeatedIds(const std::int32_t* ids, vtkIdType size)
{
  if (size == 3 || size == 4)
  {
    const std::int32_t a = ids[0], b = ids[1], c = ids[2], d = ids[size - 1];
    const bool isFourth = (size == 4) & ((a == d) | (b == d) | (c == d));
    return (a == b) | (a == c) | (b == c) | isFourth;
  }
  return HasRepeatedIdsAnywhere(ids, size);
}
}

#endif
