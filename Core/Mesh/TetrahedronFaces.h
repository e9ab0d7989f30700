// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TetrahedronFaces
 * @brief Finds the unique faces of tetrahedra, several times as fast as those of any cells.
 *
 * The points of a cell are sorted. The three faces with the lowest one go into a bucket together,
 * the face of the others into another one, by their lowest points; and equal faces are found within
 * a bucket, which fits into the cache of a processor.
 */
#ifndef camaron_TetrahedronFaces_h
#define camaron_TetrahedronFaces_h

#include "Mesh/CellBuckets.h"
#include "Mesh/FacetTable.h"
#include "Mesh/MeshView.h"

#include <limits> // for the link of a face of one cell
#include <mutex>  // for further uses
#include <vector> // for further uses

namespace camaron
{
class TetrahedronFaces
{
public:
  /**
   * Fills a table whose sizes are set, of a mesh of nothing but VTK_TETRA. False if a cell has a
   * point twice; then the table is as it was.
   */
  static bool Fill(const MeshView& mesh, FacetTable& table);

private:
  struct Cell;
  struct Fan;
  struct Triangle;
  struct Bucket;
  struct FurtherUse;

  /// Which use of a cell is the face without one of the sorted points, and whether it runs against
  /// their order.
  class FaceCodes
  {
  public:
    FaceCodes();
    CellFacet GetUse(Index cell, Index order, int without) const
    {
      CellFacet use;
      use.Packed = 8 * cell + this->Codes[order][without];
      return use;
    }

  private:
    unsigned char Codes[64][4] = {};
  };

  // While faces have no numbers, a use has a link in its place in the table: the first use of a
  // face names the second one, any other one the complement of the first, and with it whether they
  // run against each other.
  static constexpr Index NoOther = std::numeric_limits<Index>::min();
  static bool IsFirst(Index link) { return (link >= 0) | (link == NoOther); }

  TetrahedronFaces(const MeshView& mesh, FacetTable& table);

  bool CountItems();
  std::vector<Index> FindRounds() const;
  void FillBuckets(Index first, Index last, Fan* fans, Triangle* triangles);
  void Match();
  void LoadBucket(Index number, const Fan* fans, const Triangle* triangles, Bucket& bucket) const;
  void MatchBucket(Bucket& bucket);
  void Link(CellFacet first, CellFacet second);
  void OrderFurtherUses();
  void NumberFaces();
  void ListFurtherCells();

  const MeshView& Mesh;
  FacetTable& Table;
  const FaceCodes Codes;
  CellBuckets FanBuckets, TriangleBuckets;
  std::vector<Index> FanBegins, TriangleBegins; // of buckets
  std::mutex FurtherMutex;
  std::vector<FurtherUse> FurtherUses; // of faces with more than two
};
}

#endif
