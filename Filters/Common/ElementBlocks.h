// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ElementBlocks
 * @brief The cells or points of any input, block by block, with an identity of each among all
 * processes.
 *
 * The *index* of a cell counts the cells of block after block, inside a block those of process
 * after process; copies of cells that another process owns (DUPLICATECELL) are not counted. For one
 * data set on one process it is VTK's cell id; for a mesh that is split into ranges of cells it is
 * what that would be. Its *identity* is its global id if all cells have one, else its index. The
 * same holds for points.
 *
 * Points that several pieces of a block have are copies in all but one of them, that of the lowest
 * process, and so are points of nothing but copies of cells, whether or not they are marked as
 * such.
 *
 * Ghosts (vtkGhostType with DUPLICATECELL, HIDDENCELL or REFINEDCELL; DUPLICATEPOINT or
 * HIDDENPOINT) take part in nothing.
 */
#ifndef camaron_ElementBlocks_h
#define camaron_ElementBlocks_h

#include "Ranks/Reducer.h"
#include "Statistics/Population.h"
#include "Statistics/Weights.h"

#include "vtkDataObject.h"   // for kinds of elements
#include "vtkDataSet.h"      // for leaves
#include "vtkSmartPointer.h" // for data sets and arrays

#include <string> // for names
#include <vector> // for lists

class vtkDataArray;
class vtkDataSetAttributes;
class vtkDoubleArray;

namespace camaron
{
struct LinkedPiece;

/// A data set of any input.
struct DataSetLeaf
{
  vtkSmartPointer<vtkDataSet> Data;
  unsigned int FlatIndex = 0; ///< VTK's composite index, 0 if the input is not composite
  int Number = 0;             ///< of the block among the blocks, the same on all processes
  std::string Name;           ///< of the block, empty if the input is not composite
};

/**
 * The data sets of the input on this process in the order of their flat indices, empty ones
 * included; with ghosts in the form that VTK knows (WithGhostBytes).
 */
std::vector<DataSetLeaf> GetLeaves(vtkDataObject* input);
/// The same of an output, which the data sets themselves are in whatever their ghosts are.
std::vector<DataSetLeaf> GetOutputLeaves(vtkDataObject* output);

/// What an ElementBlock counts.
enum class ElementKind
{
  Cells = vtkDataObject::CELL,
  Points = vtkDataObject::POINT
};

/// A data set of the input on this process.
struct ElementBlock : DataSetLeaf
{
  ElementKind Kind = ElementKind::Cells;
  std::vector<unsigned char> Skip; ///< nonzero for ghosts; empty if there are none
  vtkIdType FirstIndex = 0;        ///< of the first element
  std::vector<vtkIdType> Indices;  ///< of all elements if they are not consecutive, else empty
  vtkSmartPointer<vtkDataArray> GlobalIds; ///< vtkIdTypeArray, none if the identity is the index

  vtkIdType GetSize() const;
  /// Arrays of the elements.
  vtkDataSetAttributes* GetAttributes() const;
  /// An array with one component or nullptr.
  vtkDataArray* GetArray(const std::string& name) const;
  vtkIdType GetIndex(vtkIdType element) const
  {
    return this->Indices.empty() ? this->FirstIndex + element : this->Indices[element];
  }
  bool IsGhost(vtkIdType element) const { return !this->Skip.empty() && this->Skip[element]; }
};

/// Bits of vtkGhostType with which an element of that kind is a ghost.
unsigned char GetGhostMask(ElementKind kind);

class ElementBlocks
{
public:
  /// Collective. Throws std::runtime_error if "vtkGhostType" is none that VTK knows.
  ElementBlocks(vtkDataObject* input, Reducer& reducer, ElementKind kind = ElementKind::Cells);

  const std::vector<ElementBlock>& Get() const { return this->Blocks; }
  bool IsComposite() const { return this->Composite; }
  ElementKind GetKind() const { return this->Kind; }
  /// True if some process has points that are there in several pieces; false for cells.
  bool HasCopiesOfPoints() const { return this->PointCopies; }
  /// True if the identity of elements is their global id.
  bool HasGlobalIds() const { return this->GlobalIds; }
  /// How the property IdSpace of SelectElements calls the identity.
  const char* GetIdSpace() const { return this->GlobalIds ? "Global id" : "Index"; }
  /// One more than the largest index.
  vtkIdType GetNumberOfIndices() const { return this->NumberOfIndices; }

  /// Leaves out the elements that are not marked; @a marks: a list for each block.
  void Restrict(const std::vector<std::vector<unsigned char>>& marks);

  /// Skip mask, identities and size of a block as Core wants them, still without values.
  ValueBlock GetValueBlock(const ElementBlock& block) const;

private:
  void AddBlock(const DataSetLeaf& leaf);
  void FindCopiesOfPoints(Reducer& reducer);
  void SkipPointsOfCopies(ElementBlock& block, const LinkedPiece& piece);
  void FindGlobalIds(Reducer& reducer);
  void FindIndices(Reducer& reducer);

  std::vector<ElementBlock> Blocks;
  ElementKind Kind;
  bool Composite = false;
  bool GlobalIds = false;
  bool PointCopies = false;
  vtkIdType NumberOfIndices = 0;
};

/**
 * Values of one array with a single component in all blocks that have it, as doubles (borrowed
 * where they are).
 */
class BlockValues
{
public:
  BlockValues(const ElementBlocks& blocks, const std::string& arrayName);
  BlockValues(BlockValues&&) = default; // copies would borrow from the first one

  const Population& Get() const { return this->Values; }
  /// Number in ElementBlocks::Get() of each block of the population.
  const std::vector<std::size_t>& GetBlockNumbers() const { return this->Numbers; }
  /// Whether there are integers that no double is, on this process.
  bool HasRests() const;
  /// Borrows the shapes of the elements of all blocks, and names those that the acceptable range is
  /// for.
  void SetShapes(const std::vector<std::vector<std::uint16_t>>& shapes, unsigned judged);

private:
  Population Values;
  std::vector<std::vector<std::int16_t>> Rests;
  std::vector<std::size_t> Numbers;
  std::vector<vtkSmartPointer<vtkDataArray>> Owners;
};

/// The values of an array by which elements count.
class BlockWeights
{
public:
  /// Collective. Throws std::invalid_argument if no process has the array.
  BlockWeights(const ElementBlocks& blocks, const std::string& arrayName, Reducer& reducer);

  /// For each block of @a values its weights; 0 where there are none.
  Weights GetWeights(const BlockValues& values) const;

private:
  BlockValues Values;
  double Unit;               // of the weights of all elements
  std::vector<double> Zeros; // as many as the largest block has elements
};
}

#endif
