// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PartialArrays.h
 * @brief Joins arrays that only some parts of a mesh have.
 */
#ifndef camaron_PartialArrays_h
#define camaron_PartialArrays_h

#include "vtkType.h" // for vtkIdType

#include <cstddef>    // for std::size_t
#include <functional> // for the sources
#include <string>     // for names
#include <vector>     // for parts

class vtkDataSetAttributes;

namespace camaron
{
/// Where a point or cell of a mesh comes from.
struct TupleSource
{
  std::size_t Part;
  vtkIdType Tuple;
};

/**
 * Adds to @a merged, of @a size tuples, the numeric arrays of parts that it lacks, by name: those
 * that some parts do not have, which get nan there, or 0 in integers, and those of which parts have
 * different types, as double. Global ids and ghost arrays are none of them.
 * @return the names of those that cannot be joined: of texts or bits, or of different numbers of
 * components
 */
std::vector<std::string> AddPartialArrays(const std::vector<vtkDataSetAttributes*>& parts,
  vtkIdType size, const std::function<TupleSource(vtkIdType)>& getSource,
  vtkDataSetAttributes* merged);
}

#endif
