// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ConnectivityKey
 * @brief Detects whether a mesh has the same cells as one seen before.
 *
 * Compares the connectivity arrays, their modification times, sizes and contents: inserting cells
 * or changing values in place does not modify the time of an array. The contents are only hashed
 * if the data set has not been seen at its current modification time.
 */
#ifndef camaron_ConnectivityKey_h
#define camaron_ConnectivityKey_h

#include "vtkType.h" // for vtkMTimeType

#include <cstdint> // for the content
#include <tuple>   // for arrays
#include <utility> // for std::pair
#include <vector>  // for arrays

class vtkCellArray;
class vtkDataArray;
class vtkDataSet;
class vtkObject;

namespace camaron
{
class ConnectivityKey
{
public:
  /// An array, its modification time and its number of values.
  using ArrayAt = std::tuple<vtkObject*, vtkMTimeType, vtkIdType>;

  explicit ConnectivityKey(vtkDataSet* mesh);

  /// Empty if there are no cells.
  const std::vector<ArrayAt>& GetArrays() const { return this->Arrays; }

  /**
   * Whether the mesh, which must still exist, has the cells of an earlier key. If that key has no
   * content hash yet, it takes over this one.
   */
  bool IsOf(ConnectivityKey& known);

  /// Hashes the contents, once. The mesh must still exist.
  void Learn();

private:
  using DataSetAt = std::pair<vtkDataSet*, vtkMTimeType>;

  void Add(vtkCellArray* cells);
  void Add(vtkDataArray* array);

  std::vector<ArrayAt> Arrays;
  bool HasContent = false;
  std::uint64_t Content = 0;
  std::vector<DataSetAt> DataSets; // the last ones seen with this content
};
}

#endif
