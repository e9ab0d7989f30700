// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The faces of binary OFF files.
#include "PolygonOFFBinaryReading.h"

#include "CellMesh/CellRows.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>

namespace camaron
{
//------------------------------------------------------------------------------
bool OFFBinaryReading::ArePlainFacesAlike(vtkIdType begin, vtkIdType end) const
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
// Assumes that all faces have the size of the first; false if they do not, or have colors. If such
// faces would exactly fill the file, this is likely, and the check may be left to reading them.
bool OFFBinaryReading::FindFacesOfOneSize(bool guesses, const Progress& progress)
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
    const bool isComplete = progress.ForBlocks(count, BlockSize,
      [&](vtkIdType begin, vtkIdType end)
      {
        if (!this->ArePlainFacesAlike(begin, end))
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
// Visits all faces, to find out where threads start and how much to store.
bool OFFBinaryReading::FindFaces(bool guesses, const Progress& progress)
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
          components, Word, "the number of components of the color of a face") ||
        !this->Scanner.Skip(Word * std::int64_t(components), "the color of a face"))
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
    return this->Scanner.FailAt(this->Scanner.GetPosition(), ErrorKind::Unsupported,
      "fewer than 2147483648 vertices of all faces together", std::to_string(this->NumberOfIds));
  }
  return true;
}

//------------------------------------------------------------------------------
// Reads a face; false if an id is out of range, or if the size of the face has changed.
bool OFFBinaryReading::ReadFace(const char*& place, vtkIdType face, vtkIdType room,
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
// The vertices of plain faces, the first of which is at a position.
ListRows OFFBinaryReading::GetFaceLists(const char* place, const std::int32_t* offsets) const
{
  ListRows rows;
  rows.Begin = place + Word;
  rows.Rest = FaceBytes;
  rows.Swap = this->Scanner.IsSwapped();
  rows.Size = this->CommonSize;
  rows.Offsets = offsets;
  return rows;
}

//------------------------------------------------------------------------------
// Reads the ids of faces of one size; false if one is out of range.
bool OFFBinaryReading::ReadAlikeFaces(const char* place, vtkIdType faces, std::int32_t* ids) const
{
  const ListRows rows = this->GetFaceLists(place, nullptr);
  rows.Copy(0, faces, ids);
  return AreIds(ids, rows.GetNumberOfIds(0, faces), this->Header.Vertices);
}

//------------------------------------------------------------------------------
// Calls take(block, cell, first id of all, ids, size, color) for all faces that become cells, in
// parallel. Their ids are stored, or read into a buffer that the next block overwrites.
template <typename Take>
bool OFFBinaryReading::ForEachFace(bool store, const Progress& progress, Take&& take)
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
void OFFBinaryReading::FailAtFace(vtkIdType face, const char* place)
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
// Reads faces at known positions; false if any is invalid.
bool OFFBinaryReading::ReadPlainFaces(const Progress& progress)
{
  CellMesh& mesh = this->Faces.Mesh;
  const vtkIdType count = this->Header.Faces;
  mesh.NumberOfPoints = this->Header.Vertices;
  mesh.NumberOfCells = count;
  mesh.CommonSize = std::max(this->CommonSize, 0);
  mesh.CommonType = GetPolygonType(mesh.CommonSize);
  mesh.Offsets = std::move(this->Offsets);
  mesh.Types = Buffer<unsigned char>(mesh.Offsets.size() > 0 ? count : 0);
  mesh.Connectivity = Buffer<std::int32_t>(this->NumberOfIds);
  const std::int32_t* const offsets = mesh.Offsets.data();
  const ListRows rows = this->GetFaceLists(this->FirstFace, offsets);
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
          mesh.Types[face] = GetPolygonType(size);
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
bool OFFBinaryReading::ReadFaces(const Progress& progress)
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
    // Faces differ from the assumption, or have invalid ids: each is checked.
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
// Keeps only the faces of a piece: reads all once more for every level of ghosts, and again to
// store them.
bool OFFBinaryReading::ReadPieceOfFaces(
  const PieceRequest& request, CellMeshPiece& piece, const Progress& progress)
{
  if (!piece.Find(this->Header.Vertices, this->NumberOfCells, request,
        [&]
        {
          return this->ForEachFace(false, progress.Part(0, 0.7),
            [&](vtkIdType, vtkIdType cell, vtkIdType, const std::int32_t* ids, std::int32_t size,
              const OFFColor&) { piece.Visit(cell, ids, size); });
        }))
  {
    return false;
  }
  this->Faces.Colors = OFFColors(this->HasFaceColors ? piece.GetNumberOfCells() : 0);
  std::vector<CellSink> sinks(this->Blocks.size());
  if (!this->ForEachFace(false, progress.Part(0.7, 1),
        [&](vtkIdType block, vtkIdType cell, vtkIdType, const std::int32_t* ids, std::int32_t size,
          const OFFColor& color)
        {
          const vtkIdType index = piece.FindCell(cell);
          if (index < 0)
          {
            return;
          }
          CellSink& sink = sinks[static_cast<std::size_t>(block)];
          sink.BeginCell(GetPolygonType(size));
          for (std::int32_t i = 0; i < size; ++i)
          {
            sink.AddPoint(static_cast<std::int32_t>(piece.FindPoint(ids[i])));
          }
          if (this->HasFaceColors)
          {
            this->Faces.Colors.Set(index, color);
          }
        }) ||
    !FillCells(sinks, this->Faces.Mesh, this->Scanner))
  {
    return false;
  }
  this->Faces.Mesh.NumberOfPoints = piece.GetNumberOfPoints();
  return true;
}
}
