// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// OFF files in text.
#include "Intake/Rows/TextRows.h"
#include "PolygonOFFFaces.h"

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
constexpr char Size[] = "the number of vertices of a face";
constexpr std::int64_t IdBytes = 2; // a blank and a digit

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
/// The words up to the end of a line.
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
  bool ReadVertices(TextScanner& scanner, const TextLines* lines, const CellMeshPiece& piece,
    OFFVertices<double>* vertices, const Progress& progress);
  ///@{
  /// @param point where to store the vertex, -1 to drop it
  bool ReadVertex(
    vtkIdType row, TextRow& text, vtkIdType point, OFFVertices<double>& vertices, OFFCensus& seen);
  bool ReadColoredVertex(
    vtkIdType row, TextRow& text, vtkIdType point, OFFVertices<double>& vertices, OFFCensus& seen);
  ///@}
  /// Finds which faces a piece has, and stores these.
  bool ReadFaces(
    TextScanner& scanner, const TextLines* lines, CellMeshPiece& piece, const Progress& progress);
  bool ReadFacesOfLines(
    TextScanner& scanner, const TextLines& lines, CellMeshPiece& piece, const Progress& progress);
  bool ReadFacesInOrder(TextScanner& scanner, CellMeshPiece& piece, const Progress& progress);

  bool MayLackKeyword;
  PieceRequest Request;
  vtkUnstructuredGrid* Grid;
  Warnings& Messages;
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

//------------------------------------------------------------------------------
// The color is the rest of the line, except normal and texture coordinates.
bool OFFTextReading::ReadColoredVertex(
  vtkIdType row, TextRow& text, vtkIdType point, OFFVertices<double>& vertices, OFFCensus& seen)
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
    seen.Add(OFFOddity::VertexWithMore, row);
  }
  if (size == 0)
  {
    seen.Add(OFFOddity::VertexWithoutColor, row);
  }
  if (!color.IsInRange())
  {
    seen.Add(OFFOddity::VertexOutOfRange, row);
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
bool OFFTextReading::ReadVertex(
  vtkIdType row, TextRow& text, vtkIdType point, OFFVertices<double>& vertices, OFFCensus& seen)
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
    seen.Add(OFFOddity::VertexWithMore, row);
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
  const auto read = [&](vtkIdType row, TextRow& text, OFFCensus& seen)
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
      seen.Add(OFFOddity::VertexWithMore, row);
    }
    return true;
  };

  this->VertexCensus = OFFCensus();
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
    std::vector<OFFCensus> seen(lines->GetNumberOfPieces(section));
    const bool good = VisitRows(*lines, section, scanner.GetComment(), progress,
      [&](vtkIdType row, vtkIdType part, TextRow& text) { return read(row, text, seen[part]); });
    for (const OFFCensus& part : seen)
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
    const vtkIdType before = this->VertexCensus.Get(OFFOddity::VertexWithMore).Count;
    if (!read(row, text, this->VertexCensus) || scanner.HasFailed())
    {
      return false;
    }
    // A vertex may continue on the next line, but must end there: otherwise a number is missing.
    if (this->VertexCensus.Get(OFFOddity::VertexWithMore).Count > before &&
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
// Reads a face after its size: its vertices, and the words after them.
bool ReadFace(TextRow& text, std::int64_t size, std::int64_t vertices, OFFFace& face)
{
  constexpr std::int64_t usual = 8; // the text may end long before the size of the face
  face.Points.resize(static_cast<std::size_t>(std::min(size, usual)));
  std::int64_t i =
    text.ReadShortIds(face.Points.data(), static_cast<std::int32_t>(face.Points.size()), vertices);
  for (; i < size; ++i)
  {
    std::int32_t id;
    if (!text.ReadId(id, 0, vertices - 1, "a vertex of a face"))
    {
      return false;
    }
    if (i < usual)
    {
      face.Points[static_cast<std::size_t>(i)] = id;
    }
    else
    {
      face.Points.push_back(id);
    }
  }
  face.Color.Count = 0;
  face.HasOddColor = false;
  if (text.HasMore())
  {
    constexpr int maxColor = 4;
    const OFFRest rest(text);
    face.HasOddColor = rest.Odd || rest.Count > maxColor;
    face.Color = rest.GetColor(face.HasOddColor ? 0 : rest.Count);
  }
  return true;
}

//------------------------------------------------------------------------------
// For faces of one line each. In a piece, none may lack vertices: else their cells would have to be
// counted first.
bool OFFTextReading::ReadFacesOfLines(
  TextScanner& scanner, const TextLines& lines, CellMeshPiece& piece, const Progress& progress)
{
  const TextLines::Section section = lines.Find(scanner.GetPosition(), this->Header.Faces);
  if (!section)
  {
    return false;
  }
  const bool isWhole = this->Request.NumberOfPieces <= 1;
  std::int64_t common = 0; // size of all faces, if they are like the first
  const char* first = section.Begin;
  lines.NextLine(first, section.End);
  ParseInteger(first, section.End, common);
  const bool hasRoom =
    common > 0 && common < (section.End - section.Begin + 1) / IdBytes / section.NumberOfLines;
  const auto parts = static_cast<std::size_t>(lines.GetNumberOfPieces(section));
  const bool isGood = CollectFaces(*this, hasRoom ? static_cast<std::int32_t>(common) : 0, parts,
    this->Request, piece, scanner, progress,
    [&](const Progress& share, std::vector<OFFFacePart>& collected, auto&& take)
    {
      return VisitRows(lines, section, scanner.GetComment(), share,
        [&](vtkIdType row, vtkIdType i, TextRow& text)
        {
          OFFFacePart& part = collected[static_cast<std::size_t>(i)];
          part.Face.Row = part.Face.Cell = row;
          std::int64_t size;
          if (!text.ReadInteger(size, Size) || size < 0 || (size == 0 && !isWhole) ||
            !ReadFace(text, size, this->Header.Vertices, part.Face))
          {
            return false;
          }
          return take(part);
        });
    });
  scanner.SetPosition(section.End);
  return isGood;
}

//------------------------------------------------------------------------------
// For faces whose vertices may be on several lines.
bool OFFTextReading::ReadFacesInOrder(
  TextScanner& scanner, CellMeshPiece& piece, const Progress& progress)
{
  const vtkIdType count = this->Header.Faces;
  const TextScanner start = scanner;
  return CollectFaces(*this, 0, 1, this->Request, piece, scanner, progress,
    [&](const Progress& share, std::vector<OFFFacePart>& collected, auto&& take)
    {
      scanner = start;
      OFFFacePart& part = collected.front();
      part.Face.Cell = 0;
      for (vtkIdType row = 0; row < count; ++row)
      {
        std::int64_t size;
        TextRow text(scanner);
        part.Face.Row = row;
        if (!share.Report(static_cast<double>(row) / count) ||
          !scanner.ReadCount(size, IdBytes, Size) ||
          !ReadFace(text, size, this->Header.Vertices, part.Face) || !take(part))
        {
          return false;
        }
        part.Face.Cell += size > 0 ? 1 : 0;
        scanner.SkipLine();
      }
      return true;
    });
}

//------------------------------------------------------------------------------
bool OFFTextReading::ReadFaces(
  TextScanner& scanner, const TextLines* lines, CellMeshPiece& piece, const Progress& progress)
{
  if (this->Header.Faces == 0)
  {
    return MakeCloud(this->Header.Vertices, this->Request, piece, this->Faces);
  }
  return lines ? this->ReadFacesOfLines(scanner, *lines, piece, progress)
               : this->ReadFacesInOrder(scanner, piece, progress);
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

//------------------------------------------------------------------------------
bool ReadTextOFF(TextScanner& scanner, const TextLines* lines, bool mayLackKeyword,
  const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings,
  const Progress& progress)
{
  return OFFTextReading(mayLackKeyword, request, grid, warnings).Read(scanner, lines, progress);
}
}
