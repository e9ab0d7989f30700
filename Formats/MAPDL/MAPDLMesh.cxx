// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLMesh.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <unordered_map>

namespace camaron
{
namespace
{
constexpr vtkIdType CommandsPerItem = 4096;

//------------------------------------------------------------------------------
void AddArray(vtkDataSetAttributes* attributes, Buffer<int>&& values, const char* name)
{
  const auto array = values.TakeArray<vtkIntArray>();
  array->SetName(name);
  attributes->AddArray(array);
}
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

//------------------------------------------------------------------------------
Buffer<double> MAPDLMesh::ReadPoints(const CellPiece& piece, const Progress& progress)
{
  Buffer<double> coordinates(3 * piece.GetNumberOfPoints());
  const auto find = [&](vtkIdType row)
  {
    const vtkIdType node = this->NodeOfRow.size() > 0 ? this->NodeOfRow[row] : row;
    return node < 0 ? -1 : piece.FindPoint(node);
  };
  // All rows are read, so that what is wrong is wrong for all pieces.
  if (!this->ForEachNodeItem(progress,
        [&](const Item& item, MAPDLFault& fault)
        {
          const MAPDLNodeBlock& block = this->Deck.NodeBlocks[item.Block];
          double x[3];
          vtkIdType row = item.FirstRow;
          const auto store = [&](const double* from)
          {
            const vtkIdType point = find(row++);
            if (point >= 0)
            {
              std::copy(from, from + 3, coordinates.data() + 3 * point);
            }
          };
          for (vtkIdType i = 0; item.FirstCommand >= 0 && i < item.NumberOfRows; ++i)
          {
            store(this->Deck.Nodes[item.FirstCommand + i].X);
          }
          if (item.FirstCommand < 0)
          {
            ForEachMAPDLNode(block.Extent, item.Chunk,
              [&](const Line& line, vtkIdType)
              {
                if (!block.Format.ReadCoordinates(line, x, fault))
                {
                  return false;
                }
                store(x);
                return true;
              });
          }
        }))
  {
    return {};
  }
  for (std::size_t i = 0; i < this->Midpoints.size(); ++i)
  {
    const vtkIdType point = piece.FindPoint(this->NodeIds.size() + static_cast<vtkIdType>(i));
    if (point >= 0) // its cell is in the piece, and with it the ends of the edge
    {
      const double* const a = coordinates.data() + 3 * piece.FindPoint(this->Midpoints[i][0]);
      const double* const b = coordinates.data() + 3 * piece.FindPoint(this->Midpoints[i][1]);
      for (int c = 0; c < 3; ++c)
      {
        coordinates[3 * point + c] = 0.5 * (a[c] + b[c]);
      }
    }
  }
  return coordinates;
}

//------------------------------------------------------------------------------
bool MAPDLMesh::AddArrays(
  const CellPiece& piece, vtkUnstructuredGrid* grid, const Progress& progress)
{
  Buffer<int> nodeIds(piece.GetNumberOfPoints());
  for (vtkIdType node = 0;
       node < this->NodeIds.size() + static_cast<vtkIdType>(this->Midpoints.size()); ++node)
  {
    if (const vtkIdType point = piece.FindPoint(node); point >= 0)
    {
      nodeIds[point] = node < this->NodeIds.size() ? this->NodeIds[node] : 0;
    }
  }
  AddArray(grid->GetPointData(), std::move(nodeIds), "NodeId");

  const vtkIdType cells = piece.GetNumberOfCells();
  Buffer<int> ids(cells), materials(cells), numbers(cells), types(cells), reals(cells),
    sections(cells);
  const bool finished = progress.For(static_cast<vtkIdType>(this->ElementItems.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        MAPDLFault fault; // there was none when all was read
        std::int64_t knownType = -1;
        int number = 0;
        this->ForEachElement(this->ElementItems[i], false, fault,
          [&](const char*, vtkIdType row, const MAPDLElement& element)
          {
            const vtkIdType cell = this->CellOfRow.size() > 0 ? this->CellOfRow[row] : row;
            const vtkIdType at = cell < 0 ? -1 : piece.FindCell(cell);
            if (at < 0)
            {
              return true;
            }
            if (element.Type != knownType)
            {
              knownType = element.Type;
              const auto found = this->Deck.Types.find(knownType);
              number = found == this->Deck.Types.end() ? 0 : found->second.Element;
            }
            ids[at] = element.Id;
            materials[at] = element.Material;
            numbers[at] = number;
            types[at] = element.Type;
            reals[at] = element.Real;
            sections[at] = element.Section;
            return true;
          });
      }
    });
  vtkCellData* const data = grid->GetCellData();
  AddArray(data, std::move(ids), "ElementId");
  AddArray(data, std::move(materials), "Material");
  AddArray(data, std::move(numbers), "ElementType");
  AddArray(data, std::move(types), "TypeId");
  AddArray(data, std::move(reals), "Real");
  AddArray(data, std::move(sections), "Section");
  return finished;
}

//------------------------------------------------------------------------------
void MAPDLMesh::Warn(Warnings& warnings) const
{
  const auto add = [&warnings](vtkIdType count, const std::string& sentence)
  {
    if (count > 0)
    {
      warnings.Add(std::to_string(count) + " " + sentence);
    }
  };
  std::map<int, vtkIdType> unknown;
  vtkIdType undefined = 0, withoutNodes = 0;
  for (const Outcome& outcome : this->Outcomes)
  {
    undefined += outcome.Undefined;
    withoutNodes += outcome.WithoutNodes;
    for (const auto& entry : outcome.Unknown)
    {
      unknown[entry.first] += entry.second;
    }
  }
  for (const auto& entry : unknown)
  {
    add(entry.second,
      "elements of type " + std::to_string(entry.first) +
        (this->Options.UnknownAsPoints ? ", which is no cell, are points"
                                       : ", which is no cell, are left out"));
  }
  add(withoutNodes, "elements have no nodes and are left out");
  add(undefined,
    "elements of types that the deck does not define; their cells follow from the "
    "numbers of their nodes");
  add(this->ReplacedNodes, "nodes are defined again later; the last definition counts");
  add(this->ReplacedElements, "elements are defined again later; the last definition counts");
  add(static_cast<vtkIdType>(this->Midpoints.size()),
    "mid-side nodes are missing; points in the middle of their edges stand for them");
  add(this->Deck.NumberOfFreeBlocks,
    "blocks have no format that makes sense; blanks and commas divide their numbers");
  add(this->Deck.NumberOfUnknownParameters,
    "commands need a parameter whose value is not known; what they define is left out");
  add(this->Deck.NumberOfTurnedNodes,
    "nodes are given in a coordinate system other than the global one, which is not regarded");
  add(this->Deck.NumberOfSkipped,
    "commands that define nodes or elements stand in branches or loops (*IF, *DO, *CREATE), which "
    "are "
    "skipped");
  std::string names;
  for (const std::string& name : this->Deck.IgnoredNames)
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  add(this->Deck.NumberOfIgnored, "commands that change the mesh are not executed: " + names);
}
}
