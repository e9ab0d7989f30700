// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VisfReading.h"

#include "Intake/FaceMesh/GridBuilder.h"
#include "Intake/Pieces/ReadMappedFile.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <memory>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// One interpretation of the beginning of a file.
struct Header
{
  bool Text;
  ByteOrder Order;
  const char* Body; // after the byte that gives the encoding
};

//------------------------------------------------------------------------------
// All interpretations of the beginning of a file, likelier ones first.
std::vector<Header> FindHeaders(const char* begin, const char* end)
{
  const char* text = TextScanner("", begin, end).GetPosition(); // after a byte order mark
  while (text < end && IsSpace(*text))
  {
    ++text;
  }
  if (text == end)
  {
    return {};
  }
  if (*text == '0' || *text == '1')
  {
    return { { false, *text == '0' ? ByteOrder::Big : ByteOrder::Little, text + 1 } };
  }
  if (*text == '2' || *text == '#')
  {
    return { { true, ByteOrder::Little, begin } };
  }
  switch (*begin)
  {
    case 0: // v0.2, or v0.1, which starts with the type
      return { { false, ByteOrder::Big, begin + 1 }, { false, ByteOrder::Little, begin },
        { false, ByteOrder::Big, begin } };
    case 1:
      return { { false, ByteOrder::Little, begin + 1 }, { false, ByteOrder::Little, begin } };
    case 2:
      return { { false, ByteOrder::Little, begin } };
    default:
      return {};
  }
}

//------------------------------------------------------------------------------
const char* DescribeType(int type)
{
  return type == 0 ? "a vertex cloud (0)"
    : type == 1    ? "a polygon mesh (1)"
                   : "a polyhedron mesh (2)";
}

//------------------------------------------------------------------------------
// Result of reading a file under one interpretation.
struct Content
{
  std::unique_ptr<TextLines> Lines; // of text, if it is large
  FaceMesh Mesh;
  int Type = -1;
  bool HasFlag = true;
  bool HasTrailingData = false;
  std::string WrongFlag; // warning about an invalid flag
  IdLists::Expectation Faces, Cells;
  ScanError Error;
};

//------------------------------------------------------------------------------
constexpr const char* Coordinate = "a coordinate of a vertex";

//------------------------------------------------------------------------------
IdLists::Expectation ExpectNeighbors(vtkIdType faces)
{
  IdLists::Expectation expected;
  expected.List = "list of neighbors";
  expected.Id = "polygon";
  expected.Limit = faces;
  expected.AccessAll = false;
  return expected;
}

//------------------------------------------------------------------------------
class VisfReading
{
public:
  VisfReading(const MappedFile& file, const PieceRequest& request, vtkIdType chunk)
    : File(file)
    , Request(request)
    , Chunk(chunk)
  {
  }

  /// Reads the file under the best interpretation; false with the error in the content, or if
  /// aborted.
  bool Read(Content& content, const Progress& progress) const;

private:
  bool ReadBinary(const Header& header, Content& content, const Progress& progress) const;
  bool ReadText(Content& content, const Progress& progress) const;
  bool ReadTextPoints(
    TextScanner& scanner, vtkIdType points, Content& content, const Progress& progress) const;
  bool ReadTextTail(TextScanner& scanner, const TextLines* lines, bool withFlag, Content& content,
    const Progress& progress) const;
  void Expect(Content& content, vtkIdType points, vtkIdType faces) const;

  const MappedFile& File;
  const PieceRequest& Request;
  vtkIdType Chunk;
};

//------------------------------------------------------------------------------
bool VisfReading::Read(Content& content, const Progress& progress) const
{
  const std::vector<Header> headers = FindHeaders(this->File.begin(), this->File.end());
  if (headers.empty())
  {
    TextScanner scanner(this->File.GetName(), this->File.begin(), this->File.end());
    scanner.SkipSpace();
    scanner.FailAt(
      scanner.GetPosition(), ErrorKind::NotThisFormat, "a Visf file, which begins with 0, 1 or 2");
    content.Error = scanner.GetError();
    return false;
  }
  if (headers.front().Text)
  {
    return this->ReadText(content, progress);
  }
  // The interpretation that consumes the whole file wins, then the first without an error, then the
  // first with a valid type.
  bool good = false;
  for (const Header& header : headers)
  {
    Content other;
    const bool otherIsGood = this->ReadBinary(header, other, progress);
    const bool isFirst = &header == &headers.front();
    const bool isBetter =
      otherIsGood ? !good || !other.HasTrailingData : !good && content.Type < 0 && other.Type >= 0;
    if (isFirst || isBetter)
    {
      content = std::move(other);
      good = otherIsGood;
    }
    if ((good && !content.HasTrailingData) || progress.IsStopped())
    {
      break;
    }
  }
  return good;
}

//------------------------------------------------------------------------------
void VisfReading::Expect(Content& content, vtkIdType points, vtkIdType faces) const
{
  content.Faces = content.Mesh.ExpectFaces(points, this->Request);
  content.Faces.List = "polygon";
  content.Faces.Id = "vertex";
  content.Cells = content.Mesh.ExpectCells(faces);
  content.Cells.List = "polyhedron";
  content.Cells.Id = "polygon";
}

//------------------------------------------------------------------------------
bool VisfReading::ReadBinary(const Header& header, Content& content, const Progress& progress) const
{
  BinaryScanner scanner(this->File.GetName(), this->File.begin(), this->File.end(), header.Order);
  scanner.SetPosition(header.Body);
  FaceMesh& mesh = content.Mesh;
  const auto read = [&]
  {
    std::int32_t type = 0, points = 0, faces = 0, cells = 0, flag = 0;
    const char* const typePlace = scanner.GetPosition();
    if (scanner.ReadInteger(type, "the type of the mesh") && (type < 0 || type > 2))
    {
      scanner.FailAt(
        typePlace, ErrorKind::NotThisFormat, "a Visf mesh type of 0, 1 or 2", std::to_string(type));
    }
    if (scanner.HasFailed())
    {
      return false;
    }
    content.Type = type;
    if (!scanner.ReadCount(points, 12, "the number of vertices"))
    {
      return false;
    }
    mesh.Points = PointSource(
      scanner.Skip(12 * std::int64_t(points), "the vertices"), points, false, scanner.IsSwapped());
    if (scanner.GetBytesLeft() == 0)
    {
      return true;
    }
    if (!scanner.ReadCount(faces, 4, "the number of polygons"))
    {
      return false;
    }
    this->Expect(content, points, faces);
    if (!mesh.Faces.Scan(scanner, faces, content.Faces, progress.Part(0, 0.5)))
    {
      return false;
    }
    if (faces > 0)
    {
      const char* const flagPlace = scanner.GetPosition();
      if (scanner.ReadInteger(flag, "the flag for neighbors") && (flag < 0 || flag > 1))
      {
        scanner.FailAt(
          flagPlace, ErrorKind::Syntax, "the flag for neighbors, 0 or 1", std::to_string(flag));
      }
      IdLists neighbors;
      IdLists::Expectation expected = ExpectNeighbors(faces);
      if (scanner.HasFailed() ||
        (flag == 1 && !neighbors.Scan(scanner, faces, expected, progress.Part(0.5, 0.6))))
      {
        return false;
      }
    }
    if (scanner.GetBytesLeft() == 0)
    {
      return true;
    }
    if (!scanner.ReadCount(cells, 4, "the number of polyhedra"))
    {
      return false;
    }
    if (faces == 0 && cells == 0 && scanner.GetBytesLeft() == 4)
    {
      std::int32_t last = 0;
      const char* const lastPlace = scanner.GetPosition();
      scanner.ReadInteger(last, "the number of polyhedra"); // the number before was the flag
      if (last != 0)
      {
        scanner.SetPosition(lastPlace);
      }
    }
    return mesh.Cells.Scan(scanner, cells, content.Cells, progress.Part(0.6, 1));
  };
  const bool good = read();
  content.Error = scanner.GetError();
  content.HasTrailingData = scanner.GetBytesLeft() > 0;
  return good;
}

//------------------------------------------------------------------------------
// Pieces of a large text check all points now, and store theirs once they are known.
bool VisfReading::ReadTextPoints(
  TextScanner& scanner, vtkIdType points, Content& content, const Progress& progress) const
{
  FaceMesh& mesh = content.Mesh;
  const TextLines* const lines = content.Lines.get();
  TextScanner attempt = scanner;
  if (this->Request.NumberOfPieces > 1 && lines)
  {
    const bool good = RowSequence(attempt, lines, points)
                        .ForEach(progress,
                          [](vtkIdType, vtkIdType, TextRow& text)
                          {
                            float x[3];
                            return text.ReadPoint(x, Coordinate);
                          });
    if (good)
    {
      mesh.Points = PointSource(nullptr, points, false);
      mesh.ReadPoints = [lines, points, start = scanner](
                          const IdSet* wanted, const FaceMesh::PutPoint& put, const Progress& part)
      {
        TextScanner again = start;
        return RowSequence(again, lines, points)
          .ForEach(part,
            [&](vtkIdType row, vtkIdType, TextRow& text)
            {
              float x[3];
              if (wanted && !wanted->Contains(row))
              {
                return true;
              }
              const bool good = text.ReadPoint(x, Coordinate);
              if (good)
              {
                put(row, x);
              }
              return good;
            });
      };
      scanner = attempt;
      return true;
    }
    attempt = scanner;
  }
  mesh.Floats = Buffer<float>(3 * points);
  mesh.Points = PointSource(reinterpret_cast<const char*>(mesh.Floats.data()), points, false);
  const auto read = [&mesh](vtkIdType row, vtkIdType, TextRow& text)
  { return text.ReadPoint(mesh.Floats.data() + 3 * row, Coordinate); };
  if (lines && RowSequence(attempt, lines, points).ForEach(progress, read))
  {
    scanner = attempt;
    return true;
  }
  return !progress.IsStopped() && RowSequence(scanner, nullptr, points).ForEach(progress, read);
}

//------------------------------------------------------------------------------
bool VisfReading::ReadText(Content& content, const Progress& progress) const
{
  const char* const end = FindTextEnd(this->File.begin(), this->File.end());
  TextScanner scanner(this->File.GetName(), this->File.begin(), end, '#');
  FaceMesh& mesh = content.Mesh;
  const auto read = [&]
  {
    std::int64_t encoding = 0, type = 0, points = 0, faces = 0;
    if (!scanner.ReadInteger(
          encoding, 2, 2, ErrorKind::NotThisFormat, "the encoding of Visf text") ||
      !scanner.ReadInteger(type, 0, 2, ErrorKind::NotThisFormat, "a Visf mesh type"))
    {
      return false;
    }
    content.Type = static_cast<int>(type);
    scanner.SkipLine();
    constexpr int VertexBytes = 6; // "0 0 0" and a line end
    if (!scanner.ReadCount(points, VertexBytes, "the number of vertices"))
    {
      return false;
    }
    scanner.SkipLine();
    std::unique_ptr<TextLines>& lines = content.Lines;
    if (scanner.GetBytesLeft() >= 2 * this->Chunk)
    {
      lines.reset(new TextLines(scanner, progress.Part(0, 0.1), this->Chunk));
    }
    if (progress.IsStopped() ||
      !this->ReadTextPoints(scanner, points, content, progress.Part(0.1, 0.4)))
    {
      return false;
    }
    if (!scanner.SkipSpace())
    {
      return true;
    }
    if (!scanner.ReadCount(faces, 2, "the number of polygons"))
    {
      return false;
    }
    scanner.SkipLine();
    this->Expect(content, points, faces);
    if (!mesh.Faces.Scan(scanner, lines.get(), faces, true, content.Faces, progress.Part(0.4, 0.7)))
    {
      return false;
    }
    if (!scanner.SkipSpace())
    {
      content.HasFlag = faces == 0;
      return faces == 0 || content.Type != 2 ||
        scanner.FailAt(
          scanner.GetEnd(), ErrorKind::Truncated, "the flag for neighbors and the polyhedra");
    }

    // Some programs omit the flag for neighbors. The interpretation that consumes the file wins.
    TextScanner flagless = scanner;
    if (faces > 0)
    {
      if (this->ReadTextTail(scanner, lines.get(), true, content, progress.Part(0.7, 1)) &&
        !content.HasTrailingData)
      {
        return true;
      }
      std::int64_t flag = 0;
      const bool mayBeCount = TextScanner(flagless).ReadInteger(flag, "") && flag != 0 && flag != 1;
      Content other;
      this->Expect(other, points, faces);
      const bool otherIsGood =
        this->ReadTextTail(flagless, lines.get(), false, other, progress.Part(0.7, 1));
      // A list of neighbors truncated after a few ids looks like a polyhedron with too few
      // polygons.
      const bool otherFits = otherIsGood && !other.HasTrailingData &&
        other.Cells.Empty.Count + other.Cells.Short.Count == 0;
      if (!mayBeCount && !otherFits)
      {
        return !scanner.HasFailed();
      }
      mesh.Cells = std::move(other.Mesh.Cells);
      mesh.FacesOfCells = std::move(other.Mesh.FacesOfCells);
      content.Cells = other.Cells;
      content.HasTrailingData = other.HasTrailingData;
      scanner = flagless;
      if (!otherIsGood || content.HasTrailingData)
      {
        content.WrongFlag = "the number " + std::to_string(flag) +
          " after the polygons is read as the number of polyhedra, as it is not a flag for "
          "neighbors, 0 or 1";
        scanner.AddToError(" (" + content.WrongFlag + ")");
      }
      return otherIsGood;
    }
    return this->ReadTextTail(scanner, lines.get(), false, content, progress.Part(0.7, 1));
  };
  const bool good = read();
  content.Error = scanner.GetError();
  return good && !progress.IsStopped();
}

//------------------------------------------------------------------------------
// Reads everything after the polygons.
bool VisfReading::ReadTextTail(TextScanner& scanner, const TextLines* lines, bool withFlag,
  Content& content, const Progress& progress) const
{
  const vtkIdType faces = content.Cells.Limit;
  if (withFlag)
  {
    std::int64_t flag = 0;
    if (!scanner.ReadInteger(flag, 0, 1, ErrorKind::Syntax, "the flag for neighbors"))
    {
      return false;
    }
    scanner.SkipLine();
    IdLists neighbors;
    IdLists::Expectation expected = ExpectNeighbors(faces);
    if (flag == 1 && !neighbors.Scan(scanner, lines, faces, false, expected, progress.Part(0, 0.3)))
    {
      return false;
    }
  }
  std::int64_t cells = 0;
  if (scanner.SkipSpace())
  {
    if (!scanner.ReadCount(cells, 2, "the number of polyhedra"))
    {
      return false;
    }
    scanner.SkipLine();
    if (!content.Mesh.Cells.Scan(scanner, lines, cells, true, content.Cells, progress.Part(0.3, 1)))
    {
      return false;
    }
    TextScanner next = scanner;
    std::int64_t last = 0;
    if (faces == 0 && cells == 0 && next.ReadInteger(last, 0, 0, ErrorKind::Count, "zero"))
    {
      scanner = next; // the number before was the flag
      scanner.SkipLine();
    }
  }
  content.HasTrailingData = scanner.SkipSpace();
  return true;
}

//------------------------------------------------------------------------------
void Warn(const Content& content, Warnings& warnings)
{
  warnings.Add(content.Faces.Empty, "polygon", "polygons", "without vertices, omitted");
  warnings.Add(content.Faces.Short, "polygon", "polygons", "with fewer than 3 vertices");
  warnings.Add(
    content.Faces.Repeating, "polygon", "polygons", "with the same vertex more than once");
  warnings.Add(content.Cells.Empty, "polyhedron", "polyhedra", "without polygons");
  const int type = content.Mesh.Cells.GetCount() > 0 ? 2
    : content.Mesh.Faces.GetCount() > 0              ? 1
                                                     : 0;
  if (type != content.Type && content.Mesh.Points.Count > 0)
  {
    warnings.Add(std::string("the header declares ") + DescribeType(content.Type) +
      ", the content is " + DescribeType(type));
  }
  if (!content.HasFlag)
  {
    warnings.Add("the flag for neighbors is missing at the end of the file");
  }
  if (content.HasTrailingData)
  {
    const std::string& flag = content.WrongFlag;
    warnings.Add(
      "there is more data after the end of the mesh" + (flag.empty() ? flag : " (" + flag + ")"));
  }
}
}

//------------------------------------------------------------------------------
bool IsVisf(const std::string& path)
{
  const MappedFile file(path);
  for (const Header& header : FindHeaders(file.begin(), file.end()))
  {
    if (header.Text)
    {
      TextScanner scanner("", file.begin(), file.end(), '#');
      std::int64_t value;
      float x[3];
      const bool hasType = scanner.ReadInteger(value, 2, 2, ErrorKind::Syntax, "") &&
        scanner.ReadInteger(value, 0, 2, ErrorKind::Syntax, "");
      scanner.SkipLine();
      const bool hasCount =
        hasType && scanner.ReadInteger(value, 0, INT32_MAX, ErrorKind::Count, "");
      scanner.SkipLine();
      return hasCount && (value == 0 || TextRow(scanner).ReadPoint(x, ""));
    }
    BinaryScanner scanner("", file.begin(), file.end(), header.Order);
    scanner.SetPosition(header.Body);
    std::int32_t type, points;
    if (scanner.ReadInteger(type, "") && type >= 0 && type <= 2 &&
      scanner.ReadInteger(points, "") && points >= 0 && points <= scanner.GetBytesLeft() / 12)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool ReadVisf(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress, vtkIdType chunk)
{
  return ReadMappedFile(path, request, grid, warnings, error, progress,
    [&](const MappedFile& file, const Progress& rest)
    {
      Content content;
      if (!VisfReading(file, request, chunk).Read(content, rest.Part(0, 0.4)))
      {
        error = content.Error;
        return false;
      }
      if (request.Piece == 0)
      {
        Warn(content, warnings);
      }
      content.Mesh.HasEmptyFaces = content.Faces.Empty.Count > 0;
      const bool built = BuildGrid(content.Mesh, request, grid, warnings, error, rest.Part(0.4, 1));
      if (error)
      {
        error.Message = file.GetName() + ": " + error.Message;
      }
      return built;
    });
}
}
