// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ConvexPolyhedron
 * @brief A convex polyhedron, from which half-spaces cut parts off.
 *
 * Faces are lists of points, outward; neighbours share the points of their edge, so that the
 * surface is closed whatever rounding does. Holds its memory for the next polyhedron.
 */
#ifndef camaron_ConvexPolyhedron_h
#define camaron_ConvexPolyhedron_h

#include "Geometry/HalfSpace.h"

#include <utility> // for pairs of points
#include <vector>  // for points and faces

namespace camaron
{
class ConvexPolyhedron
{
public:
  /// Leaves nothing.
  void Clear();
  /// Starts with a box.
  void SetBox(const Vector& low, const Vector& high);
  /**
   * Keeps what lies within the half-space. Points no further than @a tolerance from its plane count
   * as on it; a polyhedron of which no point is inside becomes empty.
   */
  void Clip(const HalfSpace& halfSpace, double tolerance);

  bool IsEmpty() const { return this->Points.empty(); }
  const std::vector<Vector>& GetPoints() const { return this->Points; }
  int GetNumberOfFaces() const { return static_cast<int>(this->FaceOffsets.size()) - 1; }
  int GetFaceSize(int face) const { return this->FaceOffsets[face + 1] - this->FaceOffsets[face]; }
  const int* GetFace(int face) const { return this->FacePoints.data() + this->FaceOffsets[face]; }
  double GetVolume() const;

private:
  void ClipFace(int face, double tolerance);
  int AddCut(int inside, int outside);
  void CloseHole();
  void DropUnusedPoints();

  std::vector<Vector> Points;
  std::vector<int> FaceOffsets = { 0 }, FacePoints;

  std::vector<double> Distances;         // of the points
  std::vector<int> OldOffsets, OldFaces; // while faces are clipped
  std::vector<int> FirstCuts;            // of the edges cut at their outer point, or -1
  struct Cut
  {
    int Inside, Point, Next;
  };
  std::vector<Cut> Cuts;
  std::vector<std::pair<int, int>> Rim, OpenRim; // edges along which clipped faces end
  std::vector<unsigned char> Used;               // edges of OpenRim
  std::vector<int> NewIds;
};
}

#endif
