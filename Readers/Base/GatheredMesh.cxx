// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GatheredMesh.h"

#include "Base/Buffer.h"
#include "Base/Text.h"
#include "GatheredArrays.h"
#include "Scan/ScanError.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnstructuredGrid.h"

#include <iterator>
#include <type_traits>

namespace camaron
{
namespace
{
using Piece = GatheredPieces::Piece;

//------------------------------------------------------------------------------
// Sizes of the kept cells.
struct Sizes
{
  vtkIdType Cells = 0, Points = 0, Faces = 0, FacePoints = 0;
  bool Polyhedra = false;
};

//------------------------------------------------------------------------------
Sizes Measure(const GatheredPieces& pieces)
{
  Sizes sizes;
  pieces.ForEachCell(
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
// A vtkCellArray of known size that is filled list by list.
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
void MergeCells(const GatheredPieces& pieces, const Sizes& sizes, vtkUnstructuredGrid* grid)
{
  Buffer<unsigned char> types(sizes.Cells);
  Lists<Id> cells(sizes.Cells, sizes.Points);
  Lists<Id> faces(sizes.Faces, sizes.FacePoints);
  Lists<Id> locations(sizes.Polyhedra ? sizes.Cells : 0, sizes.Faces);
  vtkIdType next = 0;
  pieces.ForEachCell(
    [&](const Piece& piece, vtkIdType cell)
    {
      const auto add = [&](Lists<Id>& lists, const IndexRange& points)
      {
        for (vtkIdType i = 0; i < points.Size; ++i)
        {
          lists.Add(pieces.GetNewPoint(piece, points[i]));
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
void MergePoints(const GatheredPieces& pieces, vtkUnstructuredGrid* grid)
{
  bool single = true;
  for (const Piece& piece : pieces.GetPieces())
  {
    single = single && (piece.View.HasFloatPoints() || piece.View.GetNumberOfPoints() == 0);
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(single ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(pieces.GetNumberOfNewPoints());
  for (vtkIdType i = 0; i < pieces.GetNumberOfNewPoints(); ++i)
  {
    double x[3];
    pieces.GetPlace(pieces.GetOldPoint(i), x);
    points->SetPoint(i, x);
  }
  grid->SetPoints(points);
}
}

//------------------------------------------------------------------------------
bool HasSeams(vtkDataSet* mesh)
{
  return (mesh->GetCellGhostArray() || mesh->GetPointData()->GetGlobalIds() ||
           mesh->GetCellData()->GetGlobalIds()) &&
    !GatheredPieces({ { mesh } }).IsUnchanged();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> MergeParts(
  const std::vector<MeshPart>& parts, Warnings& warnings)
{
  // Processes or blocks without points may lack arrays that the others have.
  std::vector<MeshPart> filled;
  std::copy_if(parts.begin(), parts.end(), std::back_inserter(filled),
    [](const MeshPart& part) { return part.Mesh->GetNumberOfPoints() > 0; });
  if (filled.empty() && !parts.empty())
  {
    filled.push_back(parts.front());
  }
  const GatheredPieces pieces(filled);
  auto merged = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const Sizes sizes = Measure(pieces);
  if (std::max({ sizes.Cells, sizes.Points, sizes.Faces, sizes.FacePoints }) <= VTK_TYPE_INT32_MAX)
  {
    MergeCells<vtkTypeInt32>(pieces, sizes, merged);
  }
  else
  {
    MergeCells<vtkTypeInt64>(pieces, sizes, merged);
  }
  MergePoints(pieces, merged);
  MergeArrays(pieces, merged, warnings);
  MergeFieldData(parts, merged->GetFieldData());
  if (pieces.GetNumberOfTwins() > 0)
  {
    warnings.Add(CountOf(pieces.GetNumberOfTwins(),
      "point of a piece without global ids was merged with a point of another piece at the same "
      "position",
      "points of pieces without global ids were merged with points of other pieces at the same "
      "position"));
  }
  if (pieces.GetNumberOfUnclearPlaces() > 0)
  {
    warnings.Add("the mesh may be disconnected at " +
      CountOf(pieces.GetNumberOfUnclearPlaces(), "position", "positions") +
      " where pieces without global ids have several points");
  }
  return merged;
}
}
