// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonOFFHeader.h
 * @brief The first lines of an OFF file: its keyword, and the numbers of vertices and faces.
 */
#ifndef camaron_PolygonOFFHeader_h
#define camaron_PolygonOFFHeader_h

#include "Scan/TextScanner.h"

namespace camaron
{
/// The keyword, [ST][C][N][4][n]OFF [BINARY], and the numbers after it.
struct OFFHeader
{
  bool HasKeyword = false;
  bool HasTexture = false;
  bool HasColors = false; ///< of vertices; faces may have colors regardless
  bool HasNormals = false;
  bool IsHomogeneous = false;
  bool IsBinary = false;
  /// Whether colors come before normals, as in files of MeshLab, which writes NC instead of CN.
  bool HasColorsFirst = false;
  bool HasDimension = false;
  std::int64_t Dimension = 3;
  std::int64_t Vertices = 0;
  std::int64_t Faces = 0;

  std::int64_t GetPositionSize() const { return this->Dimension + (this->IsHomogeneous ? 1 : 0); }
  std::int64_t GetNormalSize() const { return this->HasNormals ? this->Dimension : 0; }
  /// Minimum number of values of a vertex.
  std::int64_t GetVertexSize() const
  {
    return this->GetPositionSize() + this->GetNormalSize() + (this->HasTexture ? 2 : 0);
  }
  /// Whether a vertex consists of x, y and z only.
  bool IsPlain() const
  {
    return this->Dimension == 3 && this->GetVertexSize() == 3 && !this->HasColors;
  }
};

/**
 * Reads the keyword; in binary files up to the end of its line. False with the error in the
 * scanner.
 * @param mayLackKeyword whether the file may begin with a number
 */
bool ReadOFFKeyword(TextScanner& scanner, bool mayLackKeyword, OFFHeader& header);

/// Reads the numbers between keyword and vertices of a text. False with the error in the scanner.
bool ReadOFFCounts(TextScanner& scanner, OFFHeader& header);
}

#endif
