// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLMesh.h"

#include <algorithm>
#include <unordered_map>

namespace camaron
{
namespace
{
constexpr vtkIdType CommandsPerItem = 4096;
}

//------------------------------------------------------------------------------
MAPDLMesh::MAPDLMesh(const MAPDLDeck& deck, const MAPDLOptions& options)
  : Deck(deck)
  , Options(options)
{
}

//------------------------------------------------------------------------------
// Divides rows into pieces of work; returns the number of rows.
template <typename Block, typename CountNodes>
vtkIdType MAPDLMesh::MakeItems(
  const std::vector<Block>& blocks, std::vector<Item>& items, CountNodes&& countCommandNodes) const
{
  vtkIdType rows = 0, nodes = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    const Block& block = blocks[b];
    const MAPDLExtent& extent = block.Extent;
    for (std::size_t c = 0; c < extent.Chunks.size(); ++c)
    {
      const MAPDLChunk& chunk = extent.Chunks[c];
      const bool isLast = c + 1 == extent.Chunks.size();
      const vtkIdType endRow = isLast ? extent.NumberOfRows : extent.Chunks[c + 1].FirstRow;
      const vtkIdType endNode = isLast ? extent.NumberOfNodes : extent.Chunks[c + 1].FirstNode;
      items.push_back(
        { b, c, rows, endRow - chunk.FirstRow, nodes, endNode - chunk.FirstNode, -1 });
      rows += items.back().NumberOfRows;
      nodes += items.back().NumberOfNodes;
    }
    for (vtkIdType i = 0; i < block.NumberOfCommands; i += CommandsPerItem)
    {
      const vtkIdType size = std::min(CommandsPerItem, block.NumberOfCommands - i);
      const vtkIdType first = block.FirstCommand + i;
      items.push_back({ b, 0, rows, size, nodes, countCommandNodes(first, first + size), first });
      rows += size;
      nodes += items.back().NumberOfNodes;
    }
  }
  return rows;
}

//------------------------------------------------------------------------------
void MAPDLMesh::Note(const MAPDLFault& fault)
{
  if (fault && (!this->Fault || fault.Place < this->Fault.Place))
  {
    this->Fault = fault;
  }
}

//------------------------------------------------------------------------------
bool MAPDLMesh::Read(const Progress& progress)
{
  return this->ReadNodeIds(progress.Part(0, 0.3)) && this->ReadElements(progress.Part(0.3, 1));
}

//------------------------------------------------------------------------------
bool MAPDLMesh::ReadNodeIds(const Progress& progress)
{
  const vtkIdType rows = this->MakeItems(
    this->Deck.NodeBlocks, this->NodeItems, [](vtkIdType, vtkIdType) { return vtkIdType(0); });
  this->NodeIds = Buffer<std::int32_t>(rows);
  if (!this->ForEachNodeItem(progress,
        [this](const Item& item, MAPDLFault& fault)
        {
          const MAPDLNodeBlock& block = this->Deck.NodeBlocks[item.Block];
          for (vtkIdType i = 0; item.FirstCommand >= 0 && i < item.NumberOfRows; ++i)
          {
            this->NodeIds[item.FirstRow + i] = this->Deck.Nodes[item.FirstCommand + i].Id;
          }
          if (item.FirstCommand < 0)
          {
            std::int32_t* id = this->NodeIds.data() + item.FirstRow;
            ForEachMAPDLNode(block.Extent, item.Chunk,
              [&](const Line& line, vtkIdType) { return block.Format.ReadId(line, *id++, fault); });
          }
        }))
  {
    return false;
  }
  this->Nodes.Build(this->NodeIds.data(), rows);
  this->ReplacedNodes = this->Nodes.GetNumberOfRepeated();
  if (this->ReplacedNodes > 0)
  {
    // Of several definitions the last counts, at its own place.
    Buffer<std::int32_t> kept(rows - this->ReplacedNodes);
    this->NodeOfRow = Buffer<std::int32_t>(rows);
    std::int32_t next = 0;
    for (vtkIdType row = 0; row < rows; ++row)
    {
      const bool isLast = this->Nodes.Find(this->NodeIds[row]) == row;
      this->NodeOfRow[row] = isLast ? next : -1;
      if (isLast)
      {
        kept[next++] = this->NodeIds[row];
      }
    }
    this->NodeIds = std::move(kept);
    this->Nodes.Build(this->NodeIds.data(), this->NodeIds.size());
  }
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLMesh::ReadElements(const Progress& progress)
{
  this->NumberOfRows = this->MakeItems(this->Deck.ElementBlocks, this->ElementItems,
    [this](vtkIdType begin, vtkIdType end)
    {
      const auto first = [this](vtkIdType i)
      {
        return i < static_cast<vtkIdType>(this->Deck.Elements.size())
          ? this->Deck.Elements[i].FirstNode
          : static_cast<vtkIdType>(this->Deck.ElementNodes.size());
      };
      return first(end) - first(begin);
    });
  const vtkIdType nodes = this->ElementItems.empty()
    ? 0
    : this->ElementItems.back().FirstNode + this->ElementItems.back().NumberOfNodes;
  this->ElementIds = Buffer<std::int32_t>(this->NumberOfRows);
  this->Cells.Types = Buffer<unsigned char>(this->NumberOfRows);
  this->Cells.Offsets = Buffer<std::int32_t>(this->NumberOfRows + 1);
  this->Cells.Connectivity = Buffer<std::int32_t>(nodes);
  this->Outcomes.resize(this->ElementItems.size());
  const bool finished = progress.Part(0, 0.9).For(static_cast<vtkIdType>(this->ElementItems.size()),
    [this](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        this->ReadItem(this->ElementItems[i], this->Outcomes[i]);
      }
    });
  for (const Outcome& outcome : this->Outcomes)
  {
    this->Note(outcome.Fault);
  }
  if (!finished || this->Fault)
  {
    return false;
  }
  bool changes = this->ReplaceElements();
  vtkIdType points = 0;
  for (std::size_t i = 0; i < this->Outcomes.size(); ++i)
  {
    const Outcome& outcome = this->Outcomes[i];
    points += outcome.NumberOfPoints;
    changes = changes || outcome.Dropped > 0 || !outcome.Points.empty() ||
      outcome.NumberOfPoints != this->ElementItems[i].NumberOfNodes;
  }
  if (points > INT32_MAX)
  {
    const char* const place = this->Deck.ElementBlocks[0].Extent.Begin;
    return this->Fault.Set(place, ErrorKind::Unsupported,
      "elements with fewer than 2147483648 nodes altogether", std::to_string(points));
  }
  if (changes)
  {
    this->Compact();
  }
  std::int32_t* const offsets = this->Cells.Offsets.data();
  this->Cells.NumberOfCells = this->Cells.Types.size();
  offsets[0] = 0;
  for (vtkIdType cell = 0; cell < this->Cells.NumberOfCells; ++cell)
  {
    offsets[cell + 1] += offsets[cell];
  }
  this->Cells.NumberOfPoints = this->NodeIds.size();
  this->AddMidpoints();
  return progress.Report(1);
}

//------------------------------------------------------------------------------
void MAPDLMesh::MakePoints(const MAPDLElement& element, MAPDLCell& cell) const
{
  for (std::int32_t i = 0; i < element.NumberOfNodes; ++i)
  {
    if (element.Nodes[i] != 0)
    {
      cell.Nodes[cell.Size++] = element.Nodes[i];
    }
  }
  cell.Type = cell.Size == 0 ? VTK_EMPTY_CELL : cell.Size == 1 ? VTK_VERTEX : VTK_POLY_VERTEX;
}

//------------------------------------------------------------------------------
void MAPDLMesh::ReadItem(const Item& item, Outcome& outcome)
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
        const auto found = this->Deck.Types.find(knownType);
        const MAPDLType type = found == this->Deck.Types.end() ? MAPDLType() : found->second;
        number = type.Element;
        elementClass = GetMAPDLClass(number, type.Shape);
      }
      this->ElementIds[row] = element.Id;
      if (this->Options.SurfaceEffects || !IsMAPDLSurfaceEffect(number))
      {
        MakeMAPDLCell(
          elementClass, element.Nodes, element.NumberOfNodes, this->Options.Linear, cell);
        if (elementClass == MAPDLClass::Unknown)
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
      this->Cells.Types[row] = cell.Type;
      this->Cells.Offsets[row + 1] = cell.Size; // to be summed up
      outcome.Dropped += cell.Type == VTK_EMPTY_CELL;

      std::int32_t* points = this->Cells.Connectivity.data() + item.FirstNode;
      if (!outcome.Points.empty() || outcome.NumberOfPoints + cell.Size > item.NumberOfNodes)
      {
        // Cells with mid-side nodes may need more than the rows have, if zeros are left out there.
        if (outcome.Points.empty())
        {
          outcome.Points.assign(points, points + outcome.NumberOfPoints);
        }
        outcome.Points.resize(static_cast<std::size_t>(outcome.NumberOfPoints + cell.Size));
        points = outcome.Points.data();
      }
      points += outcome.NumberOfPoints;
      outcome.NumberOfPoints += cell.Size;
      for (std::int32_t i = 0; i < cell.Size; ++i)
      {
        points[i] = this->Nodes.Find(cell.Nodes[i]);
        if (points[i] < 0)
        {
          const QuadraticEdges edges = GetQuadraticEdges(cell.Type);
          if (cell.Nodes[i] != 0 || i < edges.NumberOfCorners || edges.NumberOfEdges == 0)
          {
            return outcome.Fault.Set(place, ErrorKind::Index,
              "an element of nodes that are defined", "node " + std::to_string(cell.Nodes[i]));
          }
          const unsigned char* const edge = edges.Edges[i - edges.NumberOfCorners];
          outcome.Missing.push_back({ row, i, { points[edge[0]], points[edge[1]] } });
        }
      }
      return true;
    });
}

//------------------------------------------------------------------------------
// Leaves out elements that are defined again later; returns whether there are such.
bool MAPDLMesh::ReplaceElements()
{
  const std::int32_t* const ids = this->ElementIds.data();
  if (std::is_sorted(ids, ids + this->NumberOfRows, std::less_equal<std::int32_t>()))
  {
    return false; // strictly ascending
  }
  IdMap map;
  map.Build(ids, this->NumberOfRows);
  this->ReplacedElements = map.GetNumberOfRepeated();
  for (vtkIdType row = 0; this->ReplacedElements > 0 && row < this->NumberOfRows; ++row)
  {
    if (map.Find(ids[row]) != row)
    {
      this->Cells.Types[row] = VTK_EMPTY_CELL;
    }
  }
  return this->ReplacedElements > 0;
}

//------------------------------------------------------------------------------
// Moves what is kept together; Offsets still has the sizes of cells.
void MAPDLMesh::Compact()
{
  CellMesh& old = this->Cells;
  Buffer<std::int32_t> oldIds = std::move(this->ElementIds);
  this->CellOfRow = Buffer<std::int32_t>(this->NumberOfRows);
  vtkIdType cells = 0, points = 0;
  std::vector<vtkIdType> firstPoints;
  for (const Item& item : this->ElementItems)
  {
    firstPoints.push_back(points);
    for (vtkIdType row = item.FirstRow; row < item.FirstRow + item.NumberOfRows; ++row)
    {
      const bool isKept = old.Types[row] != VTK_EMPTY_CELL;
      this->CellOfRow[row] = isKept ? static_cast<std::int32_t>(cells++) : -1;
      points += isKept ? old.Offsets[row + 1] : 0;
    }
  }
  CellMesh kept;
  kept.Types = Buffer<unsigned char>(cells);
  kept.Offsets = Buffer<std::int32_t>(cells + 1);
  kept.Connectivity = Buffer<std::int32_t>(points);
  this->ElementIds = Buffer<std::int32_t>(cells);
  Progress().For(static_cast<vtkIdType>(this->ElementItems.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const Item& item = this->ElementItems[i];
        const Outcome& outcome = this->Outcomes[i];
        const std::int32_t* from =
          outcome.Points.empty() ? old.Connectivity.data() + item.FirstNode : outcome.Points.data();
        std::int32_t* to = kept.Connectivity.data() + firstPoints[i];
        for (vtkIdType row = item.FirstRow; row < item.FirstRow + item.NumberOfRows; ++row)
        {
          const std::int32_t size = old.Offsets[row + 1];
          const std::int32_t cell = this->CellOfRow[row];
          if (cell >= 0)
          {
            kept.Types[cell] = old.Types[row];
            kept.Offsets[cell + 1] = size;
            this->ElementIds[cell] = oldIds[row];
            to = std::copy(from, from + size, to);
          }
          from += size;
        }
      }
    });
  this->Cells = std::move(kept);
}

//------------------------------------------------------------------------------
// Cells that share an edge share the point that stands for its missing node.
void MAPDLMesh::AddMidpoints()
{
  std::unordered_map<std::uint64_t, std::int32_t> known;
  for (const Outcome& outcome : this->Outcomes)
  {
    for (const MissingNode& node : outcome.Missing)
    {
      const vtkIdType cell = this->CellOfRow.size() > 0 ? this->CellOfRow[node.Row] : node.Row;
      if (cell < 0)
      {
        continue;
      }
      const auto ends = std::minmax(node.Edge[0], node.Edge[1]);
      const std::uint64_t key =
        std::uint64_t(ends.first) << 32 | static_cast<std::uint32_t>(ends.second);
      const auto next = static_cast<std::int32_t>(this->Cells.NumberOfPoints);
      const auto added = known.emplace(key, next);
      if (added.second)
      {
        this->Midpoints.push_back({ ends.first, ends.second });
        ++this->Cells.NumberOfPoints;
      }
      this->Cells.Connectivity[this->Cells.Offsets[cell] + node.Place] = added.first->second;
    }
  }
}
}
