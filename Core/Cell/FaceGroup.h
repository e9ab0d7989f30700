// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FaceGroup
 * @brief Faces of a cell with the same number of points, one per SIMD lane; lanes may repeat a
 * face.
 */
#ifndef camaron_FaceGroup_h
#define camaron_FaceGroup_h

#include "Base/VectorPair.h"
#include "Mesh/CellTopology.h"

namespace camaron
{
template <typename Lanes_>
class FaceGroup
{
public:
  using Lanes = Lanes_;
  using Vectors = VectorLanes<Lanes>;
  static constexpr int Size = sizeof(Lanes) / sizeof(double);

  /// Calls @a visit(const FaceGroup&) for groups of all faces, by size. Requires FindFacePairs.
  template <typename Visit>
  static void ForEach(const CellTopology& topology, Visit&& visit)
  {
    const std::vector<CellTopology::FacePair>& pairs = topology.FacePairs;
    for (std::size_t first = 0; first < pairs.size();)
    {
      FaceGroup group;
      group.NumberOfPoints = topology.GetFaceSize(pairs[first].First);
      std::size_t pair = first;
      for (int lane = 0; lane < Size; lane += 2)
      {
        const bool isNext =
          first < pairs.size() && topology.GetFaceSize(pairs[first].First) == group.NumberOfPoints;
        pair = isNext ? first++ : pair;
        group.SetFace(topology, lane, pairs[pair].First);
        group.SetFace(topology, lane + 1, pairs[pair].Second);
      }
      visit(group);
    }
  }

  int GetFace(int lane) const { return this->Faces[lane]; }
  /// The number of points of each face.
  int GetNumberOfPoints() const { return this->NumberOfPoints; }

  /// Gathers the vectors get(face) of all lanes.
  template <typename Get>
  Vectors Gather(Get&& get) const
  {
    if constexpr (Size == 2)
    {
      return { get(this->Faces[0]), get(this->Faces[1]) };
    }
    else
    {
      return { get(this->Faces[0]), get(this->Faces[1]), get(this->Faces[2]), get(this->Faces[3]) };
    }
  }

  /// The points of all faces at the same local corner.
  Vectors GetCorner(const Vector* points, int corner) const
  {
    if constexpr (Size == 2)
    {
      return { points[this->Rings[0][corner]], points[this->Rings[1][corner]] };
    }
    else
    {
      return { points[this->Rings[0][corner]], points[this->Rings[1][corner]],
        points[this->Rings[2][corner]], points[this->Rings[3][corner]] };
    }
  }

private:
  void SetFace(const CellTopology& topology, int lane, int face)
  {
    this->Faces[lane] = face;
    this->Rings[lane] = topology.GetFace(face);
  }

  int NumberOfPoints = 0;
  int Faces[Size];
  const int* Rings[Size];
};
}

#endif
