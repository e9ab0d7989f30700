// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedMesh.h"

#include "Cell/CellNeighborhood.h"
#include "Duplicates.h"
#include "Elements/CoincidentPoints.h"
#include "Elements/ElementContext.h"
#include "MeshInput.h"
#include "Ranks/Collective.h"
#include "Ranks/CompletedPieces.h"
#include "Ranks/LinkedPieces.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <limits>

namespace camaron
{
//------------------------------------------------------------------------------
DistributedMesh::DistributedMesh(const std::vector<DataSetLeaf>& leaves,
  const EvaluationOptions& options, int numberOfRequestedPieces, camaron::Reducer& reducer)
  : Reducer(reducer)
  , OthersAreUnknown(numberOfRequestedPieces > reducer.GetNumberOfProcesses())
{
  CheckFaces(leaves, reducer);
  RunCollectively(reducer,
    [&]
    {
      for (const DataSetLeaf& leaf : leaves)
      {
        this->FirstCopies.push_back(FindFirstCopies(leaf.Data));
        this->Meshes.push_back(
          AsMesh(HideRepeatedGhosts(ShareCopiesOfPoints(leaf.Data, this->FirstCopies.back()))));
        vtkDataSet* mesh = this->Meshes.back();
        this->Topologies.push_back(std::make_unique<MeshTopology>(mesh));
        LinkedPiece piece;
        piece.Data = mesh;
        piece.Topology = this->Topologies.back().get();
        piece.Options = options;
        piece.Block = piece.Order = leaf.Number;
        if (vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray())
        {
          piece.Options.Ghosts = ghosts->GetPointer(0);
        }
        piece.Options.IsPieceWithoutGhosts = this->OthersAreUnknown && !piece.Options.Ghosts;
        piece.PointIds = this->GetIds(mesh->GetPointData()->GetGlobalIds());
        piece.Options.GlobalIds = mesh->GetCellData()->GetGlobalIds();
        piece.CellIds = this->GetIds(piece.Options.GlobalIds);
        this->Pieces.push_back(piece);
      }
    });
}

//------------------------------------------------------------------------------
const vtkIdType* DistributedMesh::GetIds(vtkDataArray* ids)
{
  if (!ids)
  {
    return nullptr;
  }
  this->Ids.emplace_back(ids);
  if (!vtkIdTypeArray::FastDownCast(ids))
  {
    this->Ids.back() = vtkSmartPointer<vtkIdTypeArray>::New();
    this->Ids.back()->DeepCopy(ids);
  }
  return vtkIdTypeArray::FastDownCast(this->Ids.back())->GetPointer(0);
}

//------------------------------------------------------------------------------
void DistributedMesh::ShareMarks(std::vector<std::vector<unsigned char>>& marks) const
{
  for (std::size_t piece = 0; piece < marks.size(); ++piece)
  {
    const std::vector<vtkIdType>& firsts = this->FirstCopies[piece];
    for (std::size_t point = 0; point < firsts.size(); ++point)
    {
      marks[piece][firsts[point]] |= marks[piece][point];
    }
    for (std::size_t point = 0; point < firsts.size(); ++point)
    {
      marks[piece][point] = marks[piece][firsts[point]];
    }
  }
}

//------------------------------------------------------------------------------
void DistributedMesh::NumberCells()
{
  const CellIds ids(this->Pieces, this->Reducer);
  this->CellNumbers.assign(this->Pieces.size(), {});
  for (std::size_t p = 0; p < this->Pieces.size() && !ids.AreGlobal(); ++p)
  {
    LinkedPiece& piece = this->Pieces[p];
    std::vector<std::int64_t>& numbers = this->CellNumbers[p];
    for (vtkIdType cell = 0; cell < this->Meshes[p]->GetNumberOfCells(); ++cell)
    {
      numbers.push_back(
        piece.IsCopy(cell) ? std::numeric_limits<std::int64_t>::max() : ids.GetInBlock(p, cell));
    }
    piece.Options.CellNumbers = numbers.data();
  }
}

//------------------------------------------------------------------------------
bool DistributedMesh::AreSeveral()
{
  std::int64_t numberOfPieces = static_cast<std::int64_t>(this->Pieces.size());
  this->Reducer.Sum(&numberOfPieces, 1);
  return numberOfPieces > 1;
}

//------------------------------------------------------------------------------
void DistributedMesh::ConnectBlocks()
{
  for (LinkedPiece& piece : this->Pieces)
  {
    piece.Block = 0;
  }
}

//------------------------------------------------------------------------------
void DistributedMesh::Link()
{
  if (!this->AreSeveral())
  {
    return;
  }
  // Steps that may fail because of memory or ids come first, before any exchange.
  RunCollectively(this->Reducer,
    [&]
    {
      for (const LinkedPiece& piece : this->Pieces)
      {
        if (HasCellsOfDimension(piece.Topology->GetMesh(), 3))
        {
          piece.Topology->GetFaces();
        }
        if (HasCellsOfDimension(piece.Topology->GetMesh(), 2))
        {
          piece.Topology->GetSurfaceEdges();
        }
      }
    });
  this->NumberCells();
  this->Links = LinkPieces(this->Pieces, this->Reducer);
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    this->Pieces[piece].Options.Links = &this->Links[piece];
  }
}

//------------------------------------------------------------------------------
void DistributedMesh::FindFacts(unsigned needs, const std::function<void()>& goOn)
{
  const unsigned known =
    this->CanAskOthers() ? 0u : NeedsPointRegions; // by the topology of one piece
  this->Facts.Find(needs & ~known, this->Pieces, this->Reducer, goOn);
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkDataSet>> DistributedMesh::Complete(
  const std::vector<std::string>& arrays)
{
  Completion completion;
  completion.AsksOthers = this->CanAskOthers();
  completion.Arrays = arrays;
  return CompletePieces(this->Pieces, completion, this->Reducer);
}

//------------------------------------------------------------------------------
std::vector<std::vector<vtkIdType>> DistributedMesh::FindCoincidentPoints(double tolerance)
{
  if (this->CanAskOthers())
  {
    return camaron::FindCoincidentPoints(this->Pieces, tolerance, this->Reducer);
  }
  std::vector<std::vector<vtkIdType>> points;
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    PointNumbers numbers;
    numbers.Ids = this->Pieces[piece].PointIds;
    const std::vector<vtkIdType>& firsts = this->FirstCopies[piece];
    std::vector<unsigned char> isCopy(firsts.size());
    for (std::size_t point = 0; point < firsts.size(); ++point)
    {
      isCopy[point] = firsts[point] != static_cast<vtkIdType>(point);
    }
    points.push_back(camaron::FindCoincidentPoints(
      this->Topologies[piece]->GetMesh(), tolerance, numbers, isCopy));
  }
  return points;
}

//------------------------------------------------------------------------------
std::vector<std::vector<Index>> DistributedMesh::FindMismatchedFaces(
  const std::vector<vtkSmartPointer<vtkDataSet>>& completed, double tolerance)
{
  const bool canAskOthers = this->CanAskOthers();
  std::vector<MeshTopology> topologies(completed.begin(), completed.end());
  std::vector<PieceOfFaces> pieces;
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    vtkUnsignedCharArray* ghosts = completed[piece]->GetCellGhostArray();
    const auto isOwn = [=](Index cell)
    {
      return !canAskOthers || !ghosts ||
        !(ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL);
    };
    const int block = canAskOthers ? this->Pieces[piece].Block : static_cast<int>(piece);
    pieces.push_back({ &topologies[piece], block, isOwn });
  }
  camaron::Reducer alone;
  return camaron::FindMismatchedFaces(pieces, tolerance, canAskOthers ? this->Reducer : alone);
}

//------------------------------------------------------------------------------
std::vector<unsigned> DistributedMesh::FindDimensions()
{
  struct Part
  {
    int Block;
    unsigned Dimensions;
  };
  std::vector<Part> own;
  for (const LinkedPiece& piece : this->Pieces)
  {
    own.push_back({ piece.Block, FindCellDimensions(piece.Topology->GetMesh()) });
  }
  const std::vector<Part> all = this->Reducer.GatherItems(own);
  std::vector<unsigned> dimensions;
  for (const Part& part : own)
  {
    dimensions.push_back(0);
    for (const Part& other : all)
    {
      dimensions.back() |= other.Block == part.Block ? other.Dimensions : 0;
    }
  }
  return dimensions;
}
}
