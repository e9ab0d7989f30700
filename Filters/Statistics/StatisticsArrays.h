// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StatisticsArrays.h
 * @brief Chooses the arrays of a mesh for which statistics are computed.
 */
#ifndef camaron_StatisticsArrays_h
#define camaron_StatisticsArrays_h

#include "ElementBlocks.h"

#include <string> // for names
#include <vector> // for lists

namespace camaron
{
/// An array to evaluate, which may exist on some processes only.
struct StatisticsArray
{
  std::string Name;
  std::string Unit;
  bool OfIntegers = true; ///< see the function IsOfIntegers
};

/// Whether the array has an integer type, or its criterion is a count or a code.
bool IsOfIntegers(vtkDataArray* array);

/// Collective. All one-component numeric arrays on any process, by name, with their units.
std::vector<StatisticsArray> FindArrays(const ElementBlocks& blocks, Reducer& reducer);

/**
 * The arrays in @a wanted, in that order, each once. If @a wanted is empty: the arrays named like a
 * criterion, in the order of the table of criteria, then those named like a measure of faces, edges
 * or vertices of vtkMeshElements.
 *
 * @param missing receives the names in @a wanted that are not in @a present
 */
std::vector<StatisticsArray> ChooseArrays(const std::vector<StatisticsArray>& present,
  const std::vector<std::string>& wanted, std::vector<std::string>& missing);
}

#endif
