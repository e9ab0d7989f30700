// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Strategy.h
 * @brief The ways in which vtkSelectElements selects: one function each, and the table of them.
 *
 * To add one: a file beside this one with the function, its declaration below, a row in
 * StrategyTable.cxx, and what it needs to know in SelectionParameters with a property of
 * vtkSelectElements.
 */
#ifndef camaron_Strategy_h
#define camaron_Strategy_h

#include "DistributedMesh.h"
#include "ElementBlocks.h"
#include "Selection/SharedElements.h"

#include "vtkImplicitFunction.h" // for a shape

#include <memory> // for the pieces
#include <string> // for parameters
#include <vector> // for marks

class vtkSelection;

namespace camaron
{
/// All properties of vtkSelectElements; a strategy reads its own. See there what they mean.
struct SelectionParameters
{
  std::string ElementType = "Cells";
  std::string Strategy = "By criterion";
  std::string Combination = "Replace";
  std::string Ids;
  std::string IdSpace = "Index";
  std::string Array;
  std::string PointArray;
  std::string Side = "Outside";
  std::string Range = "Acceptable";
  std::string Preset = "Default ranges";
  std::string RangesFile;
  std::string LowerLimit;
  std::string UpperLimit;
  int NumberOfWorst = 10;
  double WorstShare = 1;
  std::string WorstValues = "By criterion";
  std::string StatusBits;
  std::string CellTypes;
  std::string Counted = "Faces";
  std::string Counts;
  int NumberOfFailures = 1;
  bool ByTopology = false;
  bool LeaveNulls = false;
  std::string Placement = "Centroid inside";
  bool InsideOut = false;
  std::string Adjacency = "Face";
  int NumberOfRings = 1;
  double FeatureAngle = 180;
  bool OnlyBoundary = false;
  bool OnlyInRange = false;
  int PartNumber = 1;
  std::string Quantifier = "Any";
  vtkSmartPointer<vtkImplicitFunction> Shape;
  std::string ShapeFile;
  std::vector<double> Planes; ///< of each six numbers: a point and the normal to the outside
};

/// What the inputs of vtkSelectElements are, all but the mesh or none.
struct SelectionInputs
{
  vtkDataObject* Mesh = nullptr;
  vtkSelection* Selection = nullptr;
  vtkDataObject* Surface = nullptr;
  vtkDataObject* Elements = nullptr;
};

/// For each block of the input 1 for selected elements, else 0.
using SelectionMarks = std::vector<std::vector<unsigned char>>;

/// Marks of all elements, 0.
SelectionMarks MakeMarks(const ElementBlocks& blocks);

/// What a strategy is given.
class SelectionTask
{
public:
  /// Collective. All but the inputs is borrowed. @a numberOfRequestedPieces: see DistributedMesh.
  SelectionTask(const SelectionParameters& parameters, const SelectionInputs& inputs,
    const ElementBlocks& blocks, int numberOfRequestedPieces, camaron::Reducer& reducer);

  const SelectionParameters& Parameters;
  const SelectionInputs Inputs;
  const ElementBlocks& Blocks;
  SelectionMarks Current; ///< the selection so far, set after the rest; no ghosts are in it
  camaron::Reducer& Reducer;

  /// Of each block and element how many criteria fail, if the strategy counts that.
  mutable std::vector<std::vector<int>> FailedCriteriaCounts;

  /// Array or PointArray, whichever belongs to the elements, or what stands for it where it is
  /// empty: see there. Empty if there is no array at all.
  const std::string& GetArrayName() const { return this->ArrayName; }
  bool HasCells() const { return this->Blocks.GetKind() == ElementKind::Cells; }
  ///@{
  /**
   * Collective. The blocks as meshes, piece i is block i, made when first asked for; also linked,
   * so that pieces of a block know each other.
   */
  const DistributedMesh& GetPieces() const;
  const DistributedMesh& GetLinkedPieces() const;
  ///@}
  /// Collective. The same of any blocks.
  std::unique_ptr<DistributedMesh> MakePieces(const std::vector<DataSetLeaf>& leaves) const;
  /// Collective. Marks the copies of points in other and in the same pieces, too; nothing is done
  /// about cells.
  void MarkCopies(SelectionMarks& marks) const;
  /// Collective. Marks the ghost cells whose originals are marked, and no others; nothing is done
  /// about points.
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
 * Selects: sets @a marks, which comes filled with 0. Collective: throws on all processes or none,
 * std::invalid_argument with a message for people. Returns a remark for people, empty if there is
 * none. Ghosts need not be left out: the caller does that.
 */
using SelectFunction = std::string (*)(const SelectionTask& task, SelectionMarks& marks);

std::string ChangeKind(const SelectionTask& task, SelectionMarks& marks);
std::string SelectAll(const SelectionTask& task, SelectionMarks& marks);
std::string SelectBoundary(const SelectionTask& task, SelectionMarks& marks);
std::string SelectByCriterion(const SelectionTask& task, SelectionMarks& marks);
std::string SelectByCount(const SelectionTask& task, SelectionMarks& marks);
std::string SelectByStatus(const SelectionTask& task, SelectionMarks& marks);
std::string SelectById(const SelectionTask& task, SelectionMarks& marks);
std::string SelectByType(const SelectionTask& task, SelectionMarks& marks);
std::string SelectCurrent(const SelectionTask& task, SelectionMarks& marks);
std::string SelectConnected(const SelectionTask& task, SelectionMarks& marks);
std::string SelectExpanded(const SelectionTask& task, SelectionMarks& marks);
std::string SelectFailed(const SelectionTask& task, SelectionMarks& marks);
std::string SelectInHalfSpaces(const SelectionTask& task, SelectionMarks& marks);
std::string SelectInShape(const SelectionTask& task, SelectionMarks& marks);
std::string SelectInSurface(const SelectionTask& task, SelectionMarks& marks);
std::string SelectInShapeFile(const SelectionTask& task, SelectionMarks& marks);
std::string SelectInverse(const SelectionTask& task, SelectionMarks& marks);
std::string SelectNull(const SelectionTask& task, SelectionMarks& marks);
std::string SelectPart(const SelectionTask& task, SelectionMarks& marks);
std::string SelectShrunk(const SelectionTask& task, SelectionMarks& marks);
std::string SelectWorst(const SelectionTask& task, SelectionMarks& marks);
std::string SelectWorstShare(const SelectionTask& task, SelectionMarks& marks);

struct Strategy
{
  const char* Name;
  SelectFunction Select;
  bool IsForPoints; ///< not for cells only
};

const std::vector<Strategy>& GetStrategies();
/// Throws std::invalid_argument if there is none of that name.
const Strategy& FindStrategy(const std::string& name);

/// How SelectInShape and its like call the ways in which a cell may be placed; see Placement.
std::vector<std::string> GetPlacementNames();

/// Unit of an array, the same on all processes. Collective.
std::string FindUnit(const SelectionTask& task, const std::string& arrayName);

/// Values of the array for the strategies that need one; throws if no process has it. Collective.
BlockValues FindValues(const SelectionTask& task);

/// Marks the elements for which @a isSelected(blockNumber, i) is true.
template <typename IsSelected>
void MarkElements(SelectionMarks& marks, IsSelected&& isSelected)
{
  constexpr vtkIdType grain = 1 << 14;
  for (std::size_t b = 0; b < marks.size(); ++b)
  {
    unsigned char* mark = marks[b].data();
    ParallelFor(static_cast<vtkIdType>(marks[b].size()), grain,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          mark[i] = isSelected(b, i);
        }
      });
  }
}

/// Marks the elements for which @a isSelected(block, i) is true; it is not asked about ghosts.
template <typename IsSelected>
void MarkValues(const BlockValues& values, SelectionMarks& marks, IsSelected&& isSelected)
{
  constexpr vtkIdType grain = 1 << 16;
  for (std::size_t b = 0; b < values.Get().size(); ++b)
  {
    const ValueBlock& block = values.Get()[b];
    unsigned char* mark = marks[values.GetBlockNumbers()[b]].data();
    ParallelFor(block.Size, grain,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          mark[i] = block.Contains(i) && isSelected(block, i);
        }
      });
  }
}
}

#endif
