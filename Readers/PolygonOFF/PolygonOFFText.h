// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::OFFTextReading
 * @brief Reads the part of an OFF file in text after the keyword.
 */
#ifndef camaron_PolygonOFFText_h
#define camaron_PolygonOFFText_h

#include "Intake/Rows/TextRows.h"
#include "PolygonOFFMesh.h"

namespace camaron
{
/// The words up to the end of a line.
struct OFFRest
{
  static constexpr int Most = 16; ///< numbers kept; vertices do not have more
  double Values[Most];
  bool AreReal[Most];        ///< whether they are written as real numbers
  int Count = 0;             ///< including those that are not kept
  const char* Odd = nullptr; ///< the first word that is not a number

  explicit OFFRest(TextRow& row);
  /// The color of the first numbers, at most four of them.
  OFFColor GetColor(int count) const;
};

class OFFTextReading : private OFFMesh
{
public:
  OFFTextReading(
    bool mayLackKeyword, const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings)
    : MayLackKeyword(mayLackKeyword)
    , Request(request)
    , Grid(grid)
    , Messages(warnings)
  {
  }

  /// Reads a piece of the file for ReadText; every call starts anew.
  bool Read(TextScanner& scanner, const TextLines* lines, const Progress& progress);

private:
  bool ReadVertices(TextScanner& scanner, const TextLines* lines, const CellMeshPiece& piece,
    OFFVertices<double>* vertices, const Progress& progress);
  ///@{
  /// @param point where to store the vertex, -1 to drop it
  bool ReadVertex(vtkIdType row, TextRow& text, vtkIdType point, OFFVertices<double>& vertices,
    OFFVertexCensus& seen);
  bool ReadColoredVertex(vtkIdType row, TextRow& text, vtkIdType point,
    OFFVertices<double>& vertices, OFFVertexCensus& seen);
  ///@}
  /// Finds which faces a piece has, and stores these.
  bool ReadFaces(
    TextScanner& scanner, const TextLines* lines, CellMeshPiece& piece, const Progress& progress);
  bool ReadFacesOfLines(
    TextScanner& scanner, const TextLines& lines, CellMeshPiece& piece, const Progress& progress);
  bool ReadFacesInOrder(TextScanner& scanner, CellMeshPiece& piece, const Progress& progress);

  bool MayLackKeyword;
  PieceRequest Request;
  vtkUnstructuredGrid* Grid;
  Warnings& Messages;
};
}

#endif
