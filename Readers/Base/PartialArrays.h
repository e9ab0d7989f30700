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
 * Adds to @a merged, which has @a size tuples, the numeric arrays of the parts that it lacks.
 * Arrays that some parts lack are filled with NaN there (0 for integers); arrays whose types differ
 * between parts become double. Global ids and ghost arrays are skipped.
 * @return names of arrays that cannot be joined: strings, bits, or different numbers of components
 */
std::vector<std::string> AddPartialArrays(const std::vector<vtkDataSetAttributes*>& parts,
  vtkIdType size, const std::function<TupleSource(vtkIdType)>& getSource,
  vtkDataSetAttributes* merged);
}

#endif
