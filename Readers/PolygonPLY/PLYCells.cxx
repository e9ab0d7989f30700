// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PLYCells.h"

#include "Base/Number.h"
#include "Base/Parallel.h"
#include "Mesh/CellShape.h"
#include "PLYLists.h"

#include <algorithm>
#include <mutex>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
unsigned char GetType(PLYRole role, vtkIdType size)
{
  return role == PLYRole::Edges && size > 2 ? static_cast<unsigned char>(VTK_POLY_LINE)
                                            : GetPolygonType(size);
}

}

//------------------------------------------------------------------------------
struct PLYCells::Extent
{
  vtkIdType NumberOfIds = 0;
  PLYSizes Sizes;
  Tally Empty;
  Buffer<std::int32_t> Strips;
  Buffer<std::int32_t> Edges; ///< both ends of each edge, unless they are lists

  /// Size of a cell of strips, or of a row.
  vtkIdType GetCellSize(vtkIdType i) const
  {
    return this->Strips.size() > 0 ? 3 : this->Sizes.GetSize(i);
  }
  vtkIdType GetCellOffset(vtkIdType i) const
  {
    return this->Strips.size() > 0 ? 3 * i : this->Sizes.GetOffset(i);
  }

  /// Calls visit(row, points) for the triangles of strips, which -1 separates; orientation
  /// alternates. Those with a repeated vertex, which connect parts of a strip, are left out.
  template <typename Visit>
  void ForEachTriangle(vtkIdType rows, Visit&& visit) const
  {
    for (vtkIdType row = 0; row < rows; ++row)
    {
      const std::int32_t* const ids = this->Strips.data() + this->Sizes.GetOffset(row);
      const vtkIdType size = this->Sizes.GetSize(row);
      vtkIdType begin = 0;
      for (vtkIdType i = 0; i < size; ++i)
      {
        if (ids[i] < 0)
        {
          begin = i + 1;
        }
        else if (i >= begin + 2)
        {
          const bool isOdd = ((i - begin) & 1) != 0;
          const std::int32_t points[3] = { ids[i - 2], ids[isOdd ? i : i - 1],
            ids[isOdd ? i - 1 : i] };
          if (points[0] != points[1] && points[1] != points[2] && points[2] != points[0])
          {
            visit(row, points);
          }
        }
      }
    }
  }
};

//------------------------------------------------------------------------------
bool PLYCells::MeasureStrips(PLYPart& part, Extent& extent, const Progress& progress)
{
  extent.Strips = Buffer<std::int32_t>(extent.Sizes.Total);
  const PLYIds expected = { "a vertex of a strip", this->NumberOfPoints, true };
  const PLYLists lists(extent.Sizes, extent.Strips.data());
  if (!part.Rows->ReadIds(part.List, expected, lists, progress))
  {
    return false;
  }
  vtkIdType triangles = 0;
  extent.ForEachTriangle(
    part.Rows->GetCount(), [&](vtkIdType, const std::int32_t*) { ++triangles; });
  part.NumberOfCells = triangles;
  extent.NumberOfIds = 3 * triangles;
  return true;
}

//------------------------------------------------------------------------------
// Counts lists with fewer than three vertices.
void PLYCells::CountFaces(PLYPart& part, Extent& extent)
{
  const vtkIdType count = part.Rows->GetCount();
  if (extent.Sizes.Common > 2 || extent.Sizes.Least > 2)
  {
    return;
  }
  std::mutex mutex;
  ParallelFor(count, LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      Tally none, few;
      for (vtkIdType row = begin; row < end; ++row)
      {
        const vtkIdType size = extent.Sizes.GetSize(row);
        if (size < 3 && (size == 0 || part.Role == PLYRole::Faces))
        {
          (size == 0 ? none : few).Add(row);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      this->Empty.Merge(none);
      extent.Empty.Merge(none);
      this->Short.Merge(few);
    });
}

//------------------------------------------------------------------------------
bool PLYCells::MeasurePart(PLYPart& part, Extent& extent, const Progress& progress)
{
  part.NumberOfCells = part.Rows->GetCount();
  if (part.Role == PLYRole::Edges && part.List < 0)
  {
    extent.NumberOfIds = 2 * part.NumberOfCells;
    extent.Sizes.Common = 2;
    extent.Sizes.Total = extent.NumberOfIds;
    return true;
  }
  if (part.NumberOfCells == 0)
  {
    return true;
  }
  if (!part.Rows->ReadSizes(part.List, extent.Sizes, progress.Part(0, 0.3)))
  {
    return false;
  }
  if (part.Role == PLYRole::Strips)
  {
    return this->MeasureStrips(part, extent, progress.Part(0.3, 1));
  }
  extent.NumberOfIds = extent.Sizes.Total;
  if (part.Role != PLYRole::Polyhedra)
  {
    this->CountFaces(part, extent);
  }
  return true;
}

//------------------------------------------------------------------------------
bool PLYCells::ReadEdges(PLYPart& part, std::int32_t* ids, const Progress& progress)
{
  const vtkIdType count = part.Rows->GetCount();
  Buffer<double> ends(2 * count);
  const std::vector<PLYColumn> columns = { { part.Ends[0], -1, PLYConversion::Value,
                                             PLYType::Double, ends.data(), 2 },
    { part.Ends[1], -1, PLYConversion::Value, PLYType::Double, ends.data() + 1, 2 } };
  if (!part.Rows->ReadColumns(columns, PLYTargets(), progress))
  {
    return false;
  }
  const auto limit = static_cast<double>(this->NumberOfPoints);
  for (vtkIdType i = 0; i < 2 * count; ++i)
  {
    const double end = ends[i];
    if (!(end >= 0 && end < limit && end == static_cast<std::int32_t>(end)))
    {
      const std::string range =
        limit > 0 ? " from 0 to " + std::to_string(this->NumberOfPoints - 1) : " (there are none)";
      std::string found;
      AppendNumber(found, end);
      return part.Rows->FailAt(
        i / 2, part.Ends[i % 2], ErrorKind::Index, "a vertex of an edge" + range, found);
    }
    ids[i] = static_cast<std::int32_t>(end);
  }
  return true;
}

//------------------------------------------------------------------------------
void PLYCells::FillStrips(PLYPart& part, const Extent& extent, std::int32_t* id)
{
  part.RowOfCell = Buffer<std::int32_t>(part.NumberOfCells);
  std::int32_t* rowOfCell = part.RowOfCell.data();
  extent.ForEachTriangle(part.Rows->GetCount(),
    [&](vtkIdType row, const std::int32_t* points)
    {
      id = std::copy_n(points, 3, id);
      *rowOfCell++ = static_cast<std::int32_t>(row);
    });
}

//------------------------------------------------------------------------------
PLYIds PLYCells::GetExpected(const PLYPart& part) const
{
  return { part.Role == PLYRole::Faces ? "a vertex of a face"
      : part.Role == PLYRole::Edges    ? "a vertex of an edge"
                                       : "a face of a cell",
    this->NumberOfPoints };
}

//------------------------------------------------------------------------------
bool PLYCells::FillPart(PLYPart& part, Extent& extent, vtkIdType firstId, const Progress& progress)
{
  CellMesh& mesh = this->Mesh;
  if (part.Rows->GetCount() == 0)
  {
    return true;
  }
  const bool isStrips = part.Role == PLYRole::Strips;
  std::int32_t* const ids = mesh.Connectivity.data() + firstId;
  if (isStrips)
  {
    this->FillStrips(part, extent, ids);
  }
  else if (part.List < 0)
  {
    if (!this->ReadEdges(part, ids, progress))
    {
      return false;
    }
  }
  else
  {
    Tally repeating;
    const bool areCells =
      !this->KeepsEmpty && part.NumberOfCells == mesh.NumberOfCells && part.Items.size() == 0;
    const PLYLists lists(extent.Sizes, ids, areCells ? &repeating : nullptr);
    if (!part.Rows->ReadIds(part.List, this->GetExpected(part), lists, progress))
    {
      return false;
    }
    if (areCells)
    {
      mesh.Repeating = repeating;
    }
  }
  if (mesh.Types.size() == 0)
  {
    return true; // of one type
  }

  // A single part uses the offsets of its lists for the mesh.
  const bool takesOffsets = mesh.Offsets.size() == 0;
  const bool areFaces = takesOffsets && part.Role == PLYRole::Faces && part.Items.size() == 0;
  ParallelFor(isStrips ? part.NumberOfCells : part.Rows->GetCount(), LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      const std::int32_t* const offsets = extent.Sizes.Offsets.data();
      unsigned char* const types = mesh.Types.data();
      for (vtkIdType row = begin; row < end && areFaces; ++row)
      {
        types[row] = GetPolygonType(offsets[row + 1] - offsets[row]);
      }
      for (vtkIdType row = begin; row < end && !areFaces; ++row)
      {
        const vtkIdType cell = part.GetCell(row);
        if (cell < 0)
        {
          continue;
        }
        mesh.Types[cell] = GetType(part.Role, extent.GetCellSize(row));
        if (!takesOffsets)
        {
          mesh.Offsets[cell] = static_cast<std::int32_t>(firstId + extent.GetCellOffset(row));
        }
      }
    });
  if (takesOffsets)
  {
    mesh.Offsets = std::move(extent.Sizes.Offsets);
  }
  return true;
}

//------------------------------------------------------------------------------
// Counts the cells and ids of the parts, and determines their positions in the mesh.
bool PLYCells::Measure(const std::vector<PLYPart*>& parts, std::vector<Extent>& extents,
  vtkIdType numberOfPoints, const Progress& progress)
{
  this->NumberOfPoints = numberOfPoints;
  this->NumberOfCells = 0;
  vtkIdType numberOfIds = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    PLYPart& part = *parts[i];
    if (!this->MeasurePart(part, extents[i], progress))
    {
      return false;
    }
    part.FirstCell = this->NumberOfCells;
    part.NumberOfCells -= this->KeepsEmpty ? 0 : extents[i].Empty.Count;
    this->NumberOfCells += part.NumberOfCells;
    numberOfIds += extents[i].NumberOfIds;
    if (!this->KeepsEmpty && extents[i].Empty.Count > 0)
    {
      // Cells without vertices are left out, and later cells move up.
      part.Items = Buffer<std::int32_t>(part.Rows->GetCount());
      auto cell = static_cast<std::int32_t>(part.FirstCell);
      for (vtkIdType row = 0; row < part.Rows->GetCount(); ++row)
      {
        part.Items[row] = extents[i].Sizes.GetSize(row) > 0 ? cell++ : -1;
      }
    }
  }
  if (std::max(this->NumberOfCells, numberOfIds) > INT32_MAX)
  {
    const auto largest = std::max_element(extents.begin(), extents.end(),
      [](const Extent& a, const Extent& b) { return a.NumberOfIds < b.NumberOfIds; });
    return parts[largest - extents.begin()]->Rows->FailAt(0, 0, ErrorKind::Unsupported,
      "fewer than 2147483648 cells and vertices of all cells in total",
      std::to_string(numberOfIds));
  }
  return true;
}

//------------------------------------------------------------------------------
// Whether all cells are lists of one length.
bool PLYCells::HasOneKind(
  const std::vector<PLYPart*>& parts, const std::vector<Extent>& extents) const
{
  return parts.size() == 1 && extents[0].Sizes.Common > 0 && extents[0].Strips.size() == 0 &&
    parts[0]->Role != PLYRole::Edges;
}

//------------------------------------------------------------------------------
bool PLYCells::Read(const std::vector<PLYPart*>& parts, vtkIdType numberOfPoints, bool keepsEmpty,
  const Progress& progress)
{
  this->KeepsEmpty = keepsEmpty;
  this->Mesh = CellMesh();
  this->Mesh.NumberOfPoints = numberOfPoints;
  std::vector<Extent> extents(parts.size());
  return this->Measure(parts, extents, numberOfPoints, progress.Part(0, 0.4)) &&
    this->Fill(parts, extents, progress.Part(0.4, 1));
}

//------------------------------------------------------------------------------
bool PLYCells::Fill(
  const std::vector<PLYPart*>& parts, std::vector<Extent>& extents, const Progress& progress)
{
  CellMesh& mesh = this->Mesh;
  const vtkIdType numberOfCells = this->NumberOfCells;
  vtkIdType numberOfIds = 0;
  for (const Extent& extent : extents)
  {
    numberOfIds += extent.NumberOfIds;
  }
  mesh.NumberOfCells = numberOfCells;
  mesh.Connectivity = Buffer<std::int32_t>(numberOfIds);
  // Most files have faces only, most of them of one size.
  if (this->HasOneKind(parts, extents))
  {
    mesh.CommonSize = extents[0].Sizes.Common;
    mesh.CommonType = GetPolygonType(mesh.CommonSize);
    mesh.Offsets = std::move(extents[0].Sizes.Offsets);
    extents[0].Sizes.Offsets = Buffer<std::int32_t>();
  }
  else if (numberOfCells > 0)
  {
    mesh.Types = Buffer<unsigned char>(numberOfCells);
    const bool isAlone = parts.size() == 1 && extents[0].Strips.size() == 0 &&
      extents[0].Sizes.Offsets.size() == numberOfCells + 1;
    if (!isAlone)
    {
      mesh.Offsets = Buffer<std::int32_t>(numberOfCells + 1);
      mesh.Offsets[numberOfCells] = static_cast<std::int32_t>(numberOfIds);
    }
  }
  vtkIdType firstId = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if (!this->FillPart(*parts[i], extents[i], firstId, progress))
    {
      return false;
    }
    firstId += extents[i].NumberOfIds;
    extents[i] = Extent();
  }
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
// Passes the cells of a part to a piece, or stores those of the piece in the mesh.
bool PLYCells::PassPart(PLYPart& part, const Extent& extent, CellMeshPiece& piece, CellMesh* mesh,
  const Progress& progress)
{
  const vtkIdType rows = part.Rows->GetCount();
  if (part.Role == PLYRole::Strips)
  {
    PLYSizes triangles;
    triangles.Common = 3;
    const PLYLists lists(triangles, part.FirstCell, nullptr, piece, mesh);
    vtkIdType cell = 0;
    extent.ForEachTriangle(rows,
      [&](vtkIdType row, const std::int32_t* points)
      {
        part.RowOfCell[cell] = static_cast<std::int32_t>(row);
        lists.TakeCell(cell++, points);
      });
    return progress.Report(1);
  }
  const PLYLists lists(
    extent.Sizes, part.FirstCell, part.Items.size() > 0 ? part.Items.data() : nullptr, piece, mesh);
  if (part.List >= 0)
  {
    return rows == 0 || part.Rows->ReadIds(part.List, this->GetExpected(part), lists, progress);
  }
  for (vtkIdType row = 0; row < rows; ++row)
  {
    lists.TakeCell(row, extent.Edges.data() + 2 * row);
  }
  return progress.Report(1);
}

//------------------------------------------------------------------------------
void PLYCells::AllocatePiece(const std::vector<PLYPart*>& parts, const std::vector<Extent>& extents,
  const CellMeshPiece& piece)
{
  const vtkIdType points = piece.GetNumberOfPoints(), cells = piece.GetNumberOfCells();
  if (this->HasOneKind(parts, extents))
  {
    const std::int32_t size = extents[0].Sizes.Common;
    this->Mesh = CellMesh(points, cells, GetPolygonType(size), size);
    return;
  }
  this->Mesh.NumberOfPoints = points;
  this->Mesh.NumberOfCells = cells;
  this->Mesh.Types = Buffer<unsigned char>(cells);
  this->Mesh.Offsets = Buffer<std::int32_t>(cells + 1);
  std::int32_t sum = this->Mesh.Offsets[0] = 0;
  vtkIdType next = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const vtkIdType rows =
      parts[i]->Role == PLYRole::Strips ? parts[i]->NumberOfCells : parts[i]->Rows->GetCount();
    for (vtkIdType row = 0; row < rows; ++row)
    {
      const vtkIdType cell = parts[i]->GetCell(row);
      if (cell >= 0 && piece.FindCell(cell) >= 0)
      {
        const vtkIdType size = extents[i].GetCellSize(row);
        sum += static_cast<std::int32_t>(size);
        this->Mesh.Types[next] = GetType(parts[i]->Role, size);
        this->Mesh.Offsets[++next] = sum;
      }
    }
  }
  this->Mesh.Connectivity = Buffer<std::int32_t>(sum);
}

//------------------------------------------------------------------------------
bool PLYCells::ReadPiece(const std::vector<PLYPart*>& parts, vtkIdType numberOfPoints,
  const PieceRequest& request, CellMeshPiece& piece, const Progress& progress)
{
  this->KeepsEmpty = false;
  this->Mesh = CellMesh();
  std::vector<Extent> extents(parts.size());
  if (!this->Measure(parts, extents, numberOfPoints, progress.Part(0, 0.3)))
  {
    return false;
  }
  if (request.NumberOfPieces <= 1)
  {
    piece.Start(numberOfPoints, this->NumberOfCells, request);
    this->Mesh.NumberOfPoints = numberOfPoints;
    return this->Fill(parts, extents, progress.Part(0.3, 1));
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    PLYPart& part = *parts[i];
    if (extents[i].Sizes.Common >= 0)
    {
      extents[i].Sizes.Offsets = Buffer<std::int32_t>(); // they can be derived from the size
    }
    part.RowOfCell = Buffer<std::int32_t>(part.Role == PLYRole::Strips ? part.NumberOfCells : 0);
    if (part.Role == PLYRole::Edges && part.List < 0)
    {
      extents[i].Edges = Buffer<std::int32_t>(2 * part.Rows->GetCount());
      if (!this->ReadEdges(part, extents[i].Edges.data(), progress.Part(0.3, 0.4)))
      {
        return false;
      }
    }
  }
  const auto pass = [&](CellMesh* mesh, const Progress& passProgress)
  {
    bool good = true;
    for (std::size_t i = 0; i < parts.size() && good; ++i)
    {
      good = this->PassPart(*parts[i], extents[i], piece, mesh, passProgress);
    }
    return good;
  };
  if (!piece.Find(numberOfPoints, this->NumberOfCells, request,
        [&] { return pass(nullptr, progress.Part(0.4, 0.8)); }))
  {
    return false;
  }
  this->AllocatePiece(parts, extents, piece);
  return pass(&this->Mesh, progress.Part(0.8, 1));
}

//------------------------------------------------------------------------------
Buffer<std::int32_t> MakeWords(const CellMesh& mesh)
{
  Buffer<std::int32_t> words(mesh.NumberOfCells + mesh.Connectivity.size());
  ParallelFor(mesh.NumberOfCells, LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const vtkIdType size = mesh.GetSize(cell);
        std::int32_t* const word = words.data() + cell + mesh.GetBegin(cell);
        *word = static_cast<std::int32_t>(size);
        std::copy(mesh.GetPoints(cell), mesh.GetPoints(cell) + size, word + 1);
      }
    });
  return words;
}
}
