// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ConvexPolyhedron
 * @brief A convex polyhedron that can be clipped by half-spaces.
 *
 * Faces are lists of points with outward orientation; neighbors share the points of their edge, so
 * the surface is closed regardless of roundoff. Memory is reused for the next polyhedron.
 */
#ifndef camaron_ConvexPolyhedron_h
#define camaron_ConvexPolyhedron_h

#include "Geometry/HalfSpace.h"

#include <functional> // for progress
#include <vector>     // for points and faces

namespace camaron
{
class ConvexPolyhedron
{
public:
  /// Makes it empty.
  void Clear();
  /// Starts with a box.
  void SetBox(const Vector& low, const Vector& high);
  /**
   * Keeps the part inside all half-spaces. Points within @a tolerance of a plane count as on it; a
   * polyhedron without a point inside a half-space becomes empty.
   *
   * Each half-space only processes the faces that it cuts. More than a thousand are processed in a
   * fixed random order: average time is O(n log n) for n half-spaces, but quadratic in the number
   * of vertices of a face. Points do not depend on the order, up to @a tolerance.
   *
   * @param goesOn called up to a hundred times with the completed fraction; return false to stop
   * @return false if stopped
   */
  bool Clip(const std::vector<HalfSpace>& halfSpaces, double tolerance,
    const std::function<bool(double)>& goesOn);

  bool IsEmpty() const { return this->Points.empty(); }
  const std::vector<Vector>& GetPoints() const { return this->Points; }
  int GetNumberOfFaces() const { return static_cast<int>(this->Faces.size()); }
  int GetFaceSize(int face) const { return this->Faces[face].Size; }
  const int* GetFace(int face) const { return this->Corners.data() + this->Faces[face].Begin; }
  /// For every vertex of a face, the face across the edge to the next vertex.
  const int* GetNeighbors(int face) const
  {
    return this->Neighbors.data() + this->Faces[face].Begin;
  }
  /// The half-space of the last Clip that the face bounds, or -1 if the face existed before.
  int GetHalfSpace(int face) const { return this->Faces[face].HalfSpace; }
  double GetVolume() const;

private:
  struct Face
  {
    int Begin, Size;   ///< its corners; Size is 0 if it was cut off
    int FirstConflict; ///< first half-space in its list, or -1
    int Step;          ///< that cut it last
    int HalfSpace;     ///< see GetHalfSpace
  };
  /// Properties of a point for a cut.
  struct Mark
  {
    int Step;        ///< cut whose plane Distance refers to
    double Distance; ///< positive outside
    int FirstCut;    ///< first of the edges cut at this outer point, or -1
  };
  struct Cut
  {
    int Inside, Point, Next;
  };
  /// An edge at which a clipped face ends, seen from the other side.
  struct RimEdge
  {
    int From, To;
    int Face, Corner; ///< the face and corner of the edge
    bool operator<(const RimEdge& other) const
    {
      return this->From != other.From ? this->From < other.From : this->To < other.To;
    }
  };

  void Shuffle(std::size_t size);
  void StartConflicts();
  bool AddConflict(int face, int halfSpace);
  void CutOff(int halfSpace);
  bool FindFacesToCut(int halfSpace);
  void ClipFace(int face);
  int AddCut(int inside, int outside);
  void CloseHole(int halfSpace);
  void MoveConflicts(int halfSpace, int firstNewFace);
  void DropUnused();
  template <typename Visit>
  void ForCorners(Visit&& visit);

  std::vector<Vector> Points;
  std::vector<Face> Faces;
  std::vector<int> Corners;   // points of the faces
  std::vector<int> Neighbors; // of every corner, the face across the edge to the next corner

  // While clipping, every half-space that has not been applied yet is in the list of a face with a
  // point outside of it, its conflict; without such a face, it cuts nothing.
  const std::vector<HalfSpace>* HalfSpaces = nullptr;
  double Tolerance = 0;
  std::vector<int> Order;               // of the half-spaces
  std::vector<int> Conflicts;           // of every half-space, a face or -1
  std::vector<int> NextConflicts;       // of every half-space, the next one in its list or -1
  int Step = 0;                         // number of the cut
  std::vector<Mark> Marks;              // of the points
  std::vector<int> Affected;            // faces with points outside of the plane or on it
  std::vector<int> Ring, RingNeighbors; // of the clipped face
  std::vector<Cut> Cuts;
  std::vector<RimEdge> Rim, OpenRim;
  std::vector<unsigned char> Used; // edges of OpenRim
  std::vector<int> NewIds;
};

/**
 * A convex polygon in 2D that can be clipped by half-planes.
 *
 * Points have no Z and are counter-clockwise. Memory is reused for the next polygon.
 */
class ConvexPolygon
{
public:
  /// Starts with a rectangle.
  void SetBox(const Vector& low, const Vector& high);
  /**
   * Keeps the part inside the half-plane. Points within @a tolerance of its line count as on it; a
   * polygon without a point inside becomes empty.
   */
  void Clip(const HalfSpace& halfPlane, double tolerance);

  bool IsEmpty() const { return this->Points.empty(); }
  const std::vector<Vector>& GetPoints() const { return this->Points; }
  double GetArea() const;

private:
  std::vector<Vector> Points, Kept;
  std::vector<double> Distances;
};
}

#endif
