// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentFaceBatches
 * @brief Visits the faces of a Fluent file in the order of their ids, some at a time.
 *
 * Faces of text that are not kept are read from the file, so that there is never more of them in
 * memory than one batch. Faces that are accessible are taken from where they are, block by block,
 * by whoever visits a batch. Only text with one face per line can be visited; what else there is,
 * is left to FluentFaces.
 */
#ifndef camaron_FluentFaceBatches_h
#define camaron_FluentFaceBatches_h

#include "FluentCellFaces.h"

#include <algorithm>  // for the ends of blocks
#include <atomic>     // for what shares say
#include <functional> // for visitors
#include <memory>     // for lines
#include <vector>     // for blocks

namespace camaron
{
class FluentFaceBatches
{
public:
  struct Face
  {
    const char* Nodes; ///< ids of the file, from 1; not checked if they are binary
    std::int32_t Size;
    std::int32_t Cells[2]; ///< of the piece, -1 for none
  };
  /// What a visitor wants to know of faces.
  enum class Want
  {
    Cells, ///< and sizes
    All
  };
  static constexpr vtkIdType BlockSize = FluentFaces::BlockSize;

  /**
   * @param nodes the largest id of a node
   * @param chunk bytes of text that are read as one piece
   */
  FluentFaceBatches(
    const FluentFile& file, const FluentMesh& mesh, std::int64_t nodes, vtkIdType chunk)
    : File(file)
    , Mesh(mesh)
    , Nodes(nodes)
    , Chunk(chunk)
    , IsPlain(mesh.Piece.IsWhole() && !mesh.Cells.HasOtherCells())
  {
  }

  /// Consecutive faces of a run.
  class Batch
  {
  public:
    const FluentFaces::Run& GetRun() const { return *this->Of; }
    /// A node of a face.
    std::int32_t GetNode(const Face& face, std::int32_t i) const
    {
      return Load<std::int32_t>(face.Nodes + 4 * std::ptrdiff_t(i), this->Swap);
    }
    /**
     * Calls visit(position, faces, count) for at most BlockSize faces at a time, until it returns
     * false; false if it did, or if cells are out of range. Several threads may do so at once.
     */
    template <typename Visit>
    bool ForEachBlock(Visit&& visit) const
    {
      std::vector<Face> found(this->Read ? 0 : static_cast<std::size_t>(BlockSize));
      for (vtkIdType begin = this->Begin; begin < this->End; begin += BlockSize)
      {
        const vtkIdType end = std::min(begin + BlockSize, this->End);
        if ((!this->Read && !this->Batches->Find(*this->Of, begin, end, found.data())) ||
          !visit(
            begin, this->Read ? this->Read + (begin - this->Begin) : found.data(), end - begin))
        {
          return false;
        }
      }
      return true;
    }

  private:
    friend class FluentFaceBatches;
    const FluentFaceBatches* Batches;
    const FluentFaces::Run* Of;
    vtkIdType Begin, End;
    const Face* Read; ///< if they were text
    bool Swap;
  };

  /**
   * Calls visit(batch) for all faces that bound cells, until it returns false. False if it did, if
   * some faces are wrong or laid out otherwise, or if stopped.
   */
  bool ForEach(Want want, const Progress& progress, const std::function<bool(const Batch&)>& visit);

  /**
   * In how many shares cells are made, a power of two. All look at all faces; each takes those of
   * its cells, in their order.
   */
  static int GetNumberOfShares();
  /// Which share a cell is of. Shares are many ranges of cells, so that all have some in every
  /// batch; these are not small, as a processor guesses which share comes next.
  static vtkIdType GetShare(vtkIdType cell, vtkIdType shares)
  {
    constexpr int RangeBits = 9;
    return cell >> RangeBits & (shares - 1);
  }
  /// Calls visit(share) for all shares in parallel; false if one returned false.
  template <typename Visit>
  static bool ForEachShare(vtkIdType shares, Visit&& visit)
  {
    std::atomic<bool> good{ true };
    ParallelFor(shares, 1,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType share = first; share < last; ++share)
        {
          if (!visit(share))
          {
            good = false;
          }
        }
      });
    return good;
  }

private:
  using Run = FluentFaces::Run;
  bool ReadText(
    Want want, const TextLines& lines, const Run& run, const char*& place, vtkIdType count);
  bool ReadLine(const Run& run, const char* text, const char* end, Face& face, char* nodes) const;
  bool SkimLine(const Run& run, const char* text, const char* end, Face& face) const;
  bool AreNodesGood(const Face& face, bool swap) const;
  bool SetCells(const std::int64_t* cells, Face& face) const;
  bool Find(const Run& run, vtkIdType begin, vtkIdType end, Face* faces) const;
  template <int Size>
  bool FindPlain(const Run& run, vtkIdType begin, vtkIdType end, Face* faces) const;

  const FluentFile& File;
  const FluentMesh& Mesh;
  std::int64_t Nodes;
  vtkIdType Chunk;
  bool IsPlain;                                  ///< whether cells are numbered as in the file
  std::vector<std::unique_ptr<TextLines>> Lines; ///< of every run, if it is text
  Buffer<Face> Faces;                            ///< of text
  Buffer<std::int32_t> Words;                    ///< their nodes
};
}

#endif
