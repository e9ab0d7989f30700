// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Faces of OFF files in text. The colors after their vertices make it faster to read each once than
// to find all lists first, as CellLists does.
#include "Intake/CellMesh/CellRows.h"
#include "PolygonOFFText.h"

#include <algorithm>
#include <limits>
#include <mutex>

namespace camaron
{
namespace
{
constexpr char Size[] = "the number of vertices of a face";
constexpr int IdBytes = 2; // a blank and a digit

/// A face of a file; a thread reads one after the other into the same.
struct OFFFace
{
  vtkIdType Row = 0;
  vtkIdType Cell = 0; ///< at most the row, as faces without vertices become no cells
  std::vector<std::int32_t> Points;
  OFFColor Color;
  bool HasOddColor = false; ///< whether there are data after the vertices that are not a color

  bool Read(TextRow& text, std::int64_t vertices);
  /// Whether the census counts it.
  bool IsUnusual() const
  {
    return this->Points.size() <= 2 || this->Color.Count > 0 || this->HasOddColor;
  }
};

/// The faces of one part of a file; in a cache line of its own, as it changes with every face.
struct alignas(64) OFFFacePart
{
  OFFFace Face;
  OFFCensus Census;
  CellSink Cells;
};

//------------------------------------------------------------------------------
bool OFFFace::Read(TextRow& text, std::int64_t vertices)
{
  std::int64_t size;
  if (!text.ReadCount(size, IdBytes, Size))
  {
    return false;
  }
  constexpr std::int64_t usual = 8; // the text may end long before the size of the face
  this->Points.resize(static_cast<std::size_t>(std::min(size, usual)));
  std::int64_t i = text.ReadShortIds(
    this->Points.data(), static_cast<std::int32_t>(this->Points.size()), vertices);
  for (; i < size; ++i)
  {
    std::int32_t id;
    if (!text.ReadId(id, 0, vertices - 1, "a vertex of a face"))
    {
      return false;
    }
    if (i < usual)
    {
      this->Points[static_cast<std::size_t>(i)] = id;
    }
    else
    {
      this->Points.push_back(id);
    }
  }
  this->Color.Count = 0;
  this->HasOddColor = false;
  if (text.HasMore())
  {
    constexpr int maxColor = 4;
    const OFFRest rest(text);
    this->HasOddColor = rest.Odd || rest.Count > maxColor;
    this->Color = rest.GetColor(this->HasOddColor ? 0 : rest.Count);
  }
  return true;
}

//------------------------------------------------------------------------------
// Passes all faces: take(part) gets the part of each, in parallel, and returns false to end this.
// No line may lack vertices: else cells would have to be counted first.
template <typename Take>
bool ForEachFace(RowSequence& rows, const OFFMesh& mesh, std::vector<OFFFacePart>& parts,
  const Progress& progress, Take&& take)
{
  const std::int64_t vertices = mesh.Header.Vertices;
  const bool areLines = rows.AreLines();
  vtkIdType cells = 0; // of rows that are not lines
  return rows.ForEach(progress,
    [&, vertices, areLines](vtkIdType row, vtkIdType i, TextRow& text)
    {
      OFFFacePart& part = parts[static_cast<std::size_t>(i)];
      OFFFace& face = part.Face;
      face.Row = row;
      face.Cell = areLines ? row : cells;
      if (!face.Read(text, vertices) || (face.Points.empty() && areLines))
      {
        return false;
      }
      if (!areLines && !face.Points.empty())
      {
        ++cells;
      }
      return take(part);
    });
}

//------------------------------------------------------------------------------
// Reads the lines of a whole mesh if all have as many vertices as the first, at least 3, and none
// a color.
bool ReadFacesOfOneSize(OFFMesh& mesh, RowSequence& rows, const Progress& progress)
{
  const TextLines::Section& lines = rows.GetSection();
  const vtkIdType count = rows.GetCount();
  const char* first = lines.Begin;
  std::int64_t common = 0;
  while (first < lines.End && IsSpace(*first))
  {
    ++first;
  }
  ParseInteger(first, lines.End, common);
  if (common < 3 || common >= (lines.End - lines.Begin + 1) / IdBytes / count ||
    common > std::numeric_limits<std::int32_t>::max() / count)
  {
    return false;
  }
  const auto size = static_cast<std::int32_t>(common);
  std::vector<OFFFacePart> parts(rows.GetNumberOfParts());
  mesh.Faces = CellMesh(mesh.Header.Vertices, count, GetPolygonType(size), size);
  std::int32_t* const ids = mesh.Faces.Connectivity.data();
  const bool isGood = ForEachFace(rows, mesh, parts, progress,
    [=](const OFFFacePart& part)
    {
      const OFFFace& face = part.Face;
      const bool isUsual =
        static_cast<std::int32_t>(face.Points.size()) == size && !face.IsUnusual();
      if (isUsual)
      {
        std::copy(face.Points.begin(), face.Points.end(), ids + face.Row * size);
      }
      return isUsual;
    });
  mesh.Faces = isGood ? std::move(mesh.Faces) : CellMesh();
  return isGood;
}
}

//------------------------------------------------------------------------------
bool ReadTextFaces(OFFMesh& mesh, RowSequence& rows, const PieceRequest& request,
  CellMeshPiece& piece, const Progress& progress)
{
  if (request.NumberOfPieces <= 1 && rows.AreLines() &&
    ReadFacesOfOneSize(mesh, rows, progress.Part(0, 0.9)))
  {
    piece.Start(mesh.Header.Vertices, mesh.Header.Faces, request);
    return true;
  }
  std::vector<OFFFacePart> parts(rows.GetNumberOfParts());
  std::once_flag hasColors;
  bool isFirst = true;
  const auto pass = [&](const Progress& share, auto&& take)
  {
    const bool isGood = ForEachFace(rows, mesh, parts, share,
      [&, counts = isFirst](OFFFacePart& part)
      {
        const OFFFace& face = part.Face;
        if (counts && face.IsUnusual())
        {
          part.Census.AddFace(face.Row, face.Color, face.HasOddColor);
          if (face.Points.size() <= 2)
          {
            part.Census.Add(FewVertices[face.Points.size()], face.Row);
          }
        }
        if (!face.Points.empty())
        {
          take(part);
        }
        return true;
      });
    isFirst = false;
    return isGood;
  };
  if (!piece.Find(mesh.Header.Vertices, mesh.Header.Faces, request,
        [&]
        {
          return pass(progress.Part(isFirst ? 0 : 0.4, isFirst ? 0.4 : 0.7),
            [&](OFFFacePart& part)
            {
              const std::vector<std::int32_t>& points = part.Face.Points;
              piece.Visit(part.Face.Cell, points.data(), static_cast<vtkIdType>(points.size()));
            });
        }) ||
    !pass(progress.Part(isFirst ? 0 : 0.7, 1),
      [&](OFFFacePart& part)
      {
        const vtkIdType cell = piece.FindCell(part.Face.Cell);
        if (cell < 0)
        {
          return;
        }
        std::vector<std::int32_t>& points = part.Face.Points;
        for (std::size_t i = 0; !piece.IsWhole() && i < points.size(); ++i)
        {
          points[i] = static_cast<std::int32_t>(piece.FindPoint(points[i]));
        }
        if (part.Face.Color.Count > 0)
        {
          std::call_once(hasColors, [&] { mesh.FaceColors = OFFColors(piece.GetNumberOfCells()); });
          mesh.FaceColors.Set(cell, part.Face.Color);
        }
        part.Cells.AddCell(GetPolygonType(static_cast<vtkIdType>(points.size())), points);
      }))
  {
    return false;
  }

  std::vector<CellSink> sinks;
  for (OFFFacePart& part : parts)
  {
    mesh.FaceCensus.Merge(part.Census);
    sinks.push_back(std::move(part.Cells));
  }
  mesh.Faces.NumberOfPoints = piece.GetNumberOfPoints();
  if (!FillCells(sinks, mesh.Faces, rows.GetScanner()))
  {
    return false;
  }
  // Faces of other pieces count, too.
  if (mesh.FaceCensus.Colors.HasColors || mesh.FaceCensus.Colors.HasIndices)
  {
    mesh.FaceColors.Resize(mesh.Faces.NumberOfCells);
  }
  return piece.IsWhole() || mesh.Faces.NumberOfCells == piece.GetNumberOfCells();
}
}
