// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshPieces.h"

#include "Criteria/CellNeighborhood.h"
#include "MeshInput.h"
#include "RunTogether.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"


namespace camaron
{
//------------------------------------------------------------------------------
MeshPieces::MeshPieces(const std::vector<DataSetLeaf>& leaves, const EvaluationOptions& options,
  int numberOfRequestedPieces, camaron::Reducer& reducer)
  : Reducer(reducer)
{
  RunTogether(reducer,
    [&]
    {
      for (const DataSetLeaf& leaf : leaves)
      {
        this->Meshes.push_back(AsMesh(leaf.Data));
        vtkDataSet* mesh = this->Meshes.back();
        this->Topologies.push_back(std::make_unique<MeshTopology>(mesh));
        LinkedPiece piece;
        piece.Topology = this->Topologies.back().get();
        piece.Options = options;
        piece.Block = leaf.Number;
        if (vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray())
        {
          piece.Options.Ghosts = ghosts->GetPointer(0);
        }
        piece.Options.IsPieceWithoutGhosts =
          numberOfRequestedPieces > reducer.GetNumberOfProcesses() && !piece.Options.Ghosts;
        piece.PointIds = this->GetIds(mesh->GetPointData()->GetGlobalIds());
        piece.Options.GlobalIds = mesh->GetCellData()->GetGlobalIds();
        piece.CellIds = this->GetIds(piece.Options.GlobalIds);
        this->Pieces.push_back(piece);
      }
    });
}

//------------------------------------------------------------------------------
MeshPieces::~MeshPieces() = default;

//------------------------------------------------------------------------------
const vtkIdType* MeshPieces::GetIds(vtkDataArray* ids)
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
void MeshPieces::Link(bool connectBlocks)
{
  std::int64_t numberOfPieces = static_cast<std::int64_t>(this->Pieces.size());
  this->Reducer.Sum(&numberOfPieces, 1);
  if (numberOfPieces < 2)
  {
    return;
  }
  // What may fail for want of memory or ids comes first.
  RunTogether(this->Reducer,
    [&]
    {
      for (LinkedPiece& piece : this->Pieces)
      {
        piece.Block = connectBlocks ? 0 : piece.Block;
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
  this->Links = LinkPieces(this->Pieces, this->Reducer);
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    this->Pieces[piece].Options.Links = &this->Links[piece];
  }
}

//------------------------------------------------------------------------------
void MeshPieces::FindMeanSizes()
{
  this->Means = GetMeanSizes(this->Pieces, this->Reducer);
  for (LinkedPiece& piece : this->Pieces)
  {
    piece.Options.Means = &this->Means;
  }
}

//------------------------------------------------------------------------------
void MeshPieces::FindSurfaceSides()
{
  this->Sides = camaron::FindSurfaceSides(this->Pieces, this->Reducer);
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    this->Pieces[piece].Options.Sides = &this->Sides[piece];
  }
}

//------------------------------------------------------------------------------
void MeshPieces::FindRegions()
{
  this->Regions = FindMeshRegions(this->Pieces, this->Reducer);
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    this->Pieces[piece].Options.Regions = &this->Regions[piece];
  }
}
}
