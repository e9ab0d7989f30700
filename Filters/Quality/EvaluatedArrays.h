// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::EvaluatedArrays
 * @brief Values of criteria from the last evaluation, as long as the mesh and the options are those
 * of it.
 *
 * So that one more criterion costs only that one, and none at each time step of a mesh that stays
 * what it is. The arrays are those of the last output, not copies.
 */
#ifndef camaron_EvaluatedArrays_h
#define camaron_EvaluatedArrays_h

#include "Cell/CellGeometry.h"
#include "ElementBlocks.h"
#include "Mesh/ConnectivityKey.h"
#include "Ranks/Reducer.h"

#include "vtkDoubleArray.h"  // for the values
#include "vtkSmartPointer.h" // for the values

#include <cstdint> // for what is in the arrays
#include <map>     // for the criteria
#include <string>  // for their names
#include <vector>  // for the data sets

namespace camaron
{
class EvaluatedArrays
{
public:
  /// Of all data sets in their order.
  using Arrays = std::vector<vtkSmartPointer<vtkDoubleArray>>;

  /// Collective. Forgets all arrays unless they are still right, on all processes.
  void Check(const std::vector<DataSetLeaf>& leaves, const EvaluationOptions& options,
    bool connectsBlocks, int numberOfPieces, Reducer& reducer);
  void Clear();

  /// Those of a criterion; none if it has not been evaluated.
  const Arrays* Find(const std::string& criterion) const;
  /// Takes the place of all arrays; after Check.
  void Keep(std::map<std::string, Arrays> arrays);

private:
  /// What the values of a data set come from.
  struct Source
  {
    std::vector<ConnectivityKey::ArrayAt> Arrays;
    vtkMTimeType Time = 0; // of the data set, if it has no points of its own
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
  std::uint64_t Content = 0; // of the arrays, which others may write to
};
}

#endif
