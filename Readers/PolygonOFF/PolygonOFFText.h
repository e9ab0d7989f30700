// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonOFFText.h
 * @brief Rows of OFF files in text: vertices, and faces with their colors.
 */
#ifndef camaron_PolygonOFFText_h
#define camaron_PolygonOFFText_h

#include "Intake/Rows/RowSequence.h"
#include "PolygonOFFMesh.h"

namespace camaron
{
/// The numbers up to the end of a line.
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

/// Finds the faces of a piece, and stores these. False with the error in the scanner, or if
/// stopped.
bool ReadTextFaces(OFFMesh& mesh, RowSequence& rows, const PieceRequest& request,
  CellMeshPiece& piece, const Progress& progress);
}

#endif
