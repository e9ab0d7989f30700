// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/FaceMesh/FaceMeshPiece.h"

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

  IdSet lower(this->NumberOfMeshFaces), upper(this->NumberOfMeshFaces);
  std::vector<vtkIdType> found;
  std::mutex mutex;
  mesh.Cells.ForEach(progress,
    [&](vtkIdType i, const IdList& cell)
    {
      bool touches = false;
      for (std::int32_t j = 0; j < cell.Size && !touches; ++j)
      {
        touches = touched.Contains(cell[j]);
      }
      if (touches && !this->Cells.Contains(i))
      {
        IdSet& faces = this->FacesBefore.Contains(cell[0]) ? lower : upper;
        for (std::int32_t j = 0; j < cell.Size; ++j)
        {
          faces.Add(cell[j]);
        }
        const std::lock_guard<std::mutex> lock(mutex);
        found.push_back(i);
      }
    });
  for (const vtkIdType cell : found)
  {
    this->Cells.Add(cell);
  }
  const auto ghosts = this->Items.begin() + this->NumberOfOwnedItems;
  const std::vector<vtkIdType> known(ghosts, this->Items.end());
  for (vtkIdType i = 0; i < this->GetNumberOfFreeFaces(); ++i)
  {
    const vtkIdType item = this->NumberOfCells + i;
    const vtkIdType face = this->GetFace(item);
    if (touched.Contains(face) && !this->FacesInside.Contains(face) &&
      !std::binary_search(known.begin(), known.end(), item))
    {
      (this->FacesBefore.Contains(face) ? lower : upper).Add(face);
      found.push_back(item);
    }
  }
  this->Items.insert(this->Items.end(), found.begin(), found.end());
  std::sort(this->Items.begin() + this->NumberOfOwnedItems, this->Items.end());
  this->AddPoints(mesh, lower, this->LowerPoints, progress);
  this->AddPoints(mesh, upper, this->Points, progress);
  this->Points.AddAll(this->LowerPoints);
  this->Faces.AddAll(lower);
  this->Faces.AddAll(upper);
}

//------------------------------------------------------------------------------
// Where the faces are, by their first points. They stand for the elements, as the work on a cell
// grows with its faces.
bool FaceMeshPiece::FindPlaces(
  const FaceMesh& mesh, const PieceRequest& request, const Progress& progress)
{
  const auto getFirst = [](const IdList& face) { return face.Size > 0 ? face[0] : -1; };
  this->Space.Start(this->NumberOfMeshPoints,
    this->Cloud ? this->NumberOfMeshPoints : this->NumberOfMeshFaces, request);
  for (vtkIdType point = 0; this->Cloud && point < this->NumberOfMeshPoints; ++point)
  {
    this->Space.Add(point, point);
  }
  mesh.Faces.ForEach(
    progress, [&](vtkIdType i, const IdList& face) { this->Space.Add(i, getFirst(face)); });
  const bool isGood = this->Space.Find(
    [&](const PieceOfSpace::Visit& visit)
    {
      if (mesh.ReadPoints)
      {
        return mesh.ReadPoints(
          nullptr,
          [&visit](vtkIdType point, const float* place)
          {
            const double x[3] = { place[0], place[1], place[2] };
            visit(point, x);
          },
          progress);
      }
      constexpr vtkIdType BlockSize = 4096;
      return progress.ForBlocks(this->NumberOfMeshPoints, BlockSize,
        [&](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType point = begin; point < end; ++point)
          {
            double x[3];
            mesh.Points.Get(point, x);
            visit(point, x);
          }
        });
    });
  this->FacesInside = IdSet(this->NumberOfMeshFaces);
  this->FacesBefore = IdSet(this->NumberOfMeshFaces);
  return isGood &&
    mesh.Faces.ForEach(progress,
      [&](vtkIdType i, const IdList& face)
      {
        const vtkIdType first = getFirst(face);
        if (this->Space.Has(first))
        {
          this->FacesInside.Add(i);
        }
        else if (this->Space.IsBefore(first))
        {
          this->FacesBefore.Add(i);
        }
      });
}

//------------------------------------------------------------------------------
void FaceMeshPiece::AddOwnedItems(
  const FaceMesh& mesh, const PieceRequest& request, const Progress& progress)
{
  if (this->Cloud)
  {
    for (vtkIdType point = 0; point < this->NumberOfMeshPoints; ++point)
    {
      if (this->Space.Has(point))
      {
        this->Points.Add(point);
        this->Items.push_back(point);
      }
    }
    return;
  }
  mesh.Cells.ForEach(progress,
    [&](vtkIdType i, const IdList& cell)
    {
      if (cell.Size > 0 ? this->FacesInside.Contains(cell[0]) : request.Piece == 0)
      {
        this->Cells.Add(i);
        for (std::int32_t j = 0; j < cell.Size; ++j)
        {
          this->Faces.Add(cell[j]);
        }
      }
    });
  this->Cells.Number();
  const std::vector<std::int32_t> cells = this->Cells.GetMembers();
  this->Items.assign(cells.begin(), cells.end());
  for (vtkIdType i = 0; i < this->GetNumberOfFreeFaces(); ++i)
  {
    const vtkIdType face = this->GetFace(this->NumberOfCells + i);
    if (this->FacesInside.Contains(face))
    {
      this->Faces.Add(face);
      this->Items.push_back(this->NumberOfCells + i);
    }
  }
  this->AddPoints(mesh, this->Faces, this->Points, progress);
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
  this->NumberOfOwnedItems =
    this->Cloud ? this->NumberOfMeshPoints : this->NumberOfCells + this->GetNumberOfFreeFaces();
  if (this->Whole)
  {
    return true;
  }
  if (!this->FindPlaces(mesh, request, progress))
  {
    return false;
  }
  this->Points = IdSet(this->NumberOfMeshPoints);
  this->LowerPoints = IdSet(this->NumberOfMeshPoints);
  this->Faces = IdSet(this->NumberOfMeshFaces);
  this->Cells = IdSet(this->NumberOfCells);
  this->AddOwnedItems(mesh, request, progress);
  this->NumberOfOwnedItems = static_cast<vtkIdType>(this->Items.size());
  this->OwnedPoints = IdSet(this->NumberOfMeshPoints);
  this->OwnedPoints.AddAll(this->Points);
  for (int level = 0; level < request.GhostLevels && !progress.IsStopped(); ++level)
  {
    this->AddGhosts(mesh, progress);
  }
  this->Space = PieceOfSpace();
  this->FacesInside = IdSet();
  this->FacesBefore = IdSet();
  if (request.Piece == 0 && !this->Cloud)
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
