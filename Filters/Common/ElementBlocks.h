// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ElementBlocks
 * @brief Iterates over the cells or points of any input, block by block, and identifies each of
 * them across all processes.
 *
 * The *index* of a cell numbers the cells block by block, and inside a block process by process.
 * Duplicates of cells that another process owns (DUPLICATECELL) are not counted. For a single data
 * set on one process the index is VTK's cell id; for a mesh that is split into consecutive ranges
 * of cells it is the cell id of the undivided mesh. The *identity* of a cell is its global id if
 * all cells have one, else its index. The same holds for points.
 *
 * A point that several pieces of a block contain belongs to the process with the smallest number;
 * in all other pieces it is a duplicate. So are points that only duplicate cells use. Neither has
 * to be marked in vtkGhostType.
 *
 * Ghosts are ignored everywhere: elements whose vtkGhostType has DUPLICATECELL, HIDDENCELL or
 * REFINEDCELL, for points DUPLICATEPOINT or HIDDENPOINT.
 */
#ifndef camaron_ElementBlocks_h
#define camaron_ElementBlocks_h

#include "Ranks/Reducer.h"
#include "Statistics/Population.h"
#include "Statistics/Weights.h"

#include "vtkDataObject.h"   // for element types
#include "vtkDataSet.h"      // for leaves
#include "vtkSmartPointer.h" // for data sets and arrays

#include <string> // for names
#include <vector> // for lists

class vtkDataArray;
class vtkDataSetAttributes;
class vtkDoubleArray;
class vtkIdTypeArray;

namespace camaron
{
struct LinkedPiece;

/// A data set of the input.
struct DataSetLeaf
{
  vtkSmartPointer<vtkDataSet> Data;
  unsigned int FlatIndex = 0; ///< VTK's composite index; 0 if the input is not composite
  int Number = 0;             ///< number of the block, the same on all processes
  std::string Name;           ///< of the block; empty if the input is not composite
};

/// The data sets of the input on this process by flat index, including empty ones. Ghost arrays of
/// other types are converted to VTK's type (WithGhostBytes). To read cells, use GetMeshes.
std::vector<DataSetLeaf> GetLeaves(vtkDataObject* input);
/// The same for an output: the data sets themselves, with unchanged ghost arrays.
std::vector<DataSetLeaf> GetOutputLeaves(vtkDataObject* output);

/// The element type of an ElementBlock.
enum class ElementKind
{
  Cells = vtkDataObject::CELL,
  Points = vtkDataObject::POINT
};

/// The type with the name "Cells" or "Points", the values of the property Element Type. Throws
/// std::invalid_argument for any other name.
ElementKind ParseElementKind(const std::string& name);

/// A data set of the input on this process, seen as a list of cells or points.
struct ElementBlock : DataSetLeaf
{
  ElementKind Kind = ElementKind::Cells;
  std::vector<unsigned char> Skip; ///< nonzero for ghosts; empty if there are none
  vtkIdType FirstIndex = 0;        ///< of the first element
  std::vector<vtkIdType> Indices;  ///< of all elements if they are not consecutive, else empty
  vtkSmartPointer<vtkDataArray> GlobalIds; ///< vtkIdTypeArray; null if the index is the identity

  vtkIdType GetSize() const;
  /// The cell data or point data.
  vtkDataSetAttributes* GetAttributes() const;
  /// The array of that name if it has one component, else nullptr.
  vtkDataArray* GetArray(const std::string& name) const;
  vtkIdType GetIndex(vtkIdType element) const
  {
    return this->Indices.empty() ? this->FirstIndex + element : this->Indices[element];
  }
  bool IsGhost(vtkIdType element) const { return !this->Skip.empty() && this->Skip[element]; }
};

/// The bits of vtkGhostType that mark an element of that type as a ghost.
unsigned char GetGhostMask(ElementKind kind);

/// The ids as vtkIdType; nullptr if there are none or vtkIdType cannot represent them.
vtkSmartPointer<vtkIdTypeArray> ToIds(vtkDataArray* array);

class ElementBlocks
{
public:
  /// Collective. Throws std::runtime_error on all processes if the array "vtkGhostType" has a type
  /// or size that VTK does not allow.
  ElementBlocks(vtkDataObject* input, Reducer& reducer, ElementKind kind = ElementKind::Cells);

  const std::vector<ElementBlock>& Get() const { return this->Blocks; }
  bool IsComposite() const { return this->Composite; }
  ElementKind GetKind() const { return this->Kind; }
  /// Whether some points exist in several pieces, on any process. False for cells.
  bool HasCopiesOfPoints() const { return this->PointCopies; }
  /// Whether the identity of elements is their global id.
  bool HasGlobalIds() const { return this->GlobalIds; }
  /// The identity as a value of the property IdSpace of vtkSelectElements.
  const char* GetIdSpace() const { return this->GlobalIds ? "Global id" : "Index"; }

  /// Collective. Whether there are no elements on any process.
  bool AreEmpty(Reducer& reducer) const;
  /// Collective. Throws std::invalid_argument(@a message) on all processes if @a count is 0 on all
  /// of them although there are elements.
  void RequireAny(std::size_t count, const std::string& message, Reducer& reducer) const;
  /// Collective. Throws std::invalid_argument on all processes if an array of cells or points has
  /// integers of 2^53 or more in magnitude, because values are compared as doubles.
  void RequireExactIntegers(ElementKind kind, const std::string& arrayName, Reducer& reducer) const;

  /// Skips the elements that are not marked from now on. @a marks: one list per block.
  void Restrict(const std::vector<std::vector<unsigned char>>& marks);

  /// The skip mask, identities and size of a block in the form that Core uses, without values.
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
  vtkIdType NumberOfIndices = 0; // largest index plus one
};

/// The values of a one-component array, as doubles, in all blocks that have it. Arrays of doubles
/// are borrowed, others are converted.
class BlockValues
{
public:
  /// Collective. Throws as RequireExactIntegers does.
  BlockValues(const ElementBlocks& blocks, const std::string& arrayName, Reducer& reducer);
  BlockValues(BlockValues&&) = default; // a copy would borrow from the original

  const Population& Get() const { return this->Values; }
  /// For each block of the population its position in ElementBlocks::Get().
  const std::vector<std::size_t>& GetBlockNumbers() const { return this->Numbers; }
  /// Borrows the shapes of the elements, one list per block, and sets the shapes to which the
  /// acceptable range applies.
  void SetShapes(const std::vector<std::vector<std::uint16_t>>& shapes, unsigned judged);

private:
  Population Values;
  std::vector<std::size_t> Numbers;
  std::vector<vtkSmartPointer<vtkDataArray>> Owners;
};

/// The weights of elements in weighted statistics, from an array such as Volume.
class BlockWeights
{
public:
  /// Collective. Throws std::invalid_argument on all processes if no process has the array, and as
  /// RequireExactIntegers does.
  BlockWeights(const ElementBlocks& blocks, const std::string& arrayName, Reducer& reducer);

  /// The weights for each block of @a values; 0 in blocks without the array.
  Weights GetWeights(const BlockValues& values) const;

private:
  BlockValues Values;
  double Unit;               // of all weights together
  std::vector<double> Zeros; // as long as the largest block
};
}

#endif
