// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::DistributedMesh
 * @brief Joins the data sets of an input, on all processes, into one mesh.
 *
 * A piece is one data set on this process; partitions of one block are pieces of that block. Link()
 * finds the neighbors of border cells in other pieces of the block, on any process, with or without
 * ghost cells, so that results do not depend on how the mesh is split.
 *
 * Collective methods must be called by all processes, even those without data. If one of them
 * fails, all throw std::runtime_error.
 */
#ifndef camaron_DistributedMesh_h
#define camaron_DistributedMesh_h

#include "ElementBlocks.h"
#include "Ranks/MeshFacts.h"

#include "vtkDataSet.h"      // for the meshes
#include "vtkSmartPointer.h" // for the meshes

#include <cstdint>    // for numbers of cells
#include <functional> // for the question whether to continue
#include <memory>     // for the topologies
#include <string>     // for names of arrays
#include <vector>     // for the pieces

class vtkDataArray;

namespace camaron
{
class DistributedMesh
{
public:
  /**
   * Collective.
   *
   * @param leaves the data sets, from GetMeshes or ElementBlocks, which must not change during the
   * lifetime of this object
   * @param options options common to all pieces; the members that differ by piece are set here
   * @param numberOfRequestedPieces number of pieces in which the pipeline works. If it exceeds the
   * number of processes, other pieces do not exist at the same time, and neighbors beyond a border
   * without ghost cells are unknown.
   */
  DistributedMesh(const std::vector<DataSetLeaf>& leaves, const EvaluationOptions& options,
    int numberOfRequestedPieces, Reducer& reducer);

  const std::vector<LinkedPiece>& Get() const { return this->Pieces; }
  std::size_t GetSize() const { return this->Pieces.size(); }
  /// A vtkUnstructuredGrid or vtkPolyData with the cells of the data set, in which duplicates of
  /// points are merged; see ShareCopiesOfPoints.
  vtkDataSet* GetMesh(std::size_t piece) const { return this->Meshes[piece]; }
  const MeshTopology& GetTopology(std::size_t piece) const { return *this->Topologies[piece]; }
  /// For every point of a data set its first duplicate, which may be the point itself; see
  /// FindFirstCopies. Empty if there are no duplicates.
  const std::vector<vtkIdType>& GetFirstCopies(std::size_t piece) const
  {
    return this->FirstCopies[piece];
  }
  const EvaluationOptions& GetOptions(std::size_t piece) const
  {
    return this->Pieces[piece].Options;
  }

  /// Marks all duplicates of a point of which one is marked. @a marks: one list per piece with one
  /// mark per point.
  void ShareMarks(std::vector<std::vector<unsigned char>>& marks) const;

  /// Treats all blocks as pieces of a single block. Call it before any of the following methods.
  void ConnectBlocks();
  /// Collective. Finds the neighbors of cells in other pieces of the block.
  void Link();
  /// Collective. Computes what criteria read of the mesh as a whole, such as mean sizes; see
  /// MeshFacts::Find. Call Link first.
  void FindFacts(unsigned needs, const std::function<void()>& goOn);

  /// Collective. Whether there are several pieces and all of them exist at the same time.
  bool CanAskOthers() { return this->AreSeveral() && !this->OthersAreUnknown; }
  /**
   * Collective. For every piece its mesh with the adjacent cells of other pieces, see
   * CompletePieces; the mesh itself if there are no other pieces or they are unknown. @a arrays
   * must be the same on all processes.
   */
  std::vector<vtkSmartPointer<vtkDataSet>> Complete(const std::vector<std::string>& arrays);
  /// Collective. For every piece the points at coincident positions, see CoincidentPoints.h.
  std::vector<std::vector<vtkIdType>> FindCoincidentPoints(double tolerance);
  /// Collective. For every mesh of Complete the boundary faces at the position of another boundary
  /// face, see MismatchedFaces.h.
  std::vector<std::vector<Index>> FindMismatchedFaces(
    const std::vector<vtkSmartPointer<vtkDataSet>>& completed, double tolerance);
  /// Collective. For every piece the CellDimensions of all pieces of its block.
  std::vector<unsigned> FindDimensions();

private:
  const vtkIdType* GetIds(vtkDataArray* ids);
  /// Collective.
  void NumberCells();
  /// Collective. Whether there are several pieces.
  bool AreSeveral();

  camaron::Reducer& Reducer;
  bool OthersAreUnknown;                              // there are more pieces than processes
  std::vector<std::vector<std::int64_t>> CellNumbers; // see EvaluationOptions
  std::vector<std::vector<vtkIdType>> FirstCopies;    // see FindFirstCopies
  std::vector<vtkSmartPointer<vtkDataSet>> Meshes;
  std::vector<std::unique_ptr<MeshTopology>> Topologies;
  std::vector<vtkSmartPointer<vtkDataArray>> Ids;
  std::vector<LinkedPiece> Pieces;
  std::vector<PieceLinks> Links;
  MeshFacts Facts;
};
}

#endif
