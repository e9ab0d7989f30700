// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLMesh.h"

#include <algorithm>

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
// Splits rows into tasks; returns the number of rows.
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
      items.push_back({ b, c, rows, extent.GetEndRow(c) - chunk.FirstRow, nodes,
        extent.GetEndNode(c) - chunk.FirstNode, -1 });
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
bool MAPDLMesh::Read(const PieceRequest& request, CellMeshPiece& piece, const Progress& progress)
{
  if (!this->ReadNodeIds(progress.Part(0, 0.3)))
  {
    return false;
  }
  this->NumberOfRows = this->MakeItems(this->Deck.ElementBlocks, this->ElementItems,
    [this](vtkIdType begin, vtkIdType end)
    { return this->Deck.GetFirstNode(end) - this->Deck.GetFirstNode(begin); });
  piece.SetPoints(
    [this](const PieceOfSpace::Visit& visit) { return this->ForEachNode(visit, Progress()); });
  piece.Start(this->NodeIds.size(), this->NumberOfRows, request);
  if (!this->ReadElements(piece, progress.Part(0.3, 0.8)))
  {
    return false;
  }
  this->LeaveOut();
  this->AddMidpoints();
  if (piece.IsWhole())
  {
    piece.Start(this->GetNumberOfPoints(), this->GetNumberOfCells(), request);
    this->FinishWhole();
    return progress.Report(1);
  }
  return this->FindPiece(request, piece, progress.Part(0.8, 0.9)) &&
    this->ReadPiece(piece, progress.Part(0.9, 1));
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
            if (!ForEachMAPDLNode(block.Extent, item.Chunk, [&](const Line& line, vtkIdType)
                  { return block.Format.ReadId(line, *id++, fault); }) &&
              !fault)
            {
              fault.Set(block.Extent.Begin, ErrorKind::Count, "the same number of nodes as before");
            }
          }
        }))
  {
    return false;
  }
  this->Nodes.Build(this->NodeIds.data(), rows);
  this->ReplacedNodes = this->Nodes.GetNumberOfRepeated();
  if (this->ReplacedNodes > 0)
  {
    // The last of several definitions is used, at its own position.
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
bool MAPDLMesh::ReadElements(CellMeshPiece& piece, const Progress& progress)
{
  const bool isWhole = piece.IsWhole();
  this->ElementIds = Buffer<std::int32_t>(this->NumberOfRows);
  this->LeftOut = IdSet(this->NumberOfRows);
  this->Cells.Types = Buffer<unsigned char>(this->NumberOfRows);
  if (isWhole)
  {
    const vtkIdType nodes = this->ElementItems.empty()
      ? 0
      : this->ElementItems.back().FirstNode + this->ElementItems.back().NumberOfNodes;
    this->Cells.Offsets = Buffer<std::int32_t>(this->NumberOfRows + 1);
    this->Cells.Connectivity = Buffer<std::int32_t>(nodes);
  }
  else
  {
    this->Sizes = Buffer<unsigned char>(this->NumberOfRows);
  }
  this->Outcomes.resize(this->ElementItems.size());
  const bool finished = this->ForEachElementItem(progress,
    [&](vtkIdType i)
    {
      if (isWhole)
      {
        this->ReadItem(this->ElementItems[i], this->Outcomes[i]);
      }
      else
      {
        this->CheckItem(this->ElementItems[i], this->Outcomes[i], piece);
      }
    });
  vtkIdType points = 0;
  for (const Outcome& outcome : this->Outcomes)
  {
    this->Note(outcome.Fault);
    points += outcome.NumberOfPoints;
  }
  if (finished && !this->Fault && points > INT32_MAX)
  {
    const char* const place = this->Deck.ElementBlocks[0].Extent.Begin;
    return this->Fault.Set(place, ErrorKind::Unsupported,
      "elements with fewer than 2147483648 nodes in total", std::to_string(points));
  }
  return finished && !this->Fault;
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
  this->ForEachCell(
    item, outcome,
    [&](vtkIdType row, const MAPDLElement& element, const MAPDLCell& cell)
    {
      this->ElementIds[row] = element.Id;
      this->Cells.Types[row] = cell.Type;
      this->Cells.Offsets[row + 1] = cell.Size; // summed up later
      if (cell.Type == VTK_EMPTY_CELL)
      {
        this->LeftOut.Add(row);
      }
      std::int32_t* points = this->Cells.Connectivity.data() + item.FirstNode;
      if (!outcome.Points.empty() || outcome.NumberOfPoints + cell.Size > item.NumberOfNodes)
      {
        // Cells with mid-side nodes may need more space than the row has, if it omits zeros.
        if (outcome.Points.empty())
        {
          outcome.Points.assign(points, points + outcome.NumberOfPoints);
        }
        outcome.Points.resize(static_cast<std::size_t>(outcome.NumberOfPoints + cell.Size));
        points = outcome.Points.data();
      }
      return points + outcome.NumberOfPoints;
    },
    [](vtkIdType, const MAPDLCell&, const std::int32_t*, bool) {});
}

//------------------------------------------------------------------------------
// Leaves out elements that are redefined later.
void MAPDLMesh::ReplaceElements()
{
  const std::int32_t* const ids = this->ElementIds.data();
  if (std::is_sorted(ids, ids + this->NumberOfRows, std::less_equal<std::int32_t>()))
  {
    return; // strictly ascending
  }
  IdMap map;
  map.Build(ids, this->NumberOfRows);
  this->ReplacedElements = map.GetNumberOfRepeated();
  for (vtkIdType row = 0; this->ReplacedElements > 0 && row < this->NumberOfRows; ++row)
  {
    if (map.Find(ids[row]) != row)
    {
      this->LeftOut.Add(row);
    }
  }
}

//------------------------------------------------------------------------------
// Leaves out rows that are not cells, and renumbers cells.
void MAPDLMesh::LeaveOut()
{
  this->ReplaceElements();
  if (this->LeftOut.Number() == 0)
  {
    return;
  }
  this->Kept = IdSet(this->NumberOfRows);
  this->Kept.AddMissing(this->LeftOut);
  Buffer<std::int32_t> ids(this->Kept.Number());
  for (vtkIdType row = 0; row < this->NumberOfRows; ++row)
  {
    if (const vtkIdType cell = this->GetCell(row); cell >= 0)
    {
      ids[cell] = this->ElementIds[row];
    }
  }
  this->ElementIds = std::move(ids);
}

//------------------------------------------------------------------------------
// Whether there are gaps between the points of the kept cells.
bool MAPDLMesh::NeedsCompacting() const
{
  bool needs = this->Kept.GetLimit() > 0;
  for (std::size_t i = 0; i < this->Outcomes.size() && !needs; ++i)
  {
    const Outcome& outcome = this->Outcomes[i];
    needs =
      !outcome.Points.empty() || outcome.NumberOfPoints != this->ElementItems[i].NumberOfNodes;
  }
  return needs;
}

//------------------------------------------------------------------------------
// Closes these gaps; Offsets still contains the sizes of cells.
void MAPDLMesh::Compact()
{
  CellMesh& old = this->Cells;
  vtkIdType points = 0;
  std::vector<vtkIdType> firstPoints;
  for (const Item& item : this->ElementItems)
  {
    firstPoints.push_back(points);
    for (vtkIdType row = item.FirstRow; row < item.FirstRow + item.NumberOfRows; ++row)
    {
      points += this->GetCell(row) >= 0 ? old.Offsets[row + 1] : 0;
    }
  }
  CellMesh kept;
  kept.Types = Buffer<unsigned char>(this->GetNumberOfCells());
  kept.Offsets = Buffer<std::int32_t>(this->GetNumberOfCells() + 1);
  kept.Connectivity = Buffer<std::int32_t>(points);
  this->ForEachElementItem(Progress(),
    [&](vtkIdType i)
    {
      const Item& item = this->ElementItems[i];
      const Outcome& outcome = this->Outcomes[i];
      const std::int32_t* from =
        outcome.Points.empty() ? old.Connectivity.data() + item.FirstNode : outcome.Points.data();
      std::int32_t* to = kept.Connectivity.data() + firstPoints[i];
      for (vtkIdType row = item.FirstRow; row < item.FirstRow + item.NumberOfRows; ++row)
      {
        const std::int32_t size = old.Offsets[row + 1];
        const vtkIdType cell = this->GetCell(row);
        if (cell >= 0)
        {
          kept.Types[cell] = old.Types[row];
          kept.Offsets[cell + 1] = size;
          to = std::copy(from, from + size, to);
        }
        from += size;
      }
    });
  this->Cells = std::move(kept);
}

//------------------------------------------------------------------------------
void MAPDLMesh::FinishWhole()
{
  if (this->NeedsCompacting())
  {
    this->Compact();
  }
  std::int32_t* const offsets = this->Cells.Offsets.data();
  this->Cells.NumberOfCells = this->GetNumberOfCells();
  offsets[0] = 0;
  for (vtkIdType cell = 0; cell < this->Cells.NumberOfCells; ++cell)
  {
    offsets[cell + 1] += offsets[cell];
  }
  for (const Outcome& outcome : this->Outcomes)
  {
    for (const MissingNode& node : outcome.Missing)
    {
      if (const vtkIdType cell = this->GetCell(node.Row); cell >= 0)
      {
        this->Cells.Connectivity[offsets[cell] + node.Place] =
          this->MidpointOfEdge.find(node.GetKey())->second;
      }
    }
  }
  this->Cells.NumberOfPoints = this->GetNumberOfPoints();
}

//------------------------------------------------------------------------------
// Cells that share an edge share the point that replaces its missing node.
void MAPDLMesh::AddMidpoints()
{
  for (const Outcome& outcome : this->Outcomes)
  {
    for (const MissingNode& node : outcome.Missing)
    {
      if (this->GetCell(node.Row) >= 0 &&
        this->MidpointOfEdge
          .emplace(node.GetKey(), static_cast<std::int32_t>(this->GetNumberOfPoints()))
          .second)
      {
        const auto ends = std::minmax(node.Edge[0], node.Edge[1]);
        this->Midpoints.push_back({ ends.first, ends.second });
      }
    }
  }
}
}
