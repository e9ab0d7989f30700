// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MAPDLMesh
 * @brief The nodes and cells of a deck.
 *
 * Rows are read in parallel, and more than once rather than kept: first ids of nodes, then elements
 * as cells, then, when it is known what a piece needs, coordinates and attributes of that only.
 */
#ifndef camaron_MAPDLMesh_h
#define camaron_MAPDLMesh_h

#include "CellMesh/CellPiece.h"
#include "MAPDLDeck.h"
#include "MAPDLReading.h"
#include "Scan/IdMap.h"

#include <array> // for edges

class vtkUnstructuredGrid;

namespace camaron
{
class MAPDLMesh
{
public:
  MAPDLMesh(const MAPDLDeck& deck, const MAPDLOptions& options);

  /// Fills Cells; false with what is wrong in Fault, or if stopped.
  bool Read(const Progress& progress);
  /// Coordinates of the points of a piece, x, y, z of each; an empty buffer after a fault.
  Buffer<double> ReadPoints(const CellPiece& piece, const Progress& progress);
  /// Adds the arrays of a piece to its grid.
  bool AddArrays(const CellPiece& piece, vtkUnstructuredGrid* grid, const Progress& progress);

  void Warn(Warnings& warnings) const;

  CellMesh Cells;
  MAPDLFault Fault;

  ///@{
  /// Of all nodes, and of all cells, in order; points beyond the nodes are midpoints of edges.
  const Buffer<std::int32_t>& GetNodeIds() const { return this->NodeIds; }
  const Buffer<std::int32_t>& GetElementIds() const { return this->ElementIds; }
  const IdMap& GetNodes() const { return this->Nodes; }
  ///@}

private:
  /// Rows that are read as one piece of work.
  struct Item
  {
    std::size_t Block;
    std::size_t Chunk;
    vtkIdType FirstRow; ///< of all rows
    vtkIdType NumberOfRows;
    vtkIdType FirstNode; ///< of elements: place of their points
    vtkIdType NumberOfNodes;
    vtkIdType FirstCommand; ///< if they come from commands, else -1
  };
  struct MissingNode
  {
    vtkIdType Row;
    std::int32_t Place; ///< in the cell
    std::array<std::int32_t, 2> Edge;
  };
  /// What the elements of an item were.
  struct Outcome
  {
    vtkIdType NumberOfPoints = 0;
    std::vector<std::int32_t> Points; ///< if they do not fit in their place
    std::vector<MissingNode> Missing;
    std::map<int, vtkIdType> Unknown; ///< numbers of elements that are no cells
    vtkIdType Undefined = 0;
    vtkIdType Dropped = 0;
    vtkIdType WithoutNodes = 0;
    MAPDLFault Fault;
  };

  template <typename Block, typename CountNodes>
  vtkIdType MakeItems(const std::vector<Block>& blocks, std::vector<Item>& items,
    CountNodes&& countCommandNodes) const;
  template <typename Visit>
  bool ForEachNodeItem(const Progress& progress, Visit&& visit);
  template <typename Visit>
  bool ForEachElement(const Item& item, bool withNodes, MAPDLFault& fault, Visit&& visit) const;
  void Note(const MAPDLFault& fault);

  bool ReadNodeIds(const Progress& progress);
  bool ReadElements(const Progress& progress);
  void ReadItem(const Item& item, Outcome& outcome);
  bool ReplaceElements();
  void Compact();
  void AddMidpoints();
  void MakePoints(const MAPDLElement& element, MAPDLCell& cell) const;

  const MAPDLDeck& Deck;
  MAPDLOptions Options;
  std::vector<Item> NodeItems, ElementItems;
  std::vector<Outcome> Outcomes; ///< of element items
  Buffer<std::int32_t> NodeIds, ElementIds;
  Buffer<std::int32_t> NodeOfRow,
    CellOfRow; ///< -1 for rows that are left out; none if all are kept
  IdMap Nodes;
  std::vector<std::array<std::int32_t, 2>> Midpoints;
  vtkIdType NumberOfRows = 0; ///< of elements
  vtkIdType ReplacedNodes = 0, ReplacedElements = 0;
};

//------------------------------------------------------------------------------
// Calls visit(item, fault) for all items of nodes.
template <typename Visit>
bool MAPDLMesh::ForEachNodeItem(const Progress& progress, Visit&& visit)
{
  std::vector<MAPDLFault> faults(this->NodeItems.size());
  const bool finished = progress.For(static_cast<vtkIdType>(this->NodeItems.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        visit(this->NodeItems[i], faults[i]);
      }
    });
  for (const MAPDLFault& fault : faults)
  {
    this->Note(fault);
  }
  return finished && !this->Fault;
}

//------------------------------------------------------------------------------
// Calls visit(place in the text, row, element) for the elements of an item until it returns false.
template <typename Visit>
bool MAPDLMesh::ForEachElement(
  const Item& item, bool withNodes, MAPDLFault& fault, Visit&& visit) const
{
  const MAPDLElementBlock& block = this->Deck.ElementBlocks[item.Block];
  if (item.FirstCommand < 0)
  {
    const vtkIdType offset = item.FirstRow - block.Extent.Chunks[item.Chunk].FirstRow;
    return ForEachMAPDLElement(
      block.Format, [this](std::int64_t type) { return this->Deck.GetMostNodes(type); },
      block.Extent, item.Chunk, withNodes, fault,
      [&](const Line& line, vtkIdType row, const MAPDLElement& element)
      { return visit(line.Begin, offset + row, element); });
  }
  for (vtkIdType i = 0; i < item.NumberOfRows; ++i)
  {
    const vtkIdType command = item.FirstCommand + i;
    if (!visit(
          this->Deck.Elements[command].Place, item.FirstRow + i, this->Deck.GetElement(command)))
    {
      return false;
    }
  }
  return true;
}
}

#endif
