// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ConvexPolyhedron
 * @brief A convex polyhedron, from which half-spaces cut parts off.
 *
 * Faces are lists of points, outward; neighbors share the points of their edge, so that the
 * surface is closed whatever rounding does. Holds its memory for the next polyhedron.
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
  /// Leaves nothing.
  void Clear();
  /// Starts with a box.
  void SetBox(const Vector& low, const Vector& high);
  /**
   * Keeps what lies within all half-spaces. Points no further than @a tolerance from a plane count
   * as on it; a polyhedron of which no point is inside of one becomes empty.
   *
   * Each looks only at the faces that it cuts. More than a thousand are taken in a shuffled order,
   * always the same: n of them take a time of n log n on average, but that of a face with many
   * corners grows with their square. Points are the same up to @a tolerance in any order.
   *
   * @param goesOn called up to a hundred times with the fraction done; false stops
   * @return false when stopped
   */
  bool Clip(const std::vector<HalfSpace>& halfSpaces, double tolerance,
    const std::function<bool(double)>& goesOn);

  bool IsEmpty() const { return this->Points.empty(); }
  const std::vector<Vector>& GetPoints() const { return this->Points; }
  int GetNumberOfFaces() const { return static_cast<int>(this->Faces.size()); }
  int GetFaceSize(int face) const { return this->Faces[face].Size; }
  const int* GetFace(int face) const { return this->Corners.data() + this->Faces[face].Begin; }
  /// Of every corner of a face, the face across the edge to the next corner.
  const int* GetNeighbors(int face) const
  {
    return this->Neighbors.data() + this->Faces[face].Begin;
  }
  /// The half-space of the last Clip that the face bounds, or -1 if the face was there before.
  int GetHalfSpace(int face) const { return this->Faces[face].HalfSpace; }
  double GetVolume() const;

private:
  struct Face
  {
    int Begin, Size;   ///< of its corners; Size 0 for one that was cut off
    int FirstConflict; ///< of the half-spaces in its list, or -1
    int Step;          ///< that has cut it last
    int HalfSpace;     ///< see GetHalfSpace
  };
  /// What a cut needs to know of a point.
  struct Mark
  {
    int Step;        ///< whose plane Distance is from
    double Distance; ///< positive outside
    int FirstCut;    ///< of the edges cut at this outer point, or -1
  };
  struct Cut
  {
    int Inside, Point, Next;
  };
  /// An edge along which a clipped face ends, from the other side.
  struct RimEdge
  {
    int From, To;
    int Face, Corner; ///< that it belongs to
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

  // While half-spaces cut. One that has yet to cut is in the list of a face with a point outside of
  // it, its conflict; if there is none, it never cuts.
  const std::vector<HalfSpace>* HalfSpaces = nullptr;
  double Tolerance = 0;
  std::vector<int> Order;               // of the half-spaces
  std::vector<int> Conflicts;           // of every half-space, a face or -1
  std::vector<int> NextConflicts;       // of every half-space, the next one in its list or -1
  int Step = 0;                         // number of the cut
  std::vector<Mark> Marks;              // of the points
  std::vector<int> Affected;            // faces with points outside of the plane or on it
  std::vector<int> Ring, RingNeighbors; // of the face that is clipped
  std::vector<Cut> Cuts;
  std::vector<RimEdge> Rim, OpenRim;
  std::vector<unsigned char> Used; // edges of OpenRim
  std::vector<int> NewIds;
};
}

#endif
