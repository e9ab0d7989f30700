// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GatheredMesh.h"

#include "PartialArrays.h"
#include "Mesh/MeshView.h"
#include "Scan/Buffer.h"
#include "Scan/ScanError.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDataSetAttributesFieldList.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
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
  int Block;
  MeshView View;
  vtkUnsignedCharArray* Ghosts;
  vtkIdType FirstPoint; // among the points of all pieces
  vtkIdType FirstCell;  // among the cells of all pieces
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
// The global ids of points or cells; none if there are no such ids.
std::vector<vtkIdType> GetGlobalIds(vtkDataSetAttributes* data)
{
  vtkDataArray* const ids = data->GetGlobalIds();
  std::vector<vtkIdType> values(static_cast<std::size_t>(ids ? ids->GetNumberOfTuples() : 0));
  if (auto* const exact = vtkIdTypeArray::SafeDownCast(ids))
  {
    std::copy_n(exact->GetPointer(0), values.size(), values.begin());
    return values;
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<vtkIdType>(ids->GetTuple1(static_cast<vtkIdType>(i)));
  }
  return values;
}

//------------------------------------------------------------------------------
class PieceMerger
{
public:
  explicit PieceMerger(const std::vector<MeshPart>& parts)
  {
    for (const MeshPart& part : parts)
    {
      this->Pieces.push_back({ part.Mesh, part.Block, MeshView(part.Mesh),
        part.Mesh->GetCellGhostArray(), this->NumberOfPoints, this->NumberOfCells });
      this->NumberOfPoints += this->Pieces.back().View.GetNumberOfPoints();
      this->NumberOfCells += this->Pieces.back().View.GetNumberOfCells();
    }
    this->OrderCells();
    this->DropPoints();
    this->NumberPoints();
  }

  bool IsUnchanged() const
  {
    const auto isWhole = [](const std::vector<vtkIdType>& ids, vtkIdType size)
    {
      return static_cast<vtkIdType>(ids.size()) == size && std::is_sorted(ids.begin(), ids.end());
    };
    return isWhole(this->OldCells, this->NumberOfCells) &&
      isWhole(this->OldIds, this->NumberOfPoints);
  }
  /// Points that were taken for another at the same place.
  vtkIdType GetNumberOfTwins() const { return this->NumberOfTwins; }
  /// Places where some piece has several points, and others have some, too.
  vtkIdType GetNumberOfUnclearPlaces() const { return this->NumberOfUnclearPlaces; }

  vtkSmartPointer<vtkUnstructuredGrid> Merge(Warnings& warnings) const
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
    this->MergeArrays(grid, warnings);
    return grid;
  }

private:
  using PieceIterator = std::vector<Piece>::const_iterator;

  void OrderCells();
  void DropPoints();
  void NumberPoints();
  void NumberPointsById(PieceIterator begin, PieceIterator end);
  void NumberPointsByPlace(PieceIterator begin, PieceIterator end);
  std::vector<vtkIdType> FindBorderPoints(PieceIterator begin, PieceIterator end) const;
  void MergeTwins(const vtkIdType* begin, const vtkIdType* end);
  Sizes Measure() const;
  template <typename Id>
  void MergeCells(const Sizes& sizes, vtkUnstructuredGrid* grid) const;
  void MergePoints(vtkUnstructuredGrid* grid) const;
  void MergeArrays(vtkUnstructuredGrid* grid, Warnings& warnings) const;

  /// Calls @a visit(piece, cell) for the cells that stay, in their order.
  template <typename Visit>
  void ForEachCell(Visit&& visit) const
  {
    for (const vtkIdType cell : this->OldCells)
    {
      const Piece& piece = this->FindPiece(cell, &Piece::FirstCell);
      visit(piece, cell - piece.FirstCell);
    }
  }
  /// The piece of a point or cell of all pieces.
  const Piece& FindPiece(vtkIdType id, vtkIdType Piece::*first) const
  {
    return *(std::upper_bound(this->Pieces.begin(), this->Pieces.end(), id,
               [first](vtkIdType i, const Piece& piece) { return i < piece.*first; }) -
      1);
  }
  const Piece& GetPiece(vtkIdType point) const { return this->FindPiece(point, &Piece::FirstPoint); }

  void GetPlace(vtkIdType point, double x[3]) const
  {
    const Piece& piece = this->GetPiece(point);
    piece.View.GetPoint(point - piece.FirstPoint, x);
  }
  bool HaveSamePlace(vtkIdType a, vtkIdType b) const;

  std::vector<Piece> Pieces;
  vtkIdType NumberOfPoints = 0;
  vtkIdType NumberOfCells = 0;
  vtkIdType NumberOfTwins = 0;
  vtkIdType NumberOfUnclearPlaces = 0;
  std::vector<vtkIdType> OldCells; // the cells of all pieces that stay
  std::vector<vtkIdType> NewIds;   // per point of all pieces; -1 if it is left out
  std::vector<vtkIdType> OldIds;   // per new point the first of those that became it
};

//------------------------------------------------------------------------------
void PieceMerger::OrderCells()
{
  bool haveIds = true;
  for (const Piece& piece : this->Pieces)
  {
    haveIds = haveIds && piece.Mesh->GetCellData()->GetGlobalIds();
    for (vtkIdType cell = 0; cell < piece.View.GetNumberOfCells(); ++cell)
    {
      if (!piece.IsLeftOut(cell))
      {
        this->OldCells.push_back(piece.FirstCell + cell);
      }
    }
  }
  if (!haveIds)
  {
    return;
  }
  std::vector<vtkIdType> global;
  for (const Piece& piece : this->Pieces)
  {
    const std::vector<vtkIdType> ids = GetGlobalIds(piece.Mesh->GetCellData());
    global.insert(global.end(), ids.begin(), ids.end());
  }
  std::stable_sort(this->OldCells.begin(), this->OldCells.end(),
    [&global](vtkIdType a, vtkIdType b) { return global[a] < global[b]; });
}

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
  const auto haveIds = [](PieceIterator begin, PieceIterator end)
  {
    return std::all_of(
      begin, end, [](const Piece& piece) { return piece.Mesh->GetPointData()->GetGlobalIds(); });
  };
  PieceIterator begin = this->Pieces.begin();
  const bool isOneNumbering = haveIds(begin, this->Pieces.end());
  while (begin != this->Pieces.end())
  {
    const PieceIterator end = isOneNumbering
      ? this->Pieces.cend()
      : std::find_if(begin, this->Pieces.cend(),
          [begin](const Piece& piece) { return piece.Block != begin->Block; });
    if (haveIds(begin, end))
    {
      this->NumberPointsById(begin, end);
    }
    else
    {
      this->NumberPointsByPlace(begin, end);
    }
    begin = end;
  }
}

//------------------------------------------------------------------------------
void PieceMerger::NumberPointsById(PieceIterator begin, PieceIterator end)
{
  const vtkIdType firstPoint = begin->FirstPoint;
  std::vector<vtkIdType> ids;
  for (PieceIterator piece = begin; piece != end; ++piece)
  {
    const std::vector<vtkIdType> own = GetGlobalIds(piece->Mesh->GetPointData());
    ids.insert(ids.end(), own.begin(), own.end());
  }
  const auto getId = [&ids, firstPoint](vtkIdType point) { return ids[point - firstPoint]; };
  std::vector<vtkIdType> sorted;
  for (vtkIdType point = firstPoint; point < firstPoint + static_cast<vtkIdType>(ids.size());
       ++point)
  {
    if (this->NewIds[point] >= 0)
    {
      sorted.push_back(point);
    }
  }
  std::stable_sort(sorted.begin(), sorted.end(),
    [&getId](vtkIdType a, vtkIdType b) { return getId(a) < getId(b); });

  // Points are the same if their places are, too: blocks of different meshes may use the same ids. More
  // places than this for one id, and the ids mean nothing.
  constexpr std::size_t MaxPlaces = 64;
  std::vector<vtkIdType>& kept = this->OldIds;
  std::size_t first = kept.size(); // of the kept points with the id at hand
  for (const vtkIdType point : sorted)
  {
    if (first < kept.size() && getId(kept[first]) != getId(point))
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
}

//------------------------------------------------------------------------------
void PieceMerger::NumberPointsByPlace(PieceIterator begin, PieceIterator end)
{
  // First the twin of each point, then its number.
  const vtkIdType firstPoint = begin->FirstPoint;
  const vtkIdType lastPoint = end == this->Pieces.end() ? this->NumberOfPoints : end->FirstPoint;
  for (vtkIdType point = firstPoint; point < lastPoint; ++point)
  {
    this->NewIds[point] = this->NewIds[point] < 0 ? -1 : point;
  }
  const std::vector<vtkIdType> border = this->FindBorderPoints(begin, end);
  const vtkIdType* const last = border.data() + border.size();
  for (const vtkIdType* run = border.data(); run != last;)
  {
    const vtkIdType* next = run + 1;
    while (next != last && this->HaveSamePlace(*run, *next))
    {
      ++next;
    }
    this->MergeTwins(run, next);
    run = next;
  }
  for (vtkIdType point = firstPoint; point < lastPoint; ++point)
  {
    vtkIdType& newId = this->NewIds[point];
    if (newId == point)
    {
      newId = static_cast<vtkIdType>(this->OldIds.size());
      this->OldIds.push_back(point);
    }
    else if (newId >= 0)
    {
      newId = this->NewIds[newId]; // a point before this one
    }
  }
}

//------------------------------------------------------------------------------
// Points of pieces that other pieces may have, too, sorted by place.
std::vector<vtkIdType> PieceMerger::FindBorderPoints(PieceIterator begin, PieceIterator end) const
{
  std::vector<vtkBoundingBox> boxes;
  for (PieceIterator piece = begin; piece != end; ++piece)
  {
    boxes.emplace_back(piece->Mesh->GetBounds());
  }
  std::vector<vtkIdType> points;
  for (std::size_t p = 0; p < boxes.size(); ++p)
  {
    std::vector<vtkBoundingBox> neighbors;
    for (std::size_t other = 0; other < boxes.size(); ++other)
    {
      if (other != p && boxes[other].Intersects(boxes[p]))
      {
        neighbors.push_back(boxes[other]);
      }
    }
    const Piece& piece = *(begin + static_cast<std::ptrdiff_t>(p));
    for (vtkIdType i = 0; !neighbors.empty() && i < piece.View.GetNumberOfPoints(); ++i)
    {
      double x[3];
      piece.View.GetPoint(i, x);
      if (this->NewIds[piece.FirstPoint + i] >= 0 && !std::isnan(x[0] + x[1] + x[2]) &&
        std::any_of(neighbors.begin(), neighbors.end(),
          [&x](const vtkBoundingBox& box) { return box.ContainsPoint(x) != 0; }))
      {
        points.push_back(piece.FirstPoint + i);
      }
    }
  }
  vtkSMPTools::Sort(points.begin(), points.end(),
    [this](vtkIdType a, vtkIdType b)
    {
      std::array<double, 3> x, y;
      this->GetPlace(a, x.data());
      this->GetPlace(b, y.data());
      return x != y ? x < y : a < b;
    });
  return points;
}

//------------------------------------------------------------------------------
// Makes points at one place, in the order of the pieces, one; unless some are of the same piece.
void PieceMerger::MergeTwins(const vtkIdType* begin, const vtkIdType* end)
{
  const auto areOfOnePiece = [this](vtkIdType a, vtkIdType b)
  { return &this->GetPiece(a) == &this->GetPiece(b); };
  if (areOfOnePiece(*begin, *(end - 1)))
  {
    return;
  }
  if (std::adjacent_find(begin, end, areOfOnePiece) != end)
  {
    ++this->NumberOfUnclearPlaces;
    return;
  }
  for (const vtkIdType* point = begin + 1; point != end; ++point)
  {
    this->NewIds[*point] = *begin;
    ++this->NumberOfTwins;
  }
}

//------------------------------------------------------------------------------
bool PieceMerger::HaveSamePlace(vtkIdType a, vtkIdType b) const
{
  std::array<double, 3> x, y;
  this->GetPlace(a, x.data());
  this->GetPlace(b, y.data());
  return x == y || std::memcmp(x.data(), y.data(), sizeof(x)) == 0; // or both are no numbers
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
void PieceMerger::MergeArrays(vtkUnstructuredGrid* grid, Warnings& warnings) const
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
  if (this->Pieces.empty())
  {
    return;
  }
  RestoreOrder(points, this->Pieces.front().Mesh->GetPointData());
  RestoreOrder(cells, this->Pieces.front().Mesh->GetCellData());

  std::vector<vtkDataSetAttributes*> pointParts, cellParts;
  for (const Piece& piece : this->Pieces)
  {
    pointParts.push_back(piece.Mesh->GetPointData());
    cellParts.push_back(piece.Mesh->GetCellData());
  }
  const auto getSource = [this](vtkIdType id, vtkIdType Piece::*first)
  {
    const Piece& piece = this->FindPiece(id, first);
    return TupleSource{ static_cast<std::size_t>(&piece - this->Pieces.data()), id - piece.*first };
  };
  std::vector<std::string> leftOut = AddPartialArrays(
    pointParts, static_cast<vtkIdType>(this->OldIds.size()),
    [&](vtkIdType i) { return getSource(this->OldIds[i], &Piece::FirstPoint); }, points);
  const std::vector<std::string> ofCells = AddPartialArrays(
    cellParts, grid->GetNumberOfCells(),
    [&](vtkIdType i) { return getSource(this->OldCells[i], &Piece::FirstCell); }, cells);
  leftOut.insert(leftOut.end(), ofCells.begin(), ofCells.end());
  std::string names;
  for (const std::string& name : leftOut)
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  if (!names.empty())
  {
    warnings.Add("arrays that parts of the mesh lack, or have in another form, are left out: " + names);
  }
}

//------------------------------------------------------------------------------
// Of arrays of the same name, those of the first part.
void MergeFieldData(const std::vector<MeshPart>& parts, vtkFieldData* merged)
{
  for (const MeshPart& part : parts)
  {
    vtkFieldData* const data = part.Mesh->GetFieldData();
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
  return (mesh->GetCellGhostArray() || mesh->GetPointData()->GetGlobalIds() ||
           mesh->GetCellData()->GetGlobalIds()) &&
    !PieceMerger({ { mesh } }).IsUnchanged();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> MergeParts(
  const std::vector<MeshPart>& parts, Warnings& warnings)
{
  // A process or block without points may lack arrays that the others have.
  std::vector<MeshPart> pieces;
  std::copy_if(parts.begin(), parts.end(), std::back_inserter(pieces),
    [](const MeshPart& part) { return part.Mesh->GetNumberOfPoints() > 0; });
  if (pieces.empty() && !parts.empty())
  {
    pieces.push_back(parts.front());
  }
  const PieceMerger merger(pieces);
  const auto merged = merger.Merge(warnings);
  MergeFieldData(parts, merged->GetFieldData());
  if (merger.GetNumberOfTwins() > 0)
  {
    warnings.Add(std::to_string(merger.GetNumberOfTwins()) +
      " points of pieces without global ids were taken for those of other pieces at the same place");
  }
  if (merger.GetNumberOfUnclearPlaces() > 0)
  {
    warnings.Add("the mesh may fall apart at " + std::to_string(merger.GetNumberOfUnclearPlaces()) +
      " places where pieces without global ids have several points");
  }
  return merged;
}
}
