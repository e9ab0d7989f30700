// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceMesh/FaceMeshPiece.h"

#include <algorithm>
#include <mutex>

namespace camaron
{
//------------------------------------------------------------------------------
bool FaceMeshPiece::FindFreeFaces(FaceMesh& mesh, const Progress& progress)
{
  this->AllFaces = this->NumberOfCells == 0 && !mesh.HasEmptyFaces;
  if (this->AllFaces)
  {
    return true;
  }
  if (this->NumberOfCells == 0)
  {
    mesh.FacesOfCells = IdSet(this->NumberOfMeshFaces);
  }
  if (mesh.HasEmptyFaces)
  {
    mesh.Faces.ForEach(progress,
      [&mesh](vtkIdType i, const IdList& face)
      {
        if (face.Size == 0)
        {
          mesh.FacesOfCells.Add(i); // treated as used, so it does not become an item
        }
      });
  }
  IdSet freeFaces(this->NumberOfMeshFaces);
  freeFaces.AddMissing(mesh.FacesOfCells);
  freeFaces.Number();
  this->FreeFaces = freeFaces.GetMembers();
  mesh.FacesOfCells = IdSet();
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
void FaceMeshPiece::AddPoints(
  const FaceMesh& mesh, const IdSet& faces, IdSet& points, const Progress& progress)
{
  mesh.Faces.ForEachOf(faces, progress,
    [&](vtkIdType, const IdList& face)
    {
      for (std::int32_t j = 0; j < face.Size; ++j)
      {
        points.Add(face[j]);
      }
    });
}

//------------------------------------------------------------------------------
// One ghost level: all items that share a point with those of the piece.
void FaceMeshPiece::AddGhosts(const FaceMesh& mesh, const Progress& progress)
{
  IdSet touched(this->NumberOfMeshFaces);
  mesh.Faces.ForEach(progress,
    [&](vtkIdType i, const IdList& face)
    {
      for (std::int32_t j = 0; j < face.Size; ++j)
      {
        if (this->Points.Contains(face[j]))
        {
          touched.Add(i);
          return;
        }
      }
    });

  const auto known = this->Ghosts;
  const auto isNew = [&](vtkIdType item)
  {
    return (item < this->Begin || item >= this->End) &&
      !std::binary_search(known.begin(), known.end(), item);
  };
  IdSet lower(this->NumberOfMeshFaces), upper(this->NumberOfMeshFaces);
  std::mutex mutex;
  mesh.Cells.ForEach(progress,
    [&](vtkIdType i, const IdList& cell)
    {
      bool touches = false;
      for (std::int32_t j = 0; j < cell.Size && !touches; ++j)
      {
        touches = touched.Contains(cell[j]);
      }
      if (touches && isNew(i))
      {
        this->Cells.Add(i);
        for (std::int32_t j = 0; j < cell.Size; ++j)
        {
          (i < this->Begin ? lower : upper).Add(cell[j]);
        }
        const std::lock_guard<std::mutex> lock(mutex);
        this->Ghosts.push_back(i);
      }
    });
  const vtkIdType freeFaces =
    this->AllFaces ? this->NumberOfMeshFaces : static_cast<vtkIdType>(this->FreeFaces.size());
  for (vtkIdType i = 0; i < freeFaces; ++i)
  {
    const vtkIdType item = this->NumberOfCells + i;
    const vtkIdType face = this->GetFace(item);
    if (touched.Contains(face) && isNew(item))
    {
      (item < this->Begin ? lower : upper).Add(face);
      this->Ghosts.push_back(item);
    }
  }
  std::sort(this->Ghosts.begin(), this->Ghosts.end());
  this->AddPoints(mesh, lower, this->LowerPoints, progress);
  this->AddPoints(mesh, upper, this->Points, progress);
  this->Points.AddAll(this->LowerPoints);
  this->Faces.AddAll(lower);
  this->Faces.AddAll(upper);
}

//------------------------------------------------------------------------------
bool FaceMeshPiece::Select(FaceMesh& mesh, const PieceRequest& request, const Progress& progress)
{
  this->NumberOfCells = mesh.Cells.GetCount();
  this->NumberOfMeshPoints = mesh.Points.Count;
  this->NumberOfMeshFaces = mesh.Faces.GetCount();
  this->Cloud = this->NumberOfMeshFaces == 0 && this->NumberOfCells == 0;
  this->Whole = request.NumberOfPieces <= 1;
  if (!this->FindFreeFaces(mesh, progress))
  {
    return false;
  }
  const vtkIdType numberOfItems = this->Cloud ? this->NumberOfMeshPoints
    : this->AllFaces                          ? this->NumberOfMeshFaces
                     : this->NumberOfCells + static_cast<vtkIdType>(this->FreeFaces.size());
  this->End = numberOfItems;
  if (this->Whole)
  {
    return true;
  }

  const vtkIdType pieces = request.NumberOfPieces, piece = request.Piece;
  this->Begin = numberOfItems / pieces * piece + std::min(piece, numberOfItems % pieces);
  this->End = this->Begin + numberOfItems / pieces + (piece < numberOfItems % pieces ? 1 : 0);
  this->Points = IdSet(this->NumberOfMeshPoints);
  this->LowerPoints = IdSet(this->NumberOfMeshPoints);
  this->Faces = IdSet(this->NumberOfMeshFaces);
  this->Cells = IdSet(this->NumberOfCells);
  if (this->Cloud)
  {
    for (vtkIdType id = this->Begin; id < this->End; ++id)
    {
      this->Points.Add(id);
    }
  }
  else
  {
    for (vtkIdType item = this->Begin; item < std::min(this->End, this->NumberOfCells); ++item)
    {
      this->Cells.Add(item);
    }
    mesh.Cells.ForEachOf(this->Cells, progress,
      [&](vtkIdType, const IdList& cell)
      {
        for (std::int32_t j = 0; j < cell.Size; ++j)
        {
          this->Faces.Add(cell[j]);
        }
      });
    for (vtkIdType item = std::max(this->Begin, this->NumberOfCells); item < this->End; ++item)
    {
      this->Faces.Add(this->GetFace(item));
    }
    this->AddPoints(mesh, this->Faces, this->Points, progress);
  }
  this->OwnedPoints = IdSet(this->NumberOfMeshPoints);
  this->OwnedPoints.AddAll(this->Points);
  for (int level = 0; level < request.GhostLevels && !progress.IsStopped(); ++level)
  {
    this->AddGhosts(mesh, progress);
  }
  if (piece == 0 && !this->Cloud)
  {
    this->Points.AddMissing(mesh.PointsOfFaces);
    this->OwnedPoints.AddMissing(mesh.PointsOfFaces);
  }
  this->Points.Number();
  this->Faces.Number();
  this->Cells.Number();
  return mesh.Faces.MakeRandomAccess(this->Faces, progress) &&
    mesh.Cells.MakeRandomAccess(this->Cells, progress);
}
}
