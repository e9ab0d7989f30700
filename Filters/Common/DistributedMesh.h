// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::DistributedMesh
 * @brief The data sets of an input as one mesh: this process' part of it, and what it must know of
 * others.
 *
 * Pieces are the data sets of this process, among them the partitions of one block. At their
 * borders the cells of other pieces of the block are found, wherever they are, with or without
 * ghost cells.
 *
 * Methods that are collective are called by all processes, whatever each has; if one of them fails,
 * all throw std::runtime_error.
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
   * @param leaves the data sets, which must not change while this lives
   * @param options what they have in common; the rest is set for each
   * @param numberOfRequestedPieces in how many pieces the pipeline works; if there are more than
   * processes, the others cannot be asked, and a border without ghost cells is unknown
   */
  DistributedMesh(const std::vector<DataSetLeaf>& leaves, const EvaluationOptions& options,
    int numberOfRequestedPieces, Reducer& reducer);
  ~DistributedMesh();

  const std::vector<LinkedPiece>& Get() const { return this->Pieces; }
  std::size_t GetSize() const { return this->Pieces.size(); }
  /// A vtkUnstructuredGrid or vtkPolyData with the cells of the data set, which share points that
  /// it has several times: see ShareCopiesOfPoints.
  vtkDataSet* GetMesh(std::size_t piece) const { return this->Meshes[piece]; }
  const MeshTopology& GetTopology(std::size_t piece) const { return *this->Topologies[piece]; }
  /// Of every point of a data set the first of its copies, see FindFirstCopies; none if there are
  /// no copies.
  const std::vector<vtkIdType>& GetFirstCopies(std::size_t piece) const
  {
    return this->FirstCopies[piece];
  }
  const EvaluationOptions& GetOptions(std::size_t piece) const
  {
    return this->Pieces[piece].Options;
  }

  /// What is marked of one of several copies of a point is marked of all of them. @a marks: of each
  /// piece and point.
  void ShareMarks(std::vector<std::vector<unsigned char>>& marks) const;

  /// Takes all blocks for pieces of one; before any of what follows.
  void ConnectBlocks();
  /// Collective. Finds neighbors in other pieces of the block.
  void Link();
  /// Collective. After Link. What criteria read of the mesh as a whole; see MeshFacts::Find.
  bool FindFacts(unsigned needs, const std::function<bool()>& goesOn);

  /// Collective. Whether there are several pieces, and they can be asked.
  bool CanAskOthers() { return this->AreSeveral() && !this->OthersAreUnknown; }
  /// Collective. Of every piece its mesh with the cells around it, see CompletePieces, unless the
  /// others cannot be asked or there are none. @a arrays are the same on all processes.
  std::vector<vtkSmartPointer<vtkDataSet>> Complete(const std::vector<std::string>& arrays);
  /// Collective. The points of every piece that lie in one place, see CoincidentPoints.h.
  std::vector<std::vector<vtkIdType>> FindCoincidentPoints(double tolerance);
  /// Collective. The faces of every mesh of Complete that lie in one place, see MismatchedFaces.h.
  std::vector<std::vector<Index>> FindMismatchedFaces(
    const std::vector<vtkSmartPointer<vtkDataSet>>& completed, double tolerance);
  /// Collective. Of every piece the CellDimensions that the pieces of its block have.
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
