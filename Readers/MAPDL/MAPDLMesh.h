// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::MAPDLMesh
 * @brief The nodes and cells of a deck.
 *
 * Rows are read in parallel, and repeatedly instead of being stored: first the ids of nodes, then
 * elements as cells, then, when it is known what a piece needs, its coordinates and attributes. Of
 * all elements only ids, types and sizes are stored, unless the piece is the whole mesh.
 */
#ifndef camaron_MAPDLMesh_h
#define camaron_MAPDLMesh_h

#include "Intake/CellMesh/CellMeshPiece.h"
#include "Intake/Ids/IdMap.h"
#include "MAPDLDeck.h"
#include "MAPDLReading.h"

#include <algorithm>     // for std::minmax
#include <array>         // for edges
#include <unordered_map> // for their midpoints

class vtkUnstructuredGrid;

namespace camaron
{
class MAPDLMesh
{
public:
  MAPDLMesh(const MAPDLDeck& deck, const MAPDLOptions& options);

  /// Determines a piece and reads its cells; false with the error in Fault, or if aborted.
  bool Read(const PieceRequest& request, CellMeshPiece& piece, const Progress& progress);
  /// Coordinates of the points of a piece as x, y, z; empty after a fault.
  Buffer<double> ReadPoints(const CellMeshPiece& piece, const Progress& progress);
  /// Adds the arrays of a piece to its grid.
  bool AddArrays(const CellMeshPiece& piece, vtkUnstructuredGrid* grid, const Progress& progress);

  void Warn(Warnings& warnings) const;

  CellMesh Cells; ///< of the piece
  MAPDLFault Fault;

  ///@{
  /// Numbers in the whole deck.
  vtkIdType GetNumberOfPoints() const
  {
    return this->NodeIds.size() + static_cast<vtkIdType>(this->Midpoints.size());
  }
  vtkIdType GetNumberOfCells() const { return this->ElementIds.size(); }
  ///@}
  ///@{
  /// Ids of all nodes and cells, in order; points beyond the nodes are midpoints of edges.
  const Buffer<std::int32_t>& GetNodeIds() const { return this->NodeIds; }
  const Buffer<std::int32_t>& GetElementIds() const { return this->ElementIds; }
  const IdMap& GetNodes() const { return this->Nodes; }
  ///@}

private:
  /// Rows that are read in one task.
  struct Item
  {
    std::size_t Block;
    std::size_t Chunk;
    vtkIdType FirstRow; ///< of all rows
    vtkIdType NumberOfRows;
    vtkIdType FirstNode; ///< of elements: position of their points
    vtkIdType NumberOfNodes;
    vtkIdType FirstCommand; ///< if they come from commands, else -1
  };
  struct MissingNode
  {
    vtkIdType Row;
    std::int32_t Place; ///< index in the cell
    std::array<std::int32_t, 2> Edge;

    /// Identical for all cells that share the edge.
    std::uint64_t GetKey() const
    {
      const auto ends = std::minmax(this->Edge[0], this->Edge[1]);
      return std::uint64_t(ends.first) << 32 | static_cast<std::uint32_t>(ends.second);
    }
  };
  /// Results of reading the elements of an item.
  struct Outcome
  {
    vtkIdType NumberOfPoints = 0;
    std::vector<std::int32_t> Points; ///< if they do not fit at their position
    std::vector<MissingNode> Missing;
    std::map<int, vtkIdType> Unknown; ///< numbers of elements that are not cells
    vtkIdType Undefined = 0;
    vtkIdType WithoutNodes = 0;
    MAPDLFault Fault;
  };

  template <typename Block, typename CountNodes>
  vtkIdType MakeItems(const std::vector<Block>& blocks, std::vector<Item>& items,
    CountNodes&& countCommandNodes) const;
  /// Passes the coordinates of all nodes; false with the error in Fault, or if aborted.
  bool ForEachNode(const PieceOfSpace::Visit& visit, const Progress& progress);
  template <typename Visit>
  bool ForEachNodeItem(const Progress& progress, Visit&& visit);
  template <typename Visit>
  bool ForEachElement(const Item& item, bool withNodes, MAPDLFault& fault, Visit&& visit) const;
  void Note(const MAPDLFault& fault);

  /// Index of the cell of a row, -1 if it is left out.
  vtkIdType GetCell(vtkIdType row) const
  {
    return this->Kept.GetLimit() == 0 ? row
      : this->Kept.Contains(row)      ? this->Kept.GetNumber(row)
                                      : -1;
  }
  /// The same for its index in a piece.
  vtkIdType FindCell(vtkIdType row, const CellMeshPiece& piece) const
  {
    const vtkIdType cell = this->GetCell(row);
    return cell < 0 ? -1 : piece.FindCell(cell);
  }
  template <typename Provide, typename Take>
  void ForEachCell(const Item& item, Outcome& outcome, Provide&& provide, Take&& take) const;
  template <typename Visit>
  bool ForEachElementItem(const Progress& progress, Visit&& visit) const;
  bool ReadNodeIds(const Progress& progress);
  bool ReadElements(CellMeshPiece& piece, const Progress& progress);
  void ReadItem(const Item& item, Outcome& outcome);
  void CheckItem(const Item& item, Outcome& outcome, CellMeshPiece& piece);
  void ReplaceElements();
  void LeaveOut();
  bool NeedsCompacting() const;
  void Compact();
  void FinishWhole();
  void AddMidpoints();
  bool VisitCells(CellMeshPiece& piece, const Progress& progress) const;
  bool FindPiece(const PieceRequest& request, CellMeshPiece& piece, const Progress& progress);
  void AllocatePiece(const CellMeshPiece& piece);
  bool ReadPiece(const CellMeshPiece& piece, const Progress& progress);
  void MakePoints(const MAPDLElement& element, MAPDLCell& cell) const;

  const MAPDLDeck& Deck;
  MAPDLOptions Options;
  std::vector<Item> NodeItems, ElementItems;
  std::vector<Outcome> Outcomes; ///< of element items
  Buffer<std::int32_t> NodeIds, ElementIds;
  Buffer<std::int32_t> NodeOfRow; ///< -1 for rows that are left out; empty if all are kept
  IdSet LeftOut;                  ///< rows of elements
  IdSet Kept;                     ///< the other rows, unless these are all
  Buffer<unsigned char> Sizes;    ///< of the cells of all rows, if the cells are not stored
  IdMap Nodes;
  std::vector<std::array<std::int32_t, 2>> Midpoints;
  std::unordered_map<std::uint64_t, std::int32_t> MidpointOfEdge;
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
// Calls visit(position in the text, row, element) for elements of an item until it returns false.
template <typename Visit>
bool MAPDLMesh::ForEachElement(
  const Item& item, bool withNodes, MAPDLFault& fault, Visit&& visit) const
{
  const MAPDLElementBlock& block = this->Deck.ElementBlocks[item.Block];
  if (item.FirstCommand < 0)
  {
    const vtkIdType offset = item.FirstRow - block.Extent.Chunks[item.Chunk].FirstRow;
    return ForEachMAPDLElement(block.Format, block.Extent, item.Chunk, withNodes, fault,
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

//------------------------------------------------------------------------------
// Calls visit(index) for all items of elements.
template <typename Visit>
bool MAPDLMesh::ForEachElementItem(const Progress& progress, Visit&& visit) const
{
  return progress.For(static_cast<vtkIdType>(this->ElementItems.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        visit(i);
      }
    });
}

//------------------------------------------------------------------------------
// Creates cells of the elements of an item: provide(row, element, cell) returns where to store the
// points; then take(row, cell, points, isComplete) is called. Unknown midpoints are added to the
// missing ones, and the cell is not complete.
template <typename Provide, typename Take>
void MAPDLMesh::ForEachCell(
  const Item& item, Outcome& outcome, Provide&& provide, Take&& take) const
{
  std::int64_t knownType = -1;
  int number = 0;
  MAPDLClass elementClass = MAPDLClass::Undefined;
  MAPDLCell cell;
  this->ForEachElement(item, true, outcome.Fault,
    [&](const char* place, vtkIdType row, const MAPDLElement& element)
    {
      if (element.Type != knownType)
      {
        knownType = element.Type;
        const MAPDLType type = this->Deck.GetType(knownType);
        number = type.Element;
        elementClass = GetMAPDLClass(number, type.Shape);
      }
      if (this->Options.SurfaceEffects || !IsMAPDLSurfaceEffect(number))
      {
        MakeMAPDLCell(
          elementClass, element.Nodes, element.NumberOfNodes, this->Options.Linear, cell);
        if (elementClass == MAPDLClass::Unknown && cell.Type == VTK_EMPTY_CELL)
        {
          ++outcome.Unknown[number];
          if (this->Options.UnknownAsPoints)
          {
            this->MakePoints(element, cell);
          }
        }
        outcome.Undefined += elementClass == MAPDLClass::Undefined;
        outcome.WithoutNodes += element.NumberOfNodes == 0;
      }
      else
      {
        cell.Type = VTK_EMPTY_CELL;
        cell.Size = 0;
      }

      std::int32_t* const points = provide(row, element, cell);
      outcome.NumberOfPoints += cell.Size;
      bool isComplete = true;
      for (std::int32_t i = 0; i < cell.Size; ++i)
      {
        points[i] = this->Nodes.Find(cell.Nodes[i]);
        if (points[i] < 0)
        {
          const auto edge = GetMAPDLEdge(cell, i);
          if (cell.Nodes[i] != 0 || edge[0] < 0)
          {
            return outcome.Fault.Set(place, ErrorKind::Index, "an element whose nodes are defined",
              "node " + std::to_string(cell.Nodes[i]) +
                this->Deck.GetReasonForMissing(cell.Nodes[i]));
          }
          const MissingNode node = { row, i, { points[edge[0]], points[edge[1]] } };
          const auto known = this->MidpointOfEdge.find(node.GetKey());
          if (known != this->MidpointOfEdge.end())
          {
            points[i] = known->second;
          }
          else
          {
            outcome.Missing.push_back(node);
            isComplete = false;
          }
        }
      }
      take(row, cell, points, isComplete);
      return true;
    });
}
}

#endif
