// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellTopology
 * @brief Faces, edges and vertex figures of one cell, in local point numbers.
 *
 * Computed once for every standard type, and by the same code for every polyhedron, polygon and
 * collapsed standard cell, so that results are consistent. Memory is reused for the next cell.
 */
#ifndef camaron_CellTopology_h
#define camaron_CellTopology_h

#include "Base/LocalNumbers.h"

#include <vector> // for the tables

namespace camaron
{
class CellTopology
{
public:
  /// An edge with its first two faces.
  struct Edge
  {
    int Points[2]; ///< in the direction in which Faces[0] traverses it
    int Faces[2];  ///< -1 if missing
    int Uses;
    bool Consistent; ///< whether its two faces traverse it in opposite directions
  };
  /// One step around a vertex: along an edge, then across a face to the next step.
  struct Spoke
  {
    int Edge;
    int Face;
  };

  /// Two faces with the same number of points, or a single remaining face twice.
  struct FacePair
  {
    int First, Second;
  };

  int NumberOfPoints = 0;
  std::vector<int> FaceOffsets, FacePoints;
  std::vector<int> FaceNumbers; ///< for every face, its index among all faces added
  ///@{
  /// Parallel to FacePoints.
  std::vector<int> FaceEdges;   ///< the edge from this point to the next
  std::vector<int> CornerFaces; ///< the face of this corner; longer than FacePoints
  ///@}
  std::vector<Edge> Edges;         ///< set by FindEdges
  std::vector<FacePair> FacePairs; ///< all faces, by size; set by FindFacePairs
  /// Every edge has two faces that traverse it in opposite directions, or more faces with balanced
  /// directions.
  bool IsClosed = false;
  /// Every edge has exactly two faces.
  bool IsManifold = false;

  ///@{
  /// Set by MakeVertexFigures: the spokes around every vertex, as one cycle, if HasVertexFigures.
  std::vector<int> SpokeOffsets;
  std::vector<Spoke> Spokes;
  /// False if the faces around a vertex do not form exactly one cycle, or an edge does not have two
  /// faces.
  bool HasVertexFigures = false;
  ///@}

  int GetNumberOfFaces() const { return static_cast<int>(this->FaceOffsets.size()) - 1; }
  int GetFaceSize(int face) const { return this->FaceOffsets[face + 1] - this->FaceOffsets[face]; }
  const int* GetFace(int face) const { return this->FacePoints.data() + this->FaceOffsets[face]; }

  /// Starts a new cell.
  void Clear();
  void AddFace(const int* points, int size);
  ///@{
  /// Alternative to Clear and AddFace: swaps in the lists of faces. The lists returned in exchange
  /// are those of another cell and can be overwritten.
  void Take(int numberOfPoints, std::vector<int>& faceOffsets, std::vector<int>& facePoints);
  /// Knows: whether this is the finished topology of exactly these faces. KnowsSizes: of faces with
  /// these sizes.
  bool Knows(int numberOfPoints, const std::vector<int>& faceOffsets,
    const std::vector<int>& facePoints) const;
  bool KnowsSizes(const std::vector<int>& faceOffsets) const;
  ///@}
  /**
   * Finishes a cell: removes consecutive repetitions of a point from its faces, and faces with
   * fewer than three points. Finds the edges and whether the cell is closed, unless
   * @a edgesCanWait; FindEdges or CheckClosed then do this later.
   * @return whether a face had a repeated point
   */
  bool Finish(bool edgesCanWait = false);
  ///@{
  /// FindEdges finds the edges and whether the cell is closed. CheckClosed only determines the
  /// latter, and avoids finding the edges if possible.
  void FindEdges();
  void CheckClosed();
  ///@}
  ///@{
  /**
   * The shells of the cell: faces connected over edges that have exactly two faces. Such a group
   * that is not closed by itself is merged with the groups that close it.
   */
  void FindShells();
  /// Reverses faces so that neighbors are consistently oriented; each shell keeps the orientation
  /// of its first face.
  void MakeConsistent() { this->FindShells(true); }
  int GetShell(int face) const { return this->Shells[face]; }
  int GetNumberOfShells() const { return this->NumberOfShells; }
  ///@}
  ///@{
  /// Faces with the opposite orientation of that in which they were added.
  int GetNumberOfReversedFaces() const;
  bool IsReversed(int face) const { return this->Reversed[face] != 0; }
  ///@}
  /// Reverses all faces of the marked shells.
  void ReverseShells(const std::vector<unsigned char>& areReversed);
  void MakeVertexFigures();
  void FindFacePairs();

private:
  bool DropRepeatedPoints();
  void ListCorners();
  bool IsClosedShell() const;
  bool IsConnectedManifold() const;
  void ListEdges();
  int NumberEdges();
  void FindSecondFaces();
  bool IsBalanced() const;
  void FindShells(bool makeConsistent);
  bool FloodShell(int shell, int first, bool makeConsistent);
  void JoinOpenShells();
  void ReverseFace(int face);

  bool IsAsAdded = false;                 // no face has changed since Finish
  std::vector<int> NextPoints;            // parallel to FacePoints
  std::vector<int> FirstFaces, NextFaces; // faces by size, as linked lists
  LocalNumbers EdgeNumbers;
  std::vector<int> EdgeUses, FirstCorners, LastCorners; // of edges
  std::vector<int> EdgeTable;                           // hash table of edges by their points
  bool HasEdges = false, IsOneShell = false, HasShells = false, HasFacePairs = false,
       KnowsVertexFigures = false;
  std::vector<int> Shells, Stack;
  std::vector<unsigned char> Reversed;
  int NumberOfShells = 0;
  std::vector<int> LastCornersOfPoints; // positions in FacePoints
  std::vector<int> CornerCounts;        // of every point
  std::vector<int> Twins;               // for every edge, the sum of its two positions in FaceEdges
};
}

#endif
