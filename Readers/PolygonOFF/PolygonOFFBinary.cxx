// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Binary OFF files.
#include "Intake/CellMesh/CellLists.h"
#include "Intake/Rows/BinaryScanner.h"
#include "PolygonOFFMesh.h"
#include "Scan/MappedFile.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>

namespace camaron
{
namespace
{
constexpr int Word = 4;               // bytes
constexpr vtkIdType BlockSize = 4096; // vertices that a thread reads at a time

//------------------------------------------------------------------------------
// Real numbers from 0 to 1, or an index, which programs may write as an integer or as a real
// number.
OFFColor MakeColor(const std::int32_t* words, std::int32_t count)
{
  OFFColor color;
  color.Count = count <= 4 ? count : 0;
  color.IsReal = count > 1;
  for (int c = 0; c < color.Count; ++c)
  {
    float value;
    std::memcpy(&value, words + c, Word);
    color.Values[c] = value;
  }
  // Small integers would be tiny real numbers, which do not occur.
  if (count == 1 && !(std::fabs(color.Values[0]) >= std::numeric_limits<float>::min()))
  {
    color.Values[0] = words[0];
  }
  return color;
}

//------------------------------------------------------------------------------
// Reads the parts of a file, one after the other; errors are those of its scanner.
class OFFBinaryReading : public OFFMesh
{
public:
  /// @param hasColorSizes whether faces have the number of their color components
  OFFBinaryReading(const BinaryScanner& scanner, const OFFHeader& keyword, bool hasColorSizes)
    : Scanner(scanner)
    , HasColorSizes(hasColorSizes)
  {
    this->Header = keyword;
  }

  bool ReadHeader();
  /// Reads everything after the header.
  bool Read(const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings,
    const Progress& progress);

  BinaryScanner Scanner;

private:
  bool ReadFaces(const PieceRequest& request, CellMeshPiece& piece, const Progress& progress);
  bool ReadColors(
    const CellLists::Part& faces, const CellMeshPiece& piece, const Progress& progress);
  bool ForEachVertex(const PieceOfSpace::Visit& visit) const;
  bool ReadVertices(
    const CellMeshPiece& piece, OFFVertices<float>& vertices, const Progress& progress);
  float ReadReal(const char* place) const { return Load<float>(place, this->Scanner.IsSwapped()); }
  std::int64_t GetVertexBytes() const
  {
    return Word * (this->Header.GetVertexSize() + (this->Header.HasColors ? 4 : 0));
  }
  /// Coordinates or components of a normal; missing ones are 0.
  void ReadThree(const char* place, double x[3]) const
  {
    for (std::int64_t c = 0; c < 3; ++c)
    {
      x[c] = c < this->Header.Dimension ? this->ReadReal(place + Word * c) : 0;
    }
  }

  bool HasColorSizes;
  const char* Vertices = nullptr;
};

//------------------------------------------------------------------------------
bool OFFBinaryReading::ReadHeader()
{
  std::int32_t count;
  if (this->Header.HasDimension)
  {
    const char* const place = this->Scanner.GetPosition();
    if (!this->Scanner.ReadInteger(count, "the number of dimensions"))
    {
      return false;
    }
    if (count < 1)
    {
      return this->Scanner.FailAt(
        place, ErrorKind::Count, "the number of dimensions, at least 1", std::to_string(count));
    }
    this->Header.Dimension = count;
  }
  const auto vertexBytes =
    static_cast<int>(std::min<std::int64_t>(this->GetVertexBytes(), INT32_MAX));
  if (!this->Scanner.ReadCount(count, vertexBytes, "the number of vertices"))
  {
    return false;
  }
  this->Header.Vertices = count;
  const char* const place = this->Scanner.GetPosition();
  if (!this->Scanner.ReadInteger(count, "the number of faces") ||
    !this->Scanner.Skip(Word, "the number of edges"))
  {
    return false;
  }
  this->Vertices = this->Scanner.Skip(vertexBytes * this->Header.Vertices, "the vertices");
  this->Header.Faces = count;
  const int faceBytes = this->HasColorSizes ? 2 * Word : Word;
  return this->Vertices &&
    ((count >= 0 && count <= this->Scanner.GetBytesLeft() / faceBytes) ||
      this->Scanner.FailAt(place, count < 0 ? ErrorKind::Count : ErrorKind::Truncated,
        "the number of faces, each of at least 8 bytes", std::to_string(count)));
}

//------------------------------------------------------------------------------
// Passes the positions of all vertices, homogeneous ones undivided.
bool OFFBinaryReading::ForEachVertex(const PieceOfSpace::Visit& visit) const
{
  return Progress().ForBlocks(this->Header.Vertices, BlockSize,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType vertex = begin; vertex < end; ++vertex)
      {
        double x[3];
        this->ReadThree(this->Vertices + this->GetVertexBytes() * vertex, x);
        visit(vertex, x);
      }
    });
}

//------------------------------------------------------------------------------
bool OFFBinaryReading::ReadVertices(
  const CellMeshPiece& piece, OFFVertices<float>& vertices, const Progress& progress)
{
  const OFFHeader& header = this->Header;
  const std::int64_t bytes = this->GetVertexBytes();
  const std::int64_t normalAt =
    Word * (header.GetPositionSize() + (header.HasColors && header.HasColorsFirst ? 4 : 0));
  const std::int64_t colorAt =
    Word * (header.GetPositionSize() + (header.HasColorsFirst ? 0 : header.GetNormalSize()));
  this->VertexCensus.Colors.HasColors = header.HasColors;
  this->VertexCensus.Colors.HasReals = header.HasColors;
  if (piece.IsWhole() && header.IsPlain())
  {
    ListRows rows;
    rows.Begin = this->Vertices;
    rows.Swap = this->Scanner.IsSwapped();
    rows.Size = 3;
    return progress.For(header.Vertices,
      [&](vtkIdType begin, vtkIdType end)
      {
        rows.Copy(
          begin, end, reinterpret_cast<std::int32_t*>(vertices.Coordinates.data() + 3 * begin));
      });
  }
  std::mutex mutex;
  return progress.ForBlocks(header.Vertices, BlockSize,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType vertex = begin; vertex < end; ++vertex)
      {
        const vtkIdType point = piece.FindPoint(vertex);
        if (point < 0)
        {
          continue;
        }
        const char* const place = this->Vertices + bytes * vertex;
        OFFVertex read;
        this->ReadThree(place, read.Position);
        if (header.IsHomogeneous)
        {
          read.Last = this->ReadReal(place + Word * header.Dimension);
        }
        if (header.HasNormals)
        {
          this->ReadThree(place + normalAt, read.Normal);
        }
        if (header.HasColors)
        {
          std::int32_t words[4];
          for (int c = 0; c < 4; ++c)
          {
            words[c] = Load<std::int32_t>(place + colorAt + Word * c, this->Scanner.IsSwapped());
          }
          read.Color = MakeColor(words, 4);
          if (!read.Color.IsInRange())
          {
            const std::lock_guard<std::mutex> lock(mutex);
            this->VertexCensus.Add(OFFOddity::VertexOutOfRange, vertex);
          }
        }
        if (header.HasTexture)
        {
          read.Texture[0] = this->ReadReal(place + bytes - 2 * Word);
          read.Texture[1] = this->ReadReal(place + bytes - Word);
        }
        vertices.Set(point, header, read);
      }
    });
}

//------------------------------------------------------------------------------
bool OFFBinaryReading::ReadFaces(
  const PieceRequest& request, CellMeshPiece& piece, const Progress& progress)
{
  Table table{ "face", this->Header.Faces, {} };
  table.Properties.push_back({ "vertices", ValueType::Int32, true, ValueType::Int32 });
  if (this->HasColorSizes)
  {
    table.Properties.push_back({ "color", ValueType::Int32, true, ValueType::Int32 });
  }
  CellLists::Part part;
  part.Rows = MakeBinaryRows(table, this->Scanner);
  part.List = 0;
  part.Expected.What = "a vertex of a face";
  if (!part.Rows->Locate(progress.Part(0, 0.3)))
  {
    return false;
  }
  if (!this->HasColorSizes && this->Scanner.GetBytesLeft() > 0)
  {
    return this->Scanner.FailAt(this->Scanner.GetPosition(), ErrorKind::Syntax,
      "the end of the file after little-endian faces without numbers of color components",
      std::to_string(this->Scanner.GetBytesLeft()) + " bytes");
  }
  if (this->Header.Faces == 0)
  {
    return MakeCloud(this->Header.Vertices, request, piece, this->Faces);
  }
  CellLists cells;
  if (!cells.Read({ &part }, this->Header.Vertices, false, request, piece, progress.Part(0.3, 0.8)))
  {
    return false;
  }
  this->Faces = std::move(cells.Mesh);
  for (int size = 0; size < 3; ++size)
  {
    this->FaceCensus.Add(FewVertices[size], part.Few[size]);
  }
  return !this->HasColorSizes || this->ReadColors(part, piece, progress.Part(0.8, 1));
}

//------------------------------------------------------------------------------
// Faces of other pieces count, too: their colors say what numbers mean.
bool OFFBinaryReading::ReadColors(
  const CellLists::Part& faces, const CellMeshPiece& piece, const Progress& progress)
{
  ListSizes sizes;
  if (!faces.Rows->ReadSizes(1, sizes, progress.Part(0, 0.3)))
  {
    return false;
  }
  if (sizes.Total == 0)
  {
    return true;
  }
  this->FaceColors = OFFColors(piece.GetNumberOfCells());
  std::mutex mutex;
  return faces.Rows->ReadIds(
    1, { "a color", ListIds::Any }, sizes, nullptr,
    [&](vtkIdType first, vtkIdType count, const std::int32_t* words)
    {
      OFFCensus census;
      for (vtkIdType face = first; face < first + count; ++face)
      {
        const auto size = static_cast<std::int32_t>(sizes.GetSize(face));
        const OFFColor color = MakeColor(words, size);
        census.AddFace(face, color, size > 0 && color.Count == 0);
        const vtkIdType cell = faces.GetCell(face);
        const vtkIdType index = cell < 0 ? -1 : piece.FindCell(cell);
        if (index >= 0)
        {
          this->FaceColors.Set(index, color);
        }
        words += size;
      }
      const std::lock_guard<std::mutex> lock(mutex);
      this->FaceCensus.Merge(census);
    },
    nullptr, progress.Part(0.3, 1));
}

//------------------------------------------------------------------------------
bool OFFBinaryReading::Read(const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, const Progress& progress)
{
  CellMeshPiece piece;
  piece.SetPoints([this](const PieceOfSpace::Visit& visit) { return this->ForEachVertex(visit); });
  if (!this->ReadFaces(request, piece, progress.Part(0, 0.65)))
  {
    return false;
  }
  OFFVertices<float> vertices(this->Header, piece.GetNumberOfPoints());
  if (!this->ReadVertices(piece, vertices, progress.Part(0.65, 0.9)))
  {
    return false;
  }
  if (request.Piece == 0 && this->Scanner.GetBytesLeft() > 0)
  {
    warnings.Add("there is more data after the end of the mesh");
  }
  this->Fill(vertices, piece, request, grid, warnings, progress.Part(0.9, 1));
  return !progress.IsStopped();
}
}

//------------------------------------------------------------------------------
bool ReadBinaryOFF(const MappedFile& file, const char* body, const OFFHeader& keyword,
  const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings, ScanError& error,
  const Progress& progress)
{
  bool hasHeader = false;
  for (const bool isStandard : { true, false })
  {
    const ByteOrder order = isStandard ? ByteOrder::Big : ByteOrder::Little;
    BinaryScanner scanner(file.GetName(), file.begin(), file.end(), order);
    scanner.SetPosition(body);
    Warnings found;
    if (!isStandard)
    {
      found.Add("the file is little endian, although OFF files are big endian");
      found.Add("the faces lack the number of their color components, as in files of pmp-library");
    }
    OFFBinaryReading reading(scanner, keyword, isStandard);
    const bool couldBe = reading.ReadHeader();
    if (couldBe && reading.Read(request, grid, found, progress))
    {
      warnings = request.Piece == 0 ? found : warnings;
      error = ScanError();
      return true;
    }
    if (progress.IsStopped())
    {
      error = ScanError();
      return false;
    }
    // The error is that of the format, unless the file can only be one of pmp-library.
    if (isStandard || (couldBe && !hasHeader))
    {
      error = reading.Scanner.GetError();
    }
    hasHeader = couldBe;
  }
  return false;
}
}
