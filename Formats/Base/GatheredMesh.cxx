// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GatheredMesh.h"

#include "Mesh/MeshView.h"
#include "Scan/Buffer.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDataSetAttributesFieldList.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>
#include <type_traits>

namespace camaron
{
namespace
{
constexpr int LeftOut = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;

//------------------------------------------------------------------------------
struct Piece
{
  vtkDataSet* Mesh;
  MeshView View;
  vtkUnsignedCharArray* Ghosts;
  vtkIdType FirstPoint; // among the points of all pieces
  bool IsLeftOut(vtkIdType cell) const
  {
    return this->Ghosts && (this->Ghosts->GetValue(cell) & LeftOut) != 0;
  }
};

//------------------------------------------------------------------------------
// Sizes of what stays.
struct Sizes
{
  vtkIdType Cells = 0, Points = 0, Faces = 0, FacePoints = 0;
  bool Polyhedra = false;
};

//------------------------------------------------------------------------------
class PieceMerger
{
public:
  explicit PieceMerger(const std::vector<vtkDataSet*>& meshes)
  {
    for (vtkDataSet* mesh : meshes)
    {
      this->Pieces.push_back(
        { mesh, MeshView(mesh), mesh->GetCellGhostArray(), this->NumberOfPoints });
      this->NumberOfPoints += this->Pieces.back().View.GetNumberOfPoints();
    }
    this->DropPoints();
    this->NumberPoints();
  }

  bool IsUnchanged() const
  {
    return !this->LosesCells && static_cast<vtkIdType>(this->OldIds.size()) == this->NumberOfPoints;
  }

  vtkSmartPointer<vtkUnstructuredGrid> Merge() const
  {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    const Sizes sizes = this->Measure();
    const vtkIdType largest = std::max({ sizes.Cells, sizes.Points, sizes.Faces, sizes.FacePoints });
    if (largest <= std::numeric_limits<vtkTypeInt32>::max())
    {
      this->MergeCells<vtkTypeInt32>(sizes, grid);
    }
    else
    {
      this->MergeCells<vtkTypeInt64>(sizes, grid);
    }
    this->MergePoints(grid);
    this->MergeArrays(grid);
    return grid;
  }

private:
  void DropPoints();
  void NumberPoints();
  Sizes Measure() const;
  template <typename Id>
  void MergeCells(const Sizes& sizes, vtkUnstructuredGrid* grid) const;
  void MergePoints(vtkUnstructuredGrid* grid) const;
  void MergeArrays(vtkUnstructuredGrid* grid) const;

  /// Calls @a visit(piece, cell) for the cells that stay.
  template <typename Visit>
  void ForEachCell(Visit&& visit) const
  {
    for (const Piece& piece : this->Pieces)
    {
      for (vtkIdType cell = 0; cell < piece.View.GetNumberOfCells(); ++cell)
      {
        if (!piece.IsLeftOut(cell))
        {
          visit(piece, cell);
        }
      }
    }
  }
  const Piece& GetPiece(vtkIdType point) const
  {
    return *(std::upper_bound(this->Pieces.begin(), this->Pieces.end(), point,
               [](vtkIdType p, const Piece& piece) { return p < piece.FirstPoint; }) -
      1);
  }

  void GetPlace(vtkIdType point, double x[3]) const
  {
    const Piece& piece = this->GetPiece(point);
    piece.View.GetPoint(point - piece.FirstPoint, x);
  }
  bool HaveSamePlace(vtkIdType a, vtkIdType b) const;

  std::vector<Piece> Pieces;
  vtkIdType NumberOfPoints = 0;
  bool LosesCells = false;
  std::vector<vtkIdType> NewIds; // per point of all pieces; -1 if it is left out
  std::vector<vtkIdType> OldIds; // per new point the first of those that became it
};

//------------------------------------------------------------------------------
// Points that only cells use that are left out.
void PieceMerger::DropPoints()
{
  this->NewIds.assign(static_cast<std::size_t>(this->NumberOfPoints), 0);
  for (const vtkIdType mark : { -1, 0 })
  {
    for (const Piece& piece : this->Pieces)
    {
      for (vtkIdType cell = 0; piece.Ghosts && cell < piece.View.GetNumberOfCells(); ++cell)
      {
        if (piece.IsLeftOut(cell) == (mark < 0))
        {
          this->LosesCells = this->LosesCells || mark < 0;
          const IndexRange points = piece.View.GetCellPoints(cell);
          for (vtkIdType i = 0; i < points.Size; ++i)
          {
            this->NewIds[piece.FirstPoint + points[i]] = mark;
          }
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void PieceMerger::NumberPoints()
{
  std::vector<vtkIdType> global;
  for (const Piece& piece : this->Pieces)
  {
    vtkDataArray* ids = piece.Mesh->GetPointData()->GetGlobalIds();
    for (vtkIdType i = 0; ids && i < piece.View.GetNumberOfPoints(); ++i)
    {
      global.push_back(static_cast<vtkIdType>(ids->GetTuple1(i)));
    }
  }
  for (vtkIdType point = 0; point < this->NumberOfPoints; ++point)
  {
    if (this->NewIds[point] >= 0)
    {
      this->OldIds.push_back(point);
    }
  }
  if (static_cast<vtkIdType>(global.size()) != this->NumberOfPoints)
  {
    global.assign(static_cast<std::size_t>(this->NumberOfPoints), 0);
    std::iota(global.begin(), global.end(), vtkIdType(0)); // no twins
  }
  std::vector<vtkIdType> sorted = this->OldIds;
  std::stable_sort(sorted.begin(), sorted.end(),
    [&global](vtkIdType a, vtkIdType b) { return global[a] < global[b]; });

  // Points are the same if their places are, too: blocks of different meshes may use the same ids. More
  // places than this for one id, and the ids mean nothing.
  constexpr std::size_t MaxPlaces = 64;
  std::vector<vtkIdType> kept;
  std::size_t first = 0; // of the kept points with the id at hand
  for (const vtkIdType point : sorted)
  {
    if (first < kept.size() && global[kept[first]] != global[point])
    {
      first = kept.size();
    }
    std::size_t twin = kept.size() - first < MaxPlaces ? first : kept.size();
    while (twin < kept.size() && !this->HaveSamePlace(kept[twin], point))
    {
      ++twin;
    }
    this->NewIds[point] = static_cast<vtkIdType>(twin);
    if (twin == kept.size())
    {
      kept.push_back(point);
    }
  }
  if (kept.size() < this->OldIds.size())
  {
    this->OldIds.swap(kept);
    return;
  }
  // Nothing to merge: the order stays.
  for (std::size_t i = 0; i < this->OldIds.size(); ++i)
  {
    this->NewIds[this->OldIds[i]] = static_cast<vtkIdType>(i);
  }
}

//------------------------------------------------------------------------------
bool PieceMerger::HaveSamePlace(vtkIdType a, vtkIdType b) const
{
  double x[3], y[3];
  this->GetPlace(a, x);
  this->GetPlace(b, y);
  return std::memcmp(x, y, sizeof(x)) == 0;
}

//------------------------------------------------------------------------------
Sizes PieceMerger::Measure() const
{
  Sizes sizes;
  this->ForEachCell(
    [&sizes](const Piece& piece, vtkIdType cell)
    {
      ++sizes.Cells;
      sizes.Points += piece.View.GetCellPoints(cell).Size;
      if (piece.View.GetCellType(cell) == VTK_POLYHEDRON)
      {
        sizes.Polyhedra = true;
        const IndexRange faces = piece.View.GetPolyhedronFaces(cell);
        sizes.Faces += faces.Size;
        for (vtkIdType f = 0; f < faces.Size; ++f)
        {
          sizes.FacePoints += piece.View.GetPolyhedronFacePoints(faces[f]).Size;
        }
      }
    });
  return sizes;
}

//------------------------------------------------------------------------------
// A vtkCellArray that is filled list by list and then exactly full.
template <typename Id>
class Lists
{
public:
  Lists(vtkIdType lists, vtkIdType values)
    : Offsets(lists + 1)
    , Values(values)
  {
    this->Offsets[0] = 0;
  }
  void Add(vtkIdType value) { this->Values[this->NextValue++] = static_cast<Id>(value); }
  vtkIdType EndList()
  {
    this->Offsets[++this->NextList] = static_cast<Id>(this->NextValue);
    return this->NextList - 1;
  }
  vtkSmartPointer<vtkCellArray> Take()
  {
    using Array =
      typename std::conditional<sizeof(Id) == 4, vtkTypeInt32Array, vtkTypeInt64Array>::type;
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    const auto offsets = this->Offsets.template TakeArray<Array>();
    const auto values = this->Values.template TakeArray<Array>();
    cells->SetData(offsets.Get(), values.Get());
    return cells;
  }

private:
  Buffer<Id> Offsets, Values;
  vtkIdType NextList = 0;
  vtkIdType NextValue = 0;
};

//------------------------------------------------------------------------------
template <typename Id>
void PieceMerger::MergeCells(const Sizes& sizes, vtkUnstructuredGrid* grid) const
{
  Buffer<unsigned char> types(sizes.Cells);
  Lists<Id> cells(sizes.Cells, sizes.Points);
  Lists<Id> faces(sizes.Faces, sizes.FacePoints);
  Lists<Id> locations(sizes.Polyhedra ? sizes.Cells : 0, sizes.Faces);
  vtkIdType next = 0;
  this->ForEachCell(
    [&](const Piece& piece, vtkIdType cell)
    {
      const auto add = [&](Lists<Id>& lists, const IndexRange& points)
      {
        for (vtkIdType i = 0; i < points.Size; ++i)
        {
          lists.Add(this->NewIds[piece.FirstPoint + points[i]]);
        }
        return lists.EndList();
      };
      types[next++] = piece.View.GetCellType(cell);
      add(cells, piece.View.GetCellPoints(cell));
      if (sizes.Polyhedra)
      {
        const IndexRange cellFaces = piece.View.GetCellType(cell) == VTK_POLYHEDRON
          ? piece.View.GetPolyhedronFaces(cell)
          : IndexRange();
        for (vtkIdType f = 0; f < cellFaces.Size; ++f)
        {
          locations.Add(add(faces, piece.View.GetPolyhedronFacePoints(cellFaces[f])));
        }
        locations.EndList();
      }
    });
  const auto typeArray = types.TakeArray<vtkUnsignedCharArray>();
  const auto cellArray = cells.Take();
  if (sizes.Polyhedra)
  {
    const auto locationArray = locations.Take();
    const auto faceArray = faces.Take();
    grid->SetPolyhedralCells(typeArray, cellArray, locationArray, faceArray);
  }
  else
  {
    grid->SetCells(typeArray, cellArray);
  }
}

//------------------------------------------------------------------------------
void PieceMerger::MergePoints(vtkUnstructuredGrid* grid) const
{
  bool single = true;
  for (const Piece& piece : this->Pieces)
  {
    single = single && (piece.View.HasFloatPoints() || piece.View.GetNumberOfPoints() == 0);
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(single ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(static_cast<vtkIdType>(this->OldIds.size()));
  for (std::size_t i = 0; i < this->OldIds.size(); ++i)
  {
    double x[3];
    this->GetPlace(this->OldIds[i], x);
    points->SetPoint(static_cast<vtkIdType>(i), x);
  }
  grid->SetPoints(points);
}

//------------------------------------------------------------------------------
// A FieldList sorts arrays by name; files have them in the order of the mesh.
void RestoreOrder(vtkDataSetAttributes* data, vtkDataSetAttributes* model)
{
  std::vector<std::pair<vtkSmartPointer<vtkAbstractArray>, int>> arrays;
  for (int i = 0; i < model->GetNumberOfArrays(); ++i)
  {
    const char* const name = model->GetAbstractArray(i)->GetName();
    int index = -1;
    vtkAbstractArray* const array = name ? data->GetAbstractArray(name, index) : nullptr;
    if (array)
    {
      arrays.emplace_back(array, data->IsArrayAnAttribute(index));
    }
  }
  for (const auto& array : arrays)
  {
    data->RemoveArray(array.first->GetName());
  }
  for (const auto& array : arrays)
  {
    const int index = data->AddArray(array.first);
    if (array.second >= 0)
    {
      data->SetActiveAttribute(index, array.second);
    }
  }
}

//------------------------------------------------------------------------------
void PieceMerger::MergeArrays(vtkUnstructuredGrid* grid) const
{
  vtkDataSetAttributes::FieldList pointFields, cellFields;
  for (const Piece& piece : this->Pieces)
  {
    pointFields.IntersectFieldList(piece.Mesh->GetPointData());
    cellFields.IntersectFieldList(piece.Mesh->GetCellData());
  }
  vtkPointData* points = grid->GetPointData();
  points->CopyGlobalIdsOn(); // a merged point still has the id of all of which it was made
  points->CopyAllocate(pointFields, static_cast<vtkIdType>(this->OldIds.size()));
  for (std::size_t i = 0; points->GetNumberOfArrays() > 0 && i < this->OldIds.size(); ++i)
  {
    const Piece& piece = this->GetPiece(this->OldIds[i]);
    pointFields.CopyData(static_cast<int>(&piece - this->Pieces.data()), piece.Mesh->GetPointData(),
      this->OldIds[i] - piece.FirstPoint, points, static_cast<vtkIdType>(i));
  }
  vtkCellData* cells = grid->GetCellData();
  cells->CopyGlobalIdsOn();
  cells->CopyAllocate(cellFields, grid->GetNumberOfCells());
  vtkIdType next = 0;
  if (cells->GetNumberOfArrays() > 0)
  {
    this->ForEachCell(
      [&](const Piece& piece, vtkIdType cell)
      {
        cellFields.CopyData(static_cast<int>(&piece - this->Pieces.data()),
          piece.Mesh->GetCellData(), cell, cells, next++);
      });
  }
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(points),
         static_cast<vtkDataSetAttributes*>(cells) })
  {
    data->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  }
  if (!this->Pieces.empty())
  {
    RestoreOrder(points, this->Pieces.front().Mesh->GetPointData());
    RestoreOrder(cells, this->Pieces.front().Mesh->GetCellData());
  }
}

//------------------------------------------------------------------------------
// Of arrays of the same name, those of the first piece.
void MergeFieldData(const std::vector<vtkDataSet*>& pieces, vtkFieldData* merged)
{
  for (vtkDataSet* piece : pieces)
  {
    vtkFieldData* const data = piece->GetFieldData();
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const array = data->GetAbstractArray(i);
      if (array->GetName() && !merged->HasArray(array->GetName()))
      {
        merged->AddArray(array);
      }
    }
  }
}
}

//------------------------------------------------------------------------------
bool HasSeams(vtkDataSet* mesh)
{
  return (mesh->GetCellGhostArray() || mesh->GetPointData()->GetGlobalIds()) &&
    !PieceMerger({ mesh }).IsUnchanged();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> MergePieces(const std::vector<vtkDataSet*>& pieces)
{
  const auto merged = PieceMerger(pieces).Merge();
  MergeFieldData(pieces, merged->GetFieldData());
  return merged;
}
}
