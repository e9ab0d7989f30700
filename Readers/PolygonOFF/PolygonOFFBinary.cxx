// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonOFFBinaryReading.h"

#include "Intake/Rows/ListRows.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <string>

namespace camaron
{
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
  return this->Vertices &&
    ((count >= 0 && count <= this->Scanner.GetBytesLeft() / FaceBytes) ||
      this->Scanner.FailAt(place, count < 0 ? ErrorKind::Count : ErrorKind::Truncated,
        "the number of faces, each of at least 8 bytes", std::to_string(count)));
}

//------------------------------------------------------------------------------
// Real numbers from 0 to 1, or an index, which programs may write as an integer or as a real
// number.
OFFColor OFFBinaryReading::ReadColor(const char* place, std::int32_t count) const
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
bool OFFBinaryReading::ForEachVertex(const PieceOfSpace::Visit& visit) const
{
  const auto dimension = std::min<std::int64_t>(this->Header.Dimension, 3);
  return Progress().ForBlocks(this->Header.Vertices, BlockSize,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType vertex = begin; vertex < end; ++vertex)
      {
        const char* const place = this->Vertices + this->GetVertexBytes() * vertex;
        double x[3] = { 0, 0, 0 };
        for (std::int64_t c = 0; c < dimension; ++c)
        {
          x[c] = this->ReadReal(place + Word * c);
        }
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
  const auto readThree = [&](const char* place, double x[3])
  {
    for (std::int64_t c = 0; c < std::min<std::int64_t>(header.Dimension, 3); ++c)
    {
      x[c] = this->ReadReal(place + Word * c);
    }
  };
  const std::int64_t normalAt =
    Word * (header.GetPositionSize() + (header.HasColors && header.HasColorsFirst ? 4 : 0));
  const std::int64_t colorAt =
    Word * (header.GetPositionSize() + (header.HasColorsFirst ? 0 : header.GetNormalSize()));
  std::mutex mutex;
  const auto read = [&](vtkIdType vertex, vtkIdType point)
  {
    const char* const place = this->Vertices + bytes * vertex;
    double x[3];
    readThree(place, x);
    vertices.SetPosition(
      point, header, x, header.IsHomogeneous ? this->ReadReal(place + Word * header.Dimension) : 1);
    if (header.HasNormals)
    {
      readThree(place + normalAt, x);
      vertices.SetNormal(point, header, x);
    }
    if (header.HasColors)
    {
      const OFFColor color = this->ReadColor(place + colorAt, 4);
      vertices.Colors.Set(point, color);
      if (!color.IsInRange())
      {
        const std::lock_guard<std::mutex> lock(mutex);
        this->VertexCensus.OutOfRange.Add(vertex);
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
// After the header, for faces without the number of their color components: the bytes from begin
// on, with a 0 added after each face. Empty unless such faces have valid ids and exactly fill the
// file.
std::string OFFBinaryReading::AddColorSizes(const char* begin) const
{
  const char* place = this->Scanner.GetPosition();
  const char* const end = place + this->Scanner.GetBytesLeft();
  const auto limit = static_cast<std::uint32_t>(this->Header.Vertices);
  std::string bytes(begin, place);
  for (std::int64_t face = 0; face < this->Header.Faces; ++face)
  {
    const std::int32_t size = end - place >= Word ? this->ReadInteger(place) : 0;
    if (size < 1 || size > (end - place - Word) / Word)
    {
      return "";
    }
    const char* const next = place + Word + Word * std::ptrdiff_t(size);
    for (const char* id = place + Word; id < next; id += Word)
    {
      if (static_cast<std::uint32_t>(this->ReadInteger(id)) >= limit)
      {
        return "";
      }
    }
    bytes.append(place, next);
    bytes.append(Word, '\0');
    place = next;
  }
  return place == end ? bytes : "";
}

namespace
{
//------------------------------------------------------------------------------
// Reads everything after the counts; false with the error in the scanner, or if aborted.
bool ReadMesh(OFFBinaryReading& reading, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, const Progress& progress)
{
  CellMeshPiece piece;
  piece.SetPoints(
    [&reading](const PieceOfSpace::Visit& visit) { return reading.ForEachVertex(visit); });
  if (!reading.FindFaces(progress.Part(0, 0.3)) ||
    !reading.ReadFaces(request, piece, progress.Part(0.3, 0.65)))
  {
    return false;
  }
  OFFVertices<float> vertices(reading.Header, piece.GetNumberOfPoints());
  if (!reading.ReadVertices(piece, vertices, progress.Part(0.65, 0.9)))
  {
    return false;
  }
  if (request.Piece == 0 && reading.Scanner.GetBytesLeft() > 0)
  {
    warnings.Add("there is more data after the end of the mesh");
  }
  reading.Fill(vertices, piece, request, grid, warnings, progress.Part(0.9, 1));
  return !progress.IsStopped();
}
}

//------------------------------------------------------------------------------
bool ReadBinaryOFF(const MappedFile& file, const char* body, const OFFHeader& keyword,
  const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings, ScanError& error,
  const Progress& progress)
{
  const auto start = [&](const char* begin, const char* end, ByteOrder order)
  {
    BinaryScanner scanner(file.GetName(), begin, end, order);
    scanner.SetPosition(begin + (body - file.begin()));
    return OFFBinaryReading(scanner, keyword);
  };
  const auto warn = [&](const char* message)
  {
    if (request.Piece == 0)
    {
      warnings.Add(message);
    }
  };
  constexpr char IsLittle[] = "the file is little endian, although OFF files are big endian";
  OFFBinaryReading reading = start(file.begin(), file.end(), ByteOrder::Big);
  bool hasHeader = reading.ReadHeader();
  if (!hasHeader)
  {
    OFFBinaryReading little = start(file.begin(), file.end(), ByteOrder::Little);
    if (little.ReadHeader())
    {
      hasHeader = true;
      reading = std::move(little);
      warn(IsLittle);
    }
  }
  if (hasHeader && ReadMesh(reading, request, grid, warnings, progress))
  {
    return true;
  }
  error = progress.IsStopped() ? ScanError() : reading.Scanner.GetError();
  for (const ByteOrder order : { ByteOrder::Big, ByteOrder::Little })
  {
    OFFBinaryReading plain = start(file.begin(), file.end(), order);
    const std::string bytes =
      !progress.IsStopped() && plain.ReadHeader() ? plain.AddColorSizes(file.begin()) : "";
    if (bytes.empty())
    {
      continue;
    }
    warnings = Warnings();
    if (order == ByteOrder::Little)
    {
      warn(IsLittle);
    }
    warn("the faces lack the number of their color components, as in files of pmp-library");
    OFFBinaryReading completed = start(bytes.data(), bytes.data() + bytes.size(), order);
    const bool isGood =
      completed.ReadHeader() && ReadMesh(completed, request, grid, warnings, progress);
    error = progress.IsStopped() ? ScanError() : completed.Scanner.GetError();
    return isGood;
  }
  return false;
}
}
