// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GatheredMesh.h"

#include "Base/Text.h"
#include "GatheredArrays.h"
#include "Intake/FaceMesh/GridArrays.h"
#include "Scan/ScanError.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <iterator>

namespace camaron
{
namespace
{
using Piece = GatheredPieces::Piece;

//------------------------------------------------------------------------------
IndexRange GetFaces(const Piece& piece, vtkIdType cell)
{
  return piece.View.GetCellType(cell) == VTK_POLYHEDRON ? piece.View.GetPolyhedronFaces(cell)
                                                        : IndexRange();
}

//------------------------------------------------------------------------------
// Sizes of the kept cells.
Extent Measure(const GatheredPieces& pieces)
{
  Extent sizes;
  pieces.ForEachCell(
    [&sizes](const Piece& piece, vtkIdType cell)
    {
      sizes.Points += piece.View.GetCellPoints(cell).Size;
      const IndexRange faces = GetFaces(piece, cell);
      sizes.PolyhedronFaces += faces.Size;
      for (vtkIdType f = 0; f < faces.Size; ++f)
      {
        sizes.PolyhedronFacePoints += piece.View.GetPolyhedronFacePoints(faces[f]).Size;
      }
    });
  return sizes;
}

//------------------------------------------------------------------------------
template <typename Id>
void MergeCells(const GatheredPieces& pieces, const Extent& sizes, vtkUnstructuredGrid* grid)
{
  Arrays<Id> arrays(pieces.GetNumberOfNewCells(), sizes, false);
  Id next = 0, point = 0, face = 0, corner = 0;
  pieces.ForEachCell(
    [&](const Piece& piece, vtkIdType cell)
    {
      const auto add = [&](Buffer<Id>& ids, Id& end, const IndexRange& points)
      {
        for (vtkIdType i = 0; i < points.Size; ++i)
        {
          ids[end++] = static_cast<Id>(pieces.GetNewPoint(piece, points[i]));
        }
      };
      arrays.Types[next] = piece.View.GetCellType(cell);
      arrays.Offsets[next] = point;
      add(arrays.Connectivity, point, piece.View.GetCellPoints(cell));
      if (sizes.PolyhedronFaces > 0)
      {
        arrays.LocationOffsets[next] = face;
        const IndexRange faces = GetFaces(piece, cell);
        for (vtkIdType f = 0; f < faces.Size; ++f)
        {
          arrays.Locations[face] = face;
          arrays.FaceOffsets[face++] = corner;
          add(arrays.FaceConnectivity, corner, piece.View.GetPolyhedronFacePoints(faces[f]));
        }
      }
      ++next;
    });
  arrays.MoveTo(grid);
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
    points->SetPoint(i, pieces.GetPlace(pieces.GetOldPoint(i)).data());
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
  const Extent sizes = Measure(pieces);
  if (std::max({ pieces.GetNumberOfNewCells(), sizes.Points, sizes.PolyhedronFaces,
        sizes.PolyhedronFacePoints }) <= VTK_TYPE_INT32_MAX)
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
