// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellTopology
 * @brief Faces, edges and vertex figures of one cell, in local point numbers.
 *
 * Made once for every standard type, and anew for every polyhedron, polygon and collapsed standard
 * cell, by the same code: so all of them answer alike. Holds its memory for the next cell.
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
  /// An edge with its first two faces; Uses counts all of them.
  struct Edge
  {
    int Points[2]; ///< the direction in which Faces[0] runs along it
    int Faces[2];  ///< -1 where missing
    int Uses;
    bool Consistent; ///< two faces that run along it in opposite directions
  };
  /// One step around a vertex: along an edge, then over a face to the next step.
  struct Spoke
  {
    int Edge;
    int Face;
  };

  /// Two faces with equally many points, or one that is left twice.
  struct FacePair
  {
    int First, Second;
  };

  int NumberOfPoints = 0;
  std::vector<int> FaceOffsets, FacePoints;
  std::vector<int> FaceNumbers; ///< of every face, among all that were added
  ///@{
  /// Parallel to FacePoints.
  std::vector<int> FaceEdges;   ///< the edge from this point to the next
  std::vector<int> CornerFaces; ///< the face; longer than FacePoints
  ///@}
  std::vector<Edge> Edges;         ///< after FindEdges
  std::vector<FacePair> FacePairs; ///< all faces, by size; only after FindFacePairs
  /// Every edge has two faces, or more of them in balance, which run along it in opposite
  /// directions.
  bool IsClosed = false;
  /// Every edge has exactly two faces.
  bool IsManifold = false;

  ///@{
  /// Spokes around every vertex, in one cycle; only after MakeVertexFigures, and if
  /// HasVertexFigures.
  std::vector<int> SpokeOffsets;
  std::vector<Spoke> Spokes;
  /// False when the faces around some vertex do not form exactly one cycle, or some edge has not
  /// two faces.
  bool HasVertexFigures = false;
  ///@}

  int GetNumberOfFaces() const { return static_cast<int>(this->FaceOffsets.size()) - 1; }
  int GetFaceSize(int face) const { return this->FaceOffsets[face + 1] - this->FaceOffsets[face]; }
  const int* GetFace(int face) const { return this->FacePoints.data() + this->FaceOffsets[face]; }

  /// Starts a new cell.
  void Clear();
  void AddFace(const int* points, int size);
  ///@{
  /// In place of Clear and AddFace: takes the lists, and gives those of another cell for them,
  /// which can be overwritten.
  void Take(int numberOfPoints, std::vector<int>& faceOffsets, std::vector<int>& facePoints);
  /// Whether it is finished with these faces and still has them, or with faces of so many points.
  bool Knows(int numberOfPoints, const std::vector<int>& faceOffsets,
    const std::vector<int>& facePoints) const;
  bool KnowsSizes(const std::vector<int>& faceOffsets) const;
  ///@}
  /**
   * Ends a cell. In its faces a point that follows itself counts once, and less than three points
   * are no face. Finds the edges, unless they can wait for FindEdges or CheckClosed, and with them
   * whether the cell is closed.
   * @return whether a point followed itself
   */
  bool Finish(bool edgesCanWait = false);
  ///@{
  /// Find the edges, and whether the cell is closed; the second one without edges where that is
  /// possible.
  void FindEdges();
  void CheckClosed();
  ///@}
  ///@{
  /**
   * The shells of the cell: faces that hang together over edges that have exactly two of them, and,
   * where such a group is not closed for itself, the groups that close it.
   */
  void FindShells();
  /// Reverses faces so that neighbors agree; each shell keeps the direction of its first face.
  void MakeConsistent() { this->FindShells(true); }
  int GetShell(int face) const { return this->Shells[face]; }
  int GetNumberOfShells() const { return this->NumberOfShells; }
  ///@}
  ///@{
  /// Faces that run against the order in which they were added.
  int GetNumberOfReversedFaces() const;
  bool IsReversed(int face) const { return this->Reversed[face] != 0; }
  ///@}
  /// Reverses the faces of shells by their numbers.
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

  bool IsAsAdded = false;                 // no face was changed since Finish
  std::vector<int> NextPoints;            // parallel to FacePoints
  std::vector<int> FirstFaces, NextFaces; // faces by size, as linked lists
  LocalNumbers EdgeNumbers;
  std::vector<int> EdgeUses, FirstCorners, LastCorners; // of edges
  std::vector<int> EdgeTable;                           // by the points of an edge
  bool HasEdges = false, IsOneShell = false, HasShells = false, HasFacePairs = false,
       KnowsVertexFigures = false;
  std::vector<int> Shells, Stack;
  std::vector<unsigned char> Reversed;
  int NumberOfShells = 0;
  std::vector<int> LastCornersOfPoints; // places in FacePoints
  std::vector<int> CornerCounts;        // of every point
  std::vector<int> Twins;               // of every edge the sum of its two places in FaceEdges
};
}

#endif
