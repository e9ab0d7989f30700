// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonOFFText.h"

#include "CellMesh/CellRows.h"

#include <limits>

namespace camaron
{
namespace
{
constexpr char Size[] = "the number of vertices of a face";
constexpr char Id[] = "a vertex of a face";
constexpr std::int64_t IdBytes = 2; // a blank and a digit
constexpr std::int64_t MaxIds = std::numeric_limits<std::int32_t>::max();
}

//------------------------------------------------------------------------------
// The faces of one thread; in a cache line of its own, as it changes with every face.
struct alignas(64) OFFTextReading::FacePart
{
  vtkIdType Cell = 0; // of the next face
  vtkIdType Id = 0;   // of its first vertex
  bool HasOtherSize = false;
  bool HasColor = false;
  OFFFaceCensus Census;
  std::vector<std::int32_t> Ids; // of a face that may not be kept
};

//------------------------------------------------------------------------------
// Reads the words after the vertices of a face.
OFFColor OFFTextReading::ReadFaceColor(vtkIdType row, TextRow& text, FacePart& part)
{
  constexpr int MaxColor = 4;
  const OFFRest rest(text);
  const bool isColor = !rest.Odd && rest.Count <= MaxColor;
  OFFColor color = rest.GetColor(isColor ? rest.Count : 0);
  if (!part.Census.Colors.Add(color) || !isColor)
  {
    part.Census.WithOddColor.Add(row);
    color.Count = 0;
  }
  if (!color.IsInRange())
  {
    part.Census.OutOfRange.Add(row);
  }
  return color;
}

//------------------------------------------------------------------------------
// Reads a face after its size, and stores or only checks it.
bool OFFTextReading::ReadFace(
  vtkIdType row, TextRow& text, std::int64_t size, FacePart& part, bool store)
{
  const CellMesh& mesh = this->Faces.Mesh;
  if (store &&
    (size > mesh.Connectivity.size() - part.Id || (size > 0 && part.Cell >= mesh.NumberOfCells)))
  {
    return false; // the file has changed since faces were counted
  }
  std::int32_t* const ids = store ? this->Faces.Mesh.Connectivity.data() + part.Id : nullptr;
  const std::int64_t last = this->Header.Vertices - 1;
  for (std::int64_t i = 0; i < size; ++i)
  {
    std::int32_t id;
    if (!text.ReadId(id, 0, last, Id))
    {
      return false;
    }
    if (store)
    {
      ids[i] = id;
    }
  }
  part.Census.AddSize(row, size);
  const bool storesColor = store && this->Faces.Colors.size() > 0;
  const bool hasColor = text.HasMore();
  part.HasColor = part.HasColor || hasColor;
  if (hasColor && store && !storesColor)
  {
    return false; // not allocated yet
  }
  if (hasColor || storesColor)
  {
    const OFFColor color = this->ReadFaceColor(row, text, part);
    if (storesColor && size > 0)
    {
      this->Faces.Colors.Set(part.Cell, color);
    }
  }
  if (size == 0)
  {
    return true;
  }
  if (store && this->Faces.Mesh.CommonSize == 0)
  {
    this->Faces.Begin(part.Cell, part.Id, size);
  }
  ++part.Cell;
  part.Id += size;
  return true;
}

//------------------------------------------------------------------------------
// Reads only the sizes of all faces, to find out where each thread stores its own.
bool OFFTextReading::CountFaces(const TextLines& lines, const TextLines::Section& section,
  std::vector<FacePart>& parts, const Progress& progress) const
{
  return lines.ForEach(section, progress,
    [&](vtkIdType part, vtkIdType, const char* text, const char* end)
    {
      std::int64_t size;
      const char* const next = ParseInteger(text, end, size);
      if (!next || size < 0 || size > (end - next) / IdBytes)
      {
        return false;
      }
      parts[part].Cell += size > 0 ? 1 : 0;
      parts[part].Id += size;
      return true;
    });
}

//------------------------------------------------------------------------------
// For faces of one line each. If all look like the first face, they need not be counted.
bool OFFTextReading::ReadFacesInParallel(
  TextScanner& scanner, const TextLines& lines, const Progress& progress)
{
  const vtkIdType count = this->Header.Faces;
  const TextLines::Section section = lines.Find(scanner.GetPosition(), count);
  if (!section)
  {
    return false;
  }
  FacePart first;
  std::int64_t commonSize;
  {
    TextScanner look = scanner;
    TextRow row(look);
    if (!look.ReadCount(commonSize, IdBytes, Size) ||
      !this->ReadFace(0, row, commonSize, first, false))
    {
      return false;
    }
  }
  const std::int64_t lineBytes = IdBytes * (commonSize + 1);
  bool isCommon = commonSize > 0 && count <= (section.End - section.Begin + 1) / lineBytes &&
    count * commonSize <= MaxIds;
  bool hasColors = first.HasColor;

  std::vector<FacePart> parts;
  for (int attempt = 0;; ++attempt)
  {
    const Progress part = attempt == 0 ? progress : progress.Part(1, 1);
    parts.assign(lines.GetNumberOfPieces(section), FacePart());
    vtkIdType cells = count, ids = count * commonSize;
    if (!isCommon)
    {
      if (!this->CountFaces(lines, section, parts, part.Part(0, 0.2)))
      {
        return false;
      }
      cells = ids = 0;
      for (FacePart& place : parts)
      {
        std::swap(cells, place.Cell);
        std::swap(ids, place.Id);
        cells += place.Cell;
        ids += place.Id;
      }
      if (ids > MaxIds)
      {
        return false;
      }
    }
    this->Faces.Allocate(
      cells, ids, static_cast<std::int32_t>(isCommon ? commonSize : 0), hasColors);
    if (VisitRows(lines, section, scanner.GetComment(), part.Part(isCommon ? 0 : 0.2, 1),
          [&](vtkIdType row, vtkIdType piece, TextRow& text)
          {
            FacePart& place = parts[piece];
            std::int64_t size;
            if (!text.ReadInteger(size, Size) || size < 0)
            {
              return false;
            }
            if (isCommon)
            {
              place.HasOtherSize = size != commonSize;
              place.Cell = row;
              place.Id = row * commonSize;
            }
            return !place.HasOtherSize && this->ReadFace(row, text, size, place, true);
          }))
    {
      break;
    }
    const bool hadColors = hasColors, wasCommon = isCommon;
    for (const FacePart& place : parts)
    {
      hasColors = hasColors || place.HasColor;
      isCommon = isCommon && !place.HasOtherSize;
    }
    if (progress.IsStopped() || (hasColors == hadColors && isCommon == wasCommon))
    {
      return false;
    }
  }
  for (const FacePart& place : parts)
  {
    this->FaceCensus.Merge(place.Census);
  }
  scanner.SetPosition(section.End);
  return true;
}

//------------------------------------------------------------------------------
// Reads the size and the vertices of a face.
bool OFFTextReading::ReadIds(TextRow& text, FacePart& part) const
{
  std::int64_t size;
  if (!text.ReadInteger(size, Size) || size < 0)
  {
    return false;
  }
  part.Ids.clear();
  for (std::int32_t id; size > 0; --size)
  {
    if (!text.ReadId(id, 0, this->Header.Vertices - 1, Id))
    {
      return false;
    }
    part.Ids.push_back(id);
  }
  return true;
}

//------------------------------------------------------------------------------
// For faces of one line each, to keep those of a piece: all are read to find these, once more for
// every level of ghosts, and again to store them.
bool OFFTextReading::ReadPieceOfFaces(
  TextScanner& scanner, const TextLines& lines, CellMeshPiece& piece, const Progress& progress)
{
  const TextLines::Section section = lines.Find(scanner.GetPosition(), this->Header.Faces);
  if (!section)
  {
    return false;
  }
  std::vector<FacePart> parts(lines.GetNumberOfPieces(section));
  if (!this->CountFaces(lines, section, parts, progress.Part(0, 0.1)))
  {
    return false;
  }
  std::vector<vtkIdType> firstCells;
  vtkIdType cells = 0;
  for (const FacePart& part : parts)
  {
    firstCells.push_back(cells);
    cells += part.Cell;
  }
  // Calls take(part, row, index of the part, text) for all faces that become cells, after reading
  // their ids.
  const auto visit = [&](const Progress& share, auto&& take)
  {
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      parts[i].Cell = firstCells[i];
    }
    return VisitRows(lines, section, scanner.GetComment(), share,
      [&](vtkIdType row, vtkIdType i, TextRow& text)
      {
        FacePart& part = parts[i];
        if (!this->ReadIds(text, part))
        {
          return false;
        }
        take(part, row, i, text);
        part.Cell += part.Ids.empty() ? 0 : 1;
        return true;
      });
  };

  parts.assign(parts.size(), FacePart());
  bool isFirst = true;
  piece.Start(this->Header.Vertices, cells, this->Request);
  do
  {
    if (!visit(progress.Part(isFirst ? 0.1 : 0.4, isFirst ? 0.4 : 0.7),
          [&](FacePart& part, vtkIdType row, vtkIdType, TextRow& text)
          {
            const auto size = static_cast<vtkIdType>(part.Ids.size());
            if (isFirst)
            {
              part.Census.AddSize(row, size);
              if (text.HasMore())
              {
                part.HasColor = true;
                ReadFaceColor(row, text, part);
              }
            }
            if (size > 0)
            {
              piece.Visit(part.Cell, part.Ids.data(), size);
            }
          }))
    {
      return false;
    }
    isFirst = false;
  } while (piece.NextPass());
  if (!piece.IsFound())
  {
    return false;
  }

  bool hasColors = false;
  for (const FacePart& part : parts)
  {
    this->FaceCensus.Merge(part.Census);
    hasColors = hasColors || part.HasColor;
  }
  this->Faces.Colors = OFFColors(hasColors ? piece.GetNumberOfCells() : 0);
  std::vector<CellSink> sinks(parts.size());
  if (!visit(progress.Part(0.7, 1),
        [&](FacePart& part, vtkIdType row, vtkIdType i, TextRow& text)
        {
          const auto size = static_cast<vtkIdType>(part.Ids.size());
          const vtkIdType cell = size > 0 ? piece.FindCell(part.Cell) : -1;
          if (cell < 0)
          {
            text.Skip();
            return;
          }
          sinks[i].BeginCell(GetPolygonType(size));
          for (const std::int32_t id : part.Ids)
          {
            sinks[i].AddPoint(static_cast<std::int32_t>(piece.FindPoint(id)));
          }
          if (hasColors)
          {
            this->Faces.Colors.Set(cell, ReadFaceColor(row, text, part));
          }
        }))
  {
    return false;
  }
  ScanError error;
  if (!FillCells(sinks, this->Faces.Mesh, error) ||
    this->Faces.Mesh.NumberOfCells != piece.GetNumberOfCells())
  {
    return false;
  }
  this->Faces.Mesh.NumberOfPoints = piece.GetNumberOfPoints();
  scanner.SetPosition(section.End);
  return true;
}

//------------------------------------------------------------------------------
// For faces whose vertices may be on several lines: first checks and counts, then stores them.
bool OFFTextReading::ReadFacesInOrder(TextScanner& scanner, const Progress& progress)
{
  const vtkIdType count = this->Header.Faces;
  const TextScanner start = scanner;
  FacePart part;
  std::int64_t commonSize = -1;
  for (const bool store : { false, true })
  {
    if (store)
    {
      this->Faces.Allocate(part.Cell, part.Id,
        static_cast<std::int32_t>(commonSize > 0 ? commonSize : 0), part.HasColor);
      part = FacePart();
      scanner = start;
    }
    for (vtkIdType row = 0;
      row < count && progress.Report((store ? 0.5 : 0) + 0.5 * static_cast<double>(row) / count);
      ++row)
    {
      std::int64_t size;
      TextRow text(scanner);
      if (!scanner.ReadCount(size, IdBytes, Size) || !this->ReadFace(row, text, size, part, store))
      {
        return false;
      }
      if (part.Id > MaxIds)
      {
        return scanner.FailAt(scanner.GetPosition(), ErrorKind::Unsupported,
          "fewer than 2147483648 vertices of all faces together", "more");
      }
      commonSize = commonSize == -1 || commonSize == size ? size : 0;
      scanner.SkipLine();
    }
    if (progress.IsStopped())
    {
      return false;
    }
  }
  this->FaceCensus = part.Census;
  return true;
}

//------------------------------------------------------------------------------
bool OFFTextReading::ReadFaces(
  TextScanner& scanner, const TextLines* lines, const Progress& progress)
{
  if (this->Header.Faces == 0)
  {
    this->Faces.Mesh = MakeCloud(this->Header.Vertices);
    return true;
  }
  if (!(lines ? this->ReadFacesInParallel(scanner, *lines, progress)
              : this->ReadFacesInOrder(scanner, progress)))
  {
    return false;
  }
  this->Faces.Mesh.NumberOfPoints = this->Header.Vertices;
  return true;
}
}
