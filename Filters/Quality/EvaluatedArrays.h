// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::EvaluatedArrays
 * @brief Values of criteria from the last evaluation, valid while mesh and options stay the same.
 *
 * Adding a criterion then only costs that criterion, and time steps of an unchanged mesh cost
 * nothing. The arrays are shared with the last output, not copied.
 */
#ifndef camaron_EvaluatedArrays_h
#define camaron_EvaluatedArrays_h

#include "Cell/CellGeometry.h"
#include "ElementBlocks.h"
#include "Mesh/ConnectivityKey.h"
#include "Ranks/Reducer.h"

#include "vtkDoubleArray.h"  // for the values
#include "vtkSmartPointer.h" // for the values

#include <cstdint> // for hashes
#include <map>     // for the criteria
#include <string>  // for their names
#include <vector>  // for the data sets

namespace camaron
{
class EvaluatedArrays
{
public:
  /// The arrays of a criterion, one for each data set, in order.
  using Arrays = std::vector<vtkSmartPointer<vtkDoubleArray>>;

  /// Collective. Discards all arrays if they are no longer valid on some process.
  void Check(const std::vector<DataSetLeaf>& leaves, const EvaluationOptions& options,
    bool connectsBlocks, int numberOfPieces, Reducer& reducer);
  void Clear();

  /// The arrays of a criterion, or nullptr if it has not been evaluated.
  const Arrays* Find(const std::string& criterion) const;
  /// Replaces all arrays. Call Check before.
  void Keep(std::map<std::string, Arrays> arrays);

private:
  /// The origin of the values of a data set, for comparison.
  struct Source
  {
    std::vector<ConnectivityKey::ArrayAt> Arrays;
    vtkMTimeType Time = 0; // of the data set if it has implicit points
    std::uint64_t Points = 0;
    int Block = 0;
    bool operator==(const Source& other) const;
  };
  struct Choice
  {
    EvaluationOptions Options;
    bool ConnectsBlocks = false;
    int NumberOfPieces = 0;
    bool operator==(const Choice& other) const;
  };

  static Source GetSource(const DataSetLeaf& leaf);
  std::uint64_t HashValues() const;

  std::vector<Source> Sources;
  Choice Chosen;
  std::map<std::string, Arrays> Kept;
  std::uint64_t Content = 0; // hash of the arrays, which others may modify
};
}

#endif
