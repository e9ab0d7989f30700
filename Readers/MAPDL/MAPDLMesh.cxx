// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLMesh.h"

#include <algorithm>
#include <functional>

namespace camaron
{
//------------------------------------------------------------------------------
// Splits rows into tasks; returns the number of rows.
template <typename Block>
vtkIdType MAPDLMesh::MakeBatches(const std::vector<Block>& blocks, std::vector<Batch>& batches)
{
  constexpr vtkIdType CommandsPerBatch = 4096;
  vtkIdType rows = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    const MAPDLExtent& extent = blocks[b].Extent;
    for (std::size_t c = 0; c < extent.Chunks.size(); ++c)
    {
      const vtkIdType size = extent.GetEndRow(c) - extent.Chunks[c].FirstRow;
      batches.push_back({ b, c, rows, size, -1 });
      rows += size;
    }
    for (vtkIdType i = 0; i < blocks[b].NumberOfCommands; i += CommandsPerBatch)
    {
      const vtkIdType size = std::min(CommandsPerBatch, blocks[b].NumberOfCommands - i);
      batches.push_back({ b, 0, rows, size, blocks[b].FirstCommand + i });
      rows += size;
    }
  }
  return rows;
}

//------------------------------------------------------------------------------
// Reads batches in parallel; false with the first fault in the file, or if aborted.
bool MAPDLMesh::ForEachBatch(const std::vector<Batch>& batches, const Progress& progress,
  FunctionRef<void(std::size_t batch, MAPDLFault& fault)> read)
{
  std::vector<MAPDLFault> faults(batches.size());
  const bool finished = progress.For(static_cast<vtkIdType>(batches.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        read(static_cast<std::size_t>(i), faults[i]);
      }
    });
  for (const MAPDLFault& fault : faults)
  {
    if (fault && (!this->Fault || fault.Place < this->Fault.Place))
    {
      this->Fault = fault;
    }
  }
  return finished && !this->Fault;
}

//------------------------------------------------------------------------------
bool MAPDLMesh::ForEachNode(bool withIds, const Progress& progress, VisitNode visit)
{
  return this->ForEachBatch(this->NodeBatches, progress,
    [&](std::size_t i, MAPDLFault& fault)
    {
      const Batch& batch = this->NodeBatches[i];
      const MAPDLNodeBlock& block = this->Deck.NodeBlocks[batch.Block];
      for (vtkIdType row = 0; batch.FirstCommand >= 0 && row < batch.NumberOfRows; ++row)
      {
        const MAPDLNode& node = this->Deck.Nodes[batch.FirstCommand + row];
        visit(batch.FirstRow + row, node.Id, node.X);
      }
      if (batch.FirstCommand < 0)
      {
        vtkIdType row = batch.FirstRow;
        ForEachMAPDLRow(block.Extent, batch.Chunk, fault,
          [&](const Line& line, vtkIdType)
          {
            std::int32_t id = 0;
            double x[3];
            const bool good = withIds ? block.Format.ReadId(line, id, fault)
                                      : block.Format.ReadPoint(line, x, fault);
            if (good)
            {
              visit(row++, id, x);
            }
            return good ? line.Next : nullptr;
          });
      }
    });
}

//------------------------------------------------------------------------------
bool MAPDLMesh::ReadNodeIds(const Progress& progress)
{
  const vtkIdType rows = MakeBatches(this->Deck.NodeBlocks, this->NodeBatches);
  this->NodeIds = Buffer<std::int32_t>(rows);
  if (!this->ForEachNode(true, progress,
        [this](vtkIdType row, std::int32_t id, const double*) { this->NodeIds[row] = id; }))
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
bool MAPDLMesh::Read(const PieceRequest& request, CellMeshPiece& piece, const Progress& progress)
{
  if (!this->ReadNodeIds(progress.Part(0, 0.3)))
  {
    return false;
  }
  const vtkIdType rows = MakeBatches(this->Deck.ElementBlocks, this->ElementBatches);
  this->ElementIds = Buffer<std::int32_t>(rows);
  this->LeftOut = IdSet(rows);
  this->Findings.resize(this->ElementBatches.size());
  piece.SetPoints(
    [this](const PieceOfSpace::Visit& visit)
    {
      return this->ForEachNode(false, Progress(),
        [&](vtkIdType row, std::int32_t, const double* x)
        {
          if (const vtkIdType node = this->GetNode(row); node >= 0)
          {
            visit(node, x);
          }
        });
    });
  // Most decks have a cell in every row, and define all nodes of these; then the first pass over
  // the elements is also the first that visits their cells, or the only one.
  piece.Start(this->NodeIds.size(), rows, request);
  if (!this->CheckCells(piece, progress.Part(0.3, 0.8)))
  {
    return false;
  }
  this->LeaveOutElements();
  this->AddMidpoints();
  const bool isFinal = this->GetNumberOfCells() == rows && this->Midpoints.empty();
  if (!isFinal)
  {
    piece.Start(this->GetNumberOfPoints(), this->GetNumberOfCells(), request);
  }
  for (bool goesOn = isFinal ? piece.NextPass() : !piece.IsWhole(); goesOn;
    goesOn = piece.NextPass())
  {
    if (!this->VisitCells(piece, progress.Part(0.8, 0.9)))
    {
      return false;
    }
  }
  return piece.IsFound() &&
    ((isFinal && piece.IsWhole()) || this->StoreCells(piece, progress.Part(0.9, 1))) &&
    this->Fill();
}

//------------------------------------------------------------------------------
// Calls visit(place, row, element) for the elements of a batch until it returns false.
void MAPDLMesh::ForEachElement(const Batch& batch, MAPDLFault& fault, VisitElement visit) const
{
  const MAPDLElementBlock& block = this->Deck.ElementBlocks[batch.Block];
  if (batch.FirstCommand < 0)
  {
    MAPDLElement element;
    vtkIdType row = batch.FirstRow;
    ForEachMAPDLRow(block.Extent, batch.Chunk, fault,
      [&](const Line& line, vtkIdType)
      {
        const char* const next = block.Format.Read(line, block.Extent.End, element, fault);
        return next && visit(line.Begin, row++, element) ? next : nullptr;
      });
  }
  for (vtkIdType i = 0; batch.FirstCommand >= 0 && i < batch.NumberOfRows; ++i)
  {
    const vtkIdType command = batch.FirstCommand + i;
    if (!visit(
          this->Deck.Elements[command].Place, batch.FirstRow + i, this->Deck.GetElement(command)))
    {
      return;
    }
  }
}

//------------------------------------------------------------------------------
void MAPDLMesh::ForEachCell(const Batch& batch, Finding& finding, VisitCell visit) const
{
  std::int64_t knownType = -1;
  int number = 0;
  MAPDLClass elementClass = MAPDLClass::Undefined;
  vtkIdType next = batch.FirstCell;
  const MAPDLElementFormat& format = this->Deck.ElementBlocks[batch.Block].Format;
  const int fullLine = batch.FirstCommand < 0 && format.Key == MAPDLElementKey::None
    ? format.GetNodesOnFirstLine()
    : -1;
  this->ForEachElement(batch, finding.Fault,
    [&](const char* place, vtkIdType row, const MAPDLElement& element)
    {
      if (this->LeftOut.Contains(row))
      {
        return true;
      }
      if (element.Type != knownType)
      {
        knownType = element.Type;
        const MAPDLType type = this->Deck.GetType(knownType);
        number = type.Element;
        elementClass = GetMAPDLClass(number, type.Shape);
      }
      if (element.NumberOfNodes == fullLine &&
        (elementClass == MAPDLClass::Solid || elementClass == MAPDLClass::Undefined))
      {
        return finding.Fault.Set(place, ErrorKind::Unsupported,
          "the key SOLID for elements that may have more nodes than fit on a line",
          "type " + std::to_string(knownType));
      }
      MAPDLCell cell;
      if (this->Options.SurfaceEffects || !IsMAPDLSurfaceEffect(number))
      {
        MakeMAPDLCell(
          elementClass, element.Nodes, element.NumberOfNodes, this->Options.Linear, cell);
        if (elementClass == MAPDLClass::Unknown && cell.Type == VTK_EMPTY_CELL)
        {
          ++finding.Unknown[number];
        }
        finding.Undefined += elementClass == MAPDLClass::Undefined;
        finding.WithoutNodes += element.NumberOfNodes == 0;
      }
      const std::size_t missing = finding.Missing.size();
      if (!this->FindPoints(place, row, cell, finding))
      {
        return false;
      }
      visit(row, next++, element, cell, finding.Missing.size() == missing);
      return true;
    });
}

//------------------------------------------------------------------------------
// Replaces the nodes of a cell by its points. Midpoints that do not exist yet are missing.
bool MAPDLMesh::FindPoints(
  const char* place, vtkIdType row, MAPDLCell& cell, Finding& finding) const
{
  for (std::int32_t i = 0; i < cell.Size; ++i)
  {
    const std::int32_t id = cell.Nodes[i];
    std::int32_t& point = cell.Nodes[i];
    point = this->Nodes.Find(id);
    if (point >= 0)
    {
      continue;
    }
    const auto edge = GetMAPDLEdge(cell, i);
    if (id != 0 || edge[0] < 0)
    {
      return finding.Fault.Set(place, ErrorKind::Index, "an element whose nodes are defined",
        "node " + std::to_string(id) + this->Deck.GetReasonForMissing(id));
    }
    const auto ends = std::minmax(cell.Nodes[edge[0]], cell.Nodes[edge[1]]);
    const MissingNode node = { row, { ends.first, ends.second } };
    const auto known = this->MidpointOfEdge.find(node.GetKey());
    if (known != this->MidpointOfEdge.end())
    {
      point = known->second;
    }
    else
    {
      finding.Missing.push_back(node);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool MAPDLMesh::CheckCells(CellMeshPiece& piece, const Progress& progress)
{
  if (piece.IsWhole())
  {
    this->Allocate(this->ElementIds.size());
  }
  return this->ForEachBatch(this->ElementBatches, progress,
    [&](std::size_t i, MAPDLFault& fault)
    {
      this->ForEachCell(this->ElementBatches[i], this->Findings[i],
        [&](vtkIdType row, vtkIdType, const MAPDLElement& element, const MAPDLCell& cell,
          bool isComplete)
        {
          this->ElementIds[row] = element.Id;
          if (cell.Type == VTK_EMPTY_CELL)
          {
            this->LeftOut.Add(row);
          }
          else if (isComplete && piece.IsWhole())
          {
            this->Store(row, element, cell, this->Sinks[i]);
          }
          else if (isComplete)
          {
            piece.Visit(row, cell.Nodes, cell.Size);
          }
        });
      fault = this->Findings[i].Fault;
    });
}

//------------------------------------------------------------------------------
bool MAPDLMesh::VisitCells(CellMeshPiece& piece, const Progress& progress)
{
  return this->ForEachBatch(this->ElementBatches, progress,
    [&](std::size_t i, MAPDLFault&)
    {
      Finding known;
      this->ForEachCell(this->ElementBatches[i], known,
        [&](vtkIdType, vtkIdType index, const MAPDLElement&, const MAPDLCell& cell, bool)
        { piece.Visit(index, cell.Nodes, cell.Size); });
    });
}

//------------------------------------------------------------------------------
bool MAPDLMesh::StoreCells(const CellMeshPiece& piece, const Progress& progress)
{
  this->Allocate(piece.GetNumberOfCells());
  return this->ForEachBatch(this->ElementBatches, progress,
    [&](std::size_t i, MAPDLFault&)
    {
      const Batch& batch = this->ElementBatches[i];
      const vtkIdType end = i + 1 < this->ElementBatches.size()
        ? this->ElementBatches[i + 1].FirstCell
        : this->GetNumberOfCells();
      vtkIdType first = batch.FirstCell;
      while (first < end && piece.FindCell(first) < 0)
      {
        ++first;
      }
      if (first == end)
      {
        return;
      }
      Finding known;
      this->ForEachCell(batch, known,
        [&](vtkIdType, vtkIdType index, const MAPDLElement& element, const MAPDLCell& cell, bool)
        {
          if (const vtkIdType kept = piece.FindCell(index); kept >= 0)
          {
            MAPDLCell local = cell;
            for (std::int32_t p = 0; p < cell.Size; ++p)
            {
              local.Nodes[p] = static_cast<std::int32_t>(piece.FindPoint(cell.Nodes[p]));
            }
            this->Store(kept, element, local, this->Sinks[i]);
          }
        });
    });
}

//------------------------------------------------------------------------------
void MAPDLMesh::Allocate(vtkIdType cells)
{
  this->Sinks.assign(this->ElementBatches.size(), CellSink());
  for (Buffer<int>* array :
    { &this->Ids, &this->Materials, &this->Types, &this->Reals, &this->Sections })
  {
    *array = Buffer<int>(cells);
  }
}

//------------------------------------------------------------------------------
void MAPDLMesh::Store(
  vtkIdType cell, const MAPDLElement& element, const MAPDLCell& points, CellSink& sink)
{
  sink.BeginCell(points.Type);
  for (std::int32_t i = 0; i < points.Size; ++i)
  {
    sink.AddPoint(points.Nodes[i]);
  }
  this->Ids[cell] = element.Id;
  this->Materials[cell] = element.Material;
  this->Types[cell] = element.Type;
  this->Reals[cell] = element.Real;
  this->Sections[cell] = element.Section;
}

//------------------------------------------------------------------------------
bool MAPDLMesh::Fill()
{
  ScanError error;
  return FillCells(this->Sinks, this->Cells, error) ||
    this->Fault.Set(this->Deck.ElementBlocks[0].Extent.Begin, error.Kind, error.Message, "more");
}

//------------------------------------------------------------------------------
// Numbers the cells without elements that are no cells, or are redefined later.
void MAPDLMesh::LeaveOutElements()
{
  const std::int32_t* const ids = this->ElementIds.data();
  const vtkIdType rows = this->ElementIds.size();
  if (!std::is_sorted(ids, ids + rows, std::less_equal<std::int32_t>())) // strictly ascending
  {
    IdMap map;
    map.Build(ids, rows);
    this->ReplacedElements = map.GetNumberOfRepeated();
    for (vtkIdType row = 0; this->ReplacedElements > 0 && row < rows; ++row)
    {
      if (map.Find(ids[row]) != row)
      {
        this->LeftOut.Add(row);
      }
    }
  }
  Buffer<std::int32_t> kept(rows - this->LeftOut.Number());
  vtkIdType cell = 0;
  for (Batch& batch : this->ElementBatches)
  {
    batch.FirstCell = cell;
    for (vtkIdType row = batch.FirstRow; row < batch.FirstRow + batch.NumberOfRows; ++row)
    {
      if (!this->LeftOut.Contains(row))
      {
        kept[cell++] = ids[row];
      }
    }
  }
  this->ElementIds = std::move(kept);
}

//------------------------------------------------------------------------------
// Cells that share an edge share the point that replaces its missing node.
void MAPDLMesh::AddMidpoints()
{
  for (const Finding& finding : this->Findings)
  {
    for (const MissingNode& node : finding.Missing)
    {
      if (!this->LeftOut.Contains(node.Row) &&
        this->MidpointOfEdge
          .emplace(node.GetKey(), static_cast<std::int32_t>(this->GetNumberOfPoints()))
          .second)
      {
        this->Midpoints.push_back(node);
      }
    }
  }
}
}
