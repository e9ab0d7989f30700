// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::OFFBinaryReading
 * @brief Reads the parts of a binary OFF file, one after the other; errors are those of its
 * scanner.
 */
#ifndef camaron_PolygonOFFBinaryReading_h
#define camaron_PolygonOFFBinaryReading_h

#include "PolygonOFFMesh.h"

#include "Intake/Rows/BinaryScanner.h"
#include "Scan/MappedFile.h"

#include <string> // for a completed file
#include <vector> // for blocks of faces

namespace camaron
{
struct OFFFace;

class OFFBinaryReading : public OFFMesh
{
public:
  OFFBinaryReading(const BinaryScanner& scanner, const OFFHeader& keyword)
    : Scanner(scanner)
  {
    this->Header = keyword;
  }

  ///@{
  /// Call in this order; false with the error in the scanner, or if aborted.
  bool ReadHeader();
  /// Finds where blocks of faces begin.
  bool FindFaces(const Progress& progress);
  /// Finds which faces a piece has, and stores these.
  bool ReadFaces(const PieceRequest& request, CellMeshPiece& piece, const Progress& progress);
  /// Passes the positions of all vertices, homogeneous ones undivided.
  bool ForEachVertex(const PieceOfSpace::Visit& visit) const;
  bool ReadVertices(
    const CellMeshPiece& piece, OFFVertices<float>& vertices, const Progress& progress);
  ///@}
  /// After ReadHeader: the file with the color sizes that pmp-library omits added to the faces;
  /// empty if the faces are not of this kind.
  std::string AddColorSizes(const char* begin) const;

  BinaryScanner Scanner;

private:
  static constexpr vtkIdType BlockSize = 4096; // faces or vertices that a thread reads at a time
  static constexpr int Word = 4;               // bytes
  static constexpr int FaceBytes = 2 * Word;   // number of vertices, and of color components

  struct Block
  {
    const char* Place;
    vtkIdType Cell;
  };

  bool ReadFace(const char*& place, OFFFace& face) const;
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
  std::vector<Block> Blocks;
};

/**
 * Reads the part of a file after the keyword. The format is big endian. A file whose numbers are
 * only valid as little endian is read with a warning, and so is one whose faces lack the number of
 * their color components.
 * @param body first byte after the line of the keyword
 */
bool ReadBinaryOFF(const MappedFile& file, const char* body, const OFFHeader& keyword,
  const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings, ScanError& error,
  const Progress& progress);
}

#endif
