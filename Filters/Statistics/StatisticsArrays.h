// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StatisticsArrays.h
 * @brief Which arrays of a mesh have statistics.
 */
#ifndef camaron_StatisticsArrays_h
#define camaron_StatisticsArrays_h

#include "ElementBlocks.h"

#include <string> // for names
#include <vector> // for lists

namespace camaron
{
/// An array to evaluate, which some process may not have.
struct StatisticsArray
{
  std::string Name;
  std::string Unit;
  bool OfIntegers = true; ///< a count of the registry, or an array of an integer type
};

/// Whether it is of an integer type, or a count of the registry.
bool IsOfIntegers(vtkDataArray* array);

/// Collective. All numeric arrays with one component that any process has, by name, with their
/// units.
std::vector<StatisticsArray> FindArrays(const ElementBlocks& blocks, Reducer& reducer);

/**
 * Those that are wanted, in that order; if none is, those that are named like a criterion, in the
 * order of their table, then those like a measure of faces, edges or vertices that Mesh Elements
 * makes. Each once.
 * @param missing gets the names of those that are wanted and not there
 */
std::vector<StatisticsArray> ChooseArrays(const std::vector<StatisticsArray>& present,
  const std::vector<std::string>& wanted, std::vector<std::string>& missing);
}

#endif
