// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ConnectivityKey
 * @brief Tells whether the cells of a mesh are those that were seen before.
 *
 * By the arrays that hold them, their times, their sizes and what is in them: cells that are
 * inserted in place, and values that are changed there, leave no trace in the time of an array. The
 * content is looked at only where the data set itself has not been seen at this time.
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
  /// An array, its time and its number of values.
  using ArrayAt = std::tuple<vtkObject*, vtkMTimeType, vtkIdType>;

  explicit ConnectivityKey(vtkDataSet* mesh);

  /// None if there are no cells.
  const std::vector<ArrayAt>& GetArrays() const { return this->Arrays; }

  /**
   * Whether the mesh, which must live, has the cells of a key from before. Where that one has not
   * learned its content, this is taken for it.
   */
  bool IsOf(ConnectivityKey& known);

  /// Looks at the content, once, as long as the mesh lives.
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
