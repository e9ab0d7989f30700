// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Strategy.h
 * @brief The selection strategies of vtkSelectElements: one function each, and their table.
 *
 * To add a strategy: write its function in a new file in this folder, declare it in
 * StrategyTable.cxx, and add its row there. Its parameters, if any, are members of
 * SelectionParameters and properties of vtkSelectElements.
 */
#ifndef camaron_Strategy_h
#define camaron_Strategy_h

#include "AcceptableRanges.h"
#include "Base/Parallel.h"
#include "DistributedMesh.h"
#include "ElementBlocks.h"
#include "Selection/Growth.h"
#include "Selection/KindChange.h"
#include "Selection/SharedElements.h"
#include "SelectionParameters.h"

#include <memory> // for the pieces
#include <string> // for parameters
#include <vector> // for marks

class vtkQualityAlgorithm;
class vtkSelection;

namespace camaron
{
/// The inputs of vtkSelectElements; only the mesh is required.
struct SelectionInputs
{
  vtkDataObject* Mesh = nullptr;
  vtkSelection* Selection = nullptr;
  vtkDataObject* Surface = nullptr;
  vtkDataObject* Elements = nullptr;
  vtkQualityAlgorithm* Filter = nullptr; ///< whose abort ends the filters of a strategy
};

/// For each block of the input a list with 1 for selected elements and 0 for others.
using SelectionMarks = std::vector<std::vector<unsigned char>>;

/// Marks for all elements, initially 0.
SelectionMarks MakeMarks(const ElementBlocks& blocks);

/// The mesh and the parameters that a strategy works with.
class SelectionTask
{
public:
  /// Collective. Stores references to all arguments except @a inputs. @a numberOfRequestedPieces:
  /// see DistributedMesh.
  SelectionTask(const SelectionParameters& parameters, const SelectionInputs& inputs,
    const ElementBlocks& blocks, int numberOfRequestedPieces, camaron::Reducer& reducer);

  const SelectionParameters& Parameters;
  const SelectionInputs Inputs;
  const ElementBlocks& Blocks;
  SelectionMarks Current; ///< the current selection, without ghosts; set after construction
  camaron::Reducer& Reducer;

  /// For each block and element the number of failed criteria, if the strategy counts them.
  mutable std::vector<std::vector<int>> FailedCriteriaCounts;

  /// Array or PointArray, according to the element type, or its default if it is empty; see
  /// vtkSelectElements::SetArray. Empty if there is no array.
  const std::string& GetArrayName() const { return this->ArrayName; }
  int GetNumberOfRequestedPieces() const { return this->NumberOfRequestedPieces; }
  bool HasCells() const { return this->Blocks.GetKind() == ElementKind::Cells; }
  ///@{
  /// Collective. The blocks as meshes: piece i is block i. Created at the first call. The pieces of
  /// GetLinkedPieces() also know their neighbors in other pieces of the block.
  const DistributedMesh& GetPieces() const;
  const DistributedMesh& GetLinkedPieces() const;
  ///@}
  /// Collective. The same for other data sets.
  std::unique_ptr<DistributedMesh> MakePieces(const std::vector<DataSetLeaf>& leaves) const;
  /// Collective. Also marks the duplicates of marked points, in the same and in other pieces. Does
  /// nothing for cells.
  void MarkCopies(SelectionMarks& marks) const;
  /// Collective. Marks exactly the ghost cells whose originals are marked. Does nothing for points.
  void MarkGhostCells(SelectionMarks& marks) const;

private:
  std::string FindArrayName() const;

  int NumberOfRequestedPieces;
  std::string ArrayName;
  mutable bool IsLinked = false;
  mutable std::unique_ptr<DistributedMesh> Pieces;
  mutable std::unique_ptr<SharedElements> SharedPoints;
};

/**
 * A strategy: sets @a marks, which are initially 0. Collective; throws on all processes or none,
 * std::invalid_argument with a message for the user. Returns a warning for the user, or an empty
 * text. It may mark ghosts: the caller removes these marks.
 */
using SelectFunction = std::string(const SelectionTask& task, SelectionMarks& marks);

/// Strategies that others use, too.
SelectFunction SelectAll, SelectBoundary, SelectByCriterion, SelectById;

/// A row of the table of strategies.
struct Strategy
{
  const char* Name;
  SelectFunction* Select;
  bool IsForPoints;     ///< also selects points, not only cells
  const char* Selected; ///< what it selects, as a part of a sentence for users
};

/// The table of strategies.
const std::vector<Strategy>& GetStrategies();
/// Throws std::invalid_argument if no strategy has that name.
const Strategy& FindStrategy(const std::string& name);

/**
 * Collective. The elements of the Selection, however it describes them (ids, values, locations,
 * queries, or expressions of these). If it describes elements of the other type, the cells with a
 * selected point, or the points of the selected cells. Without a Selection, the elements for which
 * the array "Selected" of the mesh is not 0; without this array, none.
 *
 * Ghosts are never selected. Throws std::runtime_error on all processes if the selection cannot be
 * evaluated.
 */
SelectionMarks FindCurrentSelection(const SelectionTask& task);

/// Collective. For each block the elements of one type that the Selection, or without one the mesh,
/// describes, including ghosts. Throws as above.
SelectionMarks FindSelected(const SelectionTask& task, ElementKind kind);

/// Marks the elements of a data set for which the array "Selected" is not 0; none without the
/// array.
void MarkSelected(vtkDataSet* data, ElementKind kind, std::vector<unsigned char>& marks);

/// Points for cells, cells for points.
ElementKind GetOtherKind(ElementKind kind);

/**
 * Replaces @a marks by its combination with @a current: "Replace" (unchanged), "Add", "Subtract",
 * "Intersect", "Toggle" (in exactly one of both) or "Refine" (as Intersect). Throws
 * std::invalid_argument for any other name.
 */
void CombineSelections(
  const std::string& combination, const SelectionMarks& current, SelectionMarks& marks);

/**
 * Collective. Marks the elements of the task that belong to marked elements (@a others) of the
 * other type of the same mesh: the cells of marked points, or the points of marked cells. @a
 * quantifier: whether any or all of them must be marked.
 */
SelectionMarks ChangeElementTypeOf(
  const SelectionTask& task, const SelectionMarks& others, Quantifier quantifier);

/// The values of the property Placement.
std::vector<std::string> GetPlacementNames();

/// Collective. The unit of an array, the same on all processes.
std::string FindUnit(const SelectionTask& task, const std::string& arrayName);

/// Collective. The values of the chosen array. Throws std::invalid_argument if no process has it,
/// or as ElementBlocks::RequireExactIntegers does.
BlockValues FindValues(const SelectionTask& task);

/// Collective. The range of SelectByCriterion. Throws std::invalid_argument if there is none, or a
/// limit is not a number.
AcceptableRange FindRange(const SelectionTask& task);

/// Which cells are neighbors, for the strategies that continue a selection. Throws
/// std::invalid_argument if a property is wrong.
Neighborhood FindNeighborhood(const SelectionTask& task);

/// The ids of all elements, one list per block.
std::vector<std::vector<vtkIdType>> ListIds(const ElementBlocks& blocks);

/// Sets the mark of each element to @a isSelected(blockNumber, i).
template <typename IsSelected>
void MarkElements(SelectionMarks& marks, IsSelected&& isSelected)
{
  constexpr vtkIdType grain = 1 << 14;
  for (std::size_t b = 0; b < marks.size(); ++b)
  {
    unsigned char* mark = marks[b].data();
    ParallelForEach(static_cast<vtkIdType>(marks[b].size()), grain,
      [&](vtkIdType i) { mark[i] = isSelected(b, i); });
  }
}

/// The same for elements with a value, with @a isSelected(block, i), which is not called for
/// ghosts.
template <typename IsSelected>
void MarkValues(const BlockValues& values, SelectionMarks& marks, IsSelected&& isSelected)
{
  for (std::size_t b = 0; b < values.Get().size(); ++b)
  {
    const ValueBlock& block = values.Get()[b];
    unsigned char* mark = marks[values.GetBlockNumbers()[b]].data();
    ParallelForEach(block.Size, LightGrain,
      [&](vtkIdType i) { mark[i] = block.Contains(i) && isSelected(block, i); });
  }
}
}

#endif
