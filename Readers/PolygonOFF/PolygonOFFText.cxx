// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
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
// The color is the rest of the line, except normal and texture coordinates.
bool OFFTextReading::ReadColoredVertex(vtkIdType row, TextRow& text, vtkIdType point,
  OFFVertices<double>& vertices, OFFVertexCensus& seen)
{
  const OFFHeader& header = this->Header;
  double normal[3] = { 0, 0, 0 }, last;
  const bool hasNormalInRest = header.HasNormals && header.HasColorsFirst;
  if (header.HasNormals && !hasNormalInRest &&
    !ReadNumbers(text, header.Dimension, normal, last, NormalComponent))
  {
    return false;
  }
  const char* const begin = text.GetPosition();
  const OFFRest rest(text);
  const std::int64_t after = (hasNormalInRest ? header.Dimension : 0) + (header.HasTexture ? 2 : 0);
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
  const OFFColor color = rest.GetColor(size);
  if (!seen.Colors.Add(color) || size > 4)
  {
    seen.WithMore.Add(row);
  }
  if (size == 0)
  {
    seen.WithoutColor.Add(row);
  }
  if (!color.IsInRange())
  {
    seen.OutOfRange.Add(row);
  }
  if (point >= 0)
  {
    vertices.Colors.Set(point, color);
  }
  if (header.HasNormals)
  {
    vertices.SetNormal(point, header, hasNormalInRest ? rest.Values + size : normal);
  }
  if (header.HasTexture)
  {
    vertices.SetTexture(point, rest.Values + rest.Count - 2);
  }
  return true;
}

//------------------------------------------------------------------------------
bool OFFTextReading::ReadVertex(vtkIdType row, TextRow& text, vtkIdType point,
  OFFVertices<double>& vertices, OFFVertexCensus& seen)
{
  const OFFHeader& header = this->Header;
  double first[3], last;
  if (!ReadNumbers(text, header.GetPositionSize(), first, last, Coordinate))
  {
    return false;
  }
  vertices.SetPosition(point, header, first, last);
  if (header.HasColors)
  {
    return this->ReadColoredVertex(row, text, point, vertices, seen);
  }
  if (header.HasNormals)
  {
    if (!ReadNumbers(text, header.Dimension, first, last, NormalComponent))
    {
      return false;
    }
    vertices.SetNormal(point, header, first);
  }
  if (header.HasTexture)
  {
    if (!ReadNumbers(text, 2, first, last, TextureCoordinate))
    {
      return false;
    }
    vertices.SetTexture(point, first);
  }
  if (text.HasMore())
  {
    seen.WithMore.Add(row);
  }
  return true;
}

//------------------------------------------------------------------------------
// Without vertices to fill, only finds their end.
bool OFFTextReading::ReadVertices(TextScanner& scanner, const TextLines* lines,
  const CellMeshPiece& piece, OFFVertices<double>* vertices, const Progress& progress)
{
  const bool isPlain = this->Header.IsPlain();
  OFFVertices<double> none;
  const auto read = [&](vtkIdType row, TextRow& text, OFFVertexCensus& seen)
  {
    const vtkIdType point = vertices ? piece.FindPoint(row) : -1;
    if (!isPlain || point < 0)
    {
      return this->ReadVertex(row, text, point, vertices ? *vertices : none, seen);
    }
    if (!text.ReadPoint(vertices->Coordinates.data() + 3 * point, Coordinate))
    {
      return false;
    }
    if (text.HasMore())
    {
      seen.WithMore.Add(row);
    }
    return true;
  };

  this->VertexCensus = OFFVertexCensus();
  const vtkIdType count = this->Header.Vertices;
  if (lines)
  {
    const TextLines::Section section = lines->Find(scanner.GetPosition(), count);
    if (!section)
    {
      return false;
    }
    scanner.SetPosition(section.End);
    if (!vertices)
    {
      return true;
    }
    std::vector<OFFVertexCensus> seen(lines->GetNumberOfPieces(section));
    const bool good = VisitRows(*lines, section, scanner.GetComment(), progress,
      [&](vtkIdType row, vtkIdType part, TextRow& text) { return read(row, text, seen[part]); });
    for (const OFFVertexCensus& part : seen)
    {
      this->VertexCensus.Merge(part);
    }
    return good;
  }
  for (vtkIdType row = 0; row < count && progress.Report(static_cast<double>(row) / count); ++row)
  {
    scanner.SkipSpace();
    const char* const begin = scanner.GetPosition();
    TextRow text(scanner);
    const vtkIdType before = this->VertexCensus.WithMore.Count;
    if (!read(row, text, this->VertexCensus) || scanner.HasFailed())
    {
      return false;
    }
    // A vertex may continue on the next line, but must end there: otherwise a number is missing.
    if (this->VertexCensus.WithMore.Count > before &&
      FindLineEnd(begin, scanner.GetPosition()) < scanner.GetPosition())
    {
      return scanner.FailAt(begin, ErrorKind::Syntax,
        "the " + std::to_string(this->Header.GetVertexSize()) + " numbers of vertex " +
          std::to_string(row),
        "fewer on its line");
    }
    scanner.SkipLine();
  }
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
bool OFFTextReading::Read(TextScanner& scanner, const TextLines* lines, const Progress& progress)
{
  this->Grid->Initialize();
  this->Messages = Warnings();
  static_cast<OFFMesh&>(*this) = OFFMesh();
  if (!ReadOFFKeyword(scanner, this->MayLackKeyword, this->Header) ||
    !ReadOFFCounts(scanner, this->Header))
  {
    return false;
  }
  // The faces, which follow the vertices, determine which vertices a piece needs.
  const bool isWhole = this->Request.NumberOfPieces <= 1;
  TextScanner vertexScanner = scanner;
  CellMeshPiece piece;
  piece.SetPoints(
    [&, lines](const PieceOfSpace::Visit& visit)
    {
      TextScanner again = vertexScanner;
      return ReadRowsOnce(again, lines, this->Header.Vertices, Progress(),
        [&](vtkIdType row, TextRow& text)
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
  if (!this->ReadVertices(
        scanner, lines, piece, isWhole ? &vertices : nullptr, progress.Part(0, 0.4)) ||
    !this->ReadFaces(scanner, lines, piece, progress.Part(0.4, isWhole ? 0.9 : 0.65)))
  {
    return false;
  }
  if (!isWhole)
  {
    vertices = OFFVertices<double>(this->Header, piece.GetNumberOfPoints());
    if (!this->ReadVertices(vertexScanner, lines, piece, &vertices, progress.Part(0.65, 0.9)))
    {
      return false;
    }
  }
  if (this->Request.Piece == 0 && scanner.SkipSpace())
  {
    this->Messages.Add("there is more data after the end of the mesh");
  }
  this->Fill(vertices, piece, this->Request, this->Grid, this->Messages, progress.Part(0.9, 1));
  return !progress.IsStopped();
}
}
