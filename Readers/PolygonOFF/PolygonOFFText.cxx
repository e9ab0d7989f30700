// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// OFF files in text.
#include "PolygonOFFText.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
constexpr char Coordinate[] = "a coordinate of a vertex";
constexpr char NormalComponent[] = "a component of the normal of a vertex";
constexpr char TextureCoordinate[] = "a texture coordinate of a vertex";
constexpr char ColorComponent[] = "a component of the color of a vertex";

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
class OFFTextReading : private OFFMesh
{
public:
  OFFTextReading(
    bool mayLackKeyword, const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings)
    : MayLackKeyword(mayLackKeyword)
    , Request(request)
    , Grid(grid)
    , Messages(warnings)
  {
  }

  /// Reads a piece of the file for ReadText; every call starts anew.
  bool Read(TextScanner& scanner, const TextLines* lines, const Progress& progress);

private:
  bool ReadVertices(RowSequence& rows, const CellMeshPiece& piece, OFFVertices<double>* vertices,
    const Progress& progress);
  bool ReadVertex(vtkIdType row, TextRow& text, OFFVertex& vertex, OFFCensus& seen) const;
  bool ReadColorAndRest(vtkIdType row, TextRow& text, OFFVertex& vertex, OFFCensus& seen) const;

  bool MayLackKeyword;
  PieceRequest Request;
  vtkUnstructuredGrid* Grid;
  Warnings& Messages;
};

//------------------------------------------------------------------------------
// The color is the rest of the line, except normal and texture coordinates.
bool OFFTextReading::ReadColorAndRest(
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
bool OFFTextReading::ReadVertex(
  vtkIdType row, TextRow& text, OFFVertex& vertex, OFFCensus& seen) const
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
bool OFFTextReading::ReadVertices(RowSequence& rows, const CellMeshPiece& piece,
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

//------------------------------------------------------------------------------
bool OFFTextReading::Read(TextScanner& scanner, const TextLines* lines, const Progress& progress)
{
  this->Grid->Initialize();
  this->Messages = Warnings();
  if (!ReadOFFKeyword(scanner, this->MayLackKeyword, this->Header) ||
    !ReadOFFCounts(scanner, this->Header))
  {
    return false;
  }
  // The faces, which follow the vertices, determine which vertices a piece needs.
  const bool isWhole = this->Request.NumberOfPieces <= 1;
  RowSequence vertexRows(scanner, lines, this->Header.Vertices);
  CellMeshPiece piece;
  piece.SetPoints(
    [&](const PieceOfSpace::Visit& visit)
    {
      return vertexRows.ForEach(Progress(),
        [&](vtkIdType row, vtkIdType, TextRow& text)
        {
          double x[3] = { 0, 0, 0 }, last;
          const bool isGood =
            ReadNumbers(text, this->Header.GetPositionSize(), x, last, Coordinate);
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
    vertices = OFFVertices<double>(this->Header, this->Header.Vertices);
  }
  if (!vertexRows ||
    !this->ReadVertices(vertexRows, piece, isWhole ? &vertices : nullptr, progress.Part(0, 0.4)))
  {
    return false;
  }
  RowSequence faceRows(scanner, lines, this->Header.Faces);
  if (this->Header.Faces == 0 ? !MakeCloud(this->Header.Vertices, this->Request, piece, this->Faces)
                              : !faceRows ||
        !ReadTextFaces(
          *this, faceRows, this->Request, piece, progress.Part(0.4, isWhole ? 0.9 : 0.65)))
  {
    return false;
  }
  if (this->Request.Piece == 0 && scanner.SkipSpace())
  {
    this->Messages.Add("there is more data after the end of the mesh");
  }
  if (!isWhole)
  {
    vertices = OFFVertices<double>(this->Header, piece.GetNumberOfPoints());
    if (!this->ReadVertices(vertexRows, piece, &vertices, progress.Part(0.65, 0.9)))
    {
      return false;
    }
  }
  this->Fill(vertices, piece, this->Request, this->Grid, this->Messages, progress.Part(0.9, 1));
  return !progress.IsStopped();
}
}

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

//------------------------------------------------------------------------------
bool ReadTextOFF(TextScanner& scanner, const TextLines* lines, bool mayLackKeyword,
  const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings,
  const Progress& progress)
{
  return OFFTextReading(mayLackKeyword, request, grid, warnings).Read(scanner, lines, progress);
}
}
