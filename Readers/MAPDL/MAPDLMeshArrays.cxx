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
//------------------------------------------------------------------------------
Buffer<double> MAPDLMesh::ReadPoints(const CellMeshPiece& piece, const Progress& progress)
{
  Buffer<double> coordinates(3 * piece.GetNumberOfPoints());
  // All rows are read, so that all pieces find the same errors.
  if (!this->ForEachNode(false, progress,
        [&](vtkIdType row, std::int32_t, const double* x)
        {
          const vtkIdType node = this->GetNode(row);
          if (const vtkIdType point = node < 0 ? -1 : piece.FindPoint(node); point >= 0)
          {
            std::copy(x, x + 3, coordinates.data() + 3 * point);
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
      const std::int32_t* const ends = this->Midpoints[i].Ends;
      const double* const a = coordinates.data() + 3 * piece.FindPoint(ends[0]);
      const double* const b = coordinates.data() + 3 * piece.FindPoint(ends[1]);
      for (int c = 0; c < 3; ++c)
      {
        coordinates[3 * point + c] = 0.5 * (a[c] + b[c]);
      }
    }
  }
  return coordinates;
}

//------------------------------------------------------------------------------
void MAPDLMesh::AddArrays(const CellMeshPiece& piece, vtkUnstructuredGrid* grid)
{
  Buffer<int> nodeIds(piece.GetNumberOfPoints());
  for (vtkIdType node = 0; node < this->GetNumberOfPoints(); ++node)
  {
    if (const vtkIdType point = piece.FindPoint(node); point >= 0)
    {
      nodeIds[point] = node < this->NodeIds.size() ? this->NodeIds[node] : 0;
    }
  }
  grid->GetPointData()->AddArray(nodeIds.TakeArray<vtkIntArray>(1, "NodeId"));

  Buffer<int> numbers(this->Types.size());
  std::int64_t knownType = -1;
  int number = 0;
  for (vtkIdType cell = 0; cell < numbers.size(); ++cell)
  {
    if (this->Types[cell] != knownType)
    {
      knownType = this->Types[cell];
      number = this->Deck.GetType(knownType).Element;
    }
    numbers[cell] = number;
  }
  vtkCellData* const data = grid->GetCellData();
  const auto add = [data](Buffer<int>& values, const char* name)
  { data->AddArray(values.TakeArray<vtkIntArray>(1, name)); };
  add(this->Ids, "ElementId");
  add(this->Materials, "Material");
  add(numbers, "ElementType");
  add(this->Types, "TypeId");
  add(this->Reals, "Real");
  add(this->Sections, "Section");
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
  for (const Finding& finding : this->Findings)
  {
    undefined += finding.Undefined;
    withoutNodes += finding.WithoutNodes;
    for (const auto& entry : finding.Unknown)
    {
      unknown[entry.first] += entry.second;
    }
  }
  for (const auto& entry : unknown)
  {
    const std::string kind = " of type " + std::to_string(entry.first) + ", which is not a cell, ";
    add(entry.second, "element" + kind + "is ", "elements" + kind + "are ", "omitted");
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
  { add(skipped.Number, one, many, ": " + JoinMAPDLNames(skipped.Names)); };
  addSkipped(this->Deck.Skipped,
    "command that defines or changes the mesh is skipped in a branch or loop (*IF, *DO, *CREATE)",
    "commands that define or change the mesh are skipped in branches or loops (*IF, *DO, *CREATE)");
  addSkipped(this->Deck.Ignored, "command that changes the mesh is not executed",
    "commands that change the mesh are not executed");
}
}
