// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonOFFMesh.h
 * @brief Common part of reading text and binary OFF files, after their numbers have been read.
 */
#ifndef camaron_PolygonOFFMesh_h
#define camaron_PolygonOFFMesh_h

#include "Intake/CellMesh/CellMeshPiece.h"
#include "Intake/Pieces/PieceRequest.h"
#include "Mesh/CellShape.h"
#include "PolygonOFFColors.h"
#include "PolygonOFFHeader.h"

class vtkUnstructuredGrid;

namespace camaron
{
class MappedFile;
class TextLines;

/// What the reader warns about, in the order of the warnings.
enum class OFFOddity
{
  VertexWithMore, ///< numbers than the keyword declares
  VertexWithoutColor,
  VertexOutOfRange, ///< a color
  FaceOutOfRange,   ///< a color
  FaceWithoutVertices,
  FaceOfOneVertex,
  FaceOfTwoVertices,
  FaceWithOddColor
};
constexpr int NumberOfOFFOddities = static_cast<int>(OFFOddity::FaceWithOddColor) + 1;
/// Of faces with 0, 1 and 2 vertices.
constexpr OFFOddity FewVertices[] = { OFFOddity::FaceWithoutVertices, OFFOddity::FaceOfOneVertex,
  OFFOddity::FaceOfTwoVertices };

/// Data for warnings about vertices or faces; each thread has its own.
struct OFFCensus
{
  OFFColors::Census Colors;
  Tally Oddities[NumberOfOFFOddities];

  void Add(OFFOddity oddity, vtkIdType row) { this->Oddities[static_cast<int>(oddity)].Add(row); }
  void Add(OFFOddity oddity, const Tally& rows)
  {
    this->Oddities[static_cast<int>(oddity)].Merge(rows);
  }
  /// @param isOdd whether there are data after the vertices that are not a color
  void AddFace(vtkIdType row, const OFFColor& color, bool isOdd);
  void Merge(const OFFCensus& other);
};

/// The numbers of a vertex, as far as they are kept.
struct OFFVertex
{
  double Position[3];
  double Last; ///< coordinate, the homogeneous one if there is one
  double Normal[3];
  double Texture[2];
  OFFColor Color;
  bool HasMore = false; ///< numbers after the color
};

/// Vertices in a piece of the mesh.
template <typename Real>
struct OFFVertices
{
  Buffer<Real> Coordinates;
  Buffer<Real> Normals;
  Buffer<Real> Texture;
  OFFColors Colors;

  OFFVertices() = default;
  OFFVertices(const OFFHeader& header, vtkIdType size)
    : Coordinates(3 * size)
    , Normals(header.HasNormals ? 3 * size : 0)
    , Texture(header.HasTexture ? 2 * size : 0)
    , Colors(header.HasColors ? size : 0)
  {
  }

  /// Sets a vertex: the first three coordinates, divided by the last one in homogeneous files, and
  /// the first three components of the normal; missing ones are 0.
  void Set(vtkIdType i, const OFFHeader& header, const OFFVertex& vertex)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double x = c < header.Dimension ? vertex.Position[c] : 0;
      this->Coordinates[3 * i + c] = static_cast<Real>(header.IsHomogeneous ? x / vertex.Last : x);
    }
    for (int c = 0; c < 3 && header.HasNormals; ++c)
    {
      this->Normals[3 * i + c] = static_cast<Real>(c < header.Dimension ? vertex.Normal[c] : 0);
    }
    for (int c = 0; c < 2 && header.HasTexture; ++c)
    {
      this->Texture[2 * i + c] = static_cast<Real>(vertex.Texture[c]);
    }
    if (header.HasColors)
    {
      this->Colors.Set(i, vertex.Color);
    }
  }
};

/// What has been read of a file.
struct OFFMesh
{
  OFFHeader Header;
  CellMesh Faces;
  OFFColors FaceColors; ///< empty, or one for every cell
  OFFCensus FaceCensus;
  OFFCensus VertexCensus;

  /// Builds the grid of a piece, and for the first piece adds warnings.
  template <typename Real>
  void Fill(OFFVertices<Real>& vertices, const CellMeshPiece& piece, const PieceRequest& request,
    vtkUnstructuredGrid* grid, Warnings& warnings, const Progress& progress);
};

/**
 * Reads the part of a binary file after the keyword. The format is big endian. A little-endian file
 * whose faces lack the number of their color components, as pmp-library writes it, is read with
 * warnings.
 * @param body first byte after the line of the keyword
 */
bool ReadBinaryOFF(const MappedFile& file, const char* body, const OFFHeader& keyword,
  const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings, ScanError& error,
  const Progress& progress);

/// Reads a file in text, see ReadText; every call starts anew.
bool ReadTextOFF(TextScanner& scanner, const TextLines* lines, bool mayLackKeyword,
  const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings,
  const Progress& progress);
}

#endif
