// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The faces of OFF files in text.
#include "PolygonOFFFaces.h"
#include "PolygonOFFText.h"

#include <algorithm>

namespace camaron
{
namespace
{
constexpr char Size[] = "the number of vertices of a face";
constexpr std::int64_t IdBytes = 2; // a blank and a digit

//------------------------------------------------------------------------------
// Reads a face after its size: its vertices, and the words after them.
bool ReadFace(TextRow& text, std::int64_t size, std::int64_t vertices, OFFFace& face)
{
  constexpr std::int64_t usual = 8; // the text may end long before the size of the face
  face.Points.resize(static_cast<std::size_t>(std::min(size, usual)));
  for (std::int64_t i = 0; i < size; ++i)
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
}
