// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PrimitiveMatcher
 * @brief Recognizes tetrahedra, pyramids, wedges and hexahedra among cells given by their faces.
 *
 * A cell is recognized if its faces are connected like those of the VTK cell, regardless of their
 * orientation. Each node is the intersection of certain faces, so the nodes follow from the order
 * in which the cell lists its faces: a cell that lists them in VTK's order gets VTK's nodes back.
 * Lists of faces do not distinguish inside from outside, so the mirror image with positive volume
 * is chosen; a cell without volume is kept. If the orientation of faces is known, it decides, and
 * an inverted cell stays inverted.
 */
#ifndef camaron_PrimitiveMatcher_h
#define camaron_PrimitiveMatcher_h

#include "Intake/FaceMesh/FaceMesh.h"

namespace camaron
{
struct Primitive;

/// The orientation of a face relative to a cell.
enum class FaceDirection : unsigned char
{
  Outward,
  Inward
};

class PrimitiveMatcher
{
public:
  explicit PrimitiveMatcher(const PointSource& points);

  /// The only type possible with this number of faces, triangles and quadrilaterals.
  static unsigned char Guess(std::int32_t faces, std::int32_t triangles, std::int32_t quads);
  static unsigned char Guess(const IdList* faces, std::int32_t count);
  static int GetNumberOfNodes(unsigned char type);

  /// Whether the cell with these faces, the same number as the type has, is of the guessed type.
  bool Match(unsigned char type, const IdList* faces);
  /// The same, but the directions of faces decide the orientation: that of VTK's first face, or of
  /// all if a hexahedron's agree. Ids may start at any number.
  bool Match(unsigned char type, const IdList* faces, const FaceDirection* directions);

  /**
   * Adds a face, whose normal points inward, to a hexahedron: its nodes, in VTK's order, and a
   * state, which is 0 before the first face, the bottom, and Complete after the last. False if the
   * faces do not form a hexahedron, or are oriented inconsistently. Ids must not be 0.
   */
  static bool AddToHexahedron(std::int32_t* nodes, std::uint32_t& state, const std::int32_t* face);
  static constexpr std::uint32_t Complete = 0xff;

  /// Point ids in VTK's order, after a match.
  const std::int32_t* GetNodes() const { return this->Nodes; }
  /// Which of the given faces is VTK's face number @a face, after a match.
  int GetFace(int face) const { return this->FaceOf[face]; }

private:
  template <typename IsMirrored>
  bool MatchTetrahedron(const IdList* faces, IsMirrored&& isMirrored);
  template <typename IsMirrored>
  bool MatchAny(unsigned char type, const IdList* faces, IsMirrored&& isMirrored);
  bool MatchHexahedron(const IdList* faces, const FaceDirection* directions);
  bool RunsAgainst(
    const Primitive& primitive, const IdList* faces, const FaceDirection* directions) const;
  bool CollectVertices(int numberOfFaces, int numberOfNodes, const IdList* faces);
  bool FindNodes(const Primitive& primitive);
  double GetVolume(const Primitive& primitive) const;

  static constexpr int MaxFaces = 6;
  static constexpr int MaxNodes = 8;

  PointSource Points;
  const Primitive* Tetrahedron;
  std::int32_t Nodes[MaxNodes];
  int FaceOf[MaxFaces];

  std::int32_t Vertices[MaxNodes];    ///< distinct points in order of appearance
  unsigned char FacesOf[MaxNodes];    ///< set of faces that contain the vertex
  unsigned char VerticesOf[MaxFaces]; ///< set of vertices of a face
  unsigned char Corners[MaxFaces][4]; ///< vertices of a face in order
  int Sizes[MaxFaces];
};
}

#endif
