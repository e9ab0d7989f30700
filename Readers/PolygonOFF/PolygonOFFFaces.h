// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonOFFFaces.h
 * @brief Collects the faces of an OFF file, or only those of a piece, however they are stored.
 */
#ifndef camaron_PolygonOFFFaces_h
#define camaron_PolygonOFFFaces_h

#include "Intake/CellMesh/CellRows.h"
#include "PolygonOFFMesh.h"

#include <algorithm> // for copies
#include <limits>    // for 32-bit offsets

namespace camaron
{
/// A face of a file; a thread reads one after the other into the same.
struct OFFFace
{
  vtkIdType Row = 0;
  vtkIdType Cell = 0; ///< at most the row; faces without vertices become no cells
  std::vector<std::int32_t> Points;
  OFFColor Color;
  bool HasOddColor = false; ///< whether there are data after the vertices that are not a color

  /// Whether the census counts it.
  bool IsUnusual() const
  {
    return this->Points.size() <= 2 || this->Color.Count > 0 || this->HasOddColor;
  }
  void AddTo(OFFCensus& census) const
  {
    if (this->Points.size() <= 2)
    {
      constexpr OFFOddity few[] = { OFFOddity::FaceWithoutVertices, OFFOddity::FaceOfOneVertex,
        OFFOddity::FaceOfTwoVertices };
      census.Add(few[this->Points.size()], this->Row);
    }
    census.AddFace(this->Row, this->Color, this->HasOddColor);
  }
};

/// The faces of one part of a file; in a cache line of its own, as it changes with every face.
struct alignas(64) OFFFacePart
{
  OFFFace Face;
  OFFCensus Census;
  CellSink Cells;
  OFFColors Colors;
};

/// Reads the faces of a whole mesh if all have a number of vertices, at least 3, and none a color;
/// see CollectFaces.
template <typename ForEach>
bool CollectFacesOfOneSize(
  OFFMesh& mesh, std::int32_t size, std::size_t parts, const Progress& progress, ForEach&& forEach)
{
  const OFFHeader& header = mesh.Header;
  if (size < 3 || header.Faces > std::numeric_limits<std::int32_t>::max() / size)
  {
    return false;
  }
  std::vector<OFFFacePart> collected(parts);
  mesh.Faces = CellMesh(header.Vertices, header.Faces, GetPolygonType(size), size);
  std::int32_t* const ids = mesh.Faces.Connectivity.data();
  const bool isGood = forEach(progress, collected,
    [=](const OFFFacePart& part)
    {
      const OFFFace& face = part.Face;
      const bool isUsual =
        static_cast<std::int32_t>(face.Points.size()) == size && !face.IsUnusual();
      if (isUsual)
      {
        std::copy(face.Points.begin(), face.Points.end(), ids + face.Row * size);
      }
      return isUsual;
    });
  mesh.Faces = isGood ? std::move(mesh.Faces) : CellMesh();
  return isGood;
}

/**
 * Fills the faces of a mesh with those of a piece, which is found first.
 * @param size probable number of vertices of all faces, for which there must be room in the file
 * @param parts number of parts of the file
 * @param forEach passes all faces: forEach(progress, parts, take) reads each into the face of its
 * part, and calls take(part), which returns false to end this. The parts are visited in parallel,
 * each in order. False if ended, if stopped, or with the error in the scanner.
 */
template <typename Scanner, typename ForEach>
bool CollectFaces(OFFMesh& mesh, std::int32_t size, std::size_t parts, const PieceRequest& request,
  CellMeshPiece& piece, Scanner& scanner, const Progress& progress, ForEach&& forEach)
{
  if (request.NumberOfPieces <= 1 &&
    CollectFacesOfOneSize(mesh, size, parts, progress.Part(0, 0.9), forEach))
  {
    piece.Start(mesh.Header.Vertices, mesh.Header.Faces, request);
    return true;
  }
  std::vector<OFFFacePart> collected(parts);
  bool isFirst = true;
  const auto pass = [&](const Progress& share, auto&& take)
  {
    const bool isGood = forEach(share, collected,
      [&, counts = isFirst](OFFFacePart& part)
      {
        if (counts && part.Face.IsUnusual())
        {
          part.Face.AddTo(part.Census);
        }
        if (!part.Face.Points.empty())
        {
          take(part, static_cast<vtkIdType>(part.Face.Points.size()));
        }
        return true;
      });
    isFirst = false;
    return isGood;
  };
  if (!piece.Find(mesh.Header.Vertices, mesh.Header.Faces, request,
        [&]
        {
          return pass(progress.Part(isFirst ? 0 : 0.4, isFirst ? 0.4 : 0.7),
            [&](OFFFacePart& part, vtkIdType count)
            { piece.Visit(part.Face.Cell, part.Face.Points.data(), count); });
        }) ||
    !pass(progress.Part(isFirst ? 0 : 0.7, 1),
      [&](OFFFacePart& part, vtkIdType count)
      {
        if (piece.FindCell(part.Face.Cell) < 0)
        {
          return;
        }
        if (!piece.IsWhole())
        {
          for (std::int32_t& point : part.Face.Points)
          {
            point = static_cast<std::int32_t>(piece.FindPoint(point));
          }
        }
        part.Colors.Append(part.Cells.GetNumberOfCells(), part.Face.Color);
        part.Cells.AddCell(GetPolygonType(count), part.Face.Points);
      }))
  {
    return false;
  }

  std::vector<CellSink> sinks;
  vtkIdType cells = 0;
  for (const OFFFacePart& part : collected)
  {
    mesh.FaceCensus.Merge(part.Census);
    cells += part.Cells.GetNumberOfCells();
  }
  // Faces of other pieces count, too.
  const bool haveColors = mesh.FaceCensus.Colors.HasColors || mesh.FaceCensus.Colors.HasIndices;
  mesh.FaceColors = OFFColors(haveColors ? cells : 0);
  cells = 0;
  for (OFFFacePart& part : collected)
  {
    if (haveColors)
    {
      mesh.FaceColors.Put(cells, part.Colors);
    }
    cells += part.Cells.GetNumberOfCells();
    sinks.push_back(std::move(part.Cells));
  }
  mesh.Faces.NumberOfPoints = piece.GetNumberOfPoints();
  return FillCells(sinks, mesh.Faces, scanner) &&
    (piece.IsWhole() || cells == piece.GetNumberOfCells());
}
}

#endif
