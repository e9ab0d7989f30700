// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellShell
 * @brief The shell of one polyhedral cell: its distinct points, and its faces turned outward.
 *
 * A face that two cells share runs outward for one of them at most, and many files do not care at
 * all. If every edge of the cell belongs to two of its faces, the faces of each connected part of
 * the shell are turned to run consistently, and outward by the volume they enclose, or inward if
 * they bound a void; a part of no volume follows its first face. A cell that is not closed in this
 * way, or cannot be oriented, keeps its faces as the mesh has them. Nothing else is repaired.
 *
 * Cost is linear in the number of corners of all faces. Holds scratch memory: use one per thread.
 */
#ifndef camaron_CellShell_h
#define camaron_CellShell_h

#include "FaceMesh/FaceMesh.h"

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

  /// Takes the faces of a cell, which has a list of their ids; faces without points are left out.
  void Load(const IdList& cell, const IdList* faces);
  /// The same of faces that are somewhere; ids may count from any number, as long as no volume is
  /// asked.
  void Load(const IdList* faces, std::int32_t count);
  /// Turns the faces; false if the cell is not closed.
  bool Orient();
  /// Turns one face.
  void Turn(std::int32_t face) { this->Turned[face] ^= 1; }

  /// Distinct points in order of appearance.
  const std::vector<std::int32_t>& GetPoints() const { return this->Ids; }
  std::int32_t GetNumberOfFaces() const { return static_cast<std::int32_t>(this->Turned.size()); }
  /// Points of all faces together.
  std::int32_t GetNumberOfCorners() const { return this->Begins.back(); }
  /// Id of a face in the mesh.
  std::int32_t GetFace(std::int32_t face) const { return this->Faces[face]; }
  std::int32_t GetFaceSize(std::int32_t face) const
  {
    return this->Begins[face + 1] - this->Begins[face];
  }
  /// Calls @a put(id) for the points of a face; a turned face starts at the same point.
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
  void Clear();
  void Add(std::int32_t id, const IdList& face)
  {
    this->Faces.push_back(id);
    this->Lists.push_back(face);
    this->Begins.push_back(this->Begins.back() + face.Size);
  }
  void NumberPoints();
  bool PairEdges();
  template <typename FindOrAdd>
  bool PairEdges(FindOrAdd&& findOrAdd);
  void LoadPlaces();
  bool TurnFromMean();
  bool IsOneSphere() const;
  bool TurnConsistently();
  void TurnVoids();
  void AddTriangles(std::int32_t face, ClosedShell& shell) const;
  double GetVolumeOfFace(std::int32_t face) const;

  PointSource Points;
  std::vector<std::int32_t> Faces;
  std::vector<IdList> Lists;         ///< of the points of every face, in the mesh
  std::vector<std::int32_t> Begins;  ///< first corner of every face, and one more
  std::vector<std::int32_t> Corners; ///< positions in Ids
  std::vector<std::int32_t> Ids;
  std::vector<unsigned char> Turned;

  static constexpr std::size_t MaxSmall = 64; ///< points of a cell whose edges fit the matrix
  unsigned char Matrix[MaxSmall * MaxSmall];  ///< per pair of points 1 + the edge between them
  std::uint64_t Next[MaxSmall];     ///< per point the set of those that the faces run to from there
  std::vector<std::int32_t> Table;  ///< open hash table of points or edges
  std::vector<std::int32_t> Mates;  ///< per corner the other use of the edge that starts there
  std::vector<std::int32_t> Owners; ///< per corner its face
  std::vector<std::int32_t> Stack;  ///< faces, of one part of the shell after the other
  std::vector<std::size_t> Parts;   ///< where they begin in Stack
  std::vector<unsigned char> Seen;
  std::vector<double> Places; ///< coordinates of the points, relative to the first
};
}

#endif
