// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonOFFBinary.h"

#include "CellMesh/CellRows.h"
#include "Scan/BinaryScanner.h"
#include "Scan/ListRows.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <string>
#include <vector>

namespace camaron
{
namespace
{
constexpr vtkIdType BlockSize = 4096; // faces or vertices that one thread reads in a row
constexpr int Word = 4;               // bytes
constexpr int FaceBytes = 2 * Word;   // its number of vertices and that of components of its colour

//------------------------------------------------------------------------------
class BinaryReading
{
public:
  BinaryReading(const BinaryScanner& scanner, const OFFHeader& keyword)
    : Scanner(scanner)
    , Header(keyword)
  {
  }

  bool ReadHeader();
  bool FindFaces(bool guesses, const Progress& progress);
  bool ReadFaces(const Progress& progress);
  bool ReadPieceOfFaces(
    const PieceRequest& request, CellPiece& piece, const Progress& progress);
  bool ReadVertices(const CellPiece& piece, OFFVertices<float>& vertices, const Progress& progress);
  std::string AddColorSizes(const char* begin) const;

  BinaryScanner Scanner;
  OFFHeader Header;
  OFFFaces Faces;
  OFFFaceCensus FaceCensus;
  OFFVertexCensus VertexCensus;

private:
  struct Block
  {
    const char* Place;
    vtkIdType Cell;
    vtkIdType Id;
  };

  bool FindFacesOfOneSize(bool guesses, const Progress& progress);
  bool ArePlainFacesAlike(vtkIdType begin, vtkIdType end) const;
  bool ReadPlainFaces(const Progress& progress);
  bool ReadAlikeFaces(const char* place, vtkIdType faces, std::int32_t* ids) const;
  bool ReadFace(const char*& place, vtkIdType face, vtkIdType room, std::int32_t* ids,
    std::int32_t& size, OFFColor& color, OFFFaceCensus& seen) const;
  template <typename Take>
  bool ForEachFace(bool store, const Progress& progress, Take&& take);
  void FailAtFace(vtkIdType face, const char* place);
  OFFColor ReadColor(const char* place, std::int32_t count) const;
  float ReadReal(const char* place) const { return Load<float>(place, this->Scanner.IsSwapped()); }
  std::int32_t ReadInteger(const char* place) const
  {
    return Load<std::int32_t>(place, this->Scanner.IsSwapped());
  }
  std::int64_t GetVertexBytes() const
  {
    return Word * (this->Header.GetVertexSize() + (this->Header.HasColors ? 4 : 0));
  }

  const char* Vertices = nullptr;
  const char* FirstFace = nullptr;
  std::vector<Block> Blocks;
  vtkIdType NumberOfCells = 0;
  vtkIdType NumberOfIds = 0;
  std::int32_t CommonSize = -1;
  bool AreAlike = false; // faces of one size without colours, so that each place is known
  Buffer<std::int32_t> Offsets; // of other faces where none is empty or has a colour, for the same
  bool HasFaceColors = false;
};

//------------------------------------------------------------------------------
bool BinaryReading::ReadHeader()
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
      this->Scanner.FailAt(
        place, ErrorKind::Count, "the number of dimensions, at least 1", std::to_string(count));
      return false;
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
  if (this->Vertices && (count < 0 || count > this->Scanner.GetBytesLeft() / FaceBytes))
  {
    this->Scanner.FailAt(place, count < 0 ? ErrorKind::Count : ErrorKind::Truncated,
      "the number of faces, each of at least 8 bytes", std::to_string(count));
  }
  this->Header.Faces = count;
  return !this->Scanner.HasFailed();
}

//------------------------------------------------------------------------------
bool BinaryReading::ArePlainFacesAlike(vtkIdType begin, vtkIdType end) const
{
  const std::ptrdiff_t bytes = FaceBytes + Word * std::ptrdiff_t(this->CommonSize);
  const char* place = this->FirstFace + begin * bytes;
  bool alike = true;
  for (vtkIdType face = begin; face < end; ++face)
  {
    alike &= this->ReadInteger(place) == this->CommonSize;
    place += bytes;
    alike &= this->ReadInteger(place - Word) == 0;
  }
  return alike;
}

//------------------------------------------------------------------------------
// Takes the size of the first face for that of all; false if it is not, or if they have colours.
// Where such faces just fill the file it is likely, and may be left to those who read them to check.
bool BinaryReading::FindFacesOfOneSize(bool guesses, const Progress& progress)
{
  const vtkIdType count = this->Header.Faces;
  const char* const first = this->FirstFace;
  const std::int64_t size = count > 0 ? this->ReadInteger(first) : 0;
  const std::int64_t bytes = FaceBytes + Word * size;
  if (size < 3 || count > this->Scanner.GetBytesLeft() / bytes || count > INT32_MAX / size)
  {
    return false;
  }
  this->CommonSize = static_cast<std::int32_t>(size);
  const vtkIdType blocks = (count + BlockSize - 1) / BlockSize;
  std::atomic<bool> areAlike{ true };
  if (!guesses || count * bytes != this->Scanner.GetBytesLeft())
  {
    const bool isComplete = progress.For(blocks,
      [&](vtkIdType begin, vtkIdType end)
      {
        if (!this->ArePlainFacesAlike(begin * BlockSize, std::min(end * BlockSize, count)))
        {
          areAlike = false;
        }
      });
    if (!isComplete || !areAlike)
    {
      return false;
    }
  }
  for (vtkIdType block = 0; block < blocks; ++block)
  {
    const vtkIdType face = block * BlockSize;
    this->Blocks.push_back({ first + face * bytes, face, face * size });
  }
  this->AreAlike = true;
  this->NumberOfCells = count;
  this->NumberOfIds = count * size;
  this->Scanner.Skip(count * bytes, "the faces");
  return true;
}

//------------------------------------------------------------------------------
// Goes from face to face, to know where threads start and how much there is to store.
bool BinaryReading::FindFaces(bool guesses, const Progress& progress)
{
  this->FirstFace = this->FirstFace ? this->FirstFace : this->Scanner.GetPosition();
  this->Scanner.SetPosition(this->FirstFace);
  this->Blocks.clear();
  this->AreAlike = this->HasFaceColors = false;
  this->NumberOfCells = this->NumberOfIds = 0;
  if (this->FindFacesOfOneSize(guesses, progress))
  {
    return true;
  }
  const vtkIdType count = this->Header.Faces;
  this->Offsets = Buffer<std::int32_t>(guesses ? count + 1 : 0);
  std::int32_t* const offsets = guesses ? this->Offsets.data() : nullptr;
  std::int32_t commonSize = -1;
  vtkIdType cells = 0, ids = 0;
  const char* place = this->FirstFace;
  const char* const end = place + this->Scanner.GetBytesLeft();
  for (vtkIdType face = 0; face < count; ++face)
  {
    if (face % BlockSize == 0)
    {
      this->Blocks.push_back({ place, cells, ids });
      if (!progress.Report(static_cast<double>(face) / count))
      {
        return false;
      }
    }
    std::int32_t size = end - place >= FaceBytes ? this->ReadInteger(place) : -1;
    std::int32_t components = -1;
    if (size >= 0 && size <= (end - place - FaceBytes) / Word)
    {
      components = this->ReadInteger(place + Word + Word * std::ptrdiff_t(size));
    }
    if (components != 0)
    {
      this->Scanner.SetPosition(place);
      if (!this->Scanner.ReadCount(size, Word, "the number of vertices of a face") ||
        !this->Scanner.Skip(Word * std::int64_t(size), "the vertices of a face") ||
        !this->Scanner.ReadCount(
          components, Word, "the number of components of the colour of a face") ||
        !this->Scanner.Skip(Word * std::int64_t(components), "the colour of a face"))
      {
        return false;
      }
    }
    place += FaceBytes + Word * (std::ptrdiff_t(size) + components);
    if (offsets)
    {
      offsets[face] = static_cast<std::int32_t>(ids);
    }
    commonSize = commonSize == -1 || commonSize == size ? size : 0;
    this->HasFaceColors = this->HasFaceColors || components > 0;
    cells += size > 0 ? 1 : 0;
    ids += size;
  }
  this->Scanner.SetPosition(place);
  this->CommonSize = commonSize;
  this->NumberOfCells = cells;
  this->NumberOfIds = ids;
  if (offsets && cells == count && !this->HasFaceColors)
  {
    offsets[count] = static_cast<std::int32_t>(ids);
  }
  else
  {
    this->Offsets = Buffer<std::int32_t>();
  }
  if (this->NumberOfIds > std::numeric_limits<std::int32_t>::max())
  {
    this->Scanner.FailAt(this->Scanner.GetPosition(), ErrorKind::Unsupported,
      "fewer than 2147483648 vertices of all faces together", std::to_string(this->NumberOfIds));
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
// Real numbers from 0 to 1, or an index, of which it is not known whether programs write it as
// real.
OFFColor BinaryReading::ReadColor(const char* place, std::int32_t count) const
{
  OFFColor color;
  color.Count = count <= 4 ? count : 0;
  color.IsReal = count > 1;
  for (int c = 0; c < color.Count; ++c)
  {
    color.Values[c] = this->ReadReal(place + Word * c);
  }
  // Small integers are tiny real numbers, which nobody means.
  if (count == 1 && !(std::fabs(color.Values[0]) >= std::numeric_limits<float>::min()))
  {
    color.Values[0] = this->ReadInteger(place);
  }
  return color;
}

//------------------------------------------------------------------------------
// Reads a face; false if an id is out of range, or if the face is not as large as it was.
bool BinaryReading::ReadFace(const char*& place, vtkIdType face, vtkIdType room,
  std::int32_t* ids, std::int32_t& size, OFFColor& color, OFFFaceCensus& seen) const
{
  const char* const end = this->Scanner.GetPosition();
  size = end - place < FaceBytes ? -1 : this->ReadInteger(place);
  if (size < 0 || size > room || size > (end - place - FaceBytes) / Word)
  {
    place = end;
    return false;
  }
  place += Word;
  const auto limit = static_cast<std::uint32_t>(this->Header.Vertices);
  bool isGood = true;
  for (std::int32_t i = 0; i < size; ++i, place += Word)
  {
    ids[i] = this->ReadInteger(place);
    isGood = isGood && static_cast<std::uint32_t>(ids[i]) < limit;
  }
  const std::int32_t components = this->ReadInteger(place);
  place += Word;
  if (components > (end - place) / Word)
  {
    place = end;
    return false;
  }
  color = OFFColor();
  if (components > 0)
  {
    color = this->ReadColor(place, components);
    if (!seen.Colors.Add(color) || color.Count == 0)
    {
      seen.WithOddColor.Add(face);
    }
    if (!color.IsInRange())
    {
      seen.OutOfRange.Add(face);
    }
    place += Word * std::ptrdiff_t(components);
  }
  seen.AddSize(face, size);
  return isGood;
}

//------------------------------------------------------------------------------
// Reads the ids of faces that are alike; false if one is out of range.
bool BinaryReading::ReadAlikeFaces(const char* place, vtkIdType faces, std::int32_t* ids) const
{
  ListRows rows;
  rows.Begin = place + Word;
  rows.Rest = FaceBytes;
  rows.Swap = this->Scanner.IsSwapped();
  rows.Size = this->CommonSize;
  rows.Copy(0, faces, ids);
  return AreIds(ids, rows.GetNumberOfIds(0, faces), this->Header.Vertices);
}

//------------------------------------------------------------------------------
// Calls take(block, cell, first id of all, ids, size, color) for all faces that are cells, in
// parallel. Their ids are stored, or read to where they are overwritten by those of the next block.
template <typename Take>
bool BinaryReading::ForEachFace(bool store, const Progress& progress, Take&& take)
{
  const auto blocks = static_cast<vtkIdType>(this->Blocks.size());
  std::vector<OFFFaceCensus> seen(blocks);
  std::vector<vtkIdType> badFaces(blocks, -1);
  std::vector<const char*> badPlaces(blocks, nullptr);
  const bool isComplete = progress.For(blocks,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<std::int32_t> scratch;
      for (vtkIdType b = begin; b < end; ++b)
      {
        const bool isLast = b + 1 == blocks;
        const char* place = this->Blocks[b].Place;
        vtkIdType cell = this->Blocks[b].Cell, id = this->Blocks[b].Id;
        const vtkIdType lastCell = isLast ? this->NumberOfCells : this->Blocks[b + 1].Cell;
        const vtkIdType lastId = isLast ? this->NumberOfIds : this->Blocks[b + 1].Id;
        scratch.resize(static_cast<std::size_t>(store ? 0 : lastId - id));
        std::int32_t* ids = store ? this->Faces.Mesh.Connectivity.data() + id : scratch.data();
        const vtkIdType last = std::min((b + 1) * BlockSize, vtkIdType(this->Header.Faces));
        vtkIdType face = b * BlockSize;
        if (this->AreAlike && this->ReadAlikeFaces(place, last - face, ids))
        {
          for (; face < last; ++face, ++cell, id += this->CommonSize, ids += this->CommonSize)
          {
            take(b, cell, id, ids, this->CommonSize, OFFColor());
          }
        }
        for (; face < last; ++face)
        {
          const char* const start = place;
          std::int32_t size;
          OFFColor color;
          if (!this->ReadFace(place, face, lastId - id, ids, size, color, seen[b]) ||
            (size > 0 && cell == lastCell))
          {
            badFaces[b] = face;
            badPlaces[b] = start;
            break;
          }
          if (size > 0)
          {
            take(b, cell, id, ids, size, color);
            ++cell;
            id += size;
            ids += size;
          }
        }
      }
    });
  this->FaceCensus = OFFFaceCensus();
  for (vtkIdType b = 0; b < blocks && isComplete; ++b)
  {
    this->FaceCensus.Merge(seen[b]);
    if (badFaces[b] >= 0)
    {
      this->FailAtFace(badFaces[b], badPlaces[b] + Word);
      return false;
    }
  }
  return isComplete;
}

//------------------------------------------------------------------------------
void BinaryReading::FailAtFace(vtkIdType face, const char* place)
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
// Reads faces whose places are known; false if anything is wrong with one.
bool BinaryReading::ReadPlainFaces(const Progress& progress)
{
  CellMesh& mesh = this->Faces.Mesh;
  const vtkIdType count = this->Header.Faces;
  mesh.NumberOfPoints = this->Header.Vertices;
  mesh.NumberOfCells = count;
  mesh.CommonSize = std::max(this->CommonSize, 0);
  mesh.CommonType = OFFFaces::GetType(mesh.CommonSize);
  mesh.Offsets = std::move(this->Offsets);
  mesh.Types = Buffer<unsigned char>(mesh.Offsets.size() > 0 ? count : 0);
  mesh.Connectivity = Buffer<std::int32_t>(this->NumberOfIds);
  const std::int32_t* const offsets = mesh.Offsets.data();
  ListRows rows;
  rows.Begin = this->FirstFace + Word;
  rows.Rest = FaceBytes;
  rows.Swap = this->Scanner.IsSwapped();
  rows.Size = this->CommonSize;
  rows.Offsets = offsets;
  Tally repeating;
  std::mutex mutex;
  std::atomic<bool> isGood{ true };
  const bool isComplete = progress.For(static_cast<vtkIdType>(this->Blocks.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      OFFFaceCensus seen;
      Tally repeatingHere;
      for (vtkIdType first = begin * BlockSize; first < std::min(end * BlockSize, count) && isGood;
           first += BlockSize)
      {
        const vtkIdType last = std::min(first + BlockSize, count);
        std::int32_t* const ids = mesh.Connectivity.data() + rows.GetNumberOfIds(0, first);
        rows.Copy(first, last, ids);
        if (!AreIds(ids, rows.GetNumberOfIds(first, last), this->Header.Vertices) ||
          (this->AreAlike && !this->ArePlainFacesAlike(first, last)))
        {
          isGood = false;
          break;
        }
        FindRepeatedPoints(ids, offsets ? offsets + first : nullptr, this->CommonSize, first,
          last - first, repeatingHere);
        for (vtkIdType face = first; offsets && face < last; ++face)
        {
          const std::int32_t size = offsets[face + 1] - offsets[face];
          mesh.Types[face] = OFFFaces::GetType(size);
          seen.AddSize(face, size);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      repeating.Merge(repeatingHere);
      this->FaceCensus.Merge(seen);
    });
  mesh.Repeating = repeating;
  return isComplete && isGood;
}

//------------------------------------------------------------------------------
bool BinaryReading::ReadFaces(const Progress& progress)
{
  if (this->Header.Faces == 0)
  {
    this->Faces.Mesh = MakeCloud(this->Header.Vertices);
    return true;
  }
  if (this->AreAlike || this->Offsets.size() > 0)
  {
    if (this->ReadPlainFaces(progress))
    {
      return true;
    }
    // Faces are not as they were taken to be, or have wrong ids: each is looked at.
    this->Faces = OFFFaces();
    this->FaceCensus = OFFFaceCensus();
    if (progress.IsStopped() || !this->FindFaces(false, progress))
    {
      return false;
    }
  }
  this->Faces.Allocate(
    this->NumberOfCells, this->NumberOfIds, std::max(this->CommonSize, 0), this->HasFaceColors);
  this->Faces.Mesh.NumberOfPoints = this->Header.Vertices;
  return this->ForEachFace(true, progress,
    [this](vtkIdType, vtkIdType cell, vtkIdType id, const std::int32_t*, std::int32_t size,
      const OFFColor& color)
    {
      if (this->HasFaceColors)
      {
        this->Faces.Colors.Set(cell, color);
      }
      if (this->Faces.Mesh.CommonSize == 0)
      {
        this->Faces.Begin(cell, id, size);
      }
    });
}

//------------------------------------------------------------------------------
// Keeps the faces of a piece only: goes through all of them once more for every level of ghosts, and
// again to store them.
bool BinaryReading::ReadPieceOfFaces(
  const PieceRequest& request, CellPiece& piece, const Progress& progress)
{
  piece.Start(this->Header.Vertices, this->NumberOfCells, request);
  do
  {
    if (!this->ForEachFace(false, progress.Part(0, 0.7),
          [&](vtkIdType, vtkIdType cell, vtkIdType, const std::int32_t* ids, std::int32_t size,
            const OFFColor&) { piece.Show(cell, ids, size); }))
    {
      return false;
    }
  } while (piece.Continue());
  this->Faces.AreOfPiece = true;
  this->Faces.Colors = OFFColors(this->HasFaceColors ? piece.GetNumberOfCells() : 0);
  std::vector<CellSink> sinks(this->Blocks.size());
  ScanError error;
  if (!this->ForEachFace(false, progress.Part(0.7, 1),
        [&](vtkIdType block, vtkIdType cell, vtkIdType, const std::int32_t* ids,
          std::int32_t size, const OFFColor& color)
        {
          const vtkIdType index = piece.FindCell(cell);
          if (index < 0)
          {
            return;
          }
          CellSink& sink = sinks[static_cast<std::size_t>(block)];
          sink.BeginCell(OFFFaces::GetType(size));
          for (std::int32_t i = 0; i < size; ++i)
          {
            sink.AddPoint(static_cast<std::int32_t>(piece.FindPoint(ids[i])));
          }
          if (this->HasFaceColors)
          {
            this->Faces.Colors.Set(index, color);
          }
        }) ||
    !FillCells(sinks, this->Faces.Mesh, error))
  {
    return false;
  }
  this->Faces.Mesh.NumberOfPoints = piece.GetNumberOfPoints();
  return true;
}

//------------------------------------------------------------------------------
bool BinaryReading::ReadVertices(
  const CellPiece& piece, OFFVertices<float>& vertices, const Progress& progress)
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
  return progress.For((count + BlockSize - 1) / BlockSize,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType vertex = begin * BlockSize; vertex < std::min(end * BlockSize, count);
           ++vertex)
      {
        if (const vtkIdType point = piece.FindPoint(vertex); point >= 0)
        {
          read(vertex, point);
        }
      }
    });
}

//------------------------------------------------------------------------------
// After the header, for faces that do not say of how many numbers their colour is: the bytes from
// begin on with a 0 behind each face. Empty if such faces, with good ids, do not just fill the
// file.
std::string BinaryReading::AddColorSizes(const char* begin) const
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

//------------------------------------------------------------------------------
// Reads what comes after the counts; false with the error in the scanner, or if stopped.
bool ReadMesh(BinaryReading& reading, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, const Progress& progress)
{
  CellPiece piece;
  const bool isGood = reading.FindFaces(request.NumberOfPieces <= 1, progress.Part(0, 0.3)) &&
    (request.NumberOfPieces > 1 && reading.Header.Faces > 0
        ? reading.ReadPieceOfFaces(request, piece, progress.Part(0.3, 0.65))
        : reading.ReadFaces(progress.Part(0.3, 0.6)) &&
          piece.Select(reading.Faces.Mesh, request, progress.Part(0.6, 0.65)));
  if (!isGood)
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
  FillOFFGrid(reading.Header, reading.Faces, reading.FaceCensus, vertices, reading.VertexCensus,
    piece, request, grid, warnings, progress.Part(0.9, 1));
  return !progress.IsStopped();
}
}

//------------------------------------------------------------------------------
bool ReadBinaryOFF(const MappedFile& file, const char* body, const OFFHeader& keyword,
  const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings, ScanError& error,
  const Progress& progress)
{
  grid->Initialize();
  const auto start = [&](const char* begin, const char* end, ByteOrder order)
  {
    BinaryScanner scanner(file.GetName(), begin, end, order);
    scanner.SetPosition(begin + (body - file.begin()));
    return BinaryReading(scanner, keyword);
  };
  const auto warn = [&](const char* message)
  {
    if (request.Piece == 0)
    {
      warnings.Add(message);
    }
  };
  constexpr char IsLittle[] = "the file is little endian, though OFF files are big endian";
  BinaryReading reading = start(file.begin(), file.end(), ByteOrder::Big);
  bool hasHeader = reading.ReadHeader();
  if (!hasHeader)
  {
    BinaryReading little = start(file.begin(), file.end(), ByteOrder::Little);
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
    BinaryReading plain = start(file.begin(), file.end(), order);
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
    warn("the faces lack the number of components of their colour, as pmp-library writes them");
    BinaryReading completed = start(bytes.data(), bytes.data() + bytes.size(), order);
    const bool isGood =
      completed.ReadHeader() && ReadMesh(completed, request, grid, warnings, progress);
    error = progress.IsStopped() ? ScanError() : completed.Scanner.GetError();
    return isGood;
  }
  return false;
}
}
