// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Binary OFF files.
#include "Intake/Rows/BinaryScanner.h"
#include "Intake/Rows/ListRows.h"
#include "PolygonOFFFaces.h"
#include "Scan/MappedFile.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Reads the parts of a file, one after the other; errors are those of its scanner. HasColorSizes:
// whether faces have the number of their color components.
template <bool HasColorSizes>
class OFFBinaryReading : public OFFMesh
{
public:
  OFFBinaryReading(const BinaryScanner& scanner, const OFFHeader& keyword)
    : Scanner(scanner)
  {
    this->Header = keyword;
  }

  bool ReadHeader();
  /// Reads everything after the header.
  bool Read(const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings,
    const Progress& progress);

  BinaryScanner Scanner;

private:
  static constexpr vtkIdType BlockSize = 4096; // faces or vertices that a thread reads at a time
  static constexpr int Word = 4;               // bytes
  static constexpr int FaceBytes = HasColorSizes ? 2 * Word : Word; // of the sizes of lists

  struct Block
  {
    const char* Place;
    vtkIdType Cell;
  };

  bool FindFaces(const Progress& progress);
  bool ReadFaces(const PieceRequest& request, CellMeshPiece& piece, const Progress& progress);
  bool ReadFace(const char*& place, OFFFace& face) const;
  void FailAtFace(vtkIdType face, const char* place);
  bool ForEachVertex(const PieceOfSpace::Visit& visit) const;
  bool ReadVertices(
    const CellMeshPiece& piece, OFFVertices<float>& vertices, const Progress& progress);
  OFFColor ReadColor(const char* place, std::int32_t count) const;
  float ReadReal(const char* place) const { return Load<float>(place, this->Scanner.IsSwapped()); }
  std::int32_t ReadInteger(const char* place) const
  {
    return Load<std::int32_t>(place, this->Scanner.IsSwapped());
  }
  std::int32_t ReadColorSize(const char* place) const
  {
    return HasColorSizes ? this->ReadInteger(place) : 0;
  }
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

  const char* Vertices = nullptr;
  std::vector<Block> Blocks;
};

//------------------------------------------------------------------------------
template <bool HasColorSizes>
bool OFFBinaryReading<HasColorSizes>::ReadHeader()
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
  return this->Vertices &&
    ((count >= 0 && count <= this->Scanner.GetBytesLeft() / FaceBytes) ||
      this->Scanner.FailAt(place, count < 0 ? ErrorKind::Count : ErrorKind::Truncated,
        "the number of faces, each of at least 8 bytes", std::to_string(count)));
}

//------------------------------------------------------------------------------
// Real numbers from 0 to 1, or an index, which programs may write as an integer or as a real
// number.
template <bool HasColorSizes>
OFFColor OFFBinaryReading<HasColorSizes>::ReadColor(const char* place, std::int32_t count) const
{
  OFFColor color;
  color.Count = count <= 4 ? count : 0;
  color.IsReal = count > 1;
  for (int c = 0; c < color.Count; ++c)
  {
    color.Values[c] = this->ReadReal(place + Word * c);
  }
  // Small integers would be tiny real numbers, which do not occur.
  if (count == 1 && !(std::fabs(color.Values[0]) >= std::numeric_limits<float>::min()))
  {
    color.Values[0] = this->ReadInteger(place);
  }
  return color;
}

//------------------------------------------------------------------------------
// Passes the positions of all vertices, homogeneous ones undivided.
template <bool HasColorSizes>
bool OFFBinaryReading<HasColorSizes>::ForEachVertex(const PieceOfSpace::Visit& visit) const
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
template <bool HasColorSizes>
bool OFFBinaryReading<HasColorSizes>::ReadVertices(
  const CellMeshPiece& piece, OFFVertices<float>& vertices, const Progress& progress)
{
  const OFFHeader& header = this->Header;
  const std::int64_t bytes = this->GetVertexBytes();
  const std::int64_t normalAt =
    Word * (header.GetPositionSize() + (header.HasColors && header.HasColorsFirst ? 4 : 0));
  const std::int64_t colorAt =
    Word * (header.GetPositionSize() + (header.HasColorsFirst ? 0 : header.GetNormalSize()));
  std::mutex mutex;
  const auto read = [&](vtkIdType vertex, vtkIdType point)
  {
    const char* const place = this->Vertices + bytes * vertex;
    double x[3];
    this->ReadThree(place, x);
    vertices.SetPosition(
      point, header, x, header.IsHomogeneous ? this->ReadReal(place + Word * header.Dimension) : 1);
    if (header.HasNormals)
    {
      this->ReadThree(place + normalAt, x);
      vertices.SetNormal(point, header, x);
    }
    if (header.HasColors)
    {
      const OFFColor color = this->ReadColor(place + colorAt, 4);
      vertices.Colors.Set(point, color);
      if (!color.IsInRange())
      {
        const std::lock_guard<std::mutex> lock(mutex);
        this->VertexCensus.Add(OFFOddity::VertexOutOfRange, vertex);
      }
    }
    if (header.HasTexture)
    {
      const double uv[2] = { this->ReadReal(place + bytes - 2 * Word),
        this->ReadReal(place + bytes - Word) };
      vertices.SetTexture(point, uv);
    }
  };
  this->VertexCensus.Colors.HasColors = header.HasColors;
  this->VertexCensus.Colors.HasReals = header.HasColors;
  const vtkIdType count = header.Vertices;
  if (piece.IsWhole() && header.Dimension == 3 && bytes == 3 * Word)
  {
    ListRows rows;
    rows.Begin = this->Vertices;
    rows.Swap = this->Scanner.IsSwapped();
    rows.Size = 3;
    return progress.For(count,
      [&](vtkIdType begin, vtkIdType end)
      {
        rows.Copy(
          begin, end, reinterpret_cast<std::int32_t*>(vertices.Coordinates.data() + 3 * begin));
      });
  }
  return progress.ForBlocks(count, BlockSize,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType vertex = begin; vertex < end; ++vertex)
      {
        if (const vtkIdType point = piece.FindPoint(vertex); point >= 0)
        {
          read(vertex, point);
        }
      }
    });
}

//------------------------------------------------------------------------------
// Visits all faces, to find out where threads start. Without the number of color components, they
// must end with the file.
template <bool HasColorSizes>
bool OFFBinaryReading<HasColorSizes>::FindFaces(const Progress& progress)
{
  const vtkIdType count = this->Header.Faces;
  this->Blocks.clear();
  vtkIdType cells = 0;
  const char* place = this->Scanner.GetPosition();
  const char* const end = place + this->Scanner.GetBytesLeft();
  for (vtkIdType face = 0; face < count; ++face)
  {
    if (face % BlockSize == 0)
    {
      this->Blocks.push_back({ place, cells });
      if (!progress.Report(static_cast<double>(face) / count))
      {
        return false;
      }
    }
    std::int32_t size = end - place >= FaceBytes ? this->ReadInteger(place) : -1;
    std::int32_t components = -1;
    if (size >= 0 && size <= (end - place - FaceBytes) / Word)
    {
      components = this->ReadColorSize(place + Word + Word * std::ptrdiff_t(size));
    }
    if (size == 0 && !HasColorSizes)
    {
      return false;
    }
    if (components != 0)
    {
      this->Scanner.SetPosition(place);
      if (!this->Scanner.ReadCount(size, Word, "the number of vertices of a face") ||
        !this->Scanner.Skip(Word * std::int64_t(size), "the vertices of a face") ||
        !this->Scanner.ReadCount(
          components, Word, "the number of components of the color of a face") ||
        !this->Scanner.Skip(Word * std::int64_t(components), "the color of a face"))
      {
        return false;
      }
    }
    place += FaceBytes + Word * (std::ptrdiff_t(size) + components);
    cells += size > 0 ? 1 : 0;
  }
  this->Scanner.SetPosition(place);
  return HasColorSizes || place == end;
}

//------------------------------------------------------------------------------
// Reads a face; false if an id is out of range, or if the file has changed.
template <bool HasColorSizes>
bool OFFBinaryReading<HasColorSizes>::ReadFace(const char*& place, OFFFace& face) const
{
  const char* const end = this->Scanner.GetPosition();
  const std::int32_t size = end - place < FaceBytes ? -1 : this->ReadInteger(place);
  if (size < 0 || size > (end - place - FaceBytes) / Word)
  {
    return false;
  }
  place += Word;
  face.Points.resize(static_cast<std::size_t>(size));
  const auto limit = static_cast<std::uint32_t>(this->Header.Vertices);
  bool isGood = true;
  for (std::int32_t& id : face.Points)
  {
    id = this->ReadInteger(place);
    isGood = isGood && static_cast<std::uint32_t>(id) < limit;
    place += Word;
  }
  const std::int32_t components = this->ReadColorSize(place);
  place += FaceBytes - Word;
  if (components > (end - place) / Word)
  {
    return false;
  }
  face.Color = components > 0 ? this->ReadColor(place, components) : OFFColor();
  face.HasOddColor = components > 0 && face.Color.Count == 0;
  place += Word * std::ptrdiff_t(std::max(components, 0));
  return isGood;
}

//------------------------------------------------------------------------------
template <bool HasColorSizes>
void OFFBinaryReading<HasColorSizes>::FailAtFace(vtkIdType face, const char* place)
{
  const char* const last = this->Scanner.GetPosition() - Word;
  while (
    place < last && static_cast<std::uint32_t>(this->ReadInteger(place)) < this->Header.Vertices)
  {
    place += Word;
  }
  place = std::min(place, last);
  this->Scanner.FailAt(place, ErrorKind::Index,
    "a vertex of face " + std::to_string(face) + " from 0 to " +
      std::to_string(this->Header.Vertices - 1),
    std::to_string(this->ReadInteger(place)));
}

//------------------------------------------------------------------------------
template <bool HasColorSizes>
bool OFFBinaryReading<HasColorSizes>::ReadFaces(
  const PieceRequest& request, CellMeshPiece& piece, const Progress& progress)
{
  const vtkIdType count = this->Header.Faces;
  if (count == 0)
  {
    return MakeCloud(this->Header.Vertices, request, piece, this->Faces);
  }
  const auto blocks = static_cast<vtkIdType>(this->Blocks.size());
  const std::int32_t first = this->ReadInteger(this->Blocks[0].Place);
  const auto bytes = this->Scanner.GetPosition() - this->Blocks[0].Place;
  const bool hasRoom = first > 0 && first <= bytes / Word / count - FaceBytes / Word;
  return CollectFaces(*this, hasRoom ? first : 0, this->Blocks.size(), request, piece,
    this->Scanner, progress,
    [&](const Progress& share, std::vector<OFFFacePart>& parts, auto&& take)
    {
      std::atomic<bool> goesOn{ true };
      std::vector<vtkIdType> badFaces(parts.size(), -1);
      std::vector<const char*> badPlaces(parts.size(), nullptr);
      const bool isComplete = share.For(blocks,
        [&](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType b = begin; b < end && goesOn; ++b)
          {
            OFFFacePart& part = parts[b];
            const char* place = this->Blocks[b].Place;
            part.Face.Cell = this->Blocks[b].Cell;
            const vtkIdType last = std::min((b + 1) * BlockSize, count);
            for (part.Face.Row = b * BlockSize; part.Face.Row < last; ++part.Face.Row)
            {
              const char* const start = place;
              if (!this->ReadFace(place, part.Face))
              {
                badFaces[b] = part.Face.Row;
                badPlaces[b] = start;
                break;
              }
              if (!take(part))
              {
                goesOn = false;
                break;
              }
              part.Face.Cell += part.Face.Points.empty() ? 0 : 1;
            }
          }
        });
      const auto bad =
        std::find_if(badFaces.begin(), badFaces.end(), [](vtkIdType face) { return face >= 0; });
      if (isComplete && goesOn && bad != badFaces.end())
      {
        this->FailAtFace(*bad, badPlaces[bad - badFaces.begin()] + Word);
        return false;
      }
      return isComplete && goesOn;
    });
}

//------------------------------------------------------------------------------
template <bool HasColorSizes>
bool OFFBinaryReading<HasColorSizes>::Read(const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, const Progress& progress)
{
  CellMeshPiece piece;
  piece.SetPoints([this](const PieceOfSpace::Visit& visit) { return this->ForEachVertex(visit); });
  if (!this->FindFaces(progress.Part(0, 0.3)) ||
    !this->ReadFaces(request, piece, progress.Part(0.3, 0.65)))
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

//------------------------------------------------------------------------------
// Whether a file has a header in this layout, and whether it can be read.
struct Attempt
{
  bool HasHeader = false;
  bool IsGood = false;
};

//------------------------------------------------------------------------------
template <bool HasColorSizes>
Attempt Try(BinaryScanner& scanner, const OFFHeader& keyword, const PieceRequest& request,
  vtkUnstructuredGrid* grid, Warnings& warnings, const Progress& progress)
{
  OFFBinaryReading<HasColorSizes> reading(scanner, keyword);
  Attempt attempt;
  attempt.HasHeader = reading.ReadHeader();
  attempt.IsGood = attempt.HasHeader && reading.Read(request, grid, warnings, progress);
  scanner = reading.Scanner;
  return attempt;
}
}

//------------------------------------------------------------------------------
bool ReadBinaryOFF(const MappedFile& file, const char* body, const OFFHeader& keyword,
  const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings, ScanError& error,
  const Progress& progress)
{
  // The error is that of the format, unless the file can only be little endian.
  bool hasHeader = false;
  for (const bool hasColorSizes : { true, false })
  {
    for (const ByteOrder order : { ByteOrder::Big, ByteOrder::Little })
    {
      BinaryScanner scanner(file.GetName(), file.begin(), file.end(), order);
      scanner.SetPosition(body);
      Warnings found;
      if (order == ByteOrder::Little)
      {
        found.Add("the file is little endian, although OFF files are big endian");
      }
      if (!hasColorSizes)
      {
        found.Add(
          "the faces lack the number of their color components, as in files of pmp-library");
      }
      const Attempt attempt =
        (hasColorSizes ? Try<true> : Try<false>)(scanner, keyword, request, grid, found, progress);
      if (attempt.IsGood)
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
      if (hasColorSizes && !hasHeader && (attempt.HasHeader || !error))
      {
        error = scanner.GetError();
      }
      hasHeader = hasHeader || attempt.HasHeader;
    }
  }
  return false;
}
}
