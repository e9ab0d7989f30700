// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The faces of binary OFF files.
#include "PolygonOFFBinaryReading.h"
#include "PolygonOFFFaces.h"

#include <algorithm>
#include <atomic>

namespace camaron
{
//------------------------------------------------------------------------------
// Visits all faces, to find out where threads start.
bool OFFBinaryReading::FindFaces(const Progress& progress)
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
    cells += size > 0 ? 1 : 0;
  }
  this->Scanner.SetPosition(place);
  return true;
}

//------------------------------------------------------------------------------
// Reads a face; false if an id is out of range, or if the file has changed.
bool OFFBinaryReading::ReadFace(const char*& place, OFFFace& face) const
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
  const std::int32_t components = this->ReadInteger(place);
  place += Word;
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
bool OFFBinaryReading::ReadFaces(
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
}
