// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLMesh.h"

#include "Base/Text.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
void AddArray(vtkDataSetAttributes* attributes, Buffer<int>&& values, const char* name)
{
  const auto array = values.TakeArray<vtkIntArray>();
  array->SetName(name);
  attributes->AddArray(array);
}
}

//------------------------------------------------------------------------------
bool MAPDLMesh::ForEachNode(const PieceOfSpace::Visit& visit, const Progress& progress)
{
  return this->ForEachNodeItem(progress,
    [&](const Item& item, MAPDLFault& fault)
    {
      const MAPDLNodeBlock& block = this->Deck.NodeBlocks[item.Block];
      double x[3];
      vtkIdType row = item.FirstRow;
      const auto pass = [&](const double* from)
      {
        const vtkIdType node = this->NodeOfRow.size() > 0 ? this->NodeOfRow[row] : row;
        ++row;
        if (node >= 0)
        {
          visit(node, from);
        }
      };
      for (vtkIdType i = 0; item.FirstCommand >= 0 && i < item.NumberOfRows; ++i)
      {
        pass(this->Deck.Nodes[item.FirstCommand + i].X);
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
            pass(x);
            return true;
          });
      }
    });
}

//------------------------------------------------------------------------------
Buffer<double> MAPDLMesh::ReadPoints(const CellMeshPiece& piece, const Progress& progress)
{
  Buffer<double> coordinates(3 * piece.GetNumberOfPoints());
  // All rows are read, so that all pieces find the same errors.
  if (!this->ForEachNode(
        [&](vtkIdType node, const double* x)
        {
          if (const vtkIdType point = piece.FindPoint(node); point >= 0)
          {
            std::copy(x, x + 3, coordinates.data() + 3 * point);
          }
        },
        progress))
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
  const CellMeshPiece& piece, vtkUnstructuredGrid* grid, const Progress& progress)
{
  Buffer<int> nodeIds(piece.GetNumberOfPoints());
  for (vtkIdType node = 0; node < this->GetNumberOfPoints(); ++node)
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
  const bool finished = this->ForEachElementItem(progress,
    [&](vtkIdType i)
    {
      MAPDLFault fault; // stays unset: all rows have been read before
      std::int64_t knownType = -1;
      int number = 0;
      this->ForEachElement(this->ElementItems[i], false, fault,
        [&](const char*, vtkIdType row, const MAPDLElement& element)
        {
          const vtkIdType at = this->FindCell(row, piece);
          if (at < 0)
          {
            return true;
          }
          if (element.Type != knownType)
          {
            knownType = element.Type;
            number = this->Deck.GetType(knownType).Element;
          }
          ids[at] = element.Id;
          materials[at] = element.Material;
          numbers[at] = number;
          types[at] = element.Type;
          reals[at] = element.Real;
          sections[at] = element.Section;
          return true;
        });
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
  const auto add = [&warnings](vtkIdType count, const std::string& one, const std::string& many,
                     const std::string& rest = {})
  {
    if (count > 0)
    {
      warnings.Add(CountOf(count, one, many) + rest);
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
    const std::string kind = " of type " + std::to_string(entry.first) + ", which is not a cell, ";
    add(entry.second, "element" + kind + "is ", "elements" + kind + "are ",
      this->Options.UnknownAsPoints ? "converted to points" : "omitted");
  }
  add(withoutNodes, "element has no nodes and is", "elements have no nodes and are", " omitted");
  add(undefined,
    "element of a type that the deck does not define; its cell type is derived from its number of "
    "nodes",
    "elements of types that the deck does not define; their cell types are derived from their "
    "numbers of nodes");
  const char* const replaced = " defined again later; the last definition is used";
  add(this->ReplacedNodes, "node is", "nodes are", replaced);
  add(this->ReplacedElements, "element is", "elements are", replaced);
  add(static_cast<vtkIdType>(this->Midpoints.size()),
    "mid-side node is missing and replaced by the middle of its edge",
    "mid-side nodes are missing and replaced by the middle of their edges");
  add(this->Deck.NumberOfClearedRows, "node or element is", "nodes and elements are",
    " omitted, as /CLEAR after them starts a new model");
  add(this->Deck.NumberOfFreeBlocks, "block has", "blocks have",
    " no valid format; numbers separated by blanks or commas are read instead");
  add(this->Deck.NumberOfMiscountedBlocks,
    "block has more or fewer rows than it declares; the actual rows are read",
    "blocks have more or fewer rows than they declare; the actual rows are read");
  const char* const unknownValue = " a parameter or an expression of unknown value; what ";
  add(this->Deck.NumberOfUnknownParameters,
    "command needs" + std::string(unknownValue) + "it defines",
    "commands need" + std::string(unknownValue) + "they define", " is omitted");
  add(this->Deck.NumberOfTurnedNodes, "node is", "nodes are",
    " given in a coordinate system other than the global one; coordinates are not transformed");
  const auto addSkipped = [&add](const MAPDLSkipped& skipped, const char* one, const char* many)
  {
    std::string names;
    for (const std::string& name : skipped.Names)
    {
      names += (names.empty() ? "" : ", ") + name;
    }
    add(skipped.Number, one, many, ": " + names);
  };
  addSkipped(this->Deck.Skipped,
    "command that defines or changes the mesh is skipped in a branch or loop (*IF, *DO, *CREATE)",
    "commands that define or change the mesh are skipped in branches or loops (*IF, *DO, *CREATE)");
  addSkipped(this->Deck.Ignored, "command that changes the mesh is not executed",
    "commands that change the mesh are not executed");
}
}
