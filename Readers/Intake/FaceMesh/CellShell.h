// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellShell
 * @brief The shell of one polyhedral cell: its distinct points, and its faces with outward
 * orientation.
 *
 * A face shared by two cells is oriented outward for at most one of them, and many files ignore
 * orientation. If every edge of the cell belongs to two of its faces, the faces of each connected
 * part of the shell are oriented consistently, then outward by the volume they enclose, or inward
 * if they bound a void; the orientation of a part without volume follows from its ids, not from the
 * directions of its faces. A cell that is not closed in this way, or not orientable, keeps its
 * faces as stored. Nothing else is repaired.
 *
 * Time is linear in the total number of points of all faces, of parts without volume n log n. Holds
 * scratch memory: use one object per thread.
 */
#ifndef camaron_CellShell_h
#define camaron_CellShell_h

#include "Intake/FaceMesh/FaceMesh.h"

#include <vector> // for scratch

namespace camaron
{
class ClosedShell;

class CellShell
{
public:
  explicit CellShell(const PointSource& points)
    : Points(points)
  {
  }

  /// Loads a cell from its list of face ids; faces without points are omitted.
  void Load(const IdList& cell, const IdList* faces);
  /// The same for a cell given by its faces; point ids may start at any number unless a volume is
  /// needed.
  void Load(const IdList* faces, std::int32_t count);
  /// Orients the faces; false if the cell is not closed.
  bool Orient();
  /// Reverses one face.
  void Turn(std::int32_t face) { this->Turned[face] ^= 1; }

  /// Distinct points in order of appearance.
  const std::vector<std::int32_t>& GetPoints() const { return this->Ids; }
  std::int32_t GetNumberOfFaces() const { return static_cast<std::int32_t>(this->Turned.size()); }
  /// Total number of points of all faces.
  std::int32_t GetNumberOfCorners() const { return this->Begins.back(); }
  /// Id of a face in the mesh.
  std::int32_t GetFace(std::int32_t face) const { return this->Faces[face]; }
  std::int32_t GetFaceSize(std::int32_t face) const
  {
    return this->Begins[face + 1] - this->Begins[face];
  }
  /// Calls @a put(id) for the points of a face; a reversed face starts at the same point.
  template <typename Put>
  void ForEachPoint(std::int32_t face, Put&& put) const
  {
    const std::int32_t begin = this->Begins[face], end = this->Begins[face + 1];
    put(this->Ids[this->Corners[begin]]);
    if (this->Turned[face])
    {
      for (std::int32_t i = end - 1; i > begin; --i)
      {
        put(this->Ids[this->Corners[i]]);
      }
    }
    else
    {
      for (std::int32_t i = begin + 1; i < end; ++i)
      {
        put(this->Ids[this->Corners[i]]);
      }
    }
  }

private:
  template <typename GetId>
  void Load(const IdList* faces, std::int32_t count, GetId&& getId);
  void NumberPoints(const IdList* faces, std::int32_t count);
  bool PairEdges();
  template <typename FindOrAdd>
  bool PairEdges(FindOrAdd&& findOrAdd);
  void LoadPlaces();
  bool TurnFromMean();
  bool IsOneSphere() const;
  bool IsAgainstIds(std::size_t begin);
  bool TurnConsistently();
  void TurnVoids();
  void AddTriangles(std::int32_t face, ClosedShell& shell) const;
  double GetVolumeOfFace(std::int32_t face, double& bound) const;

  PointSource Points;
  std::vector<std::int32_t> Faces;
  std::vector<std::int32_t> Begins;  ///< first corner of every face, and the end
  std::vector<std::int32_t> Corners; ///< positions in Ids
  std::vector<std::int32_t> Ids;
  std::vector<unsigned char> Turned;

  static constexpr std::size_t MaxSmall = 64; ///< number of points of a cell whose edges fit into
                                              ///< the matrix
  unsigned char Matrix[MaxSmall * MaxSmall]; ///< for each pair of points, 1 + the edge between them
  std::uint64_t Next[MaxSmall];    ///< for each point, the set of next points in the faces
  std::vector<std::int32_t> Table; ///< open hash table of points or edges
  std::vector<std::int32_t> Mates; ///< for each corner, the other use of the edge that starts there
  std::vector<std::int32_t> Owners; ///< the face of each corner
  std::vector<std::int32_t> Stack;  ///< faces, one part of the shell after the other
  std::vector<std::int32_t> Order;  ///< of the corners of a face, by id
  std::vector<std::size_t> Parts;   ///< where the parts begin in Stack
  std::vector<unsigned char> Seen;
  std::vector<double> Places; ///< coordinates of the points, relative to the first
};
}

#endif
