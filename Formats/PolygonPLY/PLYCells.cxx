// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PLYCells.h"

#include "Scan/Number.h"

#include <algorithm>
#include <mutex>

namespace camaron
{
namespace
{
constexpr vtkIdType Grain = 1 << 16;

//------------------------------------------------------------------------------
unsigned char GetPolygonType(vtkIdType size)
{
  switch (size)
  {
    case 0:
      return VTK_EMPTY_CELL;
    case 1:
      return VTK_VERTEX;
    case 2:
      return VTK_LINE;
    case 3:
      return VTK_TRIANGLE;
    case 4:
      return VTK_QUAD;
    default:
      return VTK_POLYGON;
  }
}

//------------------------------------------------------------------------------
// Calls visit(a, b, c) for the triangles of strips that breaks separate; the direction alternates.
template <typename Visit>
void ForEachTriangle(const std::int32_t* ids, vtkIdType size, Visit&& visit)
{
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
      visit(ids[i - 2], ids[isOdd ? i : i - 1], ids[isOdd ? i - 1 : i]);
    }
  }
}

bool IsDegenerate(std::int32_t a, std::int32_t b, std::int32_t c)
{
  return a == b || b == c || c == a;
}
}

//------------------------------------------------------------------------------
struct PLYCells::Extent
{
  vtkIdType NumberOfIds = 0;
  PLYSizes Sizes;
  Tally Empty;
  Buffer<std::int32_t> Strips;
};

//------------------------------------------------------------------------------
bool PLYCells::MeasureStrips(PLYPart& part, Extent& extent, const Progress& progress)
{
  extent.Strips = Buffer<std::int32_t>(extent.Sizes.Total);
  const PLYIds expected = { "a vertex of a strip", this->Mesh.NumberOfPoints, true };
  if (!part.Rows->ReadIds(part.List, extent.Sizes, expected, extent.Strips.data(), progress))
  {
    return false;
  }
  vtkIdType triangles = 0;
  for (vtkIdType row = 0; row < part.Rows->GetCount(); ++row)
  {
    ForEachTriangle(extent.Strips.data() + extent.Sizes.GetOffset(row), extent.Sizes.GetSize(row),
      [&](std::int32_t a, std::int32_t b, std::int32_t c)
      {
        if (IsDegenerate(a, b, c))
        {
          this->Degenerate.Add(row);
        }
        else
        {
          ++triangles;
        }
      });
  }
  part.NumberOfCells = triangles;
  extent.NumberOfIds = 3 * triangles;
  return true;
}

//------------------------------------------------------------------------------
// Lists of fewer than three vertices.
void PLYCells::CountFaces(PLYPart& part, Extent& extent)
{
  const vtkIdType count = part.Rows->GetCount();
  if (extent.Sizes.Common > 2)
  {
    return;
  }
  std::mutex mutex;
  ParallelFor(count, Grain,
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
bool PLYCells::Measure(PLYPart& part, Extent& extent, const Progress& progress)
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
  const std::vector<PLYColumn> columns = { { part.Ends[0], PLYConversion::Value, PLYType::Double,
                                             ends.data(), 2 },
    { part.Ends[1], PLYConversion::Value, PLYType::Double, ends.data() + 1, 2 } };
  if (!part.Rows->ReadColumns(columns, PLYTargets(), progress))
  {
    return false;
  }
  const auto limit = static_cast<double>(this->Mesh.NumberOfPoints);
  for (vtkIdType i = 0; i < 2 * count; ++i)
  {
    const double end = ends[i];
    if (!(end >= 0 && end < limit && end == static_cast<std::int32_t>(end)))
    {
      const std::string range = limit > 0
        ? " from 0 to " + std::to_string(this->Mesh.NumberOfPoints - 1)
        : " (there are none)";
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
void PLYCells::FillStrips(PLYPart& part, const Extent& extent, vtkIdType firstId)
{
  std::int32_t* id = this->Mesh.Connectivity.data() + firstId;
  part.RowOfCell = Buffer<std::int32_t>(part.NumberOfCells);
  std::int32_t* rowOfCell = part.RowOfCell.data();
  for (vtkIdType row = 0; row < part.Rows->GetCount(); ++row)
  {
    ForEachTriangle(extent.Strips.data() + extent.Sizes.GetOffset(row), extent.Sizes.GetSize(row),
      [&](std::int32_t a, std::int32_t b, std::int32_t c)
      {
        if (!IsDegenerate(a, b, c))
        {
          *id++ = a;
          *id++ = b;
          *id++ = c;
          *rowOfCell++ = static_cast<std::int32_t>(row);
        }
      });
  }
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
    this->FillStrips(part, extent, firstId);
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
    const PLYIds expected = { part.Role == PLYRole::Faces ? "a vertex of a face"
        : part.Role == PLYRole::Edges                     ? "a vertex of an edge"
                                                          : "a face of a cell",
      mesh.NumberOfPoints };
    if (!part.Rows->ReadIds(part.List, extent.Sizes, expected, ids, progress))
    {
      return false;
    }
  }
  if (mesh.Types.size() == 0)
  {
    return true; // of one type
  }

  // Cells without vertices are left out, those after them move up.
  const bool drops = !this->KeepsEmpty && extent.Empty.Count > 0;
  if (drops)
  {
    part.Items = Buffer<std::int32_t>(part.Rows->GetCount());
    auto cell = static_cast<std::int32_t>(part.FirstCell);
    for (vtkIdType row = 0; row < part.Rows->GetCount(); ++row)
    {
      part.Items[row] = extent.Sizes.GetSize(row) > 0 ? cell++ : -1;
    }
  }
  // The lists of a part alone are those of the mesh.
  const bool takesOffsets = mesh.Offsets.size() == 0;
  ParallelFor(isStrips ? part.NumberOfCells : part.Rows->GetCount(), Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        const vtkIdType cell = drops ? part.Items[row] : part.FirstCell + row;
        if (cell < 0)
        {
          continue;
        }
        const vtkIdType size = isStrips ? 3 : extent.Sizes.GetSize(row);
        const vtkIdType offset = isStrips ? 3 * row : extent.Sizes.GetOffset(row);
        const bool isLongEdge = part.Role == PLYRole::Edges && size > 2;
        mesh.Types[cell] =
          isLongEdge ? static_cast<unsigned char>(VTK_POLY_LINE) : GetPolygonType(size);
        if (!takesOffsets)
        {
          mesh.Offsets[cell] = static_cast<std::int32_t>(firstId + offset);
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
bool PLYCells::Read(const std::vector<PLYPart*>& parts, vtkIdType numberOfPoints, bool keepsEmpty,
  const Progress& progress)
{
  this->KeepsEmpty = keepsEmpty;
  CellMesh& mesh = this->Mesh;
  mesh = CellMesh();
  mesh.NumberOfPoints = numberOfPoints;
  std::vector<Extent> extents(parts.size());
  vtkIdType numberOfCells = 0, numberOfIds = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    PLYPart& part = *parts[i];
    if (!this->Measure(part, extents[i], progress.Part(0, 0.4)))
    {
      return false;
    }
    part.FirstCell = numberOfCells;
    part.NumberOfCells -= keepsEmpty ? 0 : extents[i].Empty.Count;
    numberOfCells += part.NumberOfCells;
    numberOfIds += extents[i].NumberOfIds;
  }
  if (std::max(numberOfCells, numberOfIds) > INT32_MAX)
  {
    const auto largest = std::max_element(extents.begin(), extents.end(),
      [](const Extent& a, const Extent& b) { return a.NumberOfIds < b.NumberOfIds; });
    return parts[largest - extents.begin()]->Rows->FailAt(0, 0, ErrorKind::Unsupported,
      "fewer than 2147483648 cells and vertices of all cells together",
      std::to_string(numberOfIds));
  }

  mesh.NumberOfCells = numberOfCells;
  mesh.Connectivity = Buffer<std::int32_t>(numberOfIds);
  // Most files have faces only, and most of these are of one kind.
  const bool isOne = parts.size() == 1 && extents[0].Sizes.Common > 0 &&
    extents[0].Strips.size() == 0 && parts[0]->Role != PLYRole::Edges;
  if (isOne)
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
    if (!this->FillPart(*parts[i], extents[i], firstId, progress.Part(0.4, 1)))
    {
      return false;
    }
    firstId += extents[i].NumberOfIds;
    extents[i] = Extent();
  }
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
Buffer<std::int32_t> MakeWords(const CellMesh& mesh)
{
  Buffer<std::int32_t> words(mesh.NumberOfCells + mesh.Connectivity.size());
  ParallelFor(mesh.NumberOfCells, Grain,
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
