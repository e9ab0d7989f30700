// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// OFF files in text.
#include "Intake/CellMesh/CellRows.h"
#include "PolygonOFFMesh.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>
#include <mutex>

namespace camaron
{
namespace
{
constexpr char Coordinate[] = "a coordinate of a vertex";
constexpr char NormalComponent[] = "a component of the normal of a vertex";
constexpr char TextureCoordinate[] = "a texture coordinate of a vertex";
constexpr char ColorComponent[] = "a component of the color of a vertex";

constexpr char Size[] = "the number of vertices of a face";
constexpr int IdBytes = 2; // a blank and a digit

/// The numbers up to the end of a line.
struct OFFRest
{
  static constexpr int Most = 16; ///< numbers kept; vertices do not have more
  double Values[Most];
  bool AreReal[Most];        ///< whether they are written as real numbers
  int Count = 0;             ///< including those that are not kept
  const char* Odd = nullptr; ///< the first word that is not a number

  explicit OFFRest(TextRow& row);
  /// The color of the first numbers, at most four of them.
  OFFColor GetColor(int count) const;
};

//------------------------------------------------------------------------------
OFFRest::OFFRest(TextRow& row)
{
  for (std::string_view word; row.HasMore() && row.ReadWord(word, "a number"); ++this->Count)
  {
    const char* const end = word.data() + word.size();
    double value = 0;
    if (ParseReal(word.data(), end, value) != end)
    {
      this->Odd = this->Odd ? this->Odd : word.data();
    }
    if (this->Count < Most)
    {
      this->Values[this->Count] = value;
      this->AreReal[this->Count] = std::any_of(
        word.begin(), word.end(), [](char c) { return !IsDigit(c) && c != '-' && c != '+'; });
    }
  }
}

//------------------------------------------------------------------------------
OFFColor OFFRest::GetColor(int count) const
{
  OFFColor color;
  color.Count = std::min(count, 4);
  for (int i = 0; i < color.Count; ++i)
  {
    color.Values[i] = this->Values[i];
    color.IsReal = color.IsReal || this->AreReal[i];
  }
  return color;
}

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
  this->Points.resize(static_cast<std::size_t>(text.ReadShortIds(
    this->Points.data(), static_cast<std::int32_t>(this->Points.size()), vertices)));
  for (auto i = static_cast<std::int64_t>(this->Points.size()); i < size; ++i)
  {
    std::int32_t id;
    if (!text.ReadId(id, 0, vertices - 1, "a vertex of a face"))
    {
      return false;
    }
    this->Points.push_back(id);
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

//------------------------------------------------------------------------------
// Finds the faces of a piece, and stores these. The colors after their vertices make it faster to
// read each once than to find all lists first, as CellLists does.
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

//------------------------------------------------------------------------------
// Reads this many numbers and keeps the first three and the last.
bool ReadNumbers(TextRow& row, std::int64_t count, double first[3], double& last, const char* what)
{
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (!row.ReadReal(last, what))
    {
      return false;
    }
    if (i < 3)
    {
      first[i] = last;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
struct OFFTextMesh : public OFFMesh
{
  bool ReadVertices(RowSequence& rows, const CellMeshPiece& piece, OFFVertices<double>* vertices,
    const Progress& progress);
  bool ReadVertex(vtkIdType row, TextRow& text, OFFVertex& vertex, OFFCensus& seen) const;
  bool ReadColorAndRest(vtkIdType row, TextRow& text, OFFVertex& vertex, OFFCensus& seen) const;
};

//------------------------------------------------------------------------------
// The color is the rest of the line, except normal and texture coordinates.
bool OFFTextMesh::ReadColorAndRest(
  vtkIdType row, TextRow& text, OFFVertex& vertex, OFFCensus& seen) const
{
  const OFFHeader& header = this->Header;
  const bool hasNormal = header.HasNormals && header.HasColorsFirst;
  const std::int64_t after = (hasNormal ? header.Dimension : 0) + (header.HasTexture ? 2 : 0);
  const char* const begin = text.GetPosition();
  const OFFRest rest(text);
  if (rest.Odd)
  {
    return text.FailAt(rest.Odd, ErrorKind::Syntax, ColorComponent);
  }
  if (rest.Count < after || rest.Count > OFFRest::Most)
  {
    return text.FailAt(begin, ErrorKind::Syntax,
      "a color and " + std::to_string(after) + " more numbers of vertex " + std::to_string(row));
  }
  const int size = rest.Count - static_cast<int>(after);
  vertex.Color = rest.GetColor(size);
  vertex.HasMore = !seen.Colors.Add(vertex.Color) || size > 4;
  if (size == 0)
  {
    seen.Add(OFFOddity::VertexWithoutColor, row);
  }
  if (!vertex.Color.IsInRange())
  {
    seen.Add(OFFOddity::VertexOutOfRange, row);
  }
  if (hasNormal)
  {
    std::copy_n(rest.Values + size, std::min<std::int64_t>(header.Dimension, 3), vertex.Normal);
  }
  if (header.HasTexture)
  {
    std::copy_n(rest.Values + rest.Count - 2, 2, vertex.Texture);
  }
  return true;
}

//------------------------------------------------------------------------------
bool OFFTextMesh::ReadVertex(vtkIdType row, TextRow& text, OFFVertex& vertex, OFFCensus& seen) const
{
  const OFFHeader& header = this->Header;
  double last;
  if (!ReadNumbers(text, header.GetPositionSize(), vertex.Position, vertex.Last, Coordinate) ||
    (header.HasNormals && !header.HasColorsFirst &&
      !ReadNumbers(text, header.Dimension, vertex.Normal, last, NormalComponent)))
  {
    return false;
  }
  if (header.HasColors)
  {
    return this->ReadColorAndRest(row, text, vertex, seen);
  }
  return !header.HasTexture || ReadNumbers(text, 2, vertex.Texture, last, TextureCoordinate);
}

//------------------------------------------------------------------------------
// Without vertices to fill, only finds their end.
bool OFFTextMesh::ReadVertices(RowSequence& rows, const CellMeshPiece& piece,
  OFFVertices<double>* vertices, const Progress& progress)
{
  if (rows.AreLines() && !vertices)
  {
    return true;
  }
  const bool isPlain = this->Header.IsPlain(), areLines = rows.AreLines();
  double* const points = vertices ? vertices->Coordinates.data() : nullptr;
  std::vector<OFFCensus> parts(rows.GetNumberOfParts());
  const bool isGood = rows.ForEach(progress,
    [&](vtkIdType row, vtkIdType part, TextRow& text)
    {
      OFFCensus& seen = parts[static_cast<std::size_t>(part)];
      const vtkIdType point = vertices ? piece.FindPoint(row) : -1;
      const char* const begin = text.GetPosition();
      bool hasMore = false;
      if (isPlain && point >= 0)
      {
        if (!text.ReadPoint(points + 3 * point, Coordinate))
        {
          return false;
        }
      }
      else
      {
        OFFVertex vertex;
        if (!this->ReadVertex(row, text, vertex, seen))
        {
          return false;
        }
        if (point >= 0)
        {
          vertices->Set(point, this->Header, vertex);
        }
        hasMore = vertex.HasMore;
      }
      if (!hasMore && !text.HasMore())
      {
        return true;
      }
      seen.Add(OFFOddity::VertexWithMore, row);
      // A vertex may continue on the next line, but must end there: otherwise a number is missing.
      return areLines || FindLineEnd(begin, text.GetPosition()) == text.GetPosition() ||
        text.FailAt(begin, ErrorKind::Syntax,
          "the " + std::to_string(this->Header.GetVertexSize()) + " numbers of vertex " +
            std::to_string(row),
          "fewer on its line");
    });
  this->VertexCensus = OFFCensus();
  for (const OFFCensus& part : parts)
  {
    this->VertexCensus.Merge(part);
  }
  return isGood;
}
}

//------------------------------------------------------------------------------
bool ReadTextOFF(TextScanner& scanner, const TextLines* lines, bool mayLackKeyword,
  const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings,
  const Progress& progress)
{
  OFFTextMesh mesh;
  grid->Initialize();
  warnings = Warnings();
  if (!ReadOFFKeyword(scanner, mayLackKeyword, mesh.Header) || !ReadOFFCounts(scanner, mesh.Header))
  {
    return false;
  }
  // The faces, which follow the vertices, determine which vertices a piece needs.
  const bool isWhole = request.NumberOfPieces <= 1;
  RowSequence vertexRows(scanner, lines, mesh.Header.Vertices);
  CellMeshPiece piece;
  piece.SetPoints(
    [&](const PieceOfSpace::Visit& visit)
    {
      return vertexRows.ForEach(Progress(),
        [&](vtkIdType row, vtkIdType, TextRow& text)
        {
          double x[3] = { 0, 0, 0 }, last;
          const bool isGood = ReadNumbers(text, mesh.Header.GetPositionSize(), x, last, Coordinate);
          if (isGood)
          {
            visit(row, x);
          }
          return isGood;
        });
    });
  OFFVertices<double> vertices;
  if (isWhole)
  {
    vertices = OFFVertices<double>(mesh.Header, mesh.Header.Vertices);
  }
  if (!vertexRows ||
    !mesh.ReadVertices(vertexRows, piece, isWhole ? &vertices : nullptr, progress.Part(0, 0.4)))
  {
    return false;
  }
  RowSequence faceRows(scanner, lines, mesh.Header.Faces);
  if (mesh.Header.Faces == 0 ? !MakeCloud(mesh.Header.Vertices, request, piece, mesh.Faces)
                             : !faceRows ||
        !ReadTextFaces(mesh, faceRows, request, piece, progress.Part(0.4, isWhole ? 0.9 : 0.65)))
  {
    return false;
  }
  if (request.Piece == 0 && scanner.SkipSpace())
  {
    warnings.Add("there is more data after the end of the mesh");
  }
  if (!isWhole)
  {
    vertices = OFFVertices<double>(mesh.Header, piece.GetNumberOfPoints());
    if (!mesh.ReadVertices(vertexRows, piece, &vertices, progress.Part(0.65, 0.9)))
    {
      return false;
    }
  }
  mesh.Fill(vertices, piece, request, grid, warnings, progress.Part(0.9, 1));
  return !progress.IsStopped();
}
}
